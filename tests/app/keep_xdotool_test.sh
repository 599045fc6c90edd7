#!/usr/bin/env bash
# Work is kept on the real window, between real processes: a window that is killed, and whose number another process has by
# now (or is a zombie still), is offered again; a command that changes the open project is seen, and saving over it asks.
# Usage: keep_xdotool_test.sh STEMWISE. Exit code 77: skipped, with the reason.
source "$(dirname "$0")/xdotool_window.sh" "$1"

"$stemwise" simulate -o "$folder/forest" --years 2018,2023 --stems 150 --seed 3 --quiet
"$stemwise" align "$folder/forest/2018.csv" "$folder/forest/2023.csv" -o "$folder/stand.gpkg" --quiet
open_window "$folder/stand.gpkg"
press n a
await "tabs/Edit log" = 1
kept=$folder/config/stemwise/autosave
"$stemwise" merge "$folder/stand.gpkg" --policy newest --quiet
press ctrl+s
await question/other is there
click question/no
echo "a command changed the file: saving asks"
kill -9 "$window_pid"
wait "$window_pid" 2> /dev/null || true
for end in gpkg gpkg.json; do mv "$kept/$window_pid.$end" "$kept/1.$end"; done  # as after a start of the machine: the number is another's
open_window
await recover/yes is there
click recover/later
click empty/recent/1
await recover/yes is there
click recover/yes
await "tabs/Edit log" = 1
press ctrl+s
await question/other is there
click question/other
[ -s "$folder/stand-copy.gpkg" ] || fail "no copy"
echo "brought back, and saved as a copy"
