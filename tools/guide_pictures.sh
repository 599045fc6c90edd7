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
settle
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
click tabs/Jobs
wait 10
screenshot $out/9-report.png
do help.keys
settle
screenshot $out/10-keys.png
END
"$stemwise" gui --script "$script"
# A point cloud under the stems: what a scanner might have seen of a simulated forest.
"$stemwise" simulate -o "$table/sim" --years 2018,2023 --stems 260 --area-ha 0.4 --seed 3 > /dev/null 2>&1
awk -F, 'BEGIN { srand(1) }
  NR > 1 {
    d = ($5 > 0 ? $5 : 15) / 100; h = 1.3 + 30 * (1 - exp(-3.2 * d))
    for (i = 0; i < 420; i++) {
      a = 6.2832 * rand(); u = rand(); r = d / 2; z = h * 0.6 * rand()
      if (u < 0.35) { z = 0.05 * rand(); r = 3.5 * sqrt(rand()) }
      else if (u > 0.6) { t = rand(); z = h * (0.4 + 0.6 * t); r = (1 - t) * (1 + 5 * d) * sqrt(rand()) + 0.1 }
      low = u < 0.35 ? 0 : z
      printf "%.3f %.3f %.3f\n", $2 + $6 * low + r * cos(a), $3 + $7 * low + r * sin(a), $4 + z
    }
  }' "$table/sim/2023.csv" > "$table/points"
{ printf 'ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\nend_header\n' "$(wc -l < "$table/points")"; cat "$table/points"; } > "$table/sim/scan_2023.ply"
cat > "$script" << END
size ${size%x*} ${size#*x}
theme $theme
settle
do step.align
click align/run
settle
do step.review
do view.bottom
do file.underlay
settle
click files/entry/scan_2023.ply
click files/accept
settle
wait 10
do view.mode
settle
click viewport/layers
settle
screenshot $out/13-underlay.png
END
"$stemwise" gui --script "$script" "$table/sim/2018.csv" "$table/sim/2023.csv"

# The states that a panel can be in: working, refused, and full. (Empty is the first picture.)
cat > "$script" << END
size ${size%x*} ${size#*x}
theme $theme
click empty/demo
settle
do step.align
click align/run
move 10 300
screenshot $out/14-working.png
settle
do step.merge
wait 100
click merge/kind/control
fill merge/control_file $table/control.csv
click tabs/Growth
settle
wheel $((${size%x*} - 100)) 400 -30
move 10 300
settle
screenshot $out/15-control-points.png
do step.report
click report/open_export
click report/open_rules
click growth/choose/0
click growth/choose/0/Residual directions
move 10 300
settle
screenshot $out/16-rules-and-rose.png
END
# Points around the stand whose places agree to some centimetres; the last one was read wrongly.
{ echo "x_m,y_m,lat,lon,height_m"
  awk 'BEGIN { n = split("-245 -5 -145 0 -142 92 -240 88 -195 45 -175 20", p, " "); for (i = 1; i < n; i += 2) { e = (i * 7 % 5 - 2) * 0.03; x = p[i]; y = p[i + 1];
    printf "%.2f,%.2f,%.8f,%.8f,%.2f\n", x, y, 48.77214 + (y + e + (i > 10 ? 14 : 0)) / 111206.0, 9.16621 + (x - e) / 73465.0, 412 } }'; } > "$table/control.csv"
"$stemwise" gui --script "$script"
"$stemwise" simulate -o "$table/a" --stems 400 --years 2015,2019 --seed 1 -q
"$stemwise" simulate -o "$table/b" --stems 30 --years 2023,2027 --seed 2 -q
cat > "$script" << END
size ${size%x*} ${size#*x}
theme $theme
settle
do step.align
click align/run
settle
do step.align
click align/survey/2023
settle
click align/rescue/2023
click align/rescue/pick
wait 100
move 10 300
screenshot $out/17-refused.png
END
"$stemwise" gui --script "$script" "$table/a/2015.csv" "$table/b/2023.csv"
"$stemwise" simulate -o "$table/full" --stems 2200 --years 2003,2008,2013,2018,2023 --seed 5 -q
cat > "$script" << END
size ${size%x*} ${size#*x}
theme $theme
settle
do step.align
click align/run
settle
do step.review
key N
wait 10
settle
screenshot $out/18-full.png
END
"$stemwise" gui --script "$script" "$table"/full/20*.csv
# Decisions, their history, what the surveys contradict each other in; finding files and commands.
export SOURCE_DATE_EPOCH=1795860000  # the decisions' time
cat > "$script" << END
size ${size%x*} ${size#*x}
theme $theme
click empty/demo
settle
do step.align
click align/run
settle
do step.review
key N
settle
key A
settle
key N
settle
key R
settle
key N
settle
key A
settle
wait 100
click tabs/Edit log
move 10 300
settle
screenshot $out/19-edit-log.png
click tabs/Conflicts
click conflicts/row/0
do step.merge
click merge/tree
move 10 300
settle
screenshot $out/20-conflicts.png
do edit.history
settle
screenshot $out/21-history.png
click dialog/Undo history/close
do help.palette
settle
type colour
settle
screenshot $out/22-palette.png
END
"$stemwise" gui --script "$script"
cat > "$script" << END
size ${size%x*} ${size#*x}
theme $theme
do file.add
settle
fill files/path $table/full
move 700 600
settle
screenshot $out/23-files.png
END
"$stemwise" gui --script "$script"
echo "pictures in $out"
