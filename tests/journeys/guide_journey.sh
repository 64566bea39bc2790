#!/bin/bash
# The pictures of the guide, made anew: guide_journey.sh PROGRAM DEMO_FOLDER OUT
set -eu
program=$1
guide=$(dirname "$2")/guide
out=$3
command -v compare >/dev/null || { echo "SKIPPED: ImageMagick is not installed"; exit 77; }
rm -rf "$out"
mkdir -p "$out"
unset DISPLAY WAYLAND_DISPLAY QT_QPA_PLATFORM LANGUAGE
export HOME=$out XDG_RUNTIME_DIR=$out
chmod 700 "$out"

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

for language in en ja; do
  locale=C.UTF-8
  [ $language = ja ] && locale=ja_JP.UTF-8
  LC_ALL=$locale "$program" --guide-pictures "$out/$language" || fail "$language: status $?"
  for shipped in "$guide/$language"/pictures/*.png; do
    made=$out/$language/$(basename "$shipped")
    [ -s "$made" ] || fail "$made is not made"
    [ "$(identify -format '%wx%h' "$made")" = "$(identify -format '%wx%h' "$shipped")" ] ||
      fail "$made has another size than $shipped"
    # Fonts and machines differ a little; scenes do not.
    convert "$made" -resize 64x -colorspace Gray "$out/made.pgm"
    convert "$shipped" -resize 64x -colorspace Gray "$out/shipped.pgm"
    difference=$(compare -metric MAE "$out/made.pgm" "$out/shipped.pgm" null: 2>&1 |
      sed 's/.*(\(.*\))/\1/') || true
    awk -v d="$difference" 'BEGIN { exit !(d < 0.06) }' ||
      fail "$made is $difference off from $shipped: make the pictures anew"
  done
  for made in "$out/$language"/*.png; do
    [ -e "$guide/$language/pictures/$(basename "$made")" ] || fail "$made is in no guide"
  done
done
