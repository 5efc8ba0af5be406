#!/usr/bin/env bash
# ./dev in a checkout that was copied or moved with its build folder: it builds anew, says so, and never runs the program
# of the old place. Usage: MovedCheckoutTest.sh SOURCE WORK. Nothing is built: a stub stands for cmake.
set -euo pipefail

Source=$1
Work=$2
Failures=0

# Puts a checkout with a finished build, configured for the folder $2, into $1.
MakeCheckout() {
	mkdir -p "$1/build/release/bin" "$1/build/release/libexec/drydock/shader-cache"
	cp "$Source/dev" "$1/dev"
	printf 'CMAKE_BUILD_TYPE:STRING=Release\nCMAKE_HOME_DIRECTORY:INTERNAL=%s\n' "$2" >"$1/build/release/CMakeCache.txt"
	touch "$1/build/release/build.ninja" "$1/build/release/libexec/drydock/shader-cache/warm.stamp"
	printf '#!/bin/sh\necho "the program of %s"\n' "$2" >"$1/build/release/bin/drydock"
	chmod +x "$1/build/release/bin/drydock"
	touch -d '1 hour' "$1/build/.packages" # no package is looked for
}

# Runs $1/dev with the rest; sets Out, Err, Code and Asked (what was asked of cmake).
RunDev() {
	local Checkout=$1; shift
	: >"$Work/asked"
	Code=0
	Out=$(PATH="$Work/bin:$PATH" ASKED="$Work/asked" "$Checkout/dev" "$@" 2>"$Work/err") || Code=$?
	Err=$(cat "$Work/err")
	Asked=$(cat "$Work/asked")
}

Expect() {
	if ! eval "$2"; then
		printf 'FAILED: %s\n  exit %s\n  out: %s\n  err: %s\n  cmake: %s\n' "$1" "$Code" "$Out" "$Err" "$Asked"
		Failures=$((Failures + 1))
	fi
}

rm -rf "$Work"
mkdir -p "$Work/bin"
# Configuring writes the cache, building the program; where the sources are broken, building fails as ninja does.
cat >"$Work/bin/cmake" <<'STUB'
#!/usr/bin/env bash
printf '%s\n' "$*" >>"$ASKED"
case "$1" in
	--preset)
		mkdir -p "build/$2/bin"
		touch "build/$2/build.ninja"
		printf 'CMAKE_HOME_DIRECTORY:INTERNAL=%s\n' "$PWD" >"build/$2/CMakeCache.txt" ;;
	--build)
		Root=$(cd "$2/../.." && pwd)
		[ ! -e "$Root/broken" ] || { echo 'error: expected ;'; exit 1; }
		printf '#!/bin/sh\necho "the program of %s"\n' "$Root" >"$2/bin/drydock"
		chmod +x "$2/bin/drydock" ;;
esac
STUB
chmod +x "$Work/bin/cmake"

MakeCheckout "$Work/old" "$Work/old"
RunDev "$Work/old" list passes
Expect "a checkout in its place is not configured again" '[ "$Code" = 0 ] && ! grep -q -- --preset <<<"$Asked"'
Expect "nor is anything said" '[ -z "$Err" ]'

ln -s "$Work/old" "$Work/link"
RunDev "$Work/link" list passes
Expect "the same folder under another name is the same folder" '! grep -q -- --preset <<<"$Asked"'

cp -a "$Work/old" "$Work/copy"
RunDev "$Work/copy" list passes
Expect "a copy runs its own program" '[ "$Code" = 0 ] && [ "$Out" = "the program of $Work/copy" ]'
Expect "which was configured first" 'grep -q -- "^--preset release" <<<"$Asked"'
Expect "and whose shaders are warmed" 'grep -q drydock_ready <<<"$Asked"'
Expect "and says so, with the old place" 'grep -q "configured for $Work/old, but this checkout was copied or moved" <<<"$Err"'
RunDev "$Work/copy" list passes
Expect "once" '! grep -q -- --preset <<<"$Asked" && [ -z "$Err" ]'

cp -a "$Work/old" "$Work/broken_copy"
touch "$Work/broken_copy/broken"
RunDev "$Work/broken_copy" list passes
Expect "a copy with an error runs nothing" '[ "$Code" = 2 ] && [ -z "$Out" ]'

mv "$Work/old" "$Work/moved"
RunDev "$Work/moved" test
Expect "tests of a moved checkout are built anew" 'grep -q -- "^--preset release" <<<"$Asked"'

MakeCheckout "$Work/first" "$Work/first"
MakeCheckout "$Work/second" "$Work/second"
rm -r "$Work/second/build"
ln -s "$Work/first/build" "$Work/second/build"
RunDev "$Work/second" list passes
Expect "the build folder of another checkout is left alone" '[ "$Code" = 2 ] && [ -x "$Work/first/build/release/bin/drydock" ]'
RunDev "$Work/second" --help
Expect "nor is its program asked for help" '! grep -q "the program of" <<<"$Out"'

[ "$Failures" = 0 ] || exit 1
echo "all as expected"
