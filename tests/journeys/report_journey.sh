#!/bin/sh
# The demonstration without a display: report_journey.sh PROGRAM DEMO_FOLDER OUT
set -eu
program=$1
out=$3
rm -rf "$out"
mkdir -p "$out"
unset DISPLAY WAYLAND_DISPLAY QT_QPA_PLATFORM
HOME=$out XDG_RUNTIME_DIR=$out
export HOME XDG_RUNTIME_DIR
chmod 700 "$out"

fail() {
  echo "FAILED: $*" >&2
  exit 1
}
# Expects an exit status and, on stderr, a word: refused STATUS WORD ARGUMENTS…
refused() {
  expected=$1
  word=$2
  shift 2
  status=0
  "$program" "$@" >"$out/stdout" 2>"$out/stderr" || status=$?
  [ "$status" -eq "$expected" ] || fail "$*: status $status, expected $expected"
  grep -q "$word" "$out/stderr" || fail "$*: nothing about \"$word\" in: $(cat "$out/stderr")"
}

"$program" --demo --offscreen-report "$out/a" >"$out/stdout" || fail "the demonstration: status $?"
grep -q "front wall" "$out/stdout" || fail "no errors before and after"
for file in refined.handmap trajectory.tum screenshot.png; do
  [ -s "$out/a/$file" ] || fail "no $file"
  grep -q "$out/a/$file" "$out/stdout" || fail "does not say where $file is"
done
grep -q '"refinement"' "$out/a/refined.handmap" || fail "refined.handmap does not say how it was made"

"$program" --demo --offscreen-report "$out/b" >/dev/null
cmp "$out/a/refined.handmap" "$out/b/refined.handmap" || fail "the same seed, another map"
cmp "$out/a/trajectory.tum" "$out/b/trajectory.tum" || fail "the same seed, another trajectory"

refused 1 display
refused 1 seed --demo --seed many --exit-after-run
refused 2 gone.handmap "$out/gone.handmap" --recording "$out" --exit-after-run
refused 2 nowhere "$2/two-rows-sketch.handmap" --recording "$out/nowhere" --exit-after-run
touch "$out/file"
refused 3 file --demo --offscreen-report "$out/file/below"
