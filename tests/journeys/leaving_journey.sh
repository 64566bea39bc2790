#!/bin/bash
# Every way to leave a run by keyboard, in the real program: leaving_journey.sh PROGRAM DEMO_FOLDER
# OUT. Each session must end with status 0.
set -eu
program=$1
demo=$2
out=$3
. "$(dirname "$0")/desktop.sh"

# The menu of simulators: &Run, Si&mulator, &Two rows of buildings.
choose_two_rows() {
  key alt+r
  key m
  key t
  expect run 'Ready to run'
}
run_two_rows() {
  choose_two_rows
  key F5
  expect run 'Running|Done'
}

# While the demonstration is rendered, which takes a while the first time.
for keys in ctrl+q 'F6 ctrl+q' 'shift+F5 ctrl+q' 'ctrl+n ctrl+q'; do
  start_program "rendering-${keys// /-}" --demo
  expect run 'Rendering|Running'
  for one in $keys; do key "$one"; done
  wait "$program_id" || fail "left with status $? after $keys"
done

# From one run to the next.
start_program changing --demo
expect run 'Rendering|Running'
run_two_rows
key ctrl+n
expect run 'No robot'
expect drawing '^drawing: 0 buildings'
run_two_rows
choose_two_rows
key F5
key ctrl+o
wait_until "the file dialog" has_window 'Open a drawing'
xdotool search --onlyvisible --name 'Open a drawing' windowactivate --sync
xdotool type "$demo/two-rows-sketch.handmap"
key Return
expect run 'No robot'
expect drawing '^drawing: 6 buildings, saved'
leave

# In the middle of a run, and of its steps.
for keys in ctrl+q 'F6 F7 ctrl+q' 'F6 F5 ctrl+q'; do
  start_program "running-${keys// /-}" --demo
  run_two_rows
  for one in $keys; do key "$one"; done
  wait "$program_id" || fail "left with status $? after $keys"
done
