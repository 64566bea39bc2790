#!/bin/bash
# The real program under a window manager, by mouse and keys:
# desktop_journey.sh PROGRAM DEMO_FOLDER OUT. Leaves screenshots and what the program said in OUT.
set -eu
program=$1
demo=$2
out=$3

for tool in Xvfb openbox xdotool import; do
  if ! command -v $tool >/dev/null; then
    echo "SKIPPED: $tool is not installed"
    exit 77
  fi
done

rm -rf "$out"
mkdir -p "$out/home" "$out/runtime"
chmod 700 "$out/runtime"
export HOME=$out/home XDG_CONFIG_HOME=$out/home XDG_DATA_HOME=$out/home XDG_RUNTIME_DIR=$out/runtime
unset QT_QPA_PLATFORM WAYLAND_DISPLAY XDG_CURRENT_DESKTOP
export LC_ALL=C.UTF-8  # xdotool reads titles by it

fail() {
  echo "FAILED: $*" >&2
  sed 's/^/  program: /' "$log" >&2
  exit 1
}
# Runs a command until it succeeds.
wait_until() {
  local what=$1 tries=600
  shift
  until "$@"; do
    tries=$((tries - 1))
    [ $tries -gt 0 ] || fail "waited in vain for $what"
    sleep 0.1
  done
}
said() { grep -Eq "$1" "$log"; }
last_said() { grep -E "^$1: " "$log" | tail -1; }
# What the program last said of a subject: expect SUBJECT PATTERN
is_now() { last_said "$1" | grep -Eq "$2"; }
expect() { wait_until "$1 to be \"$2\"" is_now "$1" "$2"; }
key() { xdotool key --clearmodifiers "$1"; }
picture() { import -window root "$out/$1.png"; }
has_window() { xdotool search --onlyvisible --name "$1" >/dev/null 2>&1; }

start_program() {
  log=$out/$1.log
  shift
  "$program" --verbose "$@" 2>"$log" &
  program_id=$!
  wait_until "the window" has_window ' — Handmap'
  wait_until "the program" said '^window: ready'
  window=$(xdotool search --onlyvisible --name ' — Handmap' | head -1)
  wait_until "the focus" xdotool windowactivate --sync "$window"
}
# A stroke in the lower left of the canvas, where the demonstration has nothing.
draw_rectangle() {
  key r
  xdotool mousemove --window "$window" 200 620 mousedown 1
  for x in 220 240 260 280 300; do xdotool mousemove --window "$window" $x $((620 + (x - 200) / 3)); done
  xdotool mouseup 1
}
leave() {
  key ctrl+q
  wait "$program_id" || fail "left with status $?"
}

exec 3<>"$out/display"
Xvfb -displayfd 3 -screen 0 1400x900x24 >/dev/null 2>&1 &
x_id=$!
trap 'kill $x_id 2>/dev/null || true' EXIT
log=/dev/null
wait_until "the X server" test -s "$out/display"
export DISPLAY=:$(tr -d '\n' <"$out/display")
openbox >/dev/null 2>&1 &

# Watching: the demonstration runs, pauses, steps and stops.
start_program watching --demo
expect run 'Running, [0-9]+ of'
picture start
key F6
expect run '^run: Paused'
paused_at=$(last_said run | grep -Eo '[0-9]+ of')
key F7
wait_until "one step" sh -c "! grep -E '^run: ' '$log' | tail -1 | grep -q 'Paused, $paused_at'"
expect run '^run: Paused'
picture paused
key F5
expect run '^run: Running'
key shift+F5
expect run '^run: Stopped'
expect drawing '^drawing: 6 buildings, saved'
key ctrl+Return
expect drawing '^drawing: 6 buildings, modified'
key ctrl+z
expect drawing '^drawing: 6 buildings, saved'

# Drawing: a rectangle, back and forth, saved under a name.
draw_rectangle
expect drawing '^drawing: 7 buildings, modified'
key ctrl+z
expect drawing '^drawing: 6 buildings, saved'
key ctrl+shift+z
expect drawing '^drawing: 7 buildings, modified'
picture drawn
key ctrl+shift+s
wait_until "the file dialog" has_window 'Save the drawing'
xdotool search --onlyvisible --name 'Save the drawing' windowactivate --sync
key ctrl+a
xdotool type "$out/mine.handmap"
key Return
expect drawing '^drawing: 7 buildings, saved'
wait_until "the file" test -s "$out/mine.handmap"
[ "$(grep -o '"shape"' "$out/mine.handmap" | wc -l)" -eq 7 ] || fail "the file has not 7 buildings"
leave

# Coming back: an existing file, changed and saved in place.
cp "$demo/two-rows-sketch.handmap" "$out/again.handmap"
start_program again "$out/again.handmap"
expect drawing '^drawing: 6 buildings, saved'
key ctrl+a
key Delete
expect drawing 'buildings, modified'
key ctrl+s
expect drawing '^drawing: 0 buildings, saved'
grep -q '"shape"' "$out/again.handmap" && fail "deleted buildings are in the file"
leave
