#!/usr/bin/env bash
# Kills `drydock run`, `run --frames` and `study` at random moments (kill -9) and looks at what is left: every file whole,
# nothing of the killed ones after the next call but an empty folder, and the same bytes as without.
#
#   run.sh BUILD SOURCE WORK [KILLS [SEED]]      such as  tests/kill/run.sh build/release . /tmp/kills 200
#
# BUILD holds bin/drydock; WORK is removed first. 20 kills of seed 1 by default; they take about a minute and a half on two
# cores, which is why no test run makes them (SequenceProgramTest.cpp kills twenty sequences). Prints one line for each
# round and the sum; ends with 1 at the first thing that is wrong.
set -euo pipefail

Drydock=$(realpath "$1")/bin/drydock Configs=$(realpath "$2")/configs
rm -rf "$3"
mkdir -p "$3/tmp"
cd "$3"
Kills=${4:-20}
RANDOM=${5:-1}
export TMPDIR=$PWD/tmp DRYDOCK_CACHE_DIR=$PWD/cache

cat >sequence.json <<END
{"scene": {"file": "$Configs/scenes/moving_camera.####.exr"}, "volumes": "fromScene",
	"passes": [
		{"type": "GaussianBlur", "at": "SSRInput", "name": "Kept"},
		{"type": "Downsample", "at": "MotionBlur", "name": "Shown", "inputs": {"Input": "CustomSSRInput"}}]}
END
cat >study.json <<END
{"scene": {"file": "$Configs/scenes/two_boxes.exr"},
	"study": {"repetitions": 1, "axes": [{"name": "r.BloomQuality", "values": [1, 5]}]}}
END

# Choose KIND FOLDER: sets Command. `compile` has a cache of its own, and shaders that are in no other.
Choose() {
	case $1 in
		run) Command=("$Drydock" run "$Configs/neutral.json" --dump 'Bloom*') ;;
		bare) Command=("$Drydock" run "$Configs/neutral.json") ;;
		sequence) Command=("$Drydock" run sequence.json --frames 2-4) ;;
		study) Command=("$Drydock" study study.json) ;;
		compile)
			Command=(env "DRYDOCK_CACHE_DIR=$PWD/cache.compile" "$Drydock" run "$Configs/neutral.json" --precision double)
			;;
	esac
	Command+=(--out "$2")
}

# Call KIND FOLDER: to the end.
Call() {
	Choose "$1" "$2"
	"${Command[@]}" >log.txt 2>&1
}

Fail() {
	printf '%s\n' "$*"
	tail -n 5 log.txt
	exit 1
}

Now() { date +%s%N; }

# Everything in the folder that somebody may look at can be read.
ExpectWhole() {
	local File
	while IFS= read -r -d '' File; do
		case $File in
			*.exr | *.png) "$Drydock" diff "$File" "$File" >log.txt 2>&1 || Fail "torn: $File" ;;
			*.json) jq empty "$File" >log.txt 2>&1 || Fail "torn: $File" ;;
			*) [ -s "$File" ] || Fail "empty: $File" ;;
		esac
	done < <(find "$1" -name '*.writing.*' -prune -o -type f ! -name .drydock.lock -print0)
}

ExpectNothingLeft() {
	local Left
	Left=$(find . tmp -mindepth 1 \( -name '*.writing.*' -o -name .drydock.lock -o -name 'drydock-*' \) ! -empty -print -quit)
	[ -z "$Left" ] || Fail "left: $Left"
}

# The same bytes as without kills; what times are in, or follows from them, is there.
ExpectSame() {
	local Difference
	Difference=$(diff -rq whole."$1" "$2" | grep -Ev '(timing\.json|trace\.json|study_timing\.(json|csv)|study\.svg)' |
		grep -Ev 'study.*(insets|\.drydock\.study\.files)' || true)
	[ -z "$Difference" ] || Fail "other than undisturbed: $Difference"
}

declare -A Duration
for Kind in run bare sequence study; do
	Call $Kind "warm.$Kind" || Fail "$Kind"
	Begin=$(Now)
	Call $Kind "whole.$Kind" || Fail "$Kind"
	Duration[$Kind]=$((($(Now) - Begin) / 1000000))
	printf '%s: %s ms undisturbed\n' "$Kind" "${Duration[$Kind]}"
done
Call compile whole.compile || Fail compile
Duration[compile]=3000

Kinds=(run sequence study bare sequence study run sequence study compile)
Killed=0 Ended=0
for ((Round = 0, Done = 0; Done < Kills; ++Round)); do
	Kind=${Kinds[$((Round % ${#Kinds[@]}))]}
	# A run replaces the outputs of one with other dumps.
	Out=out.${Kind/bare/run}
	case $Kind in
		sequence) rm -rf "$Out" ;;
		compile) rm -rf cache.compile ;;
	esac
	Here=$((1 + RANDOM % 4))
	for ((; Here > 0 && Done < Kills; --Here, ++Done)); do
		Choose $Kind "$Out"
		"${Command[@]}" >log.txt 2>&1 &
		Child=$!
		sleep "$(awk -v Part="$RANDOM" -v Ms="${Duration[$Kind]}" 'BEGIN { print Part / 32768 * Ms / 1000 }')"
		if kill -KILL $Child 2>/dev/null; then Killed=$((Killed + 1)); else Ended=$((Ended + 1)); fi
		wait $Child 2>/dev/null || true
		[ ! -d "$Out" ] || ExpectWhole "$Out"
	done
	Call $Kind "$Out" || Fail "$Kind does not go on"
	ExpectWhole "$Out"
	ExpectNothingLeft
	ExpectSame $Kind "$Out"
	printf 'round %s, %s: as undisturbed after %s kills\n' $Round $Kind $Done
done
printf '%s kills in %s rounds, %s of them before the end: nothing torn, nothing left, the same bytes\n' \
	"$Done" "$Round" "$Killed"
