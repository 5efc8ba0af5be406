#!/usr/bin/env bash
# Random shaders by the thousand, each by a kernel and by the interpreter (docs/testing.md): a process for every 500, since
# kernels stay loaded.
#   tests/random/run.sh BUILD LOGS [COUNT [FIRST [PROCESSES]]]      such as  tests/random/run.sh build/release /tmp/random
# COUNT (10000) programs, the first of number FIRST (0), PROCESSES (1) at once. A line for each 500; what failed is in
# LOGS/FIRST.log. Exit 0: all agree.
set -uo pipefail
export Test Logs
Test=$(realpath "$1")/bin/test_rdg_Compiler
mkdir -p "$2"
Logs=$(realpath "$2")
Count=${3:-10000} First=${4:-0} Processes=${5:-1}

# RunSome FIRST COUNT
RunSome() {
	DRYDOCK_RANDOM_FIRST=$1 DRYDOCK_RANDOM_PROGRAMS=$2 "$Test" --gtest_filter='*FRandom*' >"$Logs/$1.log" 2>&1
	local Exit=$?
	printf '%s: programs %d to %d: %d agree, %d do not, exit %d\n' "$(date +%T)" "$1" "$(($1 + $2 - 1))" \
		"$(grep -c '^\[       OK' "$Logs/$1.log")" "$(grep -c '^\[  FAILED  \].*ms)$' "$Logs/$1.log")" $Exit
	return $Exit
}
export -f RunSome
for ((i = First; i < First + Count; i += 500)); do
	echo "$i $((First + Count - i < 500 ? First + Count - i : 500))"
done | xargs -P "$Processes" -L 1 bash -c 'RunSome "$@"' RunSome
