#!/usr/bin/env bash
# examples/golden_test links lodestone::raster from an installation and from the sources, without the libraries of the
# laboratory, and its test passes; with another golden, or none, it fails.
#   linking_test.sh SOURCE_DIR BUILD_DIR      BUILD_DIR: lodestone, built
set -euo pipefail
source_dir=$1
build_dir=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
example=$source_dir/examples/golden_test

cmake --install "$build_dir" --prefix "$scratch/installed" >/dev/null
for way in installed sources; do
  echo "== linked from the $way"
  case $way in
    installed) where=(-DCMAKE_PREFIX_PATH="$scratch/installed") ;;
    sources) where=(-DGOLDEN_TEST_LODESTONE_SOURCE="$source_dir" -DCMAKE_CXX_FLAGS_RELEASE=-O1) ;;  # quick to build
  esac
  cmake -S "$example" -B "$scratch/$way" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_DISABLE_FIND_PACKAGE_OpenImageIO=ON -DCMAKE_DISABLE_FIND_PACKAGE_embree=ON "${where[@]}" >"$scratch/log" ||
    { cat "$scratch/log"; exit 1; }
  cmake --build "$scratch/$way" >"$scratch/log" || { cat "$scratch/log"; exit 1; }
  (cd "$scratch/$way" && ./golden_test "$example/golden.pam")
done

echo "== a golden with one other byte, and none"
cp "$example/golden.pam" "$scratch/other.pam"
printf '\1' | dd of="$scratch/other.pam" bs=1 seek=1000 conv=notrunc status=none
for golden in "$scratch/other.pam" "$scratch/none.pam"; do
  if (cd "$scratch" && installed/golden_test "$golden") >"$scratch/log"; then
    echo "expected a failure with $(basename "$golden")"
    exit 1
  fi
done
echo "both fail, as they should"
