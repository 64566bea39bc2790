#!/bin/bash
# Watching a run on a real street, looking back and changing its past:
# street_journey.sh PROGRAM DEMO_FOLDER OUT. Leaves screenshots and what the program said in OUT.
set -eu
program=$1
street=$(dirname "$0")/../../../shared/data/street
out=$3
if [ ! -d "$street" ]; then
  echo "SKIPPED: needs the real street beside the project"
  exit 77
fi

. "$(dirname "$0")/desktop.sh"

cp "$street/sketch-b.handmap" "$out/street.handmap"
start_program watching "$out/street.handmap" --recording "$street" --from 38 --source images --run
expect run '^run: Running, 1[0-9] of 36'
picture running
key F6
expect run '^run: Paused'
paused_at=$(last_said run | grep -Eo '[0-9]+ of' | grep -Eo '[0-9]+')
stood_at=$((paused_at + 1))
key F7
expect run "^run: Paused, $stood_at of"
for _ in 1 2 3; do key shift+F7; done
expect run "^run: Looking back, $((stood_at - 3)) of"
picture back
key ctrl+b
key ctrl+End
expect run "^run: Paused, $stood_at of"
key ctrl+shift+b
expect run "^run: Looking back, $((stood_at - 3)) of"
key F5  # plays on, and runs on
wait_until "more than before" sh -c \
  "grep -E '^run: Running' '$log' | tail -1 | grep -Eo '[0-9]+ of' | awk -v s=$stood_at '{exit \$1 <= s}'"
key F6
expect run '^run: Paused'

# All buildings are right, as they are shown; that is done again and the result is taken.
xdotool mousemove --window "$window" 600 300
key ctrl+a
key ctrl+g
expect message '^message: Done again'
expect drawing '^drawing: 19 buildings, modified'
picture right
key ctrl+z
expect drawing '^drawing: 19 buildings, saved'
expect message '^message: Done again'  # what was said is taken back with it
picture changed
key ctrl+shift+z
expect drawing '^drawing: 19 buildings, modified'
key ctrl+s
expect drawing '^drawing: 19 buildings, saved'
grep -q '"fixed"' "$out/street.handmap" || fail "what is right is not in the file"
leave
