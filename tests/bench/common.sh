# shellcheck shell=bash disable=SC2034,SC2154
# Shared by compare.sh and compare_quads.sh, which read it after `cd` to the root of the repository
# and after setting `folder` (empty: a temporary one, removed at the end) and `build`.

anisofront=$build/anisofront bench_cases=$build/tests/bench/bench_cases

# require PROGRAM...: stops with exit code 2 when one is not there.
require() {
  local program
  for program in "$@"; do
    command -v "$program" >/dev/null || { echo "$(basename "$0"): no $program" >&2; exit 2; }
  done
}

make_folder() {
  if [ -z "$folder" ]; then
    folder=$(mktemp -d)
    trap 'rm -rf "$folder"' EXIT
  fi
  mkdir -p "$folder"
}

# on_core_0 RESULT COMMAND...: appends a line "seconds kilobytes" (user + system time, peak memory)
# to the file RESULT; returns 2 when the command fails, whose output is in $folder/output.
on_core_0() {
  local result=$1 cpu TIMEFORMAT='%3U %3S'
  shift
  cpu=$({ time /usr/bin/time -o "$folder/memory" -f %M taskset -c 0 "$@" >"$folder/output" 2>&1; } 2>&1) ||
    return 2
  echo "$cpu $(tail -1 "$folder/memory")" | awk '{print $1 + $2, $3}' >>"$result"
}

# column K FILE: median of column K.
column() { awk -v k="$1" '{print $k}' "$2" | sort -g | awk '{v[NR] = $1} END {print v[int((NR + 1) / 2)]}'; }
