# fish completion for handmap-cli: commands, options and their values as the program itself tells them.
function __handmap_cli_commands
    handmap-cli --help 2>/dev/null | sed -nE '/^Subcommands:/,/^$/s/^  ([a-z-]+)  *(.*)/\1\t\2/p'
end
function __handmap_cli_words
    set -l words (commandline -opc)
    set -q words[2]; or return
    set -l help (handmap-cli $words[2] --help 2>/dev/null)
    if string match -q -- '-*' (commandline -ct)
        printf '%s\n' $help | string match -r -- '^ +(?:-[a-z],)?--[a-z-]+' | string match -r -- '--[a-z-]+'
        return
    end
    set -l form (printf '%s\n' $help | string replace -rf -- "^ +(?:-[a-z],)?$words[-1] ([^ ]+).*" '$1')
    set -q form[1]; or set form (printf '%s\n' $help | sed -nE '/^Positionals:/,/^$/s/^  [a-z]+ ([^ ]+).*/\1/p')
    string split '|' -- "$form[1]" | string split ',' | string trim -c '[]' | string match -r '^[a-z0-9-]+$'
end
complete -c handmap-cli -n 'test (count (commandline -opc)) -eq 1' -f -a '(__handmap_cli_commands)'
complete -c handmap-cli -n 'test (count (commandline -opc)) -gt 1' -a '(__handmap_cli_words)'
