#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Every publication cited in src/ or man/ has its entry in man/references.bib,
# and every entry there is cited.  There are two forms of citation:
#
#   GON18            a key: three capitals and the year, as in [GON18, (2.32)]
#   Clinger (1990)   the last of the authors named and the year; src/ only
#
# An entry counts as cited by either, the second if it has that author and year.
set -eu
cd "${srcdir:-$(dirname "$0")/../..}"
bib=man/references.bib
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT

if [ ! -f "$bib" ]; then
  echo "not ok cite: no $bib"
  exit 1
fi

# KEY YEAR AUTHORS, one entry a line
awk '
  /^@[a-z]+\{/ {
    key = $0
    sub(/^[^{]*\{/, "", key)
    sub(/,.*/, "", key)
    author = year = ""
  }
  /^ *author *=/ { author = $0; gsub(/[{}]/, " ", author); open = 1; next }
  /^ *[a-z]+ *=/ { open = 0 }
  open { author = author " " $0 }
  /^ *year *=/ { year = $0; gsub(/[^0-9]/, "", year) }
  /^\}/ { print key, year, author }' "$bib" >"$tmp/entries"

find src man -type f ! -name '*.bib' -exec cat {} + |
  grep -owE '[A-Z]{3}[0-9]{2}' | sort -u >"$tmp/keys"
# comments are joined, as a citation may go over the end of a line
find src -name '*.[ch]' -exec cat {} + | sed 's|^[ /]*\*||' | tr '\n' ' ' |
  tr -s ' ' | grep -oE '[A-Z][a-z]+ \(?(19|20)[0-9]{2}([^0-9]|$)' |
  tr -cd 'A-Za-z0-9 \n' | sed 's/ *$//' | sort -u >"$tmp/names"

awk '
  FILENAME ~ /entries$/ {
    if (entries[$1]++) print $1 ": twice in the bibliography"
    year[$1] = $2
    author[$1] = $0
    next
  }
  FILENAME ~ /keys$/ {
    if ($1 in entries) cited[$1] = 1
    else print $1 ": cited, not in the bibliography"
    next
  }
  {
    found = 0
    for (key in entries) {
      if (year[key] == $2 && index(author[key], " " $1 ",")) {
        found = cited[key] = 1
      }
    }
    if (!found) print $1 " (" $2 "): cited, not in the bibliography"
  }
  END {
    for (key in entries) {
      if (!(key in cited)) print key ": in the bibliography, cited nowhere"
    }
  }' "$tmp/entries" "$tmp/keys" "$tmp/names" | sort >"$tmp/bad"

if [ ! -s "$tmp/entries" ] || [ ! -s "$tmp/keys" ] || [ ! -s "$tmp/names" ]; then
  echo 'no entries or no citations were found' >>"$tmp/bad"
fi
if [ -s "$tmp/bad" ]; then
  sed 's/^/not ok cite: /' "$tmp/bad"
  exit 1
fi
echo 'ok cite'
