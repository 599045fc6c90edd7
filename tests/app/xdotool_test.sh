#!/usr/bin/env bash
# The main job on the real window, with real clicks and keys under a virtual display: open two surveys, align, click a stem,
# unlink and relink, undo, export, check the file. Usage: xdotool_test.sh STEMWISE. Exit code 77: skipped, with the reason.
set -euo pipefail
stemwise=$1
for tool in Xvfb xdotool python3; do
  command -v "$tool" > /dev/null || { echo "SKIPPED: $tool is not installed"; exit 77; }
done
folder=$(mktemp -d)
pids=()
finish() { for pid in "${pids[@]}"; do kill "$pid" 2> /dev/null || true; done; wait 2> /dev/null || true; rm -rf "$folder"; }
trap finish EXIT
fail() { echo "FAILED: $1"; [ -n "${KEEP_SCREENSHOT:-}" ] && import -window root "$KEEP_SCREENSHOT"; exit 1; }

export HOME=$folder XDG_CONFIG_HOME=$folder/config USER=tester
"$stemwise" simulate -o "$folder/forest" --years 2018,2023 --stems 150 --seed 3 --quiet
Xvfb -displayfd 3 -noreset -screen 0 1600x1000x24 3> "$folder/display" 2> /dev/null &
pids+=($!)
for _ in $(seq 100); do [ -s "$folder/display" ] && break; sleep 0.1; done
[ -s "$folder/display" ] || { echo "SKIPPED: Xvfb does not start"; exit 77; }
DISPLAY=:$(cat "$folder/display"); export DISPLAY
"$stemwise" gui --width 1600 --height 1000 --ui-json "$folder/ui.json" "$folder/forest/2018.csv" "$folder/forest/2023.csv" 2> "$folder/errors" &
pids+=($!)

# One number or text of a widget; nothing when it is not there.
widget() { python3 - "$folder/ui.json" "$1" "$2" << 'PY'
import json, sys
try:
    entry = json.load(open(sys.argv[1]))[sys.argv[2]]
except (OSError, ValueError, KeyError):
    sys.exit()
what = sys.argv[3]
print(int(entry["x"] + entry["width"] / 2) if what == "cx" else int(entry["y"] + entry["height"] / 2) if what == "cy" else entry[what])
PY
}
# Waits until a widget's value is (or, with !, is not) a text.
await() {
  for _ in $(seq 600); do
    value=$(widget "$1" value)
    if [ "$2" = "!" ]; then [ -n "$value" ] && [ "$value" != "$3" ] && return; else [ "$value" = "$2" ] && return; fi
    sleep 0.1
  done
  fail "$1 is \"$value\", not \"$2 ${3:-}\"; $(cat "$folder/errors")"
}
click_at() { xdotool mousemove "$1" "$2"; sleep 0.3; xdotool mousedown 1; sleep 0.2; xdotool mouseup 1; sleep 0.4; }
click() {
  for _ in $(seq 100); do [ -n "$(widget "$1" cx)" ] && break; sleep 0.1; done
  click_at "$(widget "$1" cx)" "$(widget "$1" cy)"
}
key() { xdotool keydown "$1"; sleep 0.2; xdotool keyup "$1"; sleep 0.4; }
ctrl() { xdotool keydown ctrl; sleep 0.1; key "$1"; xdotool keyup ctrl; sleep 0.3; }

await steps/1 "2 surveys"
xdotool windowfocus "$(xdotool search --name Stemwise | head -1)" || true
sleep 0.5
key 2
click align/run
await steps/2 "all aligned"
ctrl h   # an entry of the undo history says that the alignment is one
await history/2 ! ""
key Escape
click tabs/Matches
click matches/row/3
await review/tree ! ""
tree=$(widget review/tree value)
sleep 0.5
x=$(widget viewport/tree cx); y=$(widget viewport/tree cy)
click_at $((x + 60)) $((y + 33))     # somewhere else
click_at "$x" "$y"
await review/tree "$tree"
echo "clicked $tree in the map"
key u
await "tabs/Edit log" 1
echo "unlinked"
key l                                # relink: L, then the other survey's stem of the same tree, with only that survey shown
click view/compare/0
click_at "$x" "$y"
await "tabs/Edit log" 2
echo "relinked"
click view/compare/1
ctrl z
await "tabs/Edit log" 1
ctrl z
await "tabs/Edit log" ""
ctrl y
await "tabs/Edit log" 1
ctrl z
await "tabs/Edit log" ""
key 5
click export/path
ctrl a
xdotool type --delay 60 "$folder/out.gpkg"
sleep 0.5
click export/run
for _ in $(seq 300); do [ -s "$folder/out.gpkg" ] && break; sleep 0.1; done
[ -s "$folder/out.gpkg" ] || fail "nothing was exported"
"$stemwise" info "$folder/out.gpkg" || fail "the export cannot be read"
if command -v ogrinfo > /dev/null; then ogrinfo -al -so "$folder/out.gpkg" | grep "Feature Count" || fail "GDAL cannot read the export"; fi
echo "passed"
