#!/usr/bin/env bash
# Does what docs/first-patch.md says, as a newcomer would: all its commands in order, in a scratch folder with a home of
# its own, against a fresh install of a drydock that is built already.
#
#   FirstPatchTest.sh BUILD SOURCE WORK
#
# In the page,
#   ```sh              is run; all blocks share one shell, and the first command that fails ends the test
#   ```diff            is applied to the files in the current folder
#   ```text            shows lines that the block before it printed, in this order, each from its beginning; a number that
#                      a line begins with, as passes have, may be another
#   <!-- check ... --> holds commands for what a reader sees with his eyes; they must succeed
#
# Stood in for are only `git clone`, and of `./dev install` the packages and the compilation: BUILD has both behind it.
set -euo pipefail

Git=$(command -v git)
Build=$(realpath "$1") Source=$(realpath "$2")
Page=$Source/docs/first-patch.md
rm -rf "$3"
mkdir -p "$3/home" "$3/stand-ins" "$3/steps"
Work=$(realpath "$3")

cat >"$Work/stand-ins/git" <<END
#!/bin/sh
mkdir -p "\$3/build" && cp '$Source/dev' "\$3/dev" && touch "\$3/build/.packages"
END
cat >"$Work/stand-ins/cmake" <<END
#!/bin/sh
case "\$1 \$2" in
	"--preset "*|"--build $Work/drydock/"*) ;;
	"--install $Work/drydock/"*) shift 2; exec '$(command -v cmake)' --install '$Build' "\$@" ;;
	*) exec '$(command -v cmake)' "\$@" ;;
esac
END
chmod +x "$Work"/stand-ins/*

# The page as a script: every block a group whose output is kept.
awk -v Steps="$Work/steps" '
	/^```sh$/            { Mode = "sh"; Step = Steps "/" NR; print "Begin " NR " " Step "; {"; next }
	/^```text$/          { Mode = "text"; print "Begin " NR " " Step ".text; ExpectIn " Step " <<\"END_OF_TEXT\""; next }
	/^```diff$/          { Mode = "diff"; print "Begin " NR " " Steps "/" NR "; Apply <<\"END_OF_DIFF\""; next }
	/^<!-- check$/       { Mode = "check"; print "Begin " NR " " Steps "/" NR "; {"; Check = Steps "/" NR; next }
	/^```$/ && Mode      { print (Mode == "sh" ? "} >" Step " 2>&1" : "END_OF_" toupper(Mode)); Mode = ""; next }
	/^-->$/ && Mode == "check" { print "} >" Check " 2>&1"; Mode = ""; next }
	Mode == "text" || Mode == "diff" { print; next }
	Mode                 { sub(/^! /, "Fails "); sub(/^gdb /, "WithDebugger gdb "); print }
' "$Page" >"$Work/page.sh"

Begin() { Line=$1 Log=$2; printf 'first-patch.md:%s\n' "$1"; }

# `!` alone would not end the shell when the command succeeds.
Fails() { if "$@"; then echo "this succeeded: $*"; return 1; fi; }

Apply() { "$Git" apply --verbose - >"$Log" 2>&1; }

# wait_for COMMAND: until it succeeds, a minute at most.
wait_for() {
	local Tries=0
	until eval "$1"; do
		[ $((Tries += 1)) -le 600 ] || { echo "in vain: $1"; return 1; }
		sleep 0.1
	done
}

# Not every machine has a debugger or lets one look into a process.
WithDebugger() {
	if gdb -batch -ex run --args /bin/true 2>&1 | grep -q 'exited normally'; then
		"$@"
	else
		echo "LEFT OUT: no debugger here"
	fi
}

# The lines of stdin begin lines of the file, in this order; spaces count as one.
ExpectIn() {
	grep -q '^LEFT OUT' "$1" && return
	awk '
		BEGIN { Count = Next = 0 }
		{ gsub(/[ \t]+/, " "); sub(/^ /, ""); sub(/^[0-9]+/, "0") }
		FNR == NR { Wanted[Count++] = $0; next }
		Next < Count && index($0, Wanted[Next]) == 1 { ++Next }
		END { if (Next < Count) { print "not printed, or not in this order: " Wanted[Next]; exit 1 } }
	' - "$1" >"$Log"
}

Finish() {
	local Result=$?
	kill $(jobs -p) 2>/dev/null || true
	if [ $Result != 0 ]; then
		printf '%s:%s: this step failed (%s)\n' "$Page" "$Line" "$Result"
		tail -n 40 "$Log" || true
		[ "${Log%.text}" = "$Log" ] || { echo "what was printed:"; tail -n 40 "${Log%.text}"; }
	fi
	exit $Result
}
Line=0 Log=/dev/null
trap Finish EXIT

export HOME=$Work/home PATH=$Work/stand-ins:$PATH DRYDOCK_SOURCE=$Source
unset DRYDOCK_CACHE_DIR XDG_CACHE_HOME
cd "$Work"
. "$Work/page.sh"
grep -c '^Begin' "$Work/page.sh" | sed 's/$/ steps passed, 0 failed/'
