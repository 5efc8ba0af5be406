#!/usr/bin/env bash
# Which files ./dev tidy looks at, and what it answers. Usage: TidyTest.sh SOURCE WORK. A stub stands for clang-tidy: it finds
# something in every file that has the word bug in it, and in what such a file includes.
set -euo pipefail

Source=$1 Work=$2 Failures=0
rm -rf "$Work"
Tree=$Work/tree
mkdir -p "$Tree/tests" "$Tree/build/tidy" "$Tree/rdg/Core" "$Tree/pipeline"
cp "$Source/tests/tidy.sh" "$Tree/tests/"
printf 'build/\n' >"$Tree/.gitignore"
cat >"$Work/clang-tidy" <<'STUB'
#!/usr/bin/env bash
File=${@: -1}
case $File in /*) ;; *) File=$PWD/$File ;; esac
echo "$File" >>"$LOOKED"
if grep -q crash "$File"; then echo "clang-tidy crashed" >&2; exit 139; fi
for Header in "$File" $(sed -n "s|^#include \"\(.*\)\"|${File%/*}/\1|p" "$File"); do
	grep -n bug "$Header" | sed "s|^\([0-9]*\):.*|$Header:\1:1: warning: a bug [bugprone-bug]\n    1 \| bug|"
done
exit 0
STUB
chmod +x "$Work/clang-tidy"

Here() { git -C "$Tree" -c user.name=t -c user.email=t@t "$@" >/dev/null 2>&1; }
cd "$Tree"
Compiled=()
for Name in A B; do
	printf '#include "%s.h"\nint %s;\n' $Name $Name >rdg/Core/$Name.cpp
	printf 'int In%s;\n' $Name >rdg/Core/$Name.h
	Compiled+=("{\"file\": \"$Tree/rdg/Core/$Name.cpp\"}")
done
printf '#include "A.h"\n' >rdg/Core/C.cpp
printf 'int Alone;\n' >rdg/Core/Alone.h
printf 'int Piece;\n' >rdg/Core/Piece.inl
printf 'int Main;\n' >pipeline/Main.cpp
printf 'int Test;\n' >tests/Test.cpp
Compiled+=("{\"file\": \"$Tree/rdg/Core/C.cpp\"}" "{\"file\": \"$Tree/pipeline/Main.cpp\"}")
(IFS=,; printf '[%s]' "${Compiled[*]}") >build/tidy/compile_commands.json
Here init -b main && Here add -A && Here commit -m first

# Sets Out, Err, Code and Looked (the files that clang-tidy was given).
RunTidy() {
	: >"$Work/looked"
	Code=0
	Out=$(TIDY="$Work/clang-tidy" LOOKED="$Work/looked" tests/tidy.sh "$@" 2>"$Work/err") || Code=$?
	Err=$(cat "$Work/err")
	Looked=$(sed "s|^$Tree/||" "$Work/looked" | sort | tr '\n' ' ')
}
Expect() {
	if ! eval "$2"; then
		printf 'FAILED: %s\n  exit %s\n  out: %s\n  err: %s\n  looked at: %s\n' "$1" "$Code" "$Out" "$Err" "$Looked"
		Failures=$((Failures + 1))
	fi
}

RunTidy
Expect "the first revision has none before it" '[ "$Code" = 0 ] && [ -z "$Looked" ] && grep -q "no earlier revision" <<<"$Err"'
RunTidy --all
Expect "all files" '[ "$Code" = 0 ] && [ "$Looked" = "pipeline/Main.cpp rdg/Core/A.cpp rdg/Core/B.cpp rdg/Core/C.cpp " ]'

Here checkout -b work
printf 'int More; // bug\n' >>rdg/Core/A.h
printf 'int More;\n' >>tests/Test.cpp
Here commit -am second
printf 'int New;\n' >rdg/Core/New.cpp
RunTidy
Expect "a header's .cpp files, beside it" '[ "$Looked" = "rdg/Core/A.cpp rdg/Core/C.cpp " ]'
Expect "its finding once, and exit 1" '[ "$Code" = 1 ] && [ "$(grep -c "^rdg/Core/A.h:2:1: warning: a bug" <<<"$Out")" = 1 ]'
Expect "files that are not looked at are named" \
	'grep -q "not looked at: tests/Test.cpp" <<<"$Err" && grep -q "not looked at: rdg/Core/New.cpp" <<<"$Err"'
RunTidy --base HEAD
Expect "against a revision" '[ "$Code" = 0 ] && [ -z "$Looked" ] && ! grep -q Test.cpp <<<"$Err" && grep -q New.cpp <<<"$Err"'
Here checkout main && Here merge work
RunTidy
Expect "on main the last commit" '[ "$Code" = 1 ] && [ "$Looked" = "rdg/Core/A.cpp rdg/Core/C.cpp " ]'

cd rdg
TIDY="$Work/clang-tidy" LOOKED=/dev/null ../tests/tidy.sh Core/B.cpp >"$Work/out" 2>&1 || Failures=$((Failures + 1))
cd ..
RunTidy rdg/Core/B.cpp rdg/Core/Alone.h rdg/Core/Piece.inl
Expect "named files, and a header alone" '[ "$Code" = 0 ] && [ "$Looked" = "rdg/Core/Alone.h rdg/Core/B.cpp " ]'
Expect "a piece that no .cpp file includes is named" 'grep -q "not looked at: rdg/Core/Piece.inl" <<<"$Err"'
printf '// crash\n' >>rdg/Core/B.cpp
RunTidy rdg/Core/B.cpp
Expect "a crash is not a clean file" '[ "$Code" = 1 ] && grep -q "clang-tidy crashed" <<<"$Err"'
RunTidy rdg/None.cpp
Expect "a file that is not there" '[ "$Code" = 2 ]'
RunTidy --none
Expect "an option that is not there" '[ "$Code" = 2 ]'
[ $Failures = 0 ] && echo "TidyTest: all well"
