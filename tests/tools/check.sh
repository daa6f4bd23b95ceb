#!/bin/sh
# The one gate, the same here and in CI: formatting, then the fast tests in a normal build and once
# more under the address and undefined-behaviour sanitizers.
#
#   sh tests/tools/check.sh [--no-format] [--no-dev] [--no-sanitize]
set -eu
cd "$(dirname "$0")/../.."

format=yes dev=yes sanitize=yes
for option in "$@"; do
  case "$option" in
    --no-format) format= ;;
    --no-dev) dev= ;;
    --no-sanitize) sanitize= ;;
    *) echo "check.sh: unknown option $option; there are --no-format, --no-dev, --no-sanitize" >&2
       exit 3 ;;
  esac
done
CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
export CMAKE_BUILD_PARALLEL_LEVEL

if [ -n "$format" ]; then
  find mesher solver adapt drivers tests -name '*.[ch]pp' -print0 |
    xargs -0 clang-format --dry-run --Werror
  echo "formatting is as .clang-format says"
fi
[ -z "$dev" ] || cmake --workflow --preset dev
[ -z "$sanitize" ] || cmake --workflow --preset sanitize
