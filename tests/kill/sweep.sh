#!/usr/bin/env bash
# Kills `drydock sweep` at random moments (kill -9): a task's process, the shard that watches it, submit with all that it
# started, and reduce; and fills the disk while a task writes. Then looks at what is left: nothing torn, no finished task
# runs twice, and once it is submitted again the same bytes as without.
#
#   sweep.sh BUILD SOURCE WORK [KILLS [SEED]]      such as  tests/kill/sweep.sh build/release . /tmp/sweep_kills 30
#
# BUILD holds bin/drydock; WORK is removed first. 30 kills of seed 1 by default. tests/outside/SlurmTest.sh kills node
# daemons. Prints one line for each round and the sum; ends with 1 at the first thing that is wrong.
set -euo pipefail

Drydock=$(realpath "$1")/bin/drydock Configs=$(realpath "$2")/configs
rm -rf "$3"
mkdir -p "$3"
cd "$3"
Kills=${4:-30}
RANDOM=${5:-1}
export DRYDOCK_CACHE_DIR=$PWD/cache

cat >sweep.json <<END
{"scene": {"file": "$Configs/scenes/moving_camera.####.exr"}, "volumes": "fromScene",
	"sweep": {"frames": "1-3", "outputs": ["png", "exr"], "axes": [
		{"name": "BloomIntensity", "values": [0.5, 1, 2]}, {"name": "r.BloomQuality", "values": [1, 5]}]}}
END

Fail() {
	printf '%s\n' "$*"
	tail -n 5 log.txt
	exit 1
}

# Every result that is there is whole, by the list that it was written with.
ExpectWhole() {
	local Result File
	for Result in out/results/*/*/; do
		case $Result in *'*'* | *.writing.*) continue ;; esac
		for File in result.json .drydock.result.files 0001.png 0002.png 0003.png 0001.exr 0002.exr 0003.exr; do
			[ -s "$Result$File" ] || Fail "torn: $Result$File"
			case $File in *.png | *.exr) "$Drydock" diff "$Result$File" "$Result$File" >log.txt 2>&1 || Fail "torn: $Result$File" ;; esac
		done
	done
	for File in out/table.json out/plan.json; do
		[ ! -e $File ] || jq empty $File || Fail "torn: $File"
	done
}

# A finished result is the same file for good: its inode and its time do not change.
Remember() { find out/results -mindepth 3 -name result.json -not -path '*.writing.*' -printf '%i %T@ %p\n' 2>/dev/null | sort || true; }

Sum() { (cd "$1" && find results plots table.json table.csv sheet.png tasks.jsonl -type f ! -path '*.writing.*' -print0 | sort -z | xargs -0 sha256sum | sha256sum); }

"$Drydock" sweep plan sweep.json --out whole >log.txt 2>&1 || Fail plan
Begin=$(date +%s%N)
"$Drydock" sweep submit whole >log.txt 2>&1 || Fail submit
Ms=$((($(date +%s%N) - Begin) / 1000000))
Begin=$(date +%s%N)
"$Drydock" sweep reduce whole >log.txt 2>&1 || Fail reduce
ReduceMs=$((($(date +%s%N) - Begin) / 1000000))
Whole=$(Sum whole)
printf 'undisturbed: %s ms, %s\n' $Ms "$Whole"

Round=0 Done=0 Calls=0
while [ $Done -lt "$Kills" ]; do
	Round=$((Round + 1))
	rm -rf out
	"$Drydock" sweep plan sweep.json --out out >log.txt 2>&1 || Fail plan
	for ((Each = 2 + RANDOM % 5; Each > 0 && Done < Kills; --Each, ++Calls)); do
		Before=$(Remember)
		# Once all is done, reduce is killed. Before that a task's process, the shard that watches it, or submit.
		if [ "$("$Drydock" sweep status out --json | jq '.tasks - .done')" = 0 ]; then Kind=reduce Span=1; else Kind=$((RANDOM % 3)) Span=0.5; fi
		case $Kind in
			reduce) setsid "$Drydock" sweep reduce out >log.txt 2>&1 & ;;
			*) setsid "$Drydock" sweep submit out >log.txt 2>&1 & ;;
		esac
		Child=$!
		[ $Kind = reduce ] && Most=$ReduceMs || Most=$Ms
		sleep "$(awk -v Part=$RANDOM -v Ms=$Most -v Span=$Span 'BEGIN { print Part / 32768 * Ms * Span / 1000 }')"
		Victim=
		while [ -z "$Victim" ] && kill -0 $Child 2>/dev/null; do
			case $Kind in
				0) Victim=$(pgrep -f "sweep exec $PWD/out --here" | head -n 1 || true) ;; # a task
				1) Victim=$(pgrep -f "sweep exec $PWD/out --index" | head -n 1 || true) ;; # a shard
				*) Victim=$Child ;;
			esac
		done
		if [ -n "$Victim" ] && kill -KILL "$Victim" 2>/dev/null; then Done=$((Done + 1)); fi
		wait $Child 2>/dev/null || true
		for ((Wait = 0; Wait < 100; ++Wait)); do pgrep -f "sweep exec $PWD/out" >/dev/null || break; sleep 0.1; done
		ExpectWhole
		After=$(Remember)
		[ -z "$(comm -23 <(printf '%s' "$Before") <(printf '%s' "$After"))" ] || Fail "a finished task ran again"
	done
	if [ $((Round % 3)) = 0 ] && Full=$(mktemp -d) && mount -t tmpfs -o size=400k none "$Full" 2>/dev/null; then
		# The disk is full in the midst of tasks.
		"$Drydock" sweep plan sweep.json --out "$Full/out" --yes >log.txt 2>&1 || Fail "plan on a small disk"
		"$Drydock" sweep exec "$Full/out" >log.txt 2>&1 && Fail "a full disk is not told"
		mount -o remount,size=100m "$Full"
		"$Drydock" sweep submit "$Full/out" >log.txt 2>&1 || Fail "it does not go on after a full disk"
		[ "$(Sum "$Full/out")" = "$Whole" ] || Fail "other bytes after a full disk"
		umount "$Full"
		rmdir "$Full"
		Disk=" and a full disk"
	fi
	"$Drydock" sweep submit out >log.txt 2>&1 || Fail "it does not go on"
	[ "$(Sum out)" = "$Whole" ] || Fail "other bytes: $(diff -rq whole out | head -n 3)"
	Left=$(find out -name '*.writing.*' ! -empty -print -quit)
	[ -z "$Left" ] || Fail "left: $Left"
	printf 'round %s: the same bytes after %s kills%s\n' $Round $Done "${Disk:-}"
	Disk=
done
printf '%s kills of %s calls in %s rounds: nothing torn, nothing twice, the same bytes\n' $Done $Calls $Round
