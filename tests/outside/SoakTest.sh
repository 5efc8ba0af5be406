#!/usr/bin/env bash
# Tests ./dev soak: results by commit, the table, steps that fail, that are cut off, that are passed already. Usage:
# SoakTest.sh SOURCE WORK. Nothing is built: stubs stand for ./dev build, ctest and what the steps run.
set -euo pipefail

Source=$1 Work=$2 Failures=0
command -v git >/dev/null 2>&1 || { echo "there is no git"; exit 77; }
rm -rf "$Work"
mkdir -p "$Work/bin" "$Work/tree/tests/fuzz" "$Work/tree/tests/kill" "$Work/tree/tests/random"
Tree=$Work/tree
cp "$Source/tests/soak.sh" "$Tree/tests/"
printf '# a line for each\nini_text X.cpp ini rdg\ngraph Y.cpp graph rdg\n' >"$Tree/tests/fuzz/fuzzers.txt"
echo /build/ >"$Tree/.gitignore"

# Script FILE: an executable of what stdin says.
Script() {
	mkdir -p "$(dirname "$1")"
	{ echo '#!/usr/bin/env bash'; cat; } >"$1"
	chmod +x "$1"
}
Script "$Tree/dev" <<'STUB'
echo "dev $*" >>"$ASKED"
[ ! -e "$WORK/no_build" ] || exit 2
STUB
Script "$Work/bin/ctest" <<'STUB'
echo "ctest $*" >>"$ASKED"
if [ "$1" = -N ]; then
	printf 'Test project\n  Test  #1: one\n  Test #12: two\n  Test #13: three\n\nTotal Tests: 3\n'
	exit
fi
cat "$WORK/ctest_says"
[ ! -e "$WORK/slow" ] || exec sleep 600
STUB
Script "$Tree/tests/fuzz/run.sh" <<'STUB'
[ -e "$WORK/found" ] && echo "$2: rc 77, crash" && exit 1
echo "$2: rc 0, stat::number_of_executed_units: 4711"
STUB
Script "$Tree/tests/kill/run.sh" <<'STUB'
echo "run: 3 ms undisturbed"
[ ! -e "$WORK/torn" ] || { echo "torn: out/final.png"; exit 1; }
echo "round 0, run: as undisturbed after 3 kills"
STUB
mkdir -p "$Tree/build/release/bin" "$Tree/build/asan" "$Tree/build/tsan"
Script "$Tree/build/release/bin/test_stability" <<'STUB'
echo "sweep A"; echo "sweep B"; exit "$([ -e "$WORK/bad_sweep" ] && echo 1 || echo 0)"
STUB
(cd "$Tree" && git init -q . && git add . && git -c user.name=t -c user.email=t@t commit -q -m tree)

# Sets Out, Err, Code and Asked.
Soak() {
	: >"$Work/asked"
	Code=0
	Out=$(cd / && PATH="$Work/bin:$PATH" ASKED="$Work/asked" WORK="$Work" bash "$Tree/tests/soak.sh" "$@" 2>"$Work/err") || Code=$?
	Err=$(cat "$Work/err") Asked=$(cat "$Work/asked")
}
Expect() {
	if ! eval "$2"; then
		printf 'FAILED: %s\n  exit %s\n  out: %s\n  err: %s\n  asked: %s\n' "$1" "$Code" "$Out" "$Err" "$Asked"
		Failures=$((Failures + 1))
	fi
}
Folder() { printf '%s/build/soak/%s' "$Tree" "$(git -C "$Tree" rev-parse --short=12 HEAD)"; }
Row() { grep -E "^$1 +" <<<"$Out"; }

Soak
Expect "without a step there is the table" '[ "$Code" = 0 ] && [ "$(grep -c "not run" <<<"$Out")" = 11 ]'
Soak nothing
Expect "an unknown step is answered with those there are" '[ "$Code" = 2 ] && grep -q "no step nothing; there are all, asan, tsan, fuzz-ini_text, fuzz-graph, kills, random, chains, gates, sweep, oracles, conformance" <<<"$Err"'
DRYDOCK_SOAK_MINUTES=61 Soak
Expect "an hour is the most" '[ "$Code" = 2 ] && grep -q "expected 1 to 60" <<<"$Err"'

Soak fuzz-graph kills sweep
Expect "steps that pass are kept with their figures" '[ "$Code" = 0 ] && Row fuzz-graph | grep -q "passed .* 4711 executions" && Row kills | grep -q "passed .* 3 kills, seed" && Row sweep | grep -q "passed .* 2 cases"'
Expect "a file for each, with its log" '[ "$(cut -f 1 "$(Folder)/sweep")" = passed ] && grep -q "sweep B" "$(Folder)/sweep.log"'
Expect "presets are built" 'grep -q "dev build --preset fuzz" <<<"$Asked" && grep -q "dev build --preset release test_stability" <<<"$Asked"'

touch "$Work/found" "$Work/torn" "$Work/bad_sweep"
Soak kills fuzz-graph
Expect "what fails is named" '[ "$Code" = 1 ] && Row kills | grep -q "failed .* torn: out/final.png, seed" && Row fuzz-graph | grep -q "failed .* build/fuzz/found/graph"'
Soak sweep
Expect "a step that is asked for by its name runs again" '[ "$Code" = 1 ] && Row sweep | grep -q "failed .* exit code 1, 2 cases"'
Soak
Expect "the table has failed steps" '[ "$Code" = 1 ] && [ -z "$Asked" ]'
rm "$Work/found" "$Work/torn" "$Work/bad_sweep"
touch "$Work/no_build"
Soak tsan
Expect "a build that fails is said" '[ "$Code" = 1 ] && Row tsan | grep -q "failed .* the build failed"'
rm "$Work/no_build"

cat >"$Work/ctest_says" <<'END'
    Start  1: one
1/3 Test  #1: one ..............................   Passed    1.00 sec
    Start 12: two
END
touch "$Work/slow"
# A second in place of a minute.
sed -i 's/Minutes \* 60))$/Minutes))/' "$Tree/tests/soak.sh"
git -C "$Tree" -c user.name=t -c user.email=t@t commit -qam short
DRYDOCK_SOAK_MINUTES=3 Soak asan
Expect "tests that were not reached are not passed" '[ "$Code" = 0 ] && Row asan | grep -q "not run .* 1 test programs passed, not run: two, three"'
rm "$Work/slow"
cat >"$Work/ctest_says" <<'END'
1/2 Test #12: two ..............................***Failed    1.00 sec
2/2 Test #13: three ............................***Skipped   0.01 sec
END
DRYDOCK_SOAK_MINUTES=20 Soak asan
Expect "the next call goes on with them" 'grep -qF -- "-E ^(one)$" <<<"$Asked"'
Expect "tests that fail are named" '[ "$Code" = 1 ] && Row asan | grep -q "failed .* 1 test programs passed, 1 skipped, failed: two"'
echo '1/1 Test #12: two ..............................   Passed    1.00 sec
2/2 Test #13: three ............................   Passed    1.00 sec' >"$Work/ctest_says"
DRYDOCK_SOAK_MINUTES=20 Soak asan
Expect "all are passed" '[ "$Code" = 0 ] && Row asan | grep -q "passed .* 3 test programs passed"'

DRYDOCK_SOAK_MINUTES=20 Soak all
Expect "all leaves out what is passed" 'grep -q "asan: this commit has passed it" <<<"$Err" && ! grep -q "ctest.*asan\|preset asan" <<<"$Asked" && grep -q "preset tsan" <<<"$Asked"'
echo x >"$Tree/new"
Soak
Expect "a tree with changes is another" '[ "$Code" = 0 ] && grep -q "^commit .*-dirty" <<<"$Out" && [ "$(grep -c "not run" <<<"$Out")" = 11 ]'

[ $Failures = 0 ] && echo "all as expected"
exit $((Failures > 0))
