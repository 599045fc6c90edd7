#!/usr/bin/env bash
# Sets up, builds, makes a forest surveyed in three years, and opens the window on it. Without a display: aligns it and
# leaves pictures, the merged inventory and the growth report in build/demo.
#   tools/demo.sh [--headless]
set -euo pipefail
cd "$(dirname "$0")/.."
bash tools/build.sh release stemwise
stemwise=$PWD/build/release/bin/stemwise
folder=$PWD/build/demo
mkdir -p "$folder"
cd "$folder"

echo "demo: a forest of 600 stems, surveyed in 2015, 2019 and 2023"
"$stemwise" simulate -o surveys --years 2015,2019,2023 --stems 600 --seed 1 --quiet
echo "demo: aligning the three surveys"
"$stemwise" align surveys/2015.csv surveys/2019.csv surveys/2023.csv -o demo.gpkg --json align.json
"$stemwise" georeference demo.gpkg --anchor 48.77214,9.16621,412.5,37

if [ "${1:-}" != "--headless" ] && [ -n "${DISPLAY:-}" ]; then
  echo "demo: opening the window (close it to come back)"
  "$stemwise" gui demo.gpkg && exit 0
  echo "demo: the window could not be opened"
fi

echo "demo: without a display, so the results go to files"
"$stemwise" snapshot demo.gpkg -o map.png --view map --color-by fate
"$stemwise" snapshot demo.gpkg -o forest.png --view 3d --color-by dbh
"$stemwise" export demo.gpkg -o trees.gpkg
"$stemwise" export demo.gpkg -o matches.csv --layer matches
"$stemwise" report demo.gpkg -o report.html
"$stemwise" report demo.gpkg -o report.pdf
echo "demo: look into $folder"
ls -1 "$folder"
