#!/bin/bash
# A drawing from nothing by mouse and keys: six buildings in two rows, named and squared, the start,
# saved; then a crash after one more change: drawing_journey.sh PROGRAM DEMO_FOLDER OUT. Says how
# long it took and how many clicks and keys.
set -eu
program=$1
out=$3

. "$(dirname "$0")/desktop.sh"

mkdir -p "$out/home/handmap"
printf '[window]\ngeometry=\n[welcome]\nclosed=true\n' >"$out/home/handmap/handmap.conf"
kept() { ls "$out"/mine.handmap.*.recovery >/dev/null 2>&1; }
clicks=0
keys=0
press() {
  key "$1"
  keys=$((keys + 1))
}
write() {
  xdotool type --delay 12 "$1"
  keys=$((keys + ${#1}))
}
click() {
  xdotool mousemove --window "$window" "$1" "$2" click 1
  clicks=$((clicks + 1))
}
# The lower left corner by the mouse, the size and the name by keys.
building() {  # NAME X Y WIDTH DEPTH
  click "$2" "$3"
  xdotool mousemove_relative -- 60 -40
  write "$4"
  press Tab
  write "$5"
  press Return
  write "$1"
  press Return
}

start_program drawing
for _ in 1 2 3; do key ctrl+minus; done
began=$(date +%s%N)
press r
building 'Library' 420 380 65.8 21
building 'Main hall' 600 380 39.2 14.3
building 'Workshop' 720 365 45.9 18.2
building 'Canteen' 400 470 40.6 22
building 'Laboratories' 540 470 55.5 18.1
expect drawing '^drawing: 5 buildings'
picture five
building 'Dormitory' 690 470 59.4 15
expect drawing '^drawing: 6 buildings, modified'
press ctrl+a
press q
press t
xdotool mousemove --window "$window" 420 420 mousedown 1
for step in 10 20 40 60; do xdotool mousemove --window "$window" $((420 + step)) 420; done
xdotool mouseup 1
clicks=$((clicks + 1))
press f
press s
picture drawn
press ctrl+s
wait_until "the file dialog" has_window 'Save the drawing'
xdotool search --onlyvisible --name 'Save the drawing' windowactivate --sync
key ctrl+a
xdotool type "$out/mine.handmap"
key Return
expect drawing '^drawing: 6 buildings, saved'
ended=$(date +%s%N)
for name in Library 'Main hall' Workshop Canteen Laboratories Dormitory '"start"'; do
  grep -q "$name" "$out/mine.handmap" || fail "$name is not in the file"
done

# One building is moved and the program dies.
press Escape  # from the start to nothing, and on to the first building
press Tab
press shift+Right
expect drawing '^drawing: 6 buildings, modified'
wait_until "the recovery file" kept
kill -9 "$program_id"
wait "$program_id" 2>/dev/null || true
start_program after "$out/mine.handmap"
wait_until "the offer" said '^message: An earlier session ended'
picture offer
key alt+c
expect drawing '^drawing: 6 buildings, modified'
picture recovered
key ctrl+s
expect drawing '^drawing: 6 buildings, saved'
leave
echo "six buildings, named, squared, start set and saved: $(((ended - began) / 1000000)) ms," \
  "$clicks clicks, $keys keys"
