#!/usr/bin/env bash
# Sets up, configures and builds one preset: tools/build.sh [release|dev|asan|tsan] [TARGET...]
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-release}
[ $# -gt 0 ] && shift
bash tools/setup.sh
if command -v ccache >/dev/null; then
  export STEMWISE_LAUNCHER=ccache CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1
fi
echo "build: configuring $preset"
cmake --preset "$preset" >"build-$preset.log" 2>&1 || { cat "build-$preset.log"; rm -f "build-$preset.log"; exit 1; }
rm -f "build-$preset.log"
arguments=()
[ $# -gt 0 ] && arguments=(--target "$@")
echo "build: building $preset ${*:-(everything)}"
cmake --build --preset "$preset" "${arguments[@]}"
