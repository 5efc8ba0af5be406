#!/usr/bin/env bash
# Runs every fuzzer for SECONDS_EACH (default 60), each from its corpus; what makes one fail is left in build/fuzz/found.
# Exit 0: all clean.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
Seconds=${1:-60}
Failed=0
for Pair in settings_text:settings config_json:config exr_header:exr spirv_reader:spirv; do
	Name=${Pair%%:*}
	Found=build/fuzz/found/$Name
	mkdir -p "$Found/corpus"
	# No input of a few kB may want a gigabyte, or ten seconds.
	build/fuzz/bin/fuzz_"$Name" -max_total_time="$Seconds" -timeout=10 -malloc_limit_mb=1000 -rss_limit_mb=4000 \
		-max_len=16384 -print_final_stats=1 -artifact_prefix="$Found/" "$Found/corpus" "tests/fuzz/corpus/${Pair##*:}" \
		>"$Found/log" 2>&1
	Exit=$?
	[ $Exit = 0 ] || Failed=1
	printf '%s: rc %d, %s\n' "$Name" $Exit "$(grep -m1 number_of_executed_units "$Found/log" || tail -1 "$Found/log")"
done
exit $Failed
