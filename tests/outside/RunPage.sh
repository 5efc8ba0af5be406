#!/usr/bin/env bash
# Does what a page of docs/ says, as its reader would: all its commands in order, in a scratch folder with a home of its
# own, by a drydock that is built already.
#
#   RunPage.sh [--from-nothing] BUILD SOURCE PAGE WORK
#
# In the page,
#   ```sh                  is run; all blocks share one shell, and the first command that fails ends the test
#   ```text                is what the sh block before it printed, to the digit; see below
#   ```diff                is applied to the files in the current folder
#   <!-- file PATH -->     before another block: that block is the content of a new file
#   <!-- check ... -->     holds commands for what a reader sees with his eyes; they must succeed
#   `! COMMAND`            in both must fail
# Helpers of check blocks: `wait_for 'COMMAND'`, until it succeeds; $DRYDOCK_SOURCE, the checkout.
#
# A text block is the whole output, errors included. Runs of spaces count as one, empty lines as none. `...` stands for what
# is left out: in a line for any text, alone in a line for any lines. Milliseconds and seconds (`12.3 ms`, `0.05 sec`), and the
# bar behind them, may be others.
#
# The reader stands in a checkout, with copies of configs/ and docs/, ./dev and build/release/bin/drydock. With --from-nothing
# he stands in an empty folder, has no shaders compiled, and `git clone` gives him `dev` alone. Stood in for are `git clone`,
# and of `./dev` and `./dev install` the packages and the compilation: BUILD has both behind it.
set -euo pipefail

FromNothing=no
if [ "$1" = --from-nothing ]; then FromNothing=yes; shift; fi
Git=$(command -v git)
Build=$(realpath "$1") Source=$(realpath "$2") Page=$(realpath "$3")
rm -rf "$4"
mkdir -p "$4/home" "$4/stand-ins" "$4/steps"
Work=$(realpath "$4")
Checkout=$Work/drydock

# A clone is what `./dev` needs to believe that it has built.
cat >"$Work/stand-ins/git" <<END
#!/bin/sh
[ "\$1" = clone ] || exec '$Git' "\$@"
mkdir -p "\$3/build/release"
cp '$Source/dev' "\$3/dev"
touch "\$3/build/.packages"
ln -s '$Build/bin' "\$3/build/release/bin"
END
cat >"$Work/stand-ins/cmake" <<END
#!/bin/sh
case "\$1 \$2" in
	"--preset "*|"--build $Checkout/"*) ;;
	"--install $Checkout/"*) shift 2; exec '$(command -v cmake)' --install '$Build' "\$@" ;;
	*) exec '$(command -v cmake)' "\$@" ;;
esac
END
chmod +x "$Work"/stand-ins/*

# The page as a script: every block a group whose output is kept.
awk -v Steps="$Work/steps" '
	function Begin() { print "Begin " NR " " Steps "/" NR }
	/^```/ && !Mode && File    { Mode = "file"; Begin(); print "Write " File " <<\"END_OF_FILE\""; File = ""; next }
	/^```sh$/                  { Mode = "sh"; Printed = Steps "/" NR; Begin(); print "{"; next }
	/^```text$/                { Mode = "text"; Begin(); print "ExpectIn " Printed " <<\"END_OF_TEXT\""; next }
	/^```diff$/                { Mode = "diff"; Begin(); print "Apply <<\"END_OF_DIFF\""; next }
	/^<!-- file [^ ]+ -->$/    { File = $3; next }
	/^```/ && !Mode            { Mode = "shown"; next }
	/^<!-- check$/             { Mode = "check"; Check = Steps "/" NR; Begin(); print "{"; next }
	/^```$/ && Mode == "sh"    { print "} >" Printed " 2>&1"; Mode = ""; next }
	/^-->$/ && Mode == "check" { print "} >" Check " 2>&1"; Mode = ""; next }
	/^```$/ && Mode != "check" { if (Mode != "shown") { print "END_OF_" toupper(Mode) } Mode = ""; next }
	Mode == "sh" || Mode == "check" { sub(/^! /, "Fails "); sub(/^gdb /, "WithDebugger gdb ") }
	Mode && Mode != "shown"
	END                        { if (Mode || File) { print "Unfinished " NR } }
' "$Page" >"$Work/page.sh"

Begin() { Line=$1 Log=$2 Printed=; printf '%s:%s\n' "$(basename "$Page")" "$1"; }

Unfinished() { Line=$1; echo "a block has no end"; return 1; }

# `!` alone would not end the shell when the command succeeds.
Fails() { if "$@"; then echo "this succeeded: $*"; return 1; fi; }

Apply() { "$Git" apply --verbose - >"$Log" 2>&1; }

Write() { mkdir -p "$(dirname "$1")" && cat >"$1"; }

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

# Compares stdin, a text block, with the file.
ExpectIn() {
	grep -q '^LEFT OUT' "$1" && return
	Printed=$1
	awk '
		function Pattern(Text) {
			Text = Text " "
			while (match(Text, /[0-9]+(\.[0-9]+)? (ms|s|sec)[^a-z]/)) {
				Time = substr(Text, RSTART, RLENGTH)
				sub(/^[0-9.]+ /, "\001", Time)
				Text = substr(Text, 1, RSTART - 1) Time substr(Text, RSTART + RLENGTH)
			}
			sub(/ $/, "", Text)
			gsub(/\.\.\./, "\002", Text)
			gsub(/[][\\.^$*+?(){}|]/, "\\\\&", Text)
			gsub(/\001/, "[0-9]+([.][0-9]+)? ", Text)
			gsub(/\002/, ".*", Text)
			return "^" Text "$"
		}
		BEGIN { Wanted = Count = Next = At = Failed = 0 }
		{ gsub(/[ \t\r]+/, " "); sub(/^ /, ""); sub(/ $/, ""); sub(/ ms #+$/, " ms") }
		$0 == "" { next }
		FNR == NR { Shown[Wanted] = $0; Match[Wanted++] = Pattern($0); next }
		{ Line[Count++] = $0 }
		END {
			# A `...` takes as few lines as will do: when the rest does not fit, one more.
			Gap = -1
			while (At < Count) {
				if (Shown[Next] == "...") { Gap = Next++; Back = At }
				else if (Next < Wanted && Line[At] ~ Match[Next]) { ++Next; ++At }
				else if (Gap >= 0) { Failed = Next > Failed ? Next : Failed; Next = Gap + 1; At = ++Back }
				else break
			}
			if (Shown[Next] == "..." && Next == Wanted - 1) { ++Next }
			if (At == Count && Next == Wanted) { exit 0 }
			Next = Next > Failed ? Next : Failed
			print "the page shows:    " (Next < Wanted ? Shown[Next] : "(no more)")
			if (Gap < 0) { print "what was printed:  " (At < Count ? Line[At] : "(no more)") }
			exit 1
		}
	' - "$1" >"$Log"
}

Finish() {
	local Result=$?
	kill $(jobs -p) 2>/dev/null || true
	if [ $Result != 0 ]; then
		printf '%s:%s: this step failed (%s)\n' "$Page" "$Line" "$Result"
		tail -n 40 "$Log" || true
		[ -z "$Printed" ] || { echo "what was printed:"; tail -n 40 "$Printed"; }
	fi
	exit $Result
}
Line=0 Log=/dev/null Printed=
trap Finish EXIT

export HOME=$Work/home PATH=$Work/stand-ins:$PATH DRYDOCK_SOURCE=$Source
if [ $FromNothing = yes ]; then
	unset DRYDOCK_CACHE_DIR XDG_CACHE_HOME
	cd "$Work"
else
	git clone --quiet "$Checkout"
	touch "$Checkout/build/release/build.ninja"
	cp -r "$Source/configs" "$Source/docs" "$Checkout/"
	export PATH=$Checkout/build/release/bin:$PATH
	cd "$Checkout"
fi
. "$Work/page.sh"
grep -c '^Begin' "$Work/page.sh" | sed 's/$/ steps passed, 0 failed/'
