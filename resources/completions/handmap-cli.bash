# bash completion for handmap-cli: commands, options and their values as the program itself tells them.
_handmap_cli_form() {  # PROGRAM COMMAND OPTION: what the help says stands behind it
  "$1" "$2" --help 2>/dev/null | sed -nE "s/^ +(-[a-z],)?$3 ([^ ]+).*/\2/p" | head -n 1
}
_handmap_cli() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]} words form
  if [ "$COMP_CWORD" -eq 1 ]; then
    words=$("$1" --help 2>/dev/null | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
    mapfile -t COMPREPLY < <(compgen -W "$words --help --version" -- "$word")
    return
  fi
  if [[ $word == -* ]]; then
    words=$("$1" "$command" --help 2>/dev/null | grep -oE -- '^ +(-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+')
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
    return
  fi
  [[ $before == --* ]] && form=$(_handmap_cli_form "$1" "$command" "$before")
  case $form in
    DIR) mapfile -t COMPREPLY < <(compgen -d -- "$word") ;;
    *'|'*)  # words to choose from; those with capitals or a dot stand for files, which -o default offers
      words=$(tr -d '[]' <<<"$form" | tr '|,' '\n\n' | grep -xE '[a-z0-9-]+')
      mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
      if [[ $form =~ [A-Z.] ]]; then mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -- "$word"); fi ;;
  esac
}
complete -o default -F _handmap_cli handmap-cli
