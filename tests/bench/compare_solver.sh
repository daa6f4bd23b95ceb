#!/bin/bash
# The scalar solver side by side with FreeFem++ (Debian package freefem++) on the same meshes, and
# the plate solver alone.
#
#   tests/bench/compare_solver.sh [-b BUILD] [-r REPETITIONS] [-c CASE] [-p UNKNOWNS] [-k DIR] [SIZE...]
#
# P1 and P2 at SIZE unknowns each (100000 1000000): -Laplace u = 1, u = 0 on the boundary of a square
# meshed by our generator to CASE (uniform; see bench_cases). REPETITIONS (3) runs of each program in
# turn, medians of wall seconds with all cores, without reading the mesh; peak memory of the whole
# process; the last column is our total by FreeFem++'s with the fastest of its solvers. Then a
# clamped MITC7 plate at UNKNOWNS (1000000, 0 to leave it out), assembly by linear solver. DIR keeps
# the files; without it they go. Needs setup.sh --bench and preset bench.
set -euo pipefail
cd "$(dirname "$0")/../.."

build=build/bench repetitions=3 bench_case=uniform plate=1000000 folder=
while getopts b:r:c:p:k: option; do
  case $option in
    b) build=$OPTARG ;;
    r) repetitions=$OPTARG ;;
    c) bench_case=$OPTARG ;;
    p) plate=$OPTARG ;;
    k) folder=$OPTARG ;;
    *) sed -n '5p' "$0" >&2; exit 3 ;;
  esac
done
shift $((OPTIND - 1))
sizes=("$@")
[ ${#sizes[@]} -gt 0 ] || sizes=(100000 1000000)
# shellcheck source=tests/bench/common.sh
. tests/bench/common.sh
bench_solver=$build/tests/bench/bench_solver
require "$bench_solver" FreeFem++ /usr/bin/time
make_folder

peer_solvers="CHOLMOD UMFPACK default"

# measured COMMAND...: runs it, output in $folder/output, peak kilobytes in $folder/memory.
measured() {
  /usr/bin/time -o "$folder/memory" -f %M "$@" >"$folder/output" 2>&1 && return
  cat "$folder/output" >&2
  echo "compare_solver.sh: failed: $*" >&2
  exit 2
}

# Both append a line "assembly solver total kilobytes unknowns energy" to NAME.PROGRAM.
# ours NAME KIND METHOD
ours() {
  measured "$bench_solver" "$2" "$1.mesh" "$3"
  awk -v m="$(cat "$folder/memory")" '{print $2, $3 + $4, $5, m, $1, $6}' "$folder/output" >>"$1.ours-$3"
}
# peer NAME KIND SOLVER
peer() {
  measured FreeFem++ -nw -v 0 tests/bench/poisson.edp "$1.mesh" "$2" "$3"
  awk -v m="$(cat "$folder/memory")" '$1 == "stamp" {at[++k] = $2} $1 == "result" {n = $2; e = $3}
    END {print at[2] - at[1], at[3] - at[2], at[3] - at[1], m, n, e}' OFMT=%.3f "$folder/output" >>"$1.$3"
}

# row KIND NAME PROGRAM RATIO
row() {
  awk -v k="$1" -v p="$3" -v a="$(column 1 "$2.$3")" -v s="$(column 2 "$2.$3")" \
    -v t="$(column 3 "$2.$3")" -v m="$(column 4 "$2.$3")" -v r="$4" '
    END {printf "| %-5s | %-15s | %8d | %8.3f | %8.3f | %8.3f | %7.0f | %.9f | %5s |\n",
      k, p, $5, a, s, t, m / 1024, $6, r}' "$2.$3"
}

# compare KIND SIZE
compare() {
  local name=$folder/$1-$2 solver best i
  "$bench_solver" mesh "$bench_case" "$1" "$2" "$name.mesh"
  rm -f "$name".ours-* "$name".CHOLMOD* "$name".UMFPACK "$name".default
  for ((i = 0; i < repetitions; ++i)); do
    for solver in $peer_solvers; do peer "$name" "$1" "$solver"; done
    for solver in supernodal automatic; do ours "$name" "$1" "$solver"; done
  done
  best=$(for solver in $peer_solvers; do column 3 "$name.$solver"; done | sort -g | head -1)
  for solver in $peer_solvers; do row "$1" "$name" "$solver" ""; done
  for solver in supernodal automatic; do
    row "$1" "$name" "ours-$solver" "$(awk -v p="$best" -v o="$(column 3 "$name.ours-$solver")" \
      'BEGIN {printf "%.2f", o / p}')"
  done
}

echo "| kind  | program         | unknowns | assembly | solver   | total    | MiB     | energy      | ratio |"
echo "| ----- | --------------- | -------- | -------- | -------- | -------- | ------- | ----------- | ----- |"
for size in "${sizes[@]}"; do
  for kind in P1 P2; do compare "$kind" "$size"; done
done

[ "$plate" -gt 0 ] || exit 0
echo
"$bench_solver" mesh "$bench_case" plate "$plate" "$folder/plate.mesh"
measured "$bench_solver" plate "$folder/plate.mesh"
awk -F '\t' -v m="$(cat "$folder/memory")" '{
  printf "MITC7 plate, %d unknowns: assembly %.2f s, factorisation %.2f s (%s), solution %.2f s ", $1, $2, $3, $10, $4
  printf "(%d refinements, residual %s), in all %.2f s, peak %.0f MiB; ", $7, $9, $5, m / 1024
  printf "assembly by factorisation %.1f %%\n", 100 * $2 / $3}' "$folder/output"
