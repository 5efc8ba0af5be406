#!/usr/bin/env bash
# What ./dev test installs for the tests of the report pages: where neither apt nor npm is reached it says so once, and the
# tests run all the same. Usage: PageToolsTest.sh SOURCE WORK. Nothing is installed or built: stubs stand for apt-get,
# npm, cmake and ctest.
set -euo pipefail

Source=$1 Work=$2 Failures=0
rm -rf "$Work"
mkdir -p "$Work/bin" "$Work/tree/report" "$Work/tree/build/release" "$Work/tree/tests"
cp "$Source/dev" "$Work/tree/dev"
printf '#!/bin/sh\n' >"$Work/tree/tests/unit_tests.py" # every name is ctest's
chmod +x "$Work/tree/tests/unit_tests.py"
touch "$Work/tree/report/package-lock.json" "$Work/tree/build/release/build.ninja"
printf 'CMAKE_HOME_DIRECTORY:INTERNAL=%s\n' "$Work/tree" >"$Work/tree/build/release/CMakeCache.txt"

# Every program there is but those that would be installed.
for Program in /usr/bin/* /bin/*; do
	case "${Program##*/}" in node | nodejs | npm | chromium | firefox*) ;; *) ln -sf "$Program" "$Work/bin/" ;; esac
done
Stub() {
	rm -f "$Work/bin/$1"
	printf '#!/bin/sh\n%s\n' "$2" >"$Work/bin/$1"
	chmod +x "$Work/bin/$1"
}
Stub cmake 'exit 0'
Stub ctest 'echo "the tests"'
Stub dpkg-query 'printf installed'
Stub sudo 'shift; exec "$@"'
Stub apt-get 'echo "apt-get $*" >>"$ASKED"; echo "E: nobody answers"; exit 100'

# Sets Out, Err, Code and Asked (what was asked of apt-get and npm).
RunDev() {
	: >"$Work/asked"
	Code=0
	Out=$(PATH="$Work/bin" ASKED="$Work/asked" bash "$Work/tree/dev" "$@" 2>"$Work/err") || Code=$?
	Err=$(cat "$Work/err") Asked=$(cat "$Work/asked")
}
Expect() {
	if ! eval "$2"; then
		printf 'FAILED: %s\n  exit %s\n  out: %s\n  err: %s\n  asked: %s\n' "$1" "$Code" "$Out" "$Err" "$Asked"
		Failures=$((Failures + 1))
	fi
}

RunDev test rdg_Graph
Expect "tests that need no browser install none" '[ "$Code" = 0 ] && [ -z "$Asked" ] && [ "$Out" = "the tests" ]'
RunDev test
Expect "without apt the tests run" '[ "$Code" = 0 ] && [ "$Out" = "the tests" ]'
Expect "and it is said what is missing and why" 'grep -q "nodejs npm chromium firefox-esr cannot be installed.*skipped.*nobody answers" <<<"$Err"'
RunDev test
Expect "once" '[ "$Code" = 0 ] && [ -z "$Asked" ] && [ -z "$Err" ]'
Stub apt-get 'echo "apt-get $*" >>"$ASKED"'
Stub npm 'echo "npm $*" >>"$ASKED"; echo "npm error no registry"; exit 1'
RunDev setup
Expect "setup tries again" 'grep -q "apt-get .*install .*nodejs chromium firefox-esr" <<<"$Asked"'
Expect "npm that is there is not asked for" '! grep -q "install.* npm" <<<"$Asked"'
Expect "a registry that is not reached is said" '[ "$Code" = 0 ] && grep -q "npm ci in report/ failed.*skipped.*no registry" <<<"$Err"'
Stub npm 'mkdir -p node_modules; echo "npm $*" >>"$ASKED"'
RunDev setup
Expect "modules are installed" '[ -z "$(grep failed <<<"$Err")" ] && grep -q "^npm ci" <<<"$Asked" && [ -e "$Work/tree/report/node_modules/.package-lock.json" ]'
RunDev setup
Expect "and stay while their list is the same" '! grep -q "^npm" <<<"$Asked"'

# The container has what setup installs, of the system that the README names.
Expect "the container calls setup" 'grep -q "^RUN .*/dev setup" "$Source/Containerfile"'
System=$(sed -n 's/^FROM debian:\([0-9]*\)$/Debian \1/p' "$Source/Containerfile")
Expect "of the README's system" '[ -n "$System" ] && grep -q "$System" "$Source/README.md"'
[ $Failures = 0 ] && echo "PageToolsTest: all well"
