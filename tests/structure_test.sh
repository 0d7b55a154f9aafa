#!/usr/bin/env bash
# The shape of the repository, as tests: which folder may include which, one door for each third party, folders and
# files that the pages name exist, no path of one machine, plain file names.
#   structure_test.sh [SOURCE_DIR]
set -euo pipefail
cd "${1:-$(dirname "$0")/..}"
export LC_ALL=C
failures=0

fail() {  # WHAT, and the lines that show it
  echo "FAILED: $1"
  printf '%s\n' "$2" | sed 's/^/  /' | head -20
  failures=$((failures + 1))
}
expect_none() {  # WHAT LINES
  if [[ -n $2 ]]; then fail "$1" "$2"; else echo "ok: $1"; fi
}
includes() {  # FOLDER: its files' includes, as path:#include ...
  if [[ -d $1 ]]; then grep -rHE '^ *# *include' "$1" --include='*.h' --include='*.cpp' --include='*.inl' || true; fi
}
except() { grep -vE "$1" || true; }

# ---- Imports run one way: experiments -> techniques -> {raster, geometry} ----
expect_none "raster/ includes only raster/ of this project" "$(includes raster | grep '"' | except '"raster/')"
expect_none "geometry/ includes only geometry/ of this project" "$(includes geometry | grep '"' | except '"geometry/')"
expect_none "techniques/ includes neither experiments/ nor tests/" \
  "$(includes techniques | grep '"' | except '"(techniques|raster|geometry)/')"
if [[ -d techniques ]]; then
  for folder in techniques/*/; do
    name=$(basename "$folder")
    expect_none "techniques/$name includes no other technique" \
      "$(includes "techniques/$name" | grep '"techniques/[a-z_0-9]*/' | except "\"techniques/$name/")"
  done
fi
expect_none "experiments/ does not include tests/" "$(includes experiments | grep '"tests/' || true)"

# ---- Each third party has its one door ----
everything() { for folder in raster geometry techniques experiments; do includes "$folder"; done; }
door() {  # HEADER_REGEX WHERE_REGEX
  expect_none "<$1> is included only in $2" "$(everything | grep -E "[<\"]$1" | except "^$2")"
}
door '(tbb|oneapi)/' 'raster/parallel'
door 'thread>' 'raster/parallel'
door 'hwy/' '(raster/|techniques/masked_occlusion/occluder_kernels)'
door 'boost/' '(raster/|geometry/predicates)'
door 'embree' 'geometry/ray_query'
door 'meshoptimizer[.]' 'geometry/simplify[.]cpp'
door 'OpenImageIO/' 'geometry/image_file'
door 'png\.h' 'geometry/image_file/decode_png'
door 'nlohmann/' '(geometry/json/|geometry/model_file/|experiments/)'
door '(CLI|openssl)/' 'experiments/'
door 'gmpxx[.]' 'experiments/truth/rational'
door '(gtest|gmock|benchmark|gmp|mpfr)[./]' 'tests/'

# ---- What the pages name exists ----
files() {
  if git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
    git ls-files --cached --others --exclude-standard
  else
    find . -type f -not -path './build*' -not -path './out/*' -not -path './.git/*' | sed 's|^\./||'
  fi
}
missing=
for page in $(files | grep '\.md$' || true); do
  here=$(dirname "$page")
  # Links, and `folder/` or `folder/file` in backquotes whose first part is a folder of ours.
  for name in $(grep -oE '\]\([A-Za-z0-9_./-]+\)' "$page" | sed -E 's/^\]\(//; s/\)$//' || true); do
    if [[ ! -e $here/$name ]]; then missing+="$page: $name"$'\n'; fi
  done
  for name in $(grep -oE '`[A-Za-z0-9_.-]+/[A-Za-z0-9_./-]*`' "$page" | tr -d '`' | grep -E '^(raster|geometry|techniques|experiments|tests|notes|scripts|examples|cmake)/' || true); do
    if [[ ! -e $name && ! -e $here/$name ]]; then missing+="$page: $name"$'\n'; fi
  done
done
for name in $(grep -oE '^ *[|`]* *`?[a-z_]+/`?' README.md 2>/dev/null | grep -oE '[a-z_]+/' || true); do
  if [[ ! -d $name ]]; then missing+="README.md: $name"$'\n'; fi
done
expect_none "every folder and file that a page names exists" "${missing%$'\n'}"

# ---- Nothing of one machine ----
expect_none "no file holds a path of one machine" \
  "$(files | tr '\n' '\0' | xargs -0 grep -nIE '/(work|farm|root|home)/[a-z.]' 2>/dev/null || true)"
expect_none "file names are plain ASCII without spaces" "$(files | grep -E '[^A-Za-z0-9_./+-]' || true)"

if ((failures > 0)); then echo "$failures claims do not hold"; fi
exit $((failures > 0))
