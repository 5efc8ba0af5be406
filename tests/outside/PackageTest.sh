#!/usr/bin/env bash
# The packages as others get them: cpack makes both, lintian finds no error in the Debian package, and each of them, unpacked
# into an empty folder, makes, builds and runs a patch while the checkout and the build folder are out of sight.
#
#   PackageTest.sh BUILD SOURCE WORK
#
# Exit code 77: this machine lacks a program that the test calls, or lets nobody hide a folder; stdout says which.
set -euo pipefail

Build=$(realpath "$1") Source=$(realpath "$2") Work=$3
Room=$(mktemp -d "${TMPDIR:-/tmp}/drydock-package-XXXXXX")
trap 'rm -rf "$Room"' EXIT

Skip() { echo "SKIPPED: $*"; exit 77; }
Fail() { echo "FAILED: $*"; exit 1; }
for Tool in cpack file dpkg-deb dpkg-shlibdeps lintian unshare; do
	command -v $Tool >/dev/null 2>&1 || Skip "there is no program $Tool here (./dev package installs dpkg-dev, file and lintian)"
done
Apart=(unshare --mount)
[ "$(id -u)" = 0 ] || Apart=(unshare --user --map-root-user --mount)
"${Apart[@]}" mount -t tmpfs none "$Room" 2>"$Room/log" || Skip "no folder can be hidden here: $(cat "$Room/log")"

rm -rf "$Work"
mkdir -p "$Work"
cpack --config "$Build/CPackConfig.cmake" -B "$Work" >"$Work/log" 2>&1 || { cat "$Work/log"; Fail "cpack"; }
rm -rf "$Work/_CPack_Packages"
Package=$(echo "$Work"/drydock_*.deb) Tarball=$(echo "$Work"/drydock-*.tar.gz)
ls -l "$Package" "$Tarball"

Depends=", $(dpkg-deb -f "$Package" Depends),"
for Wanted in g++ 'cmake (>= 3.25)' 'ninja-build | make' libglm-dev libc6 'libstdc++6' libopenexr libopenimageio; do
	case "$Depends" in *", $Wanted"*) ;; *) Fail "the package does not depend on $Wanted: $Depends" ;; esac
done
lintian --no-cfg --fail-on error "$Package" || Fail "lintian finds errors"

mkdir "$Room/root" "$Room/elsewhere"
dpkg-deb -x "$Package" "$Room/root"
tar -xzf "$Tarball" -C "$Room/elsewhere"
for Document in copyright changelog.gz; do
	[ -s "$Room/root/usr/share/doc/drydock/$Document" ] || Fail "the package lacks $Document"
done
zcat "$Room/root/usr/share/man/man1/drydock.1.gz" | grep explain >/dev/null || Fail "the manual page knows no verb explain"

# As a reader walks who has the package alone. The first frame has no compiler: its shaders come with the package.
cat >"$Room/walk.sh" <<'END'
set -euo pipefail
Build=$1 Source=$2 Prefix=$3 Walk=$4
for Folder in "$Source" "$Build"; do
	[ ! -d "$Folder" ] || mount -t tmpfs none "$Folder"
	[ -z "$(ls -A "$Folder" 2>/dev/null)" ] || { echo "$Folder is in sight"; exit 1; }
done
mkdir -p "$Walk/home"
cd "$Walk"
unset DRYDOCK_CACHE_DIR XDG_CACHE_HOME CMAKE_PREFIX_PATH LD_LIBRARY_PATH
export HOME=$Walk/home PATH=$Prefix/bin:$PATH
drydock --version
drydock new MyPatch
echo '{"scene": {"file": "MyPatch/configs/scenes/room.exr"}}' >frame.json
DRYDOCK_CXX=no-compiler drydock run frame.json
test -s out/frame/final.png
drydock build MyPatch
drydock run MyPatch/configs/MyPatch.json --plugin build/MyPatch/cmake/libMyPatch.so --report on
test -s out/MyPatch/final.png
test -s out/MyPatch/report.html
grep -q '"name": "MyPatch' out/MyPatch/run.json
if drydock diff out/frame/final.png out/MyPatch/final.png --max 0 >/dev/null 2>&1; then
	echo "the patch draws nothing"
	exit 1
fi
END

# Walk PREFIX: with the program that is unpacked there.
Walk() {
	echo "-- from $1"
	rm -rf "$Room/walk"
	(cd "$Room" && "${Apart[@]}" bash "$Room/walk.sh" "$Build" "$Source" "$1" "$Room/walk") || Fail "what is unpacked in $1"
}
Walk "$Room/root/usr"
Walk "$(echo "$Room"/elsewhere/drydock-*)"
mv "$Room"/elsewhere/drydock-* "$Room/moved"
Walk "$Room/moved"
echo "all as expected"
