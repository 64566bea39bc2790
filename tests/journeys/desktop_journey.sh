#!/bin/bash
# The real program under a window manager, by mouse and keys:
# desktop_journey.sh PROGRAM DEMO_FOLDER OUT. Leaves screenshots and what the program said in OUT.
set -eu
program=$1
demo=$2
out=$3

. "$(dirname "$0")/desktop.sh"

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
draw_rectangle 200 620  # where the demonstration has nothing
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
