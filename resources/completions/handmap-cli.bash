# bash completion for handmap-cli: commands, options and their values as the program itself tells them.
_handmap_cli() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]} help words form
  if [ "$COMP_CWORD" -eq 1 ]; then
    words=$("$1" --help 2>/dev/null | sed -nE '/^Subcommands:/,/^$/s/^  ([a-z-]+) .*/\1/p')
    mapfile -t COMPREPLY < <(compgen -W "$words --help --version" -- "$word")
    return
  fi
  help=$("$1" "$command" --help 2>/dev/null)
  if [[ $word == -* ]]; then
    words=$(grep -oE -- '^ +(-[a-z],)?--[a-z-]+' <<<"$help" | grep -oE -- '--[a-z-]+')
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
    return
  fi
  [[ $word != = ]] || word=
  [[ $before != = ]] || before=${COMP_WORDS[COMP_CWORD - 2]}
  # What the help says stands behind the option; else what it says stands alone.
  [[ $before != --* ]] || form=$(sed -nE "s/^ +(-[a-z],)?$before ([^ ]+).*/\2/p" <<<"$help")
  [[ -n $form ]] || form=$(sed -nE '/^Positionals:/,/^$/s/^  [a-z]+ ([^ ]+).*/\1/p' <<<"$help")
  case $form in
    DIR)
      compopt -o filenames
      mapfile -t COMPREPLY < <(compgen -d -- "$word")
      ;;
    *'|'*)  # words to choose from; those with capitals or a dot stand for files
      words=$(tr -d '[]' <<<"$form" | tr '|,' '\n\n' | grep -xE '[a-z0-9-]+')
      mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
      [[ $form =~ [A-Z.] ]] || return
      compopt -o filenames
      mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -- "$word")
      ;;
  esac
}
complete -o default -F _handmap_cli handmap-cli
