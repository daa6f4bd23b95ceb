#!/bin/sh
# Installs the Debian 12 packages that the program needs: to build, to run, to draw figures.
#
#   sh tests/tools/setup.sh [--tests] [--bench]
#
# --tests adds what check.sh needs, --bench what tests/bench needs. Runs as root or through sudo;
# does nothing when all packages are there.
set -eu

packages="g++ cmake ninja-build ccache libeigen3-dev libsuitesparse-dev libopenblas-dev
  zlib1g-dev liblemon-dev libcli11-dev libspdlog-dev nlohmann-json3-dev libtomlplusplus-dev libmuparser-dev
  gnuplot-nox librsvg2-bin"
for option in "$@"; do
  case "$option" in
    --tests) packages="$packages clang-format doctest-dev librapidcheck-dev libcgal-dev gmsh
      universal-ctags chromium nodejs dpkg-dev" ;;
    --bench) packages="$packages libbenchmark-dev freefem++ gmsh rheolef jq time" ;;
    *) echo "setup.sh: unknown option $option; there are --tests and --bench" >&2; exit 3 ;;
  esac
done

is_installed() { [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

missing=
for package in $packages; do
  is_installed "$package" || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

as_root=
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "setup.sh: run as root, or install sudo; missing packages:$missing" >&2
    exit 2
  fi
  as_root=sudo
fi
$as_root apt-get -q update
# shellcheck disable=SC2086 # one word per package
$as_root env DEBIAN_FRONTEND=noninteractive apt-get -qy install --no-install-recommends $missing
