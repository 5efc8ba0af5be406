#!/usr/bin/env bash
# What RunPage.sh lets pass and what not, by pages of a few lines.
#
#   RunPageTest.sh BUILD SOURCE WORK
set -euo pipefail

Runner=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/RunPage.sh
Build=$1 Source=$2 Work=$3
rm -rf "$Work"
mkdir -p "$Work"
Count=0

# Expect passes|fails WHAT: the page on stdin.
Expect() {
	local Result=passes
	cat >"$Work/page.md"
	"$Runner" --from-nothing "$Build" "$Source" "$Work/page.md" "$Work/run" >"$Work/log" 2>&1 || Result=fails
	[ $Result = "$1" ] || { echo "RunPageTest: $2: $Result"; cat "$Work/log"; exit 1; }
	Count=$((Count + 1))
}

# Prints passes|fails WHAT TEXT SHOWN: a page whose command prints TEXT, and which shows SHOWN.
Prints() { Expect "$1" "$2" < <(printf '```sh\nprintf '"'%s'"'\n```\nWords.\n```text\n%b\n```\n' "$3" "$4"); }

Prints passes 'the output as it is' 'a 0.125\nb\n' 'a  0.125\n\nb'
Prints fails 'a digit less' 'a 0.125\n' 'a 0.12'
Prints fails 'another digit' 'a 0.125\n' 'a 0.126'
Prints fails 'another number where the line begins' '  1  a\n' '2 a'
Prints fails 'a line left out in silence' 'a\nb\nc\n' 'a\nc'
Prints fails 'the last line left out in silence' 'a\nb\nc\n' 'a\nb'
Prints fails 'a line too many' 'a\nb\n' 'a\nb\nc'
Prints fails 'another order' 'a\nb\nc\n' 'b\na\nc'
Prints passes 'lines left out, with a line like the wanted one among them' 'a\nb\nc\nb\nd\n' '...\nb\nd'
Prints fails 'lines left out before one that is not there' 'a\nb\nc\n' 'a\n...\nd'
Prints passes 'nothing left out' 'a\nb\n' 'a\nb\n...'
Prints passes 'text left out' 'a 17 b\n' 'a ... b'
Prints fails 'no pattern but the dots' 'a.b\n' 'a+b'
Prints passes 'other times' 'in 12.5 ms, 3 s\n' 'in 7 ms, 20.25 s'
Prints fails 'a number of what is no time' 'in 12 steps\n' 'in 13 steps'
Expect fails 'a command that fails' <<'END'
```sh
false
true
```
END
Expect fails 'a command that ought to fail' <<'END'
```sh
! true
```
END
Expect passes 'a file, a change to it, and what a reader sees' <<'END'
<!-- file folder/some.json -->
```json
{ "a": 1 }
```
```diff
--- a/folder/some.json
+++ b/folder/some.json
@@ -1 +1 @@
-{ "a": 1 }
+{ "a": 2 }
```
<!-- check
grep -q 2 folder/some.json
! grep -q 1 folder/some.json
-->
```cpp
not run
```
END
Expect fails 'a check that fails' <<'END'
<!-- check
test -e nowhere
-->
END
Expect fails 'a block without an end' <<'END'
```sh
true
END

# Figures passes|fails WHAT PRINTED PAGE: a page with a figures block that prints PRINTED, and the text PAGE behind it.
Figures() { Expect "$1" "$2" < <(printf 'Before 1.5.\n<!-- figures%s\nprintf '"'%s'"'\n-->\n\n%b\n' "${5:-}" "$3" "$4"); }

Figures passes 'a row, rounded as the page rounds' '| a | 0.1249 | 17.04 |\n' '| | x | y |\n|---|---|---|\n| a | 0.12 | 17 |'
Figures fails 'a row with a last digit too large' '| a | 0.1249 | 17.04 |\n' '| a | 0.13 | 17 |'
Figures fails 'a row with a number too many' '| a | 0.1249 |\n' '| a | 0.12 | 17 |'
Figures passes 'a row whose middle is not compared' '| a | ... | 17.04 |\n' '| a | some words, 3 | 17 |'
Figures fails 'a row that goes on in the next one' '| a | ... | 18.04 |\n' '| a | words | 17 |\n| b | words | 18 |'
Figures passes 'a sentence' 'off by 0.00981 at quality 4, 3.4e-7 at 5\n' 'It is off by\n**0.0098** at\n`quality 4`, 3e-7 at 5.'
Figures fails 'a sentence with another number' 'off by 0.00991 at quality 4\n' 'It is off by\n0.0098 at quality 4.'
Figures fails 'a sentence that stands before' 'Before 1.5\n' 'nothing'
Figures passes 'thousands' '| a | 200231.7 |\n' '| a | 200 232 |'
Figures passes 'a stated bound' '| a | 103 |\n' '| a | 100 |' ' within 3%'
Figures fails 'more than a stated bound' '| a | 104 |\n' '| a | 100 |' ' within 3%'
Figures fails 'no figures at all' '' 'nothing'
Expect passes 'a block that is not run' <<'END'
<!-- not run: it would fail -->
```sh
false
```
END
echo "RunPageTest: $Count pages as expected"
