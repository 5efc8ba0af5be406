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
#   <!-- figures ... -->   holds commands that print figures of the page; see below
#   <!-- not run: WHY -->  before a block: it is not run, nor compared
#   `! COMMAND`            in sh and check must fail
# Helpers of check blocks: `wait_for 'COMMAND'`, until it succeeds; $DRYDOCK_SOURCE, the checkout.
#
# A text block is the whole output, errors included. Runs of spaces count as one, empty lines as none. `...` stands for what
# is left out: in a line for any text, alone in a line for any lines. Milliseconds and seconds (`12.3 ms`, `0.05 sec`), and the
# bar behind them, may be others.
#
# A figures block prints lines as they stand somewhere behind it in the page: rows of a table or words of a sentence. Words
# and signs must be the same, numbers the page's when rounded to as many digits as the page has; `<!-- figures within 3%`
# allows that much besides. In a line `...` stands for words of the page that are not compared, no further than a table's row.
# Spaces within numbers (12 345), line breaks, backticks and asterisks do not count.
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
	/^<!-- not run: .* -->$/   { Skipped = 1; next }
	/^```/ && !Mode && Skipped { Mode = "shown"; Skipped = 0; next }
	/^```sh$/                  { Mode = "sh"; Printed = Steps "/" NR; Begin(); print "{"; next }
	/^```text$/                { Mode = "text"; Begin(); print "ExpectIn " Printed " <<\"END_OF_TEXT\""; next }
	/^```diff$/                { Mode = "diff"; Begin(); print "Apply <<\"END_OF_DIFF\""; next }
	/^<!-- file [^ ]+ -->$/    { File = $3; next }
	/^```/ && !Mode            { Mode = "shown"; next }
	/^<!-- check$/             { Mode = "check"; Check = Steps "/" NR; Begin(); print "{"; next }
	/^<!-- figures( within [0-9.]+%)?$/ { Mode = "figures"; Within = $4 + 0; Check = Steps "/" NR; Begin(); print "{"; next }
	/^-->$/ && Mode == "figures" { print "} >" Check ".figures 2>" Check; print "Figures " NR " " Within " " Check ".figures"; Mode = ""; next }
	/^```$/ && Mode == "sh"    { print "} >" Printed " 2>&1"; Mode = ""; next }
	/^-->$/ && Mode == "check" { print "} >" Check " 2>&1"; Mode = ""; next }
	/^```$/ && Mode != "check" && Mode != "figures" { if (Mode != "shown") { print "END_OF_" toupper(Mode) } Mode = ""; next }
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
	if gdb -batch -ex run --args /bin/true 2>&1 | grep 'exited normally' >/dev/null; then
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

# Figures LINE PERCENT FILE: looks for the lines of the file in the page, from the line on.
Figures() {
	Log=$3.log
	[ -s "$3" ] || { echo "no figure was printed" >"$Log"; return 1; }
	awk -v From="$1" -v Within="$2" '
		function Clean(Text,  Place) {
			gsub(/[`*]/, "", Text)
			gsub(/\|/, " | ", Text)
			while (match(Text, /(^|[^0-9.])[0-9][0-9]?[0-9]? [0-9][0-9][0-9]([^0-9.]|$)/)) {
				Place = RSTART + index(substr(Text, RSTART + 1), " ")
				Text = substr(Text, 1, Place - 1) substr(Text, Place + 1)
			}
			return Text
		}
		# Sets Before, Number, After of a word; 0 where there is no number in it.
		function Split(Word) {
			if (!match(Word, /-?[0-9]+(\.[0-9]+)?(e-?[0-9]+)?/)) { return 0 }
			Before = substr(Word, 1, RSTART - 1)
			Number = substr(Word, RSTART, RLENGTH)
			After = substr(Word, RSTART + RLENGTH)
			return 1
		}
		# Half of what the last digit counts.
		function Half(Written,  Mantissa, Exponent) {
			Mantissa = Written
			Exponent = sub(/e.*/, "", Mantissa) ? substr(Written, length(Mantissa) + 2) + 0 : 0
			return 0.5000001 * 10 ^ (Exponent - (index(Mantissa, ".") ? length(Mantissa) - index(Mantissa, ".") : 0))
		}
		function IsSame(Printed, Shown,  Prefix, Value, Suffix, Distance) {
			sub(/[,.;:]+$/, "", Printed)
			sub(/[,.;:]+$/, "", Shown)
			if (Printed == Shown) { return 1 }
			if (!Split(Printed)) { return 0 }
			Prefix = Before; Value = Number + 0; Suffix = After
			if (!Split(Shown) || Before != Prefix || After != Suffix) { return 0 }
			Distance = Number - Value
			Distance = Distance < 0 ? -Distance : Distance
			return Distance <= Half(Number) + Within / 100 * (Value < 0 ? -Value : Value)
		}
		function Match(At, Place) {
			if (At > Furthest) { Furthest = At; FurthestPlace = Place }
			if (At == NumWords) { return Words[At] != "|" || Page[Place] == "\n" }
			if (Words[At + 1] == "...") {
				for (; Place <= NumPage; ++Place) {
					if (Match(At + 1, Place)) { return 1 }
					if (Page[Place] == "\n") { return 0 }
				}
				return At + 1 == NumWords
			}
			return Place <= NumPage && IsSame(Words[At + 1], Page[Place]) ? Match(At + 1, Place + 1) : 0
		}
		BEGIN { NumPage = 0 }
		FNR == NR && FNR <= From { next }
		{ Line = $0; Count = split(Clean(Line), Words, " ") }
		FNR == NR {
			for (Index = 1; Index <= Count; ++Index) { Page[++NumPage] = Words[Index] }
			if (Line ~ /^\|.*\|$/) { Page[++NumPage] = "\n" }
			next
		}
		{
			NumWords = Count
			Furthest = -1
			for (Place = 1; Place <= NumPage && !Match(0, Place); ++Place) {}
			if (Place <= NumPage) { next }
			Shown = ""
			for (Index = 0; Index < 8; ++Index) { Shown = Shown " " Page[FurthestPlace + Index] }
			print "the page has no such figures:  " Line
			print "from the word \"" Words[Furthest + 1] "\" on it has:  " Shown
			Failed = 1
		}
		END { exit Failed }
	' "$Page" "$3" >"$Log"
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
printf '%s steps passed, 0 failed\n' "$(awk '/^Begin/ { ++N } END { print N + 0 }' "$Work/page.sh")"
