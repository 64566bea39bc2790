#!/bin/bash
# A crash, and what is left after it: recovery_journey.sh PROGRAM DEMO_FOLDER OUT
set -eu
program=$1
out=$3

. "$(dirname "$0")/desktop.sh"

# Not the first start, which begins with the demonstration.
mkdir -p "$out/home/handmap"
printf '[window]\ngeometry=\n' >"$out/home/handmap/handmap.conf"
kept() { ls "$out"/home/handmap/handmap/recovery/*.recovery >/dev/null 2>&1; }
crash() {
  kill -9 "$1"
  wait "$1" 2>/dev/null || true
}
offered() { said '^message: An earlier session ended'; }

# Something that was never saved; a second window does not offer what the first one works on.
start_program drawing
draw_rectangle 200 500
expect drawing '^drawing: 1 buildings, modified'
wait_until "the recovery file" kept
first_id=$program_id
start_program second
sleep 1
offered && fail "a living session's work is offered"
leave
crash "$first_id"

# It is offered, survives another crash, and is recovered.
start_program after
wait_until "the offer" offered
picture offer
crash "$program_id"
start_program again
wait_until "the offer" offered
key alt+c
expect drawing '^drawing: 1 buildings, modified'
picture recovered
key ctrl+s
wait_until "the file dialog" has_window 'Save the drawing'
xdotool search --onlyvisible --name 'Save the drawing' windowactivate --sync
key ctrl+a
xdotool type "$out/mine.handmap"
key Return
expect drawing '^drawing: 1 buildings, saved'
[ "$(grep -o '"shape"' "$out/mine.handmap" | wc -l)" -eq 1 ] || fail "the file has not 1 building"
leave
