#!/usr/bin/env bash
# Installs the .debs into a fresh Debian 12 and starts both programs there. Needs root, debootstrap and
# a network; is skipped without. BUILD-FOLDER WORK-FOLDER
set -euo pipefail
build=$1
work=$2
skip() { echo "skipped: $*"; exit 77; }
[ "$(id -u)" -eq 0 ] || skip "not root"
command -v debootstrap >/dev/null || skip "no debootstrap"
command -v dpkg-shlibdeps >/dev/null || skip "no dpkg-dev"

root=$work/debian
rm -rf "$work"
mkdir -p "$work"
debootstrap --variant=minbase bookworm "$root" >"$work/debootstrap.log" 2>&1 || skip "no Debian to be had"
trap 'rm -rf "$root"' EXIT
cpack --config "$build/CPackConfig.cmake" -B "$work" >"$work/cpack.log"
mkdir "$root/debs"
cp "$work"/handmap_*.deb "$root/debs"
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
  DEBIAN_FRONTEND=noninteractive QT_QPA_PLATFORM=offscreen "$@"; }
inside sh -c 'apt-get -qq update && apt-get -qq install -y --no-install-recommends /debs/handmap_*.deb' \
  >"$work/apt.log" 2>&1 || { tail -n 30 "$work/apt.log"; exit 1; }
inside handmap-cli simulate --seed 1 --out /world
inside handmap-cli validate /world /world/sketch.handmap
inside handmap /world/sketch.handmap --recording /world --offscreen-report /report
test -s "$root/report/trajectory.tum"
inside dpkg --verify handmap
inside apt-get -qq purge -y handmap >>"$work/apt.log" 2>&1
left=$(find "$root/usr" -name '*handmap*')
[ -z "$left" ] || { echo "left behind: $left"; exit 1; }
