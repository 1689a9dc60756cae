#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Who may include whom, and who may keep state.  The rooms of src/ and their
# arrows are the table below; foreign headers, forbidden calls and mutable data
# of file scope are looked for besides.  nm reads the objects in builddir.
set -eu
cd "${srcdir:-$(dirname "$0")/../..}"
builddir=${builddir:-build/plain}
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT

# report NAME: `ok NAME', or one `not ok' for each line of standard input
report() {
  if awk -v name="$1" 'NF { print "not ok " name ": " $0; bad = 1 }
      END { exit bad }'; then
    echo "ok $1"
  else
    touch "$tmp/bad"
  fi
}

find src -name '*.[ch]' -o -name '*.def' | sort >"$tmp/files"
# Every include as "FILE HEADER", the header with its quotes or brackets.
while read -r file; do
  sed -n "s|^[ 	]*#[ 	]*include[ 	]*\([\"<][^\">]*[\">]\).*|$file \1|p" "$file"
done <"$tmp/files" >"$tmp/includes"

# room: the rooms, or headers, it may include from.  check never includes solve,
# else it would certify its own mistakes, and of curve the structs alone.
awk '
  BEGIN {
    may["base"] = " base "
    may["kernel"] = " kernel base "
    may["curve"] = " curve kernel base "
    may["solve"] = " solve curve kernel base "
    may["check"] = " check kernel base curve/result.h curve/problem.h "
    may["plot"] = " plot curve kernel base "
    may["io"] = " io curve base "
    may["cli"] = " cli io plot check solve curve kernel base "
  }
  {
    split($1, from, "/")
    room = from[2]
    if (!(room in may)) {
      print $1 ": " room " is no room of src/"
    } else if ($2 ~ /^"/) {
      name = substr($2, 2, length($2) - 2)
      if (split(name, to, "/") < 2) {
        print $1 ": " $2 " is not written from src/"
      } else if (!index(may[room], " " to[1] " ") &&
                 !index(may[room], " " name " ")) {
        print $1 ": " room " may not include " name
      }
    }
  }' "$tmp/includes" | report layers-arrows

# src/README names every room, and tables that are where it says.
{
  find src -mindepth 1 -maxdepth 1 -type d | sed 's|src/||' | sort |
    while read -r room; do
      grep -qw "$room" src/README || echo "src/README: no room $room"
    done
  grep -oE '(PH|ph)_[A-Za-z]+, [a-z]+/[a-z_]+\.[ch]' src/README |
    tr -d ',' >"$tmp/tables"
  while read -r name file; do
    grep -qE "(#define |[ *])$name(\(|\[)" "src/$file" ||
      echo "src/README: $name is not in src/$file"
  done <"$tmp/tables"
  test -s "$tmp/tables" || echo 'src/README: no tables'
} | report layers-readme

# GSL, cairo, teem and cJSON stay behind few doors and out of all headers.
awk '
  $2 ~ /gsl\// && $1 !~ /^src\/(kernel|solve)\/.*\.c$/ &&
    $1 != "src/cli/main.c" { print $1 ": includes " $2 }
  $2 ~ /cairo/ && $1 !~ /^src\/plot\/.*\.c$/ {
    print $1 ": includes " $2
  }
  $2 ~ /expat/ && $1 != "src/io/split_xml.c" { print $1 ": includes " $2 }
  $2 ~ /teem/ && $1 != "src/io/nrrd.c" { print $1 ": includes " $2 }
  $2 ~ /cJSON/ && $1 !~ /^src\/io\/value\.c$/ &&
    $1 !~ /^src\/cli\/(main|schema)\.c$/ {
    print $1 ": includes " $2
  }' "$tmp/includes" | report layers-foreign

# Input and output belong to io and cli; diag.c has snprintf.
awk '$2 == "<stdio.h>" && $1 !~ /^src\/(io|cli)\// &&
  $1 != "src/base/diag.c" { print $1 ": includes " $2 }' "$tmp/includes" |
  report layers-stdio

# Only cli ends the program or asks the system for its surroundings, nobody
# touches the locale or jumps.  mem.c reads what fault injection has to fail.
while read -r file; do
  # comments out, then strings; line numbers stay
  awk -v file="$file" '
    {
      line = $0
      gsub(/"([^"\\]|\\.)*"/, "\"\"", line)
      out = ""
      while (line != "") {
        if (inside) {
          i = index(line, "*/")
          if (!i) break
          inside = 0
          line = substr(line, i + 2)
        } else {
          i = index(line, "/*")
          j = index(line, "//")
          if (j && (!i || j < i)) { out = out substr(line, 1, j - 1); break }
          if (!i) { out = out line; break }
          out = out substr(line, 1, i - 1) " "
          inside = 1
          line = substr(line, i + 2)
        }
      }
      call = "(^|[^A-Za-z0-9_])(setlocale|setjmp|longjmp|gets|strtok|rand|srand"
      if (file !~ /^src\/cli\//) {
        call = call "|exit|_exit|_Exit|quick_exit|abort|time|clock"
        if (file != "src/base/mem.c") call = call "|getenv"
      }
      if (out ~ (call ")[ ]*\\(")) print file ":" NR ": " $0
    }' "$file"
done <"$tmp/files" | report layers-calls

# Mutable data of file scope below cli: any symbol in a writable section, which
# .data.rel.ro (constant pointers, relocated once) is not.
objects() {
  (cd "$builddir" 2>/dev/null && find src -name '*.o' ! -path 'src/cli/*') |
    sort
}
if [ -z "$(objects)" ]; then
  echo "skip layers-state: no objects below $builddir"
elif ! objects | (cd "$builddir" && xargs nm -A -f sysv) >"$tmp/symbols" 2>&1
then
  echo 'skip layers-state: no nm that knows -f sysv'
else
  # an object whose source is gone is no concern of ours
  awk -F '|' '
    $NF ~ /^[ ]*(\.data|\.bss|\.tdata|\.tbss|\*COM\*|COMMON)/ &&
    $NF !~ /\.data\.rel\.ro/ {
      object = $1
      sub(/:[^:]*$/, "", object)
      symbol = $1
      sub(/.*:/, "", symbol)
      sub(/\.o$/, ".c", object)
      gsub(/ /, "", symbol)
      gsub(/ /, "", $NF)
      if ((getline line < object) >= 0) print object ": " symbol " in " $NF
      close(object)
    }' "$tmp/symbols" | report layers-state
fi

test ! -e "$tmp/bad"
