#!/usr/bin/env bash
# Runs the fuzzers NAMES (default: every one of fuzzers.txt) for SECONDS_EACH (default 60), each from its corpus; what makes
# one fail is left in build/fuzz/found.
#   tests/fuzz/run.sh [SECONDS_EACH [NAMES...]]
# With 0 seconds each file of the corpus runs once, and nothing is made up: CI does that.
# A line for each. Exit 0: all clean; 1: a fuzzer has found something, or is not built; 2: a name that is none.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
Seconds=${1:-60}
shift || true
mapfile -t Known < <(grep -v '^#' tests/fuzz/fuzzers.txt | cut -d ' ' -f 1)
Wanted=("$@")
[ $# -gt 0 ] || Wanted=("${Known[@]}")
Length=-max_total_time=$Seconds
[ "$Seconds" != 0 ] || Length=-runs=0
Options=${ASAN_OPTIONS:-}
export LSAN_OPTIONS="suppressions=tests/fuzz/lsan.supp:print_suppressions=0${LSAN_OPTIONS:+:$LSAN_OPTIONS}"
Failed=0

# RunFuzzer NAME CORPUS
RunFuzzer() {
	local Found=build/fuzz/found/$1 Frames Code=0
	if [ ! -x "build/fuzz/bin/fuzz_$1" ]; then
		printf '%s: not built (./dev build --preset fuzz)\n' "$1"
		return 1
	fi
	# Short stacks of allocations, which cost a tenth of the time: what is found is run again with the defaults.
	# lsan.supp knows a leak by its caller's caller.
	case $1 in exr_file | picture_file) Frames=8 ;; *) Frames=1 ;; esac
	mkdir -p "$Found/corpus"
	# No input of a few kB may want a gigabyte, or ten seconds.
	ASAN_OPTIONS="malloc_context_size=$Frames:quarantine_size_mb=16${Options:+:$Options}" \
		"build/fuzz/bin/fuzz_$1" "$Length" -timeout=10 -malloc_limit_mb=1000 -rss_limit_mb=4000 \
		-max_len=4096 -entropic=0 -print_final_stats=1 -artifact_prefix="$Found/" "$Found/corpus" "tests/fuzz/corpus/$2" \
		>"$Found/log" 2>&1 || Code=$?
	printf '%s: rc %d, %s\n' "$1" "$Code" "$(grep -m1 number_of_executed_units "$Found/log" || tail -n 1 "$Found/log")"
	return $((Code != 0))
}

for Name in "${Wanted[@]}"; do
	Corpus=$(awk -v Name="$Name" '$1 == Name { print $3 }' tests/fuzz/fuzzers.txt)
	if [ -z "$Corpus" ]; then
		printf 'there is no fuzzer %s; there are %s\n' "$Name" "${Known[*]}" >&2
		exit 2
	fi
	RunFuzzer "$Name" "$Corpus" || Failed=1
done
exit $Failed
