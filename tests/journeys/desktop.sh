# What every journey through the real program needs: a screen, a window manager, mouse and keys.
# Sourced by a script that has set `program` and `out`; clears $out and leaves there screenshots and
# what the program said.

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
  for id in $(xdotool search --name '' 2>/dev/null); do  # what the screen knew
    echo "  screen: window $id of $(xdotool getwindowpid "$id" 2>/dev/null || echo nobody):" \
      "$(xdotool getwindowname "$id" 2>/dev/null)" >&2
  done
  picture failed 2>/dev/null || true
  exit 1
}
# Runs a command until it succeeds.
wait_until() {
  local what=$1 tries=1800  # three minutes: what the demonstration sees is rendered first
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

find_window() {
  window=$(xdotool search --all --onlyvisible --pid "$program_id" --name ' — Handmap' 2>/dev/null |
    head -1)
  [ -n "$window" ]
}

start_program() {
  log=$out/$1.log
  shift
  "$program" --verbose "$@" 2>"$log" &
  program_id=$!
  wait_until "the program" said '^window: ready'
  wait_until "the window" find_window
  wait_until "the focus" xdotool windowactivate --sync "$window"
}
# A stroke from a place of the window.
draw_rectangle() {
  local x=$1 y=$2 step
  key r
  xdotool mousemove --window "$window" "$x" "$y" mousedown 1
  for step in 20 40 60 80 100; do
    xdotool mousemove --window "$window" $((x + step)) $((y + step / 3))
  done
  xdotool mouseup 1
}
leave() {
  key ctrl+q
  wait "$program_id" || fail "left with status $?"
}

exec 3<>"$out/display"
# Without -noreset a server whose only client leaves starts anew and loses who is just coming.
Xvfb -noreset -displayfd 3 -screen 0 "${screen:-1400x900}x24" >/dev/null 2>&1 &
x_id=$!
trap 'kill $x_id 2>/dev/null || true' EXIT
log=/dev/null
wait_until "the X server" test -s "$out/display"
export DISPLAY=:$(tr -d '\n' <"$out/display")
# A window that comes while it starts is never shown.
openbox --startup "touch '$out/managed'" >/dev/null 2>&1 &
wait_until "the window manager" test -e "$out/managed"
