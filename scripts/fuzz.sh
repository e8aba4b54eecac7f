#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Runs every fuzzer for some seconds from its corpus, one on each processor, and sums up: scripts/fuzz.sh [SECONDS_EACH [FOLDER [SEED]]]
# SEED 0 (the default) draws other inputs in each run; any other number draws the same inputs again.
# New inputs and artefacts (crash-*, timeout-*, leak-*) stay in FOLDER.
set -euo pipefail
cd "$(dirname "$0")/.."
export seconds=${1:-10} work=${2:-$(mktemp -d)} seed=${3:-0}
cmake --preset sanitize > /dev/null
cmake --build --preset sanitize --target fuzzers --parallel "$(nproc)"
export LSAN_OPTIONS="suppressions=$PWD/tests/leak_suppressions.txt"

fuzz() {
  local fuzzer=$1 name=${1#build-sanitize/fuzz_} status=0 inputs found
  mkdir -p "$work/$name"
  "$fuzzer" -seed="$seed" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=2048 -print_final_stats=1 \
    -artifact_prefix="$work/$name-" "$work/$name" "fuzz/corpus/$name" > "$work/$name.log" 2>&1 || status=$?
  inputs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$work/$name.log")
  found=$(find "$work" -maxdepth 1 -name "$name-*" | wc -l)
  echo "$name: ${inputs:-?} inputs, $found crashes, hangs or leaks"
  if [ "$status" -ne 0 ] || [ "$found" -ne 0 ]; then
    tail -n 40 "$work/$name.log"
    return 1
  fi
}
export -f fuzz
failures=0
find build-sanitize -maxdepth 1 -name 'fuzz_*' -type f -executable | sort |
  xargs -P "$(nproc)" -I '{}' bash -c 'fuzz "$1"' fuzz '{}' || failures=1
echo "logs and new inputs: $work"
exit $failures
