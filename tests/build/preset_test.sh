#!/usr/bin/env bash
# Builds one of CMakePresets.json and runs its tests (those labelled quick).
#   preset_test.sh SOURCE_DIR PRESET
set -euo pipefail
cd "$1"
jobs=${LODESTONE_JOBS:-$(nproc)}
start=$SECONDS
cmake --preset "$2" -DCMAKE_COMPILE_WARNING_AS_ERROR="${LODESTONE_WERROR:-OFF}" --log-level=WARNING
cmake --build --preset "$2" -j "$jobs" --target quick_tests hash_program
echo "-- build $2: $((SECONDS - start)) s"
start=$SECONDS
ctest --preset "$2" -j "$jobs"
echo "-- test $2: $((SECONDS - start)) s"
