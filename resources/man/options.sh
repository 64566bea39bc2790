#!/bin/sh
# The page on stdin with the options of each command, as the program's own help tells them. PROGRAM
set -eu
program=$1

commands() { "$program" --help | sed -nE '/^Subcommands:/,/^$/s/^  ([a-z-]+) .*/\1/p'; }

# Entries are indented by two, what they are by thirty: on the same line, or on the next after a long entry.
options() {  # COMMAND
  "$program" "$1" --help | sed -nE '/^(Positionals|Options):$/,/^$/p' |
    sed -E -e ':all' -e 'N' -e '$!b all' -e 's/\n {30}/\t/g' |
    sed -nE -e '/^  -h,/d' -e '/\t/!s/^(.{30})/\1\t/' -e 's/\\/\\e/g' -e 's/-/\\-/g' -e "s/'/\\\\(aq/g" \
      -e 's/^  ([^\t]*[^ \t]) *\t(.*)/.TP\n.B \1\n\\\&\2/p'
}

while IFS= read -r line; do
  printf '%s\n' "$line"
  [ "$line" = '.SH OPTIONS OF EACH COMMAND' ] || continue
  for command in $(commands); do
    printf '.SS %s\n' "$command" | sed 's/-/\\-/g'
    options "$command"
  done
done
