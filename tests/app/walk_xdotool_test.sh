#!/usr/bin/env bash
# The whole job on the real window under a virtual display, with real keys and clicks: three messy files by the import dialog,
# the demo aligned, twenty rows of the queue by keys only, a split and a link by the mouse, all undone and redone, the process
# killed; another one brings the work back and exports it. tests/app/window/walk_window_test.cpp does the same without a display.
# Usage: walk_xdotool_test.sh STEMWISE [FOLDER_OF_SHARED_DATA]. Exit code 77: skipped, with the reason.
source "$(dirname "$0")/xdotool_window.sh" "$1"
names=(fia_azimuth_dist_feet_inches.csv fortls_tree.list.multi.tls.csv paracou_circumference_utm_latlon.csv)
messy=${STEMWISE_SHARED_DATA:-${2:-}}/messy
[ -d "$messy" ] || messy=$tests/messy  # of the same kinds, but small and made up
echo "the messy files are those of $messy"
SECONDS=0
tell() { echo "$(printf '%3d' "$SECONDS") s  $1"; }

checks() { python3 -SE "$tests/walk_checks.py" "$@"; }
# What autosave has of the window that is open, copied to this file.
keep_autosave() { cp "$XDG_CONFIG_HOME/stemwise/autosave/$window_pid.gpkg" "$1" || fail "autosave has no copy"; }
histories() { ui paths review/history/; }

import_messy_files() {
  press ctrl+i
  fill files/path "$messy"
  press Return
  click "files/entry/${names[0]}"
  ctrl_click "files/entry/${names[1]}"
  ctrl_click "files/entry/${names[2]}"
  click files/accept
  await import/add = "Add 3 inventories"
  click import/file/0
  click import/plot   # four subplots lie over each other: one is wanted
  click import/plot/1
  click import/add
  await steps/1 = "3 surveys"
  keep_autosave "$folder/messy.gpkg"
  checks messy "$folder/messy.gpkg" "${names[@]/#/$messy/}" || fail "the messy files were not understood"
  tell "three messy files by the import dialog"
}

open_and_align_the_demo() {
  press ctrl+d
  click leave/discard
  await steps/1 = "3 surveys" steps/2 = "not aligned yet" window/settled = yes
  press ctrl+r
  await steps/2 = "all aligned"
  tell "the demo is aligned"
}

decide_twenty_rows_by_keys() {
  local of_matches=(a r u) of_fates=(a shift+r shift+d) i keys
  for i in $(seq 0 19); do
    press n
    await review/tree is there
    if [ "$(ui get review/reject enabled)" = yes ]; then keys=("${of_matches[@]}"); else keys=("${of_fates[@]}"); fi
    press "${keys[$((i % 3))]}"
    await "tabs/Edit log" = "$((i + 1))"
  done
  tell "twenty rows of the queue by keys"
}

# A tree that was seen three times and that a click on the map means: its place in x and y, its label in tree.
find_tree_seen_three_times() {
  local rows try
  for try in $(seq 8); do
    mapfile -t rows < <(ui paths matches/row/)   # the table follows what is selected
    click "${rows[$((try % 3 + 3))]}"
    tree=$(value review/tree)
    [ "$(histories | wc -l)" = 3 ] || continue
    x=$(ui get viewport/tree x) y=$(ui get viewport/tree y)
    click_at $((x + 60)) $((y + 33))
    click_at "$x" "$y"
    [ "$(value review/tree)" = "$tree" ] && return
  done
  fail "no tree of the table can be clicked on the map"
}

split_and_link_by_mouse() {
  local x y tree stems survey
  click tabs/Matches
  find_tree_seen_three_times
  mapfile -t stems < <(histories)
  click "${stems[1]}"
  click review/split
  await "tabs/Edit log" = 21 review/tree != "$tree"
  # The two lie on each other: with the later surveys hidden a click can only mean the earlier one.
  click review/link
  for survey in 1 2; do
    survey=${stems[$survey]#review/history/}
    click "inventories/${survey%%:*}/eye"
  done
  click_at "$x" "$y"
  await "tabs/Edit log" = 22
  [ "$(histories | wc -l)" = 3 ] || fail "the stems are not linked again"
  tell "$tree is split and linked by the mouse"
}

undo_and_redo_all() {
  local steps keys=()
  keep_autosave "$folder/before.gpkg"
  press ctrl+h
  steps=$(ui paths history/ | sed 's/.*\///' | sort -n | tail -1)
  press Escape
  for _ in $(seq "$steps"); do keys+=(ctrl+z); done
  press "${keys[@]}"
  await steps/1 = "none yet" "tabs/Edit log" = ""
  press "${keys[@]//z/y}"
  await steps/2 = "all aligned" "tabs/Edit log" = 22
  keep_autosave "$folder/after.gpkg"
  checks same "$folder/before.gpkg" "$folder/after.gpkg" || fail "the project is not what it was before all was undone and redone"
  tell "all $steps changes undone and redone"
}

kill_and_recover() {
  local status=0
  kill -KILL "$window_pid"
  wait "$window_pid" 2> /dev/null || status=$?
  [ "$status" = 137 ] || fail "the process ended with $status, not by SIGKILL"
  open_window
  await recover/yes is there
  click recover/yes
  await steps/2 = "all aligned" "tabs/Edit log" = 22 window/settled = yes
  keep_autosave "$folder/recovered.gpkg"
  checks same "$folder/before.gpkg" "$folder/recovered.gpkg" || fail "what was brought back is not what was there"
  tell "killed, opened again, brought back"
}

export_and_check() {
  local trees
  press 5
  fill export/path "$folder/trees.csv"
  click export/run
  fill export/path "$folder/trees.gpkg"
  click export/run
  "$stemwise" export "$folder/before.gpkg" -o "$folder/expected.csv" --quiet
  cmp "$folder/expected.csv" "$folder/trees.csv" || fail "the export is not that of the project before the kill"
  trees=$(($(wc -l < "$folder/trees.csv") - 1))
  "$stemwise" info "$folder/trees.gpkg" > "$folder/info" || fail "the export cannot be read"
  grep -q "stems *$trees\$" "$folder/info" || fail "not $trees trees in the GeoPackage: $(cat "$folder/info")"
  if command -v ogrinfo > /dev/null; then
    ogrinfo -so "$folder/trees.gpkg" trees | grep -q "Feature Count: $trees\$" || fail "GDAL does not find $trees trees in the GeoPackage"
  fi
  tell "$trees trees exported and checked"
}

open_window
import_messy_files
open_and_align_the_demo
decide_twenty_rows_by_keys
split_and_link_by_mouse
undo_and_redo_all
kill_and_recover
export_and_check
echo "passed"
