#!/usr/bin/env bash
# The main job on the real window, with real clicks and keys under a virtual display: open two surveys, align, click a stem,
# unlink and relink, undo, export, check the file; and what is done while the window cannot draw is done in its order and place.
# Usage: xdotool_test.sh STEMWISE. Exit code 77: skipped, with the reason.
source "$(dirname "$0")/xdotool_window.sh" "$1"

"$stemwise" simulate -o "$folder/forest" --years 2018,2023 --stems 150 --seed 3 --quiet
open_window "$folder/forest/2018.csv" "$folder/forest/2023.csv"
await steps/1 = "2 surveys"
press 2
click align/run
await steps/2 = "all aligned"
press ctrl+h   # an entry of the undo history says that the alignment is one
await history/2 is there
press Escape
click tabs/Matches
click matches/row/3
tree=$(value review/tree)
x=$(ui get viewport/tree x) y=$(ui get viewport/tree y)
click_at $((x + 60)) $((y + 33))     # somewhere else
await review/tree != "$tree"
click_at "$x" "$y"
await review/tree = "$tree"
echo "clicked $tree in the map"
press u
await "tabs/Edit log" = 1
press l                              # relink: L, then the other survey's stem of the same tree, with only that survey shown
click view/compare/0
click_at "$x" "$y"
await "tabs/Edit log" = 2
click view/compare/1
echo "unlinked and relinked"
press ctrl+z ctrl+z
await "tabs/Edit log" = ""
press ctrl+y
await "tabs/Edit log" = 1
press ctrl+z
await "tabs/Edit log" = ""

# What comes while the process stands still comes within one frame: a click, and the mouse is away again; a field, all of it
# marked, letters, Enter and two keys.
step_x=$(ui get steps/5 x) step_y=$(ui get steps/5 y)
kill -STOP "$window_pid"
xdotool mousemove "$step_x" "$step_y" click 1 mousemove 5 995
kill -CONT "$window_pid"
await export/run is there window/settled = yes
path_x=$(ui get export/path x) path_y=$(ui get export/path y)
kill -STOP "$window_pid"
xdotool mousemove "$path_x" "$path_y" click 1 mousemove 5 995 key ctrl+a type "$folder/out.gpkg"
xdotool key Return 4 5
kill -CONT "$window_pid"
await export/path = "$folder/out.gpkg" window/settled = yes
expected=$(value window/inputs)
echo "clicks and letters came in their order and place"
click export/run
[ -s "$folder/out.gpkg" ] || fail "nothing was exported"
"$stemwise" info "$folder/out.gpkg" || fail "the export cannot be read"
if command -v ogrinfo > /dev/null; then ogrinfo -al -so "$folder/out.gpkg" | grep "Feature Count" || fail "GDAL cannot read the export"; fi
echo "passed"
