#!/usr/bin/env bash
# Long tests in steps of at most an hour; what each commit passed is kept in build/soak and shown as one table.
#
#   ./dev soak                  shows the table of this commit
#   ./dev soak STEP...          runs these steps
#   ./dev soak all              runs all steps but those that this commit has passed
#
# STEP: asan, tsan, fuzz-NAME of each fuzzer, kills, random, chains, gates, sweep, oracles, conformance.
# DRYDOCK_SOAK_MINUTES (60, and at most 60) is the time of a step, its build included. A step that has an end is "not run"
# where its end is not reached; asan and tsan go on at the next call where they stopped. DRYDOCK_SOAK_SEED (0 to 32767)
# chooses the kills, the random programs and the random frames; by default each call has others. DRYDOCK_CONFORMANCE_TESTS
# names a folder of tests that conformance runs beside our own.
#
# The result of a step is a line in build/soak/COMMIT/STEP: status, seconds, figure, with tabs between; STEP.log is beside
# it. A tree with changes is COMMIT-dirty and skips nothing. Exit 1 where a step has failed; 2: no such step.
set -euo pipefail

Here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$Here"

Say() { printf 'soak: %s\n' "$*" >&2; }
Die() { Say "$*"; exit 2; }

mapfile -t Fuzzers < <(grep -v '^#' tests/fuzz/fuzzers.txt | cut -d ' ' -f 1)
Steps=(asan tsan "${Fuzzers[@]/#/fuzz-}" kills random chains gates sweep oracles conformance)

Minutes=${DRYDOCK_SOAK_MINUTES:-60}
[[ $Minutes =~ ^[1-9][0-9]?$ && $Minutes -le 60 ]] || Die "DRYDOCK_SOAK_MINUTES is $Minutes; expected 1 to 60"

Commit=$(git rev-parse --short=12 HEAD 2>/dev/null) || Commit=unknown
Dirty=0
if [ "$Commit" = unknown ] || [ -n "$(git status --porcelain)" ]; then
	Commit=$Commit-dirty
	Dirty=1
fi
Results=build/soak/$Commit
Seed=${DRYDOCK_SOAK_SEED:-$RANDOM}
[[ $Seed =~ ^[0-9]{1,5}$ ]] || Die "DRYDOCK_SOAK_SEED is $Seed; expected 0 to 32767"

# A step's function prints to its log. It sets Status and Figure.
Step="" Status="" Figure="" Deadline=0

# Whoever stops it, or a fault of this script, leaves no result.
exec 3>&2
trap 'exit 130' INT TERM
trap '[ -z "$Step" ] || printf "soak: %s broke off, see %s\n" "$Step" "$Results/$Step.log" >&3' EXIT

Finish() { Status=$1 Figure=$2; }

# Seconds that are left of the step, none below 0.
Left() { echo $((Deadline > SECONDS ? Deadline - SECONDS : 0)); }

# Within COMMAND...: runs it as long as the step has time; 124: the time is over. Its children end with it.
Within() {
	local Seconds Code=0
	Seconds=$(Left)
	[ "$Seconds" -gt 0 ] || return 124
	timeout --kill-after=20 "$Seconds" "$@" &
	# shellcheck disable=SC2064 # the number of now
	trap "kill $! 2>/dev/null; exit 130" INT TERM
	wait $! || Code=$?
	trap 'exit 130' INT TERM
	[ $Code != 137 ] || [ "$(Left)" -gt 0 ] || Code=124 # it did not end when it was told to
	return $Code
}

# Prepare PRESET TARGET...: builds what a step needs; sets Status where it cannot.
Prepare() {
	local Code=0
	Within ./dev build --preset "$@" || Code=$?
	case $Code in
		0) return 0 ;;
		124) Finish "not run" "the time was over before the build was" ;;
		*) Finish failed "the build failed" ;;
	esac
	return 1
}

# Join WORD...: with commas.
Join() { local Text; Text=$(printf ', %s' "$@"); printf '%s' "${Text#, }"; }

# SanitizedTests PRESET: the tests of ./dev test, each by its own name: what was not reached is not passed. Names that this
# commit has passed stand in a list, which the next call goes on from.
SanitizedTests() {
	local Passed="$Results/$1.passed" Run="$Results/$1.run" All Name Code=0 Failed=() Missing=() NumPassed=0 NumSkipped=0
	[ $Dirty = 0 ] || rm -f "$Passed"
	touch "$Passed"
	Prepare "$1" drydock_tests || return 0
	All=$(cd "build/$1" && ctest -N -LE long | sed -n 's/^ *Test *#[0-9]*: *//p')
	if [ -z "$All" ]; then
		Finish failed "ctest lists no tests"
		return 0
	fi
	local Skip
	Skip=$(paste -s -d '|' "$Passed")
	: >"$Run"
	if grep -qvxFf "$Passed" <<<"$All"; then
		(cd "build/$1" && Within ctest --output-on-failure -j "$(nproc)" -LE long ${Skip:+-E "^($Skip)\$"}) 2>&1 | tee "$Run" || Code=$?
	fi
	sed -n 's/^ *[0-9]*\/[0-9]* Test *#[0-9]*: \([^ ]*\) [. ]*Passed .*/\1/p' "$Run" >>"$Passed"
	while read -r Name; do
		if grep -qxF "$Name" "$Passed"; then
			NumPassed=$((NumPassed + 1))
		elif grep -qE "Test *#[0-9]*: $Name [. ]*\*\*\*Skipped" "$Run"; then
			NumSkipped=$((NumSkipped + 1))
		elif grep -qE "Test *#[0-9]*: $Name [. ]*\*\*\*" "$Run"; then
			Failed+=("$Name")
		else
			Missing+=("$Name")
		fi
	done <<<"$All"
	local Text="$NumPassed test programs passed"
	[ $NumSkipped = 0 ] || Text+=", $NumSkipped skipped"
	[ ${#Failed[@]} = 0 ] || Text+=", failed: $(Join "${Failed[@]}")"
	[ ${#Missing[@]} = 0 ] || Text+=", not run: $(Join "${Missing[@]}")"
	if [ ${#Failed[@]} -gt 0 ]; then
		Finish failed "$Text"
	elif [ ${#Missing[@]} -gt 0 ]; then
		Finish "not run" "$Text"
	elif [ $Code != 0 ]; then
		Finish failed "$Text, exit code $Code of ctest"
	else
		Finish passed "$Text"
	fi
}

# Fuzz NAME
Fuzz() {
	local Code=0 Line
	Prepare fuzz || return 0
	if [ "$(Left)" = 0 ]; then
		Finish "not run" "the time was over when the build was"
		return 0
	fi
	Line=$(tests/fuzz/run.sh "$(Left)" "$1") || Code=$?
	printf '%s\n' "$Line"
	cat "build/fuzz/found/$1/log" 2>/dev/null || true
	if [ $Code = 0 ]; then
		Finish passed "${Line##* } executions"
	else
		Finish failed "see build/fuzz/found/$1: $Line"
	fi
}

# Ended CODE: whether a step that goes on until its time is over has found nothing.
Ended() { [ "$1" = 0 ] || [ "$1" = 124 ]; }

Kills() {
	local Code=0 Log=$Results/kills.run Work Rounds
	Prepare release drydock_ready || return 0
	Work=$(mktemp -d)
	Within tests/kill/run.sh build/release . "$Work" 1000000 "$Seed" 2>&1 | tee "$Log" || Code=$?
	rm -rf "$Work"
	Rounds=$(sed -n 's/^round .* after \([0-9]*\) kills$/\1/p' "$Log" | tail -n 1)
	if ! Ended $Code; then
		Finish failed "$(grep -v '^round' "$Log" | tail -n 1), seed $Seed"
	elif [ -z "$Rounds" ]; then
		Finish "not run" "the time was over before the first round was"
	else
		Finish passed "$Rounds kills, seed $Seed"
	fi
}

Random() {
	local Code=0 Log=$Results/random.run Work Agree Other
	Prepare release test_rdg_Compiler || return 0
	Work=$(mktemp -d)
	Within tests/random/run.sh build/release "$Work" 20000 $((Seed * 20000)) "$(nproc)" 2>&1 | tee "$Log" || Code=$?
	Agree=$(cat "$Work"/*.log 2>/dev/null | grep -c '^\[       OK' || true)
	Other=$(cat "$Work"/*.log 2>/dev/null | grep '^\[  FAILED  \].*ms)$' || true)
	printf '%s\n' "$Other"
	if [ -n "$Other" ] || ! Ended $Code || awk '/ exit [0-9]+$/ && $NF != 0 && $NF != 143 { Bad = 1 } END { exit !Bad }' "$Log"; then
		mv "$Work" "$Results/random.logs.$$"
		Finish failed "$Agree programs agree, see $Results/random.logs.$$"
		return 0
	fi
	rm -rf "$Work"
	if [ "$Agree" = 0 ]; then
		Finish "not run" "the time was over before the first program was"
	else
		Finish passed "$Agree programs, from number $((Seed * 20000)) on"
	fi
}

# OneTest COMMAND...: runs it for a step that has an end. Its figure is what the function Count prints of the log.
OneTest() {
	local Code=0 Run=$Results/$Step.run Text
	DRYDOCK_CACHE_DIR="$Here/build/release/cache" Within "$@" 2>&1 | tee "$Run" || Code=$?
	Text=$(Count "$Run")
	case $Code in
		0) if [[ $Text = "0 "* ]]; then Finish "not run" "$Text"; else Finish passed "$Text"; fi ;;
		124) Finish "not run" "the time was over after $Text" ;;
		*) Finish failed "exit code $Code, $Text" ;;
	esac
}

# Frames TEST COUNT: random frames that are run in several ways.
Frames() {
	Count() { echo "$(grep -c ' ends' "$1" || true) frames, from seed $((Seed * Frames + 1)) on"; }
	local Frames=$2
	Prepare release test_stability || return 0
	OneTest env DRYDOCK_RANDOM_FRAMES="$((Seed * Frames + 1)) $Frames" build/release/bin/test_stability --gtest_filter="RandomFrames.$1"
}

Sweep() {
	Count() { echo "$(grep -c '^sweep ' "$1" || true) cases"; }
	Prepare release test_stability || return 0
	OneTest env DRYDOCK_SWEEP=all build/release/bin/test_stability --gtest_filter='Sweep.*'
}

Oracles() {
	Count() { echo "$(grep -c '^\[       OK' "$1" || true) tests"; }
	Prepare release test_rdg_vulkan || return 0
	OneTest env DRYDOCK_ORACLES=512 build/release/bin/test_rdg_vulkan
}

Conformance() {
	Count() { grep ' tests:' "$1" | paste -s -d ';' || true; }
	local Others=${DRYDOCK_CONFORMANCE_TESTS:-}
	Prepare release conformance || return 0
	# shellcheck disable=SC2016 # of the inner shell
	OneTest env -u DRYDOCK_CONFORMANCE_TESTS bash -c 'build/release/bin/conformance --all tests/conformance/Tests &&
		if [ -n "$1" ]; then build/release/bin/conformance "$1"; fi' conformance "$Others"
}

RunStep() {
	local Begin=$SECONDS Line
	Step=$1
	mkdir -p "$Results"
	Say "$Step, at most $Minutes minutes, $Results/$Step.log"
	Deadline=$((SECONDS + Minutes * 60))
	Finish failed "the step did not end"
	{
		case $Step in
			asan | tsan) SanitizedTests "$Step" ;;
			fuzz-*) Fuzz "${Step#fuzz-}" ;;
			kills) Kills ;;
			random) Random ;;
			chains) Frames ChainsGiveTheSameBitsInEveryWay 2000 ;;
			gates) Frames GatesAreNotFooled 1000 ;;
			sweep) Sweep ;;
			oracles) Oracles ;;
			conformance) Conformance ;;
		esac
	} >"$Results/$Step.log" 2>&1 </dev/null
	rm -f "$Results/$Step.run"
	Line=$(printf '%s\t%s\t%s' "$Status" $((SECONDS - Begin)) "$Figure")
	printf '%s\n' "$Line" >"$Results/.$Step.writing" && mv "$Results/.$Step.writing" "$Results/$Step"
	Say "$Step: $Status, $Figure"
	Step=""
}

# StatusOf STEP
StatusOf() { cut -f 1 "$Results/$1" 2>/dev/null || echo "not run"; }

ShowTable() {
	local Each
	printf 'commit %s\n%-20s %-8s %8s  %s\n' "$Commit" step status seconds figure
	for Each in "${Steps[@]}"; do
		if [ -f "$Results/$Each" ]; then
			awk -F '\t' -v Step="$Each" '{ printf "%-20s %-8s %8s  %s\n", Step, $1, $2, $3 }' "$Results/$Each"
		else
			printf '%-20s %-8s\n' "$Each" "not run"
		fi
	done
}

for Wanted in "$@"; do
	[ "$Wanted" = all ] || [[ " ${Steps[*]} " = *" $Wanted "* ]] || Die "there is no step $Wanted; there are all, $(Join "${Steps[@]}")"
done
Asked=()
for Wanted in "$@"; do
	if [ "$Wanted" != all ]; then
		Asked+=("$Wanted")
		continue
	fi
	for Each in "${Steps[@]}"; do
		if [ $Dirty = 0 ] && [ "$(StatusOf "$Each")" = passed ]; then
			Say "$Each: this commit has passed it"
		else
			Asked+=("$Each")
		fi
	done
done
for Wanted in ${Asked[@]+"${Asked[@]}"}; do
	RunStep "$Wanted"
done
ShowTable
[ $# -gt 0 ] || Asked=("${Steps[@]}")
for Wanted in ${Asked[@]+"${Asked[@]}"}; do
	[ "$(StatusOf "$Wanted")" != failed ] || exit 1
done
