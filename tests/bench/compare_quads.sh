#!/bin/bash
# `anisofront mesh --quad` side by side with rheolef's `bamg -thetaquad 30 -2q` and Gmsh on the same
# mesh and metric files: whole commands, one core, user + system time, medians.
#
#   compare_quads.sh [-b BUILD] [-s SIZES] [-r REPETITIONS] [-p PROGRAMS] [-a] [-k DIR] [CASE...]
#
# SIZES: a list of "paper" (the sizes of the paper and of the ready studies) and numbers of
# quadrilaterals (for example-2 and example-2-anisotropic); default "paper 10000 100000". PROGRAMS: a
# list of those below. DIR keeps the files; without it they go. Needs setup.sh --bench, preset bench.
#
# The quality is that of `anisofront check`, but against the exact metric also between the vertices,
# and for meshes with concave quadrilaterals too: beta mean is over the convex ones, bad are the
# concave ones and those below 0.2. The others' sizes are multiplied by what brings their number of
# quadrilaterals near the ideal, the integral of sqrt(det M), as fine meshes have short edges; with
# -a they are taken as they are. "x time" is the time per quadrilateral by that of `best`.
#
# bamg halves what it is given (-2q), hence twice the sizes, and now and then stops at one of its
# assertions, hence sizes one percent off; its limit of vertices is near what comes out, as it
# reserves memory for it. Gmsh takes the sizes, or the metric, from a view on the
# triangles; it follows a metric in its algorithm 7 only, packs parallelograms (9) for sizes only.
set -euo pipefail
cd "$(dirname "$0")/../.."

# shellcheck disable=SC2034 # build is read by common.sh
build=build/bench sizes='paper 10000 100000' repetitions=3 programs='' as_given='' folder=''
while getopts b:s:r:p:ak: option; do
  case $option in
    b) build=$OPTARG ;;
    s) sizes=$OPTARG ;;
    r) repetitions=$OPTARG ;;
    p) programs=$OPTARG ;;
    a) as_given=1 ;;
    k) folder=$OPTARG ;;
    *) sed -n '5p' "$0" >&2; exit 3 ;;
  esac
done
shift $((OPTIND - 1))
cases=("$@")
# shellcheck source=tests/bench/common.sh
. tests/bench/common.sh
require "$anisofront" "$bench_cases" /usr/bin/bamg gmsh /usr/bin/time
make_folder

starts="right-angle equilateral greedy systematic"
others="bamg gmsh-blossom gmsh-full gmsh-packing"
isotropic() { [ "$1" = example-2 ]; }

# set_command PROGRAM CASE NAME FACTOR: sets command, and made, the mesh that it makes.
set_command() {
  local algorithm=7 gmsh
  if isotropic "$2"; then algorithm=6; fi
  made=$3-$1.mesh
  command=("$anisofront" mesh "$3.mesh" --metric "$3.sol" -q -o "$made" --quad)
  gmsh=(gmsh "$3.geo" -2 -v 1 -bgm "$3.pos" -clscale "$4" -format msh22 -o "$3-$1.msh"
    -setnumber Mesh.MeshSizeExtendFromBoundary 0 -setnumber Mesh.MeshSizeFromPoints 0
    -setnumber Mesh.MeshSizeMin 0 -setnumber Mesh.MeshSizeMax 1e22
    -setnumber Mesh.RecombineAll 1 -setnumber Mesh.RecombinationAlgorithm)
  case $1 in
    best | fast) command+=(--quad-effort "$1") ;;
    paper) command+=(--quad-method paper) ;;
    bamg) command=(/usr/bin/bamg -b "$3.mesh" -M "$3.mtr" -thetaquad 30 -2q -nbv "$limit"
      -o "$made" -coef "$(awk -v f="$4" 'BEGIN {print 2 * f}')") ;;
    gmsh-blossom) command=("${gmsh[@]}" 1 -setnumber Mesh.Algorithm "$algorithm") ;;
    gmsh-full) command=("${gmsh[@]}" 3 -setnumber Mesh.Algorithm "$algorithm") ;;
    gmsh-packing) command=("${gmsh[@]}" 1 -setnumber Mesh.Algorithm 9) ;;
    *) command+=(--quad-start "$1") ;;
  esac
  case $1 in gmsh-*) made=$3-$1.msh ;; esac
}

# run PROGRAM CASE NAME FACTOR: one timed run.
run() {
  local command
  set_command "$@"
  rm -f "$made"
  on_core_0 "$3-$1.seconds" timeout 900 "${command[@]}" && [ -f "$made" ] || return 2
  # rheolef's bamg writes version 0
  [ "$1" != bamg ] || sed -i '1s/MeshVersionFormatted 0/MeshVersionFormatted 1/' "$made"
}

# quality CASE SCALE: of the mesh made, see bench_cases.
quality() { "$bench_cases" quads "$1" "$2" "$made" 2>"$folder/output"; }

# run_near PROGRAM CASE NAME FACTOR: one timed run, the first, with FACTOR or one near it: factor.
run_near() {
  local percent
  rm -f "$3-$1.seconds"
  for percent in 1 0.99 1.01 0.98 1.02; do
    factor=$(awk -v f="$4" -v p=$percent 'BEGIN {print f * p}')
    if run "$1" "$2" "$3" "$factor"; then return; fi
  done
  return 2
}

# run_fitting PROGRAM CASE NAME SCALE: the same with the factor that makes the number right.
run_fitting() {
  local ratio _
  run_near "$1" "$2" "$3" 1 || return 2
  [ -z "$as_given" ] || return 0
  for _ in 1 2 3; do
    ratio=$(quality "$2" "$4") || return 2
    ratio=$(cut -f 3 <<<"$ratio")
    awk -v r="$ratio" 'BEGIN {exit !(r < 0.96 || r > 1.04)}' || return 0
    run_near "$1" "$2" "$3" "$(awk -v f="$factor" -v r="$ratio" 'BEGIN {print f * sqrt(r)}')" ||
      return 2
  done
}

# row PROGRAM CASE NAME SCALE: one line of the table.
row() {
  local seconds result
  result=$(quality "$2" "$4") || return 2
  seconds=$(column 1 "$3-$1.seconds")
  [ "$1" != best ] || best=$(echo "$seconds $result" | awk '{print $1 / $2}')
  awk -F '\t' -v p="$1" -v c="$2" -v f="$factor" -v s="$seconds" -v best="$best" '
    {printf "| %-21s | %-12s | %7.3f | %6d | %4d | %8.3f | %9.4f | %6.3f | %5d | %3.0f-%-3.0f | %8.3f | %7.3f | %7.2f | %6.1f | ",
      c, p, f, $1, $2, $3, $4, $5, $6, $7, $8, $9, $10, s, $1 / s / 1e3
     if (best > 0) printf "%6.2f |\n", s / $1 / best; else print "       |"}' <<<"$result"
}

# timed PROGRAM CASE NAME SCALE: all runs.
timed() {
  local i
  case " $others " in
    *" $1 "*) run_fitting "$@" || return 2 ;;
    *) run_near "$1" "$2" "$3" 1 || return 2 ;;
  esac
  for ((i = 1; i < repetitions; ++i)); do run "$1" "$2" "$3" "$factor" || return 2; done
}

# measure PROGRAM CASE NAME SCALE
measure() {
  local factor=1 made=''
  timed "$@" && row "$@" && return
  printf '| %-21s | %-12s | failed: %s\n' "$2" "$1" "$(tail -1 "$folder/output")"
}

# programs_for SIZE CASE
programs_for() {
  if [ -n "$programs" ]; then echo "$programs"; return; fi
  echo best fast paper
  [ "$1" != paper ] || echo "$starts"
  echo bamg gmsh-blossom gmsh-full
  ! isotropic "$2" || echo gmsh-packing
}

# cases_for SIZE
cases_for() {
  if [ ${#cases[@]} -gt 0 ]; then echo "${cases[@]}"; return; fi
  echo example-2 example-2-anisotropic
  [ "$1" != paper ] || echo wall arc
}

# header SIZE
header() {
  printf '| %-21s | program      | sizes x | quads  | tri  | by ideal | beta mean | min    | bad   | angles  | .5-1.5 %% | band %%  | seconds | k/s    | x time |\n' "size: $1"
  echo "| --------------------- | ------------ | ------- | ------ | ---- | -------- | --------- | ------ | ----- | ------- | -------- | ------- | ------- | ------ | ------ |"
}

for size in $sizes; do
  echo
  header "$size"
  for case in $(cases_for "$size"); do
    name=$folder/$case-$size best=0
    elements=paper limit=20000
    if [ "$size" != paper ]; then
      elements=$(awk -v n="$size" 'BEGIN {print 2.3094 * n}') limit=$((2 * size))
    fi
    scale=$("$bench_cases" make "$case" "$elements" "$name")
    "$bench_cases" gmsh "$case" "$name"
    for program in $(programs_for "$size" "$case"); do
      measure "$program" "$case" "$name" "$scale"
    done
  done
done
