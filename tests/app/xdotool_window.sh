# The real window under a virtual display, with real keys and clicks. Sourced by the tests beside it: source xdotool_window.sh STEMWISE
# Nobody sleeps: after every key and click it waits until the window has dealt with it and come to rest (window/inputs and
# window/settled of --ui-json). Leaves with 77 (skipped) where there is no Xvfb or xdotool, and says so.
set -euo pipefail
stemwise=$(realpath "$1")
tests=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
for tool in Xvfb xdotool python3; do
  command -v "$tool" > /dev/null || { echo "SKIPPED: $tool is not installed"; exit 77; }
done
folder=$(mktemp -d)
display_pid="" window_pid="" window_id="" expected=0 most_seconds=${WINDOW_TEST_SECONDS:-90}
finish() {
  for pid in $window_pid $display_pid; do kill "$pid" 2> /dev/null || true; done
  wait 2> /dev/null || true
  rm -rf "$folder"
}
trap finish EXIT
# Says what went wrong, what the window wrote and held; KEEP_SCREENSHOT=FILE.png keeps its picture.
fail() {
  echo "FAILED: $1"
  [ -s "$folder/errors" ] && cat "$folder/errors"
  [ -n "${KEEP_SCREENSHOT:-}" ] && import -window root "$KEEP_SCREENSHOT"
  [ -n "${KEEP_SCREENSHOT:-}" ] && cp "$folder/ui.json" "$KEEP_SCREENSHOT.json"
  exit 1
}

export HOME=$folder XDG_CONFIG_HOME=$folder/config USER=tester
unset SOURCE_DATE_EPOCH WAYLAND_DISPLAY
mkfifo "$folder/display"
Xvfb -displayfd 3 -noreset -screen 0 1600x1000x24 3<> "$folder/display" 2> /dev/null &
display_pid=$!
exec 4<> "$folder/display"
read -r -t 60 number <&4 || { echo "SKIPPED: Xvfb does not start"; exit 77; }
export DISPLAY=:$number

ui() { python3 -SE "$tests/ui_json.py" "$folder/ui.json" "$@"; }
value() { ui get "$1" value; }
# await PATH = TEXT: waits until it holds. Several of them: until they hold at once.
await() {
  local missed
  missed=$(ui wait "$most_seconds" "$@") || fail "$missed"
}
# Until the window has dealt with everything that was sent to it, and is at rest.
settle() { await window/inputs ">=" "$expected" window/settled = yes; }

# Starts the program with these arguments and gives it the keyboard.
open_window() {
  rm -f "$folder/ui.json"
  expected=0
  "$stemwise" gui --width 1600 --height 1000 --ui-json "$folder/ui.json" "$@" 2> "$folder/errors" &
  window_pid=$!
  settle
  local end=$((SECONDS + most_seconds))
  while [ "$SECONDS" -lt "$end" ]; do
    window_id=$(xdotool search --onlyvisible --name Stemwise 2> /dev/null | head -1) || true
    [ -n "$window_id" ] && xdotool windowfocus "$window_id" 2> /dev/null || true
    [ -n "$window_id" ] && [ "$(xdotool getwindowfocus 2> /dev/null)" = "$window_id" ] && return
  done
  fail "the window does not get the keyboard"
}

# press KEY...: chords in the words of xdotool (ctrl+shift+s), struck one after the other without a pause but xdotool's own
# 12 ms: GLFW takes a key that comes twice in one millisecond for an echo.
press() {
  local chord plus
  for chord in "$@"; do
    plus=${chord//[^+]/}
    expected=$((expected + 2 + 2 * ${#plus}))
  done
  xdotool key "$@"
  settle
}
click_at() {
  xdotool mousemove "$1" "$2" click 1
  expected=$((expected + 2))
  settle
}
click() {
  await "$1" is enabled
  click_at "$(ui get "$1" x)" "$(ui get "$1" y)"
}
ctrl_click() {
  await "$1" is enabled
  xdotool keydown ctrl mousemove "$(ui get "$1" x)" "$(ui get "$1" y)" click 1 keyup ctrl
  expected=$((expected + 4))
  settle
}
# fill FIELD TEXT: in the place of what is in it.
fill() {
  local shifted=${2//[a-z0-9.\/ -]/}
  click "$1"
  press ctrl+a
  xdotool type "$2"
  expected=$((expected + 2 * ${#2} + 2 * ${#shifted}))
  settle
  await "$1" = "$2"
}
