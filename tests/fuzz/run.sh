#!/usr/bin/env bash
# Runs the fuzzers NAMES (default: every one that is built) for SECONDS_EACH (default 60), each from its corpus; what makes
# one fail is left in build/fuzz/found.
#   tests/fuzz/run.sh [SECONDS_EACH [NAMES...]]
# Exit 0: all clean.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
Seconds=${1:-60}
shift
export LSAN_OPTIONS="suppressions=tests/fuzz/lsan.supp:print_suppressions=0${LSAN_OPTIONS:+:$LSAN_OPTIONS}"
Options=${ASAN_OPTIONS:-}
Failed=0
while read -r Name Corpus <&3; do
	[ -x build/fuzz/bin/fuzz_"$Name" ] || continue
	[ $# = 0 ] || [[ " $* " = *" $Name "* ]] || continue
	Found=build/fuzz/found/$Name
	# Short stacks of allocations, which cost a tenth of the time: what is found is run again with the defaults.
	# lsan.supp knows a leak by its caller's caller.
	case $Name in exr_header | picture_file) Frames=8 ;; *) Frames=1 ;; esac
	export ASAN_OPTIONS="malloc_context_size=$Frames:quarantine_size_mb=16${Options:+:$Options}"
	mkdir -p "$Found/corpus"
	# No input of a few kB may want a gigabyte, or ten seconds.
	build/fuzz/bin/fuzz_"$Name" -max_total_time="$Seconds" -timeout=10 -malloc_limit_mb=1000 -rss_limit_mb=4000 \
		-max_len=4096 -entropic=0 -print_final_stats=1 -artifact_prefix="$Found/" "$Found/corpus" "tests/fuzz/corpus/$Corpus" \
		>"$Found/log" 2>&1
	Exit=$?
	[ $Exit = 0 ] || Failed=1
	printf '%s: rc %d, %s\n' "$Name" $Exit "$(grep -m1 number_of_executed_units "$Found/log" || tail -1 "$Found/log")"
done 3<build/fuzz/fuzzers.txt
exit $Failed
