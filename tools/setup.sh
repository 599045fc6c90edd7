#!/usr/bin/env bash
# Installs what Stemwise is built from on Debian 12. Works as root, or with sudo. Says what it installs; quick when all is there.
#   tools/setup.sh          what building, testing and running need
#   tools/setup.sh --lint   clang-format and clang-tidy too
set -euo pipefail

packages=(
  g++ cmake make ninja-build pkg-config ccache lld
  libvtk9-dev libglfw3-dev libimgui-dev libeigen3-dev libnanoflann-dev libceres-dev libgeographiclib-dev
  libgdal-dev gdal-bin proj-data libpcl-dev libopencv-core-dev libopencv-imgproc-dev libopencv-imgcodecs-dev
  libcli11-dev nlohmann-json3-dev libspdlog-dev libgtest-dev libgmock-dev libbenchmark-dev
  libcairo2-dev libpango1.0-dev libegl-dev libglew-dev libgl1-mesa-dri libegl1
  fonts-dejavu-core fonts-font-awesome fonts-roboto-unhinted
  xvfb xauth xdotool imagemagick x11-utils poppler-utils python3
)
[ "${1:-}" = "--lint" ] && packages+=(clang-format clang-tidy)

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null || true)
  [ "$status" = "install ok installed" ] || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  echo "setup: everything is installed (${#packages[@]} packages)"
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "setup: these Debian packages are missing, and this is neither root nor is there sudo:" >&2
    echo "  apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

echo "setup: installing ${#missing[@]} Debian packages (up to 3 GB with what they need, some minutes): ${missing[*]}"
log=$(mktemp)
export DEBIAN_FRONTEND=noninteractive
if ! { "${as_root[@]}" apt-get update && "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"; } >"$log" 2>&1; then
  tail -n 25 "$log" >&2
  echo "setup: apt-get failed; its whole output is in $log" >&2
  exit 1
fi
rm -f "$log"
echo "setup: done"
