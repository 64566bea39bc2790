#!/bin/bash
# A live robot in the real program, under a window manager, by mouse and keys:
# live_journey.sh PROGRAM DEMO_FOLDER OUT. Leaves screenshots and what the program said in OUT.
set -eu
program=$1
out=$3

. "$(dirname "$0")/desktop.sh"

# As a new user: one command, then Run and Stop; twice, since the robot is there again.
start_program live --virtual-rig
expect run '^run: Ready'
for drive in 1 2; do
  key F5
  expect run '^run: Running, [0-9]+'
  picture "running$drive"
  key F6
  expect run '^run: Paused'
  key F5
  expect run '^run: Running'
  key shift+F5
  expect run '^run: Done'
  picture "done$drive"
done
key ctrl+Return
expect drawing '^drawing: 6 buildings, modified'

# The dialog, with nothing in it.
key ctrl+shift+r
wait_until "the dialog" has_window 'Connect a robot'
sleep 0.5
picture dialog
xdotool search --onlyvisible --name 'Connect a robot' windowactivate --sync
# After its choice of a file the keys are its own again, not those of the window below.
key alt+o
wait_until "the choice of a file" has_window 'Open a rig'
key Escape
is_active() { [ "$(xdotool getactivewindow getwindowname)" = "$1" ]; }
wait_until "the dialog to have the keys" is_active 'Connect a robot'
key Escape
key ctrl+z
expect drawing '^drawing: 6 buildings, saved'

# Left in the middle of a drive.
key F5
expect run '^run: Running, [0-9]+'
leave
