#!/usr/bin/env bash
# Carries out two recipes of docs/architecture.md on a scratch copy of the tree: an effect with a setting (Posterize) and a
# verb (Hello). Copies their files in, adds their rows, builds the program and looks for both where a person would. The
# recipes touch nothing of rdg, so that its library is BUILD's. They touch no tool, so that none is built.
#
#   RecipesTest.sh BUILD SOURCE WORK
set -euo pipefail

Here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
Build=$(realpath "$1") Source=$(realpath "$2") Work=$3
Tree=$Work/tree
Fail() { printf 'RecipesTest: %s\n' "$*" >&2; exit 1; }

# Times of files are kept, so that a second run compiles only what changed.
rm -rf "$Tree"
mkdir -p "$Tree" "$Work/edited"
(cd "$Source" && cp -a CMakeLists.txt CMakePresets.json rdg settings passes pipeline cmake templates configs "$Tree/")
mkdir "$Tree/report" && cp "$Source/report/page.html" "$Tree/report/" # the page of a run
find "$Tree/rdg" -name '*.cpp' -delete
[ -f "$Work/edited/Reused.cpp" ] || echo '// The library of rdg stands ready.' >"$Work/edited/Reused.cpp"
cp -p "$Work/edited/Reused.cpp" "$Tree/rdg/core/Core/Reused.cpp"

# New files, as they stand in the recipes' folders. Posterize's test stays there: it would be built with all of its room.
for Recipe in Posterize Hello; do
	(cd "$Here/$Recipe" && find . -type f ! -name rows.txt ! -path './tests/*') | while read -r File; do
		[ ! -e "$Tree/$File" ] || Fail "$File is no new file"
		mkdir -p "$(dirname "$Tree/$File")"
		cp -p "$Here/$Recipe/$File" "$Tree/$File"
	done
done
# Rows, each after the last line that begins as it does.
grep -hv '^#' "$Here"/*/rows.txt | while IFS=$'\t' read -r File Row; do
	case "$File" in tests/*) grep -q "^${Row%%(*}(" "$Source/$File" || Fail "$File has no such rows"; continue ;; esac
	Last=$(grep -n "^${Row%%(*}(" "$Tree/$File" | tail -n 1 | cut -d: -f1)
	[ -n "$Last" ] || Fail "$File has no row that begins with ${Row%%(*}"
	Edited=$Work/edited/${File//\//_}
	sed "${Last}r /dev/stdin" "$Tree/$File" <<<"$Row" >"$Edited.new"
	cmp -s "$Edited.new" "$Edited" || mv "$Edited.new" "$Edited"
	cp -p "$Edited" "$Tree/$File"
done

BuildTarget() { cmake --build "$Work/build" --target "$1" >>"$Work/build.log" 2>&1 || { tail -n 40 "$Work/build.log" >&2; Fail "it does not build"; }; }
: >"$Work/build.log"
cmake -S "$Tree" -B "$Work/build" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG="-O0 -DNDEBUG" \
	-DDRYDOCK_INSTRUCTION_SETS=native -DDRYDOCK_TOOLS=OFF -DDRYDOCK_BUILD_TESTS=OFF -DDRYDOCK_BUILD_BENCH=OFF >"$Work/configure.log"
BuildTarget drydock_rdg
cp --remove-destination "$(realpath "$Build/lib/libdrydock_rdg.so")" "$(realpath "$Work/build/lib/libdrydock_rdg.so")"
mkdir -p "$Work/build/share/drydock"
ln -sfn "$Tree/rdg" "$Work/build/share/drydock/rdg" # beside the library, where it looks first
ln -sfn "$Tree/passes" "$Work/build/share/drydock/passes"
BuildTarget drydock_program

Drydock=$Work/build/bin/drydock
export DRYDOCK_CACHE_DIR=$Work/cache
cd "$Work"
Expect() { grep -qE "$2" <<<"$1" || Fail "expected \"$2\" in: $1"; }
Expect "$("$Drydock" list effects)" '^Posterize +The picture in few levels\. +Posterize\*'
Expect "$("$Drydock" list settings Posterize)" 'PosterizeLevels'
Expect "$("$Drydock" check "$Tree/configs/posterize.json" 2>&1)" 'no errors'
Expect "$("$Drydock" explain "$Tree/configs/posterize.json")" '^Posterize +yes +.*PosterizeLevels is 8; before bloom'
Expect "$("$Drydock" explain "$Tree/configs/posterize.json" --pp PosterizeLevels=0)" '^Posterize +no +.*PosterizeLevels is 0: neutral'
Expect "$("$Drydock" explain "$Tree/configs/posterize.json" --effect Posterize)" 'Posterize 641x359'
"$Drydock" run "$Tree/configs/posterize.json" --out with >/dev/null
"$Drydock" run "$Tree/configs/posterize.json" --pp PosterizeLevels=0 --out without >/dev/null
! cmp -s with/final.exr without/final.exr || Fail "the picture is as without the effect"
Expect "$(cat with/run.json)" '"name": "Posterize", "active": true'
Expect "$("$Drydock" --help)" 'hello +Greet somebody'
[ "$("$Drydock" hello --name drydock)" = "hello drydock" ] || Fail "the verb does not greet"
# This build leaves the tools out, as a first ./dev run does: it says how they are had.
Code=0
Said=$("$Drydock" study "$Tree/configs/posterize.json" 2>&1) || Code=$?
[ $Code = 2 ] || Fail "study, which is not built, ended with $Code"
Expect "$Said" 'this build leaves study out: `./dev study`'
echo "RecipesTest: Posterize was added in $(cd "$Here/Posterize" && find . -type f ! -name rows.txt | wc -l) new files and $(grep -vc '^#' "$Here/Posterize/rows.txt") rows"
