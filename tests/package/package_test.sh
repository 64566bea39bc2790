#!/usr/bin/env bash
# Installs a build into a folder of its own and looks at what a desktop, a shell and another program
# find there. BUILD-FOLDER WORK-FOLDER
set -euo pipefail
build=$1
work=$2
here=$(dirname "$(readlink -f "$0")")
rm -rf "$work"
mkdir -p "$work"
cmake --install "$build" --prefix "$work/usr" >"$work/install.log"
cd "$work"
share=usr/share

fail() { echo "package test: $*" >&2; exit 1; }
# Runs a checker that need not be on every machine.
check() { if command -v "$1" >/dev/null; then "$@" || fail "$*"; else echo "no $1 here: not checked"; fi; }

check desktop-file-validate $share/applications/handmap.desktop
check appstreamcli validate --no-net $share/metainfo/org.handmap.Handmap.metainfo.xml
check xmllint --noout $share/mime/packages/handmap.xml $share/icons/hicolor/scalable/apps/handmap.svg
if command -v update-mime-database >/dev/null; then
  update-mime-database $share/mime
  grep -q 'application/x-handmap:\*.handmap' $share/mime/globs || fail "*.handmap has no type"
fi
for page in handmap handmap-cli; do
  if command -v groff >/dev/null; then
    [ -z "$(groff -man -K utf8 -ww -z $share/man/man1/$page.1 2>&1)" ] || fail "$page.1 is no clean page"
  fi
done
# Every option that the window's program tells stands in its page; of the other the page is made from what it tells.
# (In a pipe tr would be broken off by what is found early.)
text=$(tr -d '\\-' <$share/man/man1/handmap.1)
for word in $(QT_QPA_PLATFORM=offscreen usr/bin/handmap --help | grep -oE '^  --[a-z-]+' | tr -d ' -'); do
  grep -q "$word" <<<"$text" || fail "handmap.1 does not tell of $word"
done
grep -q '^.SS sketch' $share/man/man1/handmap-cli.1 || fail "handmap-cli.1 has no options"

# Completion asks the installed program.
(
  PATH=$work/usr/bin:$PATH
  # shellcheck disable=SC1090
  source $share/bash-completion/completions/handmap-cli
  COMP_WORDS=(handmap-cli val) COMP_CWORD=1
  _handmap_cli handmap-cli
  [ "${COMPREPLY[*]}" = validate ] || fail "val is completed to \"${COMPREPLY[*]}\""
)

# Both programs start from there and find what they bring along.
usr/bin/handmap-cli simulate --seed 1 --out world >/dev/null
usr/bin/handmap-cli validate world world/sketch.handmap >/dev/null
QT_QPA_PLATFORM=offscreen XDG_CACHE_HOME=$work/cache XDG_CONFIG_HOME=$work/config \
  XDG_DATA_HOME=$work/data usr/bin/handmap world/sketch.handmap --recording world \
  --offscreen-report report >report.txt
[ -s report/trajectory.tum ] || fail "handmap wrote no trajectory"

cmake -S "$here/example" -B example -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_PREFIX_PATH="$work/usr" >example.log
cmake --build example >>example.log
example/example
