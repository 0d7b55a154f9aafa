#!/usr/bin/env bash
# Builds the libFuzzer targets with sanitizers and runs all at a time for a minute. What they find stays in build/fuzz.
#   fuzz_test.sh SOURCE_DIR       LODESTONE_FUZZ_SECONDS=60
set -euo pipefail
cd "$1"
cmake --preset clang-fuzz --log-level=WARNING
cmake --build --preset clang-fuzz -j "${LODESTONE_JOBS:-$(nproc)}"
build/clang-fuzz/tests/fuzz/make_fuzz_seeds build/fuzz
fuzz() {  # TARGET
  local name
  name=$(basename "$1")
  mkdir -p "build/fuzz/$name"
  "$1" -max_total_time="${LODESTONE_FUZZ_SECONDS:-60}" -max_len=4096 -timeout=25 -rss_limit_mb=2048 \
    -artifact_prefix="build/fuzz/$name-" -print_final_stats=1 "build/fuzz/$name" 2>"build/fuzz/$name.log" ||
    { tail -60 "build/fuzz/$name.log"; return 1; }
  grep -E '^(Done|stat::number_of_executed_units|stat::slowest_unit_time_sec)' "build/fuzz/$name.log" | sed "s/^/$name: /"
}
pids=()
for target in build/clang-fuzz/tests/fuzz/*_fuzzer; do
  fuzz "$target" &
  pids+=($!)
done
for pid in "${pids[@]}"; do wait "$pid"; done  # the first that found something ends the test; its file names it
