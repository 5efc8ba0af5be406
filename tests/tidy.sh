#!/usr/bin/env bash
# Runs clang-tidy over the product code, by the checks of .clang-tidy, with the commands of the preset `tidy`.
#   tests/tidy.sh                   the files that were changed since the merge base with main; on main itself, in the last
#                                   commit and after it
#   tests/tidy.sh --base REVISION   the files that were changed since that revision
#   tests/tidy.sh FILE...           these files
#   tests/tidy.sh --all             all files of the product
# A header is looked at through .cpp files that include it, at most 5, or alone where none does.
# Exit 0: no findings; 1: findings; 2: it cannot run. TIDY: the program, where it is not clang-tidy-19.
set -euo pipefail
Called=$PWD
cd "$(dirname "${BASH_SOURCE[0]}")/.."
Build=build/tidy
Storeys=(rdg settings passes pipeline)
Most=5

Say() { printf 'tidy: %s\n' "$*" >&2; }
Die() { Say "$*"; exit 2; }

# The revision that the working tree is compared with; empty where there is none.
FindBase() {
	local Base
	Base=$(git merge-base HEAD origin/main 2>/dev/null || git merge-base HEAD main 2>/dev/null) || Base=
	if [ -z "$Base" ] || [ "$Base" = "$(git rev-parse HEAD)" ]; then
		Base=$(git rev-parse -q --verify HEAD~1) || Base=
	fi
	printf '%s' "$Base"
}

ChangedFiles() {
	git diff --name-only --diff-filter=d "${1:-HEAD}"
	git ls-files --others --exclude-standard
}

# The files that clang-tidy can be given: those that the preset compiles.
CompiledFiles() {
	jq -r '.[].file' "$Build/compile_commands.json" | sed "s|^$PWD/||" | grep -E '\.cpp$' | sort -u
}

# Includers HEADER: the compiled .cpp files that include it, those beside it first.
Includers() {
	local Name=${1##*/} Folder=${1%/*} Found
	Found=$(grep -lE --include='*.cpp' -r "^#include \"([^\"]*/)?${Name//./\\.}\"" "${Storeys[@]}" | sort | grep -xFf "$Compiled" || true)
	{ grep "^$Folder/[^/]*$" <<<"$Found" || true; grep -v "^$Folder/[^/]*$" <<<"$Found" || true; } | sed '/^$/d'
}

# TakeFile FILE: adds what there is to look at to Files, or says why nothing is.
TakeFile() {
	local Through
	case $1 in
		*.cpp)
			if grep -qxF "$1" "$Compiled"; then Files+=("$1"); else Say "not looked at: $1, which the preset does not compile"; fi ;;
		*.h | *.inl)
			[[ " ${Storeys[*]} " = *" ${1%%/*} "* ]] || { Say "not looked at: $1, which is not product code"; return; }
			mapfile -t Through < <(Includers "$1")
			if [ ${#Through[@]} = 0 ]; then
				[[ $1 = *.h ]] || { Say "not looked at: $1, which no .cpp file includes directly"; return; }
				Through=("$1")
			fi
			[ ${#Through[@]} -le $Most ] || Say "$1 is looked at through $Most of the ${#Through[@]} .cpp files that include it"
			Files+=("${Through[@]:0:$Most}") ;;
		*) [ "$bNamed" = 0 ] || Say "not looked at: $1, which is not C++" ;;
	esac
}

Tidy=${TIDY:-clang-tidy-19}
command -v "$Tidy" >/dev/null 2>&1 || Die "$Tidy is missing; ./dev tidy installs it"
[ -f "$Build/compile_commands.json" ] || Die "$Build is missing; ./dev tidy configures it"
Work=$(mktemp -d)
trap 'rm -rf "$Work"' EXIT
Compiled=$Work/compiled
CompiledFiles >"$Compiled"

Files=()
bNamed=0
case ${1:-} in
	--all) mapfile -t Files <"$Compiled" ;;
	--base | "")
		if [ $# -gt 0 ]; then
			[ $# = 2 ] && Base=$(git rev-parse -q --verify "$2^{commit}") || Die "--base needs a revision"
		else
			Base=$(FindBase)
			[ -n "$Base" ] || Say "there is no earlier revision, so only what is not committed is looked at"
		fi
		mapfile -t Changed < <(ChangedFiles "$Base")
		for File in "${Changed[@]}"; do TakeFile "$File"; done ;;
	-*) Die "unknown option $1; there are --all and --base" ;;
	*)
		bNamed=1
		for File in "$@"; do
			Real=$(cd "$Called" && realpath "$File")
			[ -f "$Real" ] || Die "$File is not a file"
			TakeFile "${Real#"$PWD"/}"
		done ;;
esac
[ ${#Files[@]} -gt 0 ] || { Say "no file to look at"; exit 0; }
mapfile -t Files < <(printf '%s\n' "${Files[@]}" | sort -u)
Say "looking at ${#Files[@]} file(s)"

# Each file's report has a file of its own, since several run at a time.
export Tidy Build Work
Began=$SECONDS
printf '%s\n' "${Files[@]}" | xargs -P "$(nproc)" -I {} bash -c '
	Report=$Work/${1//\//-}
	"$Tidy" -p "$Build" --quiet "$1" >"$Report.out" 2>"$Report.err" || { touch "$Work/failed"; cat "$Report.err" >&2; }' _ {} &
for ((Second = 1; ; ++Second)); do
	kill -0 $! 2>/dev/null || break
	sleep 1
	[ $((Second % 60)) != 0 ] || Say "$(find "$Work" -name '*.out' | wc -l) of ${#Files[@]} file(s)"
done
wait $!

# A header's finding is reported once, whichever files showed it.
cat "$Work"/*.out | awk '/^\/[^ ]*:[0-9]+:[0-9]+: (warning|error): / { Show = !($0 in Seen); Seen[$0] = 1 } Show' >"$Work/findings"
sed "s|^$PWD/||" "$Work/findings"
Count=$(grep -cE '^/[^ ]*:[0-9]+:[0-9]+: (warning|error): ' "$Work/findings" || true)
Say "$Count finding(s) in $((SECONDS - Began)) s"
[ "$Count" = 0 ] && [ ! -e "$Work/failed" ]
