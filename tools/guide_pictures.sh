#!/usr/bin/env bash
# Makes the window's pictures of README and guide, without a display: tools/guide_pictures.sh [WIDTHxHEIGHT] [light|dark]
set -euo pipefail
cd "$(dirname "$0")/.."
size=${1:-1280x720}
theme=${2:-light}
stemwise=build/release/bin/stemwise
out=docs/guide/$theme-$size
mkdir -p "$out"
script=$(mktemp)
table=$(mktemp -d)
trap 'rm -rf "$script" "$table"' EXIT
# A table as people have them: no unit, one row that is none, codes for the status.
{ echo "nr;x;y;bhd;art;status"; for i in $(seq 1 60); do echo "$i;$((i * 7 % 50)),$((i % 10));$((i * 13 % 40)),5;$((12 + i * 5 % 38));$([ $((i % 3)) = 0 ] && echo Fichte || echo Buche);$([ $((i % 9)) = 0 ] && echo T || echo L)"; done; echo "61;here;3,5;20;Buche;L"; } > "$table/plot_2021.csv"
cat > "$script" << END
size ${size%x*} ${size#*x}
theme $theme
settle
screenshot $out/11-import.png
END
"$stemwise" gui --script "$script" "$table/plot_2021.csv"
cat > "$script" << END
size ${size%x*} ${size#*x}
theme $theme
screenshot $out/1-empty.png
click empty/demo
settle
do step.inventories
settle
screenshot $out/2-inventories.png
do step.align
click align/run
settle
do step.align
move 10 300
wait 10
screenshot $out/3-align.png
do step.review
key N
wait 10
screenshot $out/4-review.png
do view.mode
settle
screenshot $out/5-review-3d.png
do view.mode
do heat.times_seen
settle
screenshot $out/12-heat-map.png
do heat.times_seen
click tabs/Matches
settle
screenshot $out/6-matches.png
click tabs/Growth
settle
screenshot $out/7-growth.png
do step.merge
settle
screenshot $out/8-merge.png
do step.report
click tabs/Jobs and notices
wait 10
screenshot $out/9-report.png
do help.keys
settle
screenshot $out/10-keys.png
END
"$stemwise" gui --script "$script"
echo "pictures in $out"
