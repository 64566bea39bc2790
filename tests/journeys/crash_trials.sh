#!/bin/bash
# What a crash costs: kills the program at random moments of drawing, running, saving, exporting,
# teaching and training, and counts what the next session does not get back. Not one of the tests,
# as it takes minutes:
# crash_trials.sh PROGRAM IMAGE OUT [TRIALS_OF_EACH [SEED]]
set -eu
program=$1
image=$2
out=$3
trials=${4:-13}
RANDOM=${5:-1}

. "$(dirname "$0")/desktop.sh"

conf=$HOME/handmap/handmap.conf
mkdir -p "$(dirname "$conf")"
now_ms() { date +%s%3N; }
buildings() { last_said drawing | grep -Eo '[0-9]+' | head -1; }

fresh() {  # of every trial: nothing left from the one before, and not the first start
  rm -rf "$HOME/handmap" "$out/trial"
  mkdir -p "$HOME/handmap" "$out/trial"
  printf '[window]\ngeometry=\n' >"$conf"
}
crash() {
  kill -9 "$program_id"
  wait "$program_id" 2>/dev/null || true
}
# Draws until the moment has come; remembers when each building was there.
draw_until() {
  local end=$1 then=$2 n
  while [ "$(now_ms)" -lt "$end" ]; do
    draw_rectangle $((120 + RANDOM % 500)) $((250 + RANDOM % 380))
    n=$(buildings)
    [ "$n" = "${drawn:-}" ] || echo "$(now_ms) $n" >>"$out/trial/times"
    drawn=$n
    $then
  done
}
nothing() { :; }
save() { key ctrl+s; }

recovered() {  # how many buildings the next session gets back
  start_program after ${1:+"$1"}
  sleep 1.5
  if said '^message: An earlier session ended'; then
    key alt+c
    sleep 1
  fi
  buildings
  crash
}

teach() {
  local end=$1 panel x
  key alt+r
  sleep 0.3
  key i
  wait_until "the panel" has_window 'Teach buildings'
  panel=$(xdotool search --onlyvisible --name 'Teach buildings' | tail -1)
  xdotool windowactivate --sync "$panel" mousemove --window "$panel" 110 40 click 1
  wait_until "the dialog" has_window 'Open images'
  xdotool search --onlyvisible --name 'Open images' windowactivate --sync
  xdotool type "$image"
  key Return
  sleep 1
  [ "$2" = teaching ] || train
  while [ "$(now_ms)" -lt "$end" ]; do [ "$2" = training ] && sleep 0.1 || paint 250; done
}
paint() {  # below a line of the panel
  xdotool mousemove --window "$panel" $((400 + RANDOM % 300)) $(($1 + RANDOM % 100)) click 1
  painted=$((painted + 1))
}
train() {
  for _ in $(seq 15); do paint 150; done
  key alt+p
  key Down
  for _ in $(seq 15); do paint 300; done
  key alt+t
}
# Pictures, each whole or not there.
export_until() {
  local end=$1
  while [ "$(now_ms)" -lt "$end" ]; do
    exported=$((exported + 1))
    key alt+f
    key p
    wait_until "the file dialog" has_window 'Export a picture'
    xdotool search --onlyvisible --name 'Export a picture' windowactivate --sync
    key ctrl+a
    xdotool type "$out/trial/$exported.png"
    key Return
  done
}
torn_pictures() {
  local picture
  for picture in "$out"/trial/*.png; do
    [ ! -e "$picture" ] || tail -c 8 "$picture" | grep -q IEND || echo "TORN: $picture"
  done
}
painted_windows() {
  cat "$HOME"/handmap/handmap/recovery/*.recovery 2>/dev/null | grep -c '[0-9]b' || true
}

trial() {
  local kind=$1 moment=$((RANDOM % 9000 + 1500)) end file= lost=0 back oldest=0
  fresh
  drawn= painted=0 exported=0
  [ "$kind" != saving ] || {
    file=$out/trial/mine.handmap
    echo '{"format":"handmap","version":1,"buildings":[]}' >"$file"
  }
  start_program before ${file:+"$file"}
  if [ "$kind" = running ] || [ "$kind" = exporting ]; then
    key ctrl+shift+m
    sleep 0.3
    key t
    expect drawing '[1-9]'
    key F5
  fi
  end=$(($(now_ms) + moment))
  case $kind in
    teaching | training) teach "$end" "$kind" ;;
    exporting) export_until "$end" ;;
    saving) draw_until "$end" save ;;
    *) draw_until "$end" nothing ;;
  esac
  crash
  local killed
  killed=$(now_ms)
  if [ "$kind" = exporting ]; then
    torn_pictures
    echo "$kind moment_ms=$moment strokes=$exported lost=0 age_ms=-"
    return
  fi
  if [ "$kind" = teaching ] || [ "$kind" = training ]; then
    [ "$painted" -eq 0 ] || [ "$(painted_windows)" -gt 0 ] || lost=$painted
    echo "$kind moment_ms=$moment strokes=$painted lost=$lost age_ms=-"
    return
  fi
  [ -z "$file" ] || grep -q '"buildings"' "$file" || echo "TORN: $file"
  back=$(recovered "$file")
  lost=$((${drawn:-0} - ${back:-0}))
  [ "$lost" -gt 0 ] || lost=0
  # How old the oldest lost change was.
  [ "$lost" -eq 0 ] || oldest=$((killed - $(awk -v n="${back:-0}" '$2 > n { print $1; exit }' "$out/trial/times")))
  echo "$kind moment_ms=$moment drawn=${drawn:-0} lost=$lost age_ms=$oldest"
}

for kind in drawing running saving exporting teaching training; do
  for i in $(seq "$trials"); do trial $kind; done
done | tee "$out/trials"
awk '{ n[$1]++
       for (i = 2; i <= NF; ++i) { split($i, p, "=")
         if (p[1] == "lost") { lost[$1] += p[2]; if (p[2] > 0) hit[$1]++ }
         if (p[1] == "drawn" || p[1] == "strokes") all[$1] += p[2]
         if (p[1] == "age_ms" && p[2] + 0 > worst[$1]) worst[$1] = p[2] } }
     END { for (k in n) printf "%-9s %d kills, %d made, %d lost in %d of them, the oldest lost %.1f s old\n",
                               k, n[k], all[k], lost[k], hit[k], worst[k] / 1000 }' "$out/trials"
