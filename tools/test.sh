#!/usr/bin/env bash
# Sets up, builds and runs every test; the last line is "N passed, N failed, N skipped".
#   tools/test.sh [PRESET]    release (default), dev, asan or tsan; further arguments go to ctest
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-release}
[ $# -gt 0 ] && shift
bash tools/build.sh "$preset"
results=$PWD/build/$preset/test-results.xml
status=0
ctest --test-dir "build/$preset" --output-on-failure --output-junit "$results" -j "$(nproc)" --timeout 900 "$@" || status=$?
bash tools/count_tests.sh "$status" "$results"
