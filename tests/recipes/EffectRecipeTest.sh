#!/usr/bin/env bash
# Carries out the recipe "an effect with a setting" of docs/architecture.md on a scratch copy of the tree: copies the files
# of Posterize in, adds the rows, builds the program and looks for the effect where a person would.
#
#   EffectRecipeTest.sh SOURCE WORK
set -euo pipefail

Here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
Source=$(realpath "$1") Work=$2
Tree=$Work/tree
Fail() { printf 'EffectRecipeTest: %s\n' "$*" >&2; exit 1; }

# Times of files are kept, so that a second run compiles only what changed.
rm -rf "$Tree"
mkdir -p "$Tree" "$Work/edited"
(cd "$Source" && cp -a CMakeLists.txt CMakePresets.json rdg settings passes pipeline cmake templates configs "$Tree/")

# New files, as they stand in the recipe's folder; its test is compiled with the others of its room.
(cd "$Here/Posterize" && find passes pipeline configs -type f) | while read -r File; do
	[ ! -e "$Tree/$File" ] || Fail "$File is no new file"
	mkdir -p "$(dirname "$Tree/$File")"
	cp -p "$Here/Posterize/$File" "$Tree/$File"
done
# Rows, each after the last line that begins as it does.
grep -v '^#' "$Here/Posterize/rows.txt" | while IFS=$'\t' read -r File Row; do
	case "$File" in tests/*) grep -q "^${Row%%(*}(" "$Source/$File" || Fail "$File has no such rows"; continue ;; esac
	Last=$(grep -n "^${Row%%(*}(" "$Tree/$File" | tail -n 1 | cut -d: -f1)
	[ -n "$Last" ] || Fail "$File has no row that begins with ${Row%%(*}"
	Edited=$Work/edited/${File//\//_}
	sed "${Last}r /dev/stdin" "$Tree/$File" <<<"$Row" >"$Edited.new"
	cmp -s "$Edited.new" "$Edited" || mv "$Edited.new" "$Edited"
	cp -p "$Edited" "$Tree/$File"
done

cmake -S "$Tree" -B "$Work/build" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG="-O0 -DNDEBUG" \
	-DDRYDOCK_BUILD_TESTS=OFF -DDRYDOCK_BUILD_BENCH=OFF >"$Work/configure.log"
cmake --build "$Work/build" --target drydock_program >"$Work/build.log" 2>&1 || { tail -n 40 "$Work/build.log" >&2; Fail "it does not build"; }

Drydock=$Work/build/bin/drydock
export DRYDOCK_CACHE_DIR=$Work/cache
cd "$Work"
Expect() { grep -qE "$2" <<<"$1" || Fail "expected \"$2\" in: $1"; }
Expect "$("$Drydock" list effects)" '^Posterize +Posterize\* +The picture in few levels\.'
Expect "$("$Drydock" list settings Posterize)" 'PosterizeLevels'
Expect "$("$Drydock" check "$Tree/configs/posterize.json" 2>&1)" 'no errors'
Expect "$("$Drydock" explain "$Tree/configs/posterize.json")" '^Posterize +yes +.*PosterizeLevels is 8; before bloom'
Expect "$("$Drydock" explain "$Tree/configs/posterize.json" --pp PosterizeLevels=0)" '^Posterize +no +.*PosterizeLevels is 0: neutral'
Expect "$("$Drydock" explain "$Tree/configs/posterize.json" --effect Posterize)" 'Posterize 641x359'
"$Drydock" run "$Tree/configs/posterize.json" --out with >/dev/null
"$Drydock" run "$Tree/configs/posterize.json" --pp PosterizeLevels=0 --out without >/dev/null
! cmp -s with/final.exr without/final.exr || Fail "the picture is as without the effect"
Expect "$(cat with/run.json)" '"name": "Posterize", "active": true'
echo "EffectRecipeTest: Posterize was added in $(cd "$Here/Posterize" && find passes pipeline tests configs -type f | wc -l) new files and $(grep -vc '^#' "$Here/Posterize/rows.txt") rows"
