#!/bin/bash
# `anisofront mesh` side by side with FreeFem++'s bamg (Debian package freefem++) on the same mesh
# and metric files: whole commands, one core, user + system time.
#
#   tests/bench/compare.sh [-b BUILD] [-n TRIANGLES] [-l LARGE] [-r REPETITIONS] [-k DIR] [CASE...]
#
# First a table at TRIANGLES (100000), the two programs in turn, REPETITIONS (5) pairs: medians, and
# the median of the ratios of the pairs, per triangle. Then anisofront alone at LARGE (1000000, 0 to
# leave it out). DIR keeps the files; without it they go. Needs setup.sh --bench and preset bench.
#
# bamg reads the metric as m11 m12 m22 per vertex (-M) on a background mesh (-b) and runs with its
# own defaults; -r would keep the old mesh where it fits. Its limit of vertices is twice what comes
# out, as it reserves memory for it. Quality is taken from the exact metric at the new vertices.
set -euo pipefail
cd "$(dirname "$0")/../.."

# shellcheck disable=SC2034 # build is read by common.sh
build=build/bench triangles=100000 large=1000000 repetitions=5 folder=
while getopts b:n:l:r:k: option; do
  case $option in
    b) build=$OPTARG ;;
    n) triangles=$OPTARG ;;
    l) large=$OPTARG ;;
    r) repetitions=$OPTARG ;;
    k) folder=$OPTARG ;;
    *) sed -n '5p' "$0" >&2; exit 3 ;;
  esac
done
shift $((OPTIND - 1))
cases=("$@")
[ ${#cases[@]} -gt 0 ] || cases=(uniform example-2 layer sine)
# shellcheck source=tests/bench/common.sh
. tests/bench/common.sh
require "$anisofront" "$bench_cases" ffbamg jq /usr/bin/time
make_folder

# measured RESULT COMMAND...: on_core_0, stops when the command fails.
measured() {
  on_core_0 "$@" && return
  cat "$folder/output" >&2
  echo "compare.sh: failed: ${*:2}" >&2
  exit 2
}

count() { awk '/^Triangles/ {getline; print $1; exit}' "$1"; }

# quality CASE SCALE MESH: mean, min, percent in [1/sqrt2, sqrt2].
quality() {
  "$bench_cases" metric "$1" "$2" "$3" "$folder/check.sol"
  "$anisofront" check "$3" --metric "$folder/check.sol" --json |
    jq -r '[.quality.mean, .quality.min, .edge_length["in_unit_band"]] | @tsv'
}

ours() { measured "$1.ours" "$anisofront" mesh "$1.mesh" --metric "$1.sol" -v -o "$1.ours.mesh"; }
bamg() { measured "$1.bamg" ffbamg -b "$1.mesh" -M "$1.mtr" -nbv "$2" -o "$1.bamg.mesh"; }

# row CASE PROGRAM NAME SCALE: one line of a table.
row() {
  local seconds kilobytes triangles mean least band
  seconds=$(column 1 "$3.$2") kilobytes=$(column 2 "$3.$2") triangles=$(count "$3.$2.mesh")
  read -r mean least band <<<"$(quality "$1" "$4" "$3.$2.mesh")"
  awk -v c="$1" -v p="$2" -v n="$triangles" -v s="$seconds" -v k="$kilobytes" -v a="$mean" \
    -v m="$least" -v b="$band" 'BEGIN {printf "| %-9s | %-4s | %8d | %6.0f | %6.0f | %5.0f | %.4f | %.3f | %7.3f |",
      c, p, n, n / s / 1e3, 1e9 * s / n, 1024 * k / n, a, m, b}'
}

# pair_ratio NAME: median over the pairs of bamg's time per triangle by ours.
pair_ratio() {
  paste "$1.bamg" "$1.ours" |
    awk -v nb="$(count "$1.bamg.mesh")" -v no="$(count "$1.ours.mesh")" '{print $1 / nb / ($3 / no)}' \
      >"$1.ratio"
  printf "%.1f" "$(column 1 "$1.ratio")"
}

header() {
  echo
  echo "| case      | prog | triangles | k/s | ns/tri | B/tri | alpha mean | min | in band % |$1"
  echo "| --------- | ---- | --------- | --- | ------ | ----- | ---------- | --- | --------- |$2"
}

header " ratio |" " ----- |"
for case in "${cases[@]}"; do
  name=$folder/$case-$triangles
  rm -f "$name".ours "$name".bamg
  scale=$("$bench_cases" make "$case" "$triangles" "$name")
  for ((i = 0; i < repetitions; ++i)); do
    bamg "$name" $((triangles + 10000))
    ours "$name"
  done
  echo "$(row "$case" bamg "$name" "$scale") |"
  echo "$(row "$case" ours "$name" "$scale") $(pair_ratio "$name") |"
done

[ "$large" -gt 0 ] || exit 0
header " front k/s | time per triangle, by that at $triangles |" " --- | --- |"
for case in "${cases[@]}"; do
  name=$folder/$case-$large
  rm -f "$name".ours
  scale=$("$bench_cases" make "$case" "$large" "$name")
  for ((i = 0; i < (repetitions + 1) / 2; ++i)); do ours "$name"; done
  front=$(awk '$1 == "front" {printf "%.0f", $4 / 1e3}' "$folder/output")
  small=$folder/$case-$triangles
  growth=$(echo "$(column 1 "$name.ours") $(count "$name.ours.mesh") $(column 1 "$small.ours")" \
    "$(count "$small.ours.mesh")" | awk '{printf "%.2f", $1 / $2 / ($3 / $4)}')
  echo "$(row "$case" ours "$name" "$scale") $front | $growth |"
done
