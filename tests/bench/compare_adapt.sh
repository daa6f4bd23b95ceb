#!/bin/bash
# The adaptive loop side by side with that of FreeFem++ (Debian package freefem++): linear elements,
# boundary layers of width 0.001, five cycles (data/studies/reaction-diffusion-layer.toml).
#
#   tests/bench/compare_adapt.sh [-b BUILD] [-r REPETITIONS] [-n VERTICES] [-e ERR] [-k DIR]
#
# REPETITIONS (3) runs of each program in turn. We aim at VERTICES (6800), FreeFem++ at an
# interpolation error of ERR (0.01, which gives about as many). Medians of wall seconds: of the whole
# process, with all files, page and true errors on our side, and of the loop alone (solve, estimate,
# metric, mesh; ours is CPU time). Errors are true relative energy errors of the last mesh. DIR keeps
# the results; without it they go. Needs setup.sh --bench and preset bench.
set -euo pipefail
cd "$(dirname "$0")/../.."

build=build/bench repetitions=3 vertices=6800 err=0.01 folder=
while getopts b:r:n:e:k: option; do
  case $option in
    b) build=$OPTARG ;;
    r) repetitions=$OPTARG ;;
    n) vertices=$OPTARG ;;
    e) err=$OPTARG ;;
    k) folder=$OPTARG ;;
    *) sed -n '5p' "$0" >&2; exit 3 ;;
  esac
done
# shellcheck source=tests/bench/common.sh
. tests/bench/common.sh
require "$anisofront" FreeFem++ python3
make_folder

study=data/studies/reaction-diffusion-layer.toml

# timed RESULT COMMAND...: appends the wall seconds to the file RESULT.
timed() {
  local result=$1 TIMEFORMAT=%R
  shift
  { time "$@" >"$folder/output" 2>&1; } 2>>"$result" && return
  cat "$folder/output" >&2
  echo "compare_adapt.sh: failed: $*" >&2
  exit 2
}

# Vertices, error and loop seconds of our last run.
our_figures() {
  python3 - "$folder/run/history.json" <<'EOF'
import json, sys
cycles = json.load(open(sys.argv[1]))["variants"][0]["cycles"]
seconds = sum(sum(v for v in c["seconds"].values()) for c in cycles)
print(cycles[-1]["vertices"], cycles[-1]["error"]["relative_energy"], round(seconds, 3))
EOF
}

rm -f "$folder"/*.wall "$folder"/*.figures
for ((i = 0; i < repetitions; ++i)); do
  timed "$folder/ours.wall" "$anisofront" run -q --fresh "$study" -o "$folder/run" \
    --set problem.constants.eps=0.001 --set problem.order=1 --set vary.mesh=fine \
    --set adapt.target.nodes="$vertices"
  our_figures >>"$folder/ours.figures"
  timed "$folder/FreeFem++.wall" FreeFem++ -nw -v 0 tests/bench/layer_loop.edp 0.001 "$err" aniso
  awk '$1 == "cycle" {n = $3; e = $4} $1 == "loop" {print n, e, $2}' "$folder/output" \
    >>"$folder/FreeFem++.figures"
done

printf '%-10s %9s %10s %9s %9s\n' program vertices error process loop
for program in ours FreeFem++; do
  printf '%-10s %9d %10.2e %9.2f %9.2f\n' $program "$(column 1 "$folder/$program.figures")" \
    "$(column 2 "$folder/$program.figures")" "$(column 1 "$folder/$program.wall")" \
    "$(column 3 "$folder/$program.figures")"
done
awk -v a="$(column 1 "$folder/ours.wall")" -v b="$(column 1 "$folder/FreeFem++.wall")" \
  -v c="$(column 3 "$folder/ours.figures")" -v d="$(column 3 "$folder/FreeFem++.figures")" \
  'BEGIN {printf "ratio of seconds: process %.2f, loop %.2f\n", a / b, c / d}'
