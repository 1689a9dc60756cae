#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Prints the completions for a shell, made from the program's help texts.
#
#   sh data/completions/generate.sh bash|zsh|fish [PATH/TO/phspline]
#
# They are kept beside this file, so that installing does not run the program,
# as phspline.bash, _phspline and phspline.fish; tests/lint/completions.sh holds
# them to what this prints.
set -eu
shell=${1:?bash, zsh or fish}
program=${2:-build/plain/phspline}
export LC_ALL=C COLUMNS=120

"$program" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z][a-z-]*\)  .*/\1/p' |
  while read -r command; do
    echo "Command $command"
    "$program" help "$command"
  done | awk -v shell="$shell" '
  # An entry is an option or a field: its name, letter and argument, the words
  # that the argument may be, and its text.
  function finish() {
    if (name == "") return
    if (part == "Fields") {
      # what it is; what it may be (default: ...)
      rest = text
      sub(/;[^;]*$/, "", text)
      rest = substr(rest, length(text) + 1)
      sub(/ \([a-z]*:?.*/, "", rest)
      if (rest ~ /true or false/) { argument = ""; words = " true false" }
      while (match(rest, /"[A-Za-z0-9-]*"/)) {
        words = words " " substr(rest, RSTART + 1, RLENGTH - 2)
        rest = substr(rest, RSTART + RLENGTH)
      }
      fields[command] = fields[command] " " name "="
    } else if (argument ~ /^[a-z|-]+$/) {
      words = " " argument
      gsub(/\|/, " ", words)
    }
    sub(/:$/, "", text)
    n++
    of[n] = command; names[n] = name; letters[n] = letter
    arguments[n] = argument; choices[n] = substr(words, 2); texts[n] = text
    name = ""
  }
  function begin(word) {
    finish()
    name = word
    letter = argument = words = text = ""
    listed = 0
  }
  function add(words) { text = text (text == "" ? "" : " ") words }
  function trim(s) { sub(/^ +/, "", s); return s }
  /^Command / { command = $2; commands[++c] = command; getline; getline; getline
    sub(/\.$/, ""); titles[command] = $0; next }
  /^(Fields|Options)/ { finish(); part = $1; next }
  !NF || /^[^ ]/ { finish(); part = ""; next }
  part == "" { next }
  part == "Fields" && /^  [a-z_]+ / {
    begin($1); argument = "VALUE"; add(trim(substr($0, 3 + length($1)))); next
  }
  part == "Fields" && /^  [a-z]/ { finish(); next }
  part == "Options:" && /^ +-/ && !/^        / {
    begin("")
    if (/^  -/) letter = substr($0, 4, 1)
    sub(/^[^=]*  --|^[^=]*, --/, "")
    name = argument = $1
    if (!sub(/^[^=]*=/, "", argument)) argument = ""
    add(trim(substr($0, length(name) + 1)))
    sub(/=.*/, "", name)
    next
  }
  # the list of what an option may be
  /^        [a-z]/ { words = words " " $1; listed = 1; next }
  name != "" && !listed { add(trim($0)) }

  # ---- bash ----

  # \047 is a single quote
  function quote(s) {
    gsub(/\047/, "\047\\\047\047", s)
    return "\047" s "\047"
  }
  function all(   s, i) {
    for (i = 1; i <= c; i++) s = s " " commands[i]
    return substr(s, 2)
  }
  # how the value of entry i is completed
  function value_bash(i) {
    if (arguments[i] == "FILE") return "kind=files"
    if (arguments[i] ~ /^FIELD/ && of[i] in fields) {
      return "list=" quote(substr(fields[of[i]], 2))
    }
    return choices[i] == "" ? "kind=nothing" : "list=" quote(choices[i])
  }
  function print_bash(   i, j, s) {
    print "# SPDX-License-Identifier: GPL-3.0-or-later"
    print "# Completions of phspline for bash; made by generate.sh."
    print "_phspline() {"
    print "  local cur=${COMP_WORDS[COMP_CWORD]} option kind=words list="
    print "  # --option=value is three words, --option value two"
    print "  if [[ $cur == = ]]; then"
    print "    cur= option=${COMP_WORDS[COMP_CWORD - 1]}="
    print "  elif [[ ${COMP_WORDS[COMP_CWORD - 1]} == = ]]; then"
    print "    option=${COMP_WORDS[COMP_CWORD - 2]}="
    print "  else"
    print "    option=${COMP_WORDS[COMP_CWORD - 1]}"
    print "  fi"
    print "  case $COMP_CWORD,${COMP_WORDS[1]} in"
    print "  1,*) list=" quote(all() " help schema --help --version") " ;;"
    print "  *,help | *,schema) list=" quote(all()) " ;;"
    for (j = 1; j <= c; j++) {
      print "  *," commands[j] ")"
      print "    case $option in"
      s = ""
      for (i = 1; i <= n; i++) {
        if (of[i] != commands[j]) continue
        s = s " --" names[i] (arguments[i] == "" ? "" : "=")
        if (arguments[i] != "") {
          print "    " (letters[i] == "" ? "" : "-" letters[i] " | ") "--" \
            names[i] " | --" names[i] "=) " value_bash(i) " ;;"
        } else if (choices[i] != "") {
          print "    --" names[i] "=) " value_bash(i) " ;;"
        }
      }
      print "    *)"
      print "      kind=files"
      print "      if [[ $cur == -* ]]; then"
      print "        kind=words list=" quote(substr(s, 2))
      print "      fi"
      print "      ;;"
      print "    esac"
      print "    ;;"
    }
    print "  esac"
    print "  COMPREPLY=()"
    print "  if [[ $kind == words ]]; then"
    print "    COMPREPLY=($(compgen -W \"$list\" -- \"$cur\"))"
    print "    [[ ${COMPREPLY[0]-} != *= ]] || compopt -o nospace 2>/dev/null"
    print "  elif [[ $kind == files ]]; then"
    print "    local IFS=$\047\\n\047"
    print "    compopt -o filenames 2>/dev/null"
    print "    COMPREPLY=($(compgen -f -- \"$cur\"))"
    print "  fi"
    print "}"
    print "complete -F _phspline phspline"
  }

  # ---- zsh ----

  function value_zsh(i) {
    if (arguments[i] == "FILE") return "_files"
    if (arguments[i] ~ /^FIELD/ && of[i] in fields) {
      return "compadd -S \"\" --" fields[of[i]]
    }
    if (choices[i] != "") return "(" choices[i] ")"
    return " "
  }
  function bracketed(s) { gsub(/[][]/, "\\\\&", s); return "[" s "]" }
  function print_zsh(   i, j, s) {
    print "#compdef phspline"
    print "# SPDX-License-Identifier: GPL-3.0-or-later"
    print "# Completions of phspline for zsh; made by generate.sh."
    print "local -a commands"
    print "commands=("
    for (j = 1; j <= c; j++) {
      print "  " quote(commands[j] ":" titles[commands[j]])
    }
    print "  \047help:the fields and options of a command\047"
    print "  \047schema:a JSON Schema of problems and results\047"
    print ")"
    print "if (( CURRENT == 2 )); then"
    print "  _describe -t commands command commands"
    print "  compadd -- --help --version"
    print "  return"
    print "fi"
    print "case $words[2] in"
    print "help | schema) compadd -- " all() " ;;"
    for (j = 1; j <= c; j++) {
      print commands[j] ")"
      print "  shift words"
      print "  (( CURRENT-- ))"
      print "  _arguments -S \\"
      for (i = 1; i <= n; i++) {
        if (of[i] != commands[j]) continue
        s = bracketed(texts[i])
        if (arguments[i] != "") s = s ":" arguments[i] ":" value_zsh(i)
        else if (choices[i] != "") s = s "::value:(" choices[i] ")"
        if (letters[i] != "") {
          print "    " quote("*-" letters[i] (arguments[i] == "" ? "" : "+") s) \
            " \\"
        }
        print "    " quote("*--" names[i] \
          (arguments[i] != "" ? "=" : choices[i] != "" ? "=-" : "") s) " \\"
      }
      print "    \047*:file:_files\047"
      print "  ;;"
    }
    print "esac"
  }

  # ---- fish ----

  function print_fish(   i, j, s) {
    print "# SPDX-License-Identifier: GPL-3.0-or-later"
    print "# Completions of phspline for fish; made by generate.sh."
    for (j = 1; j <= c; j++) {
      print "complete -c phspline -n __fish_use_subcommand -f -a " commands[j] \
        " -d " quote(titles[commands[j]])
    }
    print "complete -c phspline -n __fish_use_subcommand -f -a help" \
      " -d \047the fields and options of a command\047"
    print "complete -c phspline -n __fish_use_subcommand -f -a schema" \
      " -d \047a JSON Schema of problems and results\047"
    print "complete -c phspline -n __fish_use_subcommand -l help -l version"
    print "complete -c phspline -n \047__fish_seen_subcommand_from help schema\047" \
      " -f -a " quote(all())
    for (i = 1; i <= n; i++) {
      s = "complete -c phspline -n \047__fish_seen_subcommand_from " of[i] "\047"
      if (letters[i] != "") s = s " -s " letters[i]
      s = s " -l " names[i]
      if (arguments[i] == "FILE") s = s " -r -F"
      else if (arguments[i] ~ /^FIELD/ && of[i] in fields) {
        s = s " -x -a " quote(substr(fields[of[i]], 2))
      } else if (arguments[i] != "") s = s " -x"
      if (arguments[i] != "" && choices[i] != "") s = s " -a " quote(choices[i])
      print s " -d " quote(texts[i])
    }
  }
  END {
    finish()
    if (shell == "bash") print_bash()
    else if (shell == "zsh") print_zsh()
    else if (shell == "fish") print_fish()
    else exit 2
  }'
