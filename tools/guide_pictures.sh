#!/usr/bin/env bash
# Makes the window's pictures of README and guide, without a display:
#   tools/guide_pictures.sh [WIDTHxHEIGHT] [light|dark] [CHAPTER...]
# Chapters (all of them when none is named): import walk underlay states decisions dialogs compare
set -euo pipefail
cd "$(dirname "$0")/.."
size=${1:-1280x720}
theme=${2:-light}
chapters=${*:3}
width=${size%x*}
height=${size#*x}
stemwise=build/release/bin/stemwise
out=docs/guide/$theme-$size
mkdir -p "$out"
table=$(mktemp -d)
trap 'rm -rf "$table"' EXIT
export SOURCE_DATE_EPOCH=1795860000  # the time of every decision
export TZ=UTC
source tools/guide_data.sh

# play [FILE...] < LINES: runs the lines of app/window/window_script.hpp in a window that opens the files. "shot NAME" takes a
# picture when everything is at rest and the mouse stands aside; "config" may be the first line.
play() {
  local lines=$table/lines
  sed -e "s|^shot \(.*\)|settle\nscreenshot $out/\1.png|" > "$table/told"
  { grep '^config ' "$table/told" || true; printf 'size %s %s\ntheme %s\n' "$width" "$height" "$theme"; grep -v '^config ' "$table/told"; } > "$lines"
  "$stemwise" gui --script "$lines" "$@"
}

# Lines that many chapters begin with.
align='do step.align
click align/run
settle'
demo="click empty/demo
settle
$align"
aside='move 10 300'

chapter_import() {
  make_table
  play "$table/plot_2021.csv" <<< 'shot 11-import'
  make_broken_tables
  play "$table/broken/stand_2022.csv" "$table/broken/weather.csv" <<< 'shot 27-import-errors'
}

# From the empty window to the report.
chapter_walk() {
  play << END
shot 1-empty
click empty/demo
settle
do step.inventories
shot 2-inventories
$align
do step.align
$aside
wait 10
shot 3-align
do step.review
key N
wait 10
shot 4-review
do view.mode
shot 5-review-3d
do view.mode
do heat.times_seen
shot 12-heat-map
do heat.times_seen
click tabs/Matches
shot 6-matches
click tabs/Growth
shot 7-growth
do step.merge
shot 8-merge
do step.report
click tabs/Jobs
wait 10
shot 9-report
do export.preview_report
wait 10
settle
wait 10
shot 33-report-pages
click dialog/Growth report, as it will be printed/close
wait 5
do help.keys
shot 10-keys
END
}

chapter_underlay() {
  make_scan
  play "$table/sim/2018.csv" "$table/sim/2023.csv" << END
settle
$align
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
shot 13-underlay
END
}

# The states that a panel can be in: working, refused, and full (empty is the first picture); and the forms of steps 4 and 5.
chapter_states() {
  make_control_points
  play << END
click empty/demo
settle
do step.align
click align/run
$aside
screenshot $out/14-working.png
settle
do step.merge
wait 100
click merge/kind/control
fill merge/control_file $table/control.csv
click tabs/Growth
settle
wheel $((width - 100)) 400 -30
$aside
shot 15-control-points
do step.report
click report/open_export
click report/open_rules
click growth/choose/0
click growth/choose/0/Residual directions
$aside
shot 16-rules-and-rose
click report/open_rules
click report/open_report
click report/open_check
$aside
shot 29-field-check
END
  make_frames_and_track
  play "$table"/frames/2019* "$table"/frames/2023* << END
settle
$align
do step.merge
wait 100
click merge/kind/gnss
fill merge/gnss_file $table/track.csv
settle
click tabs/Growth
wheel $((width - 100)) 400 -30
$aside
shot 28-gnss-track
END
  make_strangers
  play "$table/a/2015.csv" "$table/b/2023.csv" << END
settle
$align
do step.align
click align/survey/2023
settle
click align/rescue/2023
click align/rescue/pick
wait 100
$aside
shot 17-refused
END
  make_full
  play "$table"/full/20*.csv << END
settle
$align
do step.review
key N
wait 10
shot 18-full
END
}

# Decisions, their history, and what the surveys contradict each other in.
chapter_decisions() {
  play << END
$demo
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
$aside
shot 19-edit-log
click tabs/Conflicts
click conflicts/row/0
do step.merge
click merge/tree
$aside
shot 20-conflicts
do edit.history
shot 21-history
click dialog/Undo history/close
do help.palette
settle
type colour
shot 22-palette
END
  play << END
$demo
do step.review
wait 100
do tool.lasso
$(lasso_corners)
key Enter
$aside
shot 30-group
END
}

# A polygon in the middle of the map.
lasso_corners() {
  local middle=$(((272 + width - 360) / 2)) top=200
  local deep=$((height * 28 / 100))
  printf 'click-at %d %d\n' $((middle - 90)) $((top + 20)) $((middle + 60)) $top $((middle + 100)) $((top + deep / 2)) $((middle + 20)) $((top + deep)) $((middle - 80)) $((top + deep - 20))
}

chapter_dialogs() {
  make_full
  play << END
do file.add
settle
fill files/path $table/full
move 700 600
shot 23-files
END
  mkdir -p "$table/kept"
  play << END
config $table/kept
$demo
do step.review
key N
settle
key A
settle
wait 100
do file.quit
shot 25-leave
click leave/cancel
do help.about
shot 26-about
click dialog/About Stemwise/close
click menu/View
click menu/more/Colour by
shot 32-menu
END
  play << END
config $table/kept
shot 24-recovery
END
}

# The last two surveys in one picture, with a bar between them.
chapter_compare() {
  play << END
$demo
do step.review
key N
wait 10
settle
do view.slide
do color.inventory
$aside
shot 31-slide
END
}

for chapter in ${chapters:-import walk underlay states decisions dialogs compare}; do "chapter_$chapter"; done
echo "pictures in $out"
