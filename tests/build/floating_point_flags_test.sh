#!/usr/bin/env bash
# Flags under which floating-point results could change stop the configuration; flags that are harmless do not.
#   floating_point_flags_test.sh SOURCE_DIR [CXX...]
set -euo pipefail
source_dir=$1
shift
compilers=("${@:-c++}")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0

configures() {  # CXX FLAGS: is the project configured with them?
  rm -rf "$scratch/build"
  cmake -S "$source_dir" -B "$scratch/build" -G Ninja -DCMAKE_CXX_COMPILER="$1" -DCMAKE_CXX_FLAGS="$2" \
    -DLODESTONE_TESTS=OFF -DLODESTONE_PROGRAM=OFF >"$scratch/log" 2>&1
}
expect() {  # yes|no CXX FLAGS
  local got=no
  if configures "$2" "$3"; then got=yes; fi
  if [[ $got == no ]] && ! grep -q "plain IEEE arithmetic" "$scratch/log"; then got="no, but for another reason"; fi
  echo "$2 with '$3': configured: $got"
  if [[ $got != "$1" ]]; then
    echo "  expected: $1"
    tail -20 "$scratch/log"
    failures=$((failures + 1))
  fi
}

for cxx in "${compilers[@]}"; do
  expect yes "$cxx" "-O2"
  expect yes "$cxx" "-march=native"
  expect no "$cxx" "-march=native -ffp-contract=fast"
  expect no "$cxx" "-ffast-math"
  expect no "$cxx" "-Ofast"

  # The probe program sees it in the results, too, not only in the flags' names.
  if grep -qw fma /proc/cpuinfo 2>/dev/null; then
    "$cxx" -O2 -march=native -ffp-contract=fast "$source_dir/cmake/contraction_probe.cpp" -o "$scratch/probe"
    if "$scratch/probe" >/dev/null; then
      echo "$cxx: the probe does not notice contraction"
      failures=$((failures + 1))
    fi
  fi
  "$cxx" -O3 -funsafe-math-optimizations "$source_dir/cmake/contraction_probe.cpp" -o "$scratch/probe"
  if "$scratch/probe" >/dev/null; then
    echo "$cxx: the probe does not notice reordered sums"
    failures=$((failures + 1))
  fi
done
exit $((failures > 0))
