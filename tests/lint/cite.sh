#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Citations of the form [KEY, eq. (n)] in src/ have their entry @type{KEY, in
# man/references.bib, and every entry there is cited in src/ or man/.
# A key is a name, which begins with a capital, and at least two digits.
set -eu
cd "${srcdir:-$(dirname "$0")/../..}"
bib=man/references.bib
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
bad=0

find src -name '*.[ch]' -exec cat {} + |
  grep -Eo '(^|[^A-Za-z0-9_)])\[[A-Z][A-Za-z]*[0-9]{2,4}[a-z]?(\]|, *(eqs?|sec|ch|p|pp|app|[Ff]ig|[Tt]able|[Ll]emma|[Tt]h|[Pp]rop|[Cc]or|[Aa]lg|[Dd]ef|[Rr]em|ex)[^A-Za-z])' |
  sed 's/^[^[]*\[//; s/[],].*//' | sort -u >"$tmp/used" || true
if [ ! -f "$bib" ]; then
  if [ -s "$tmp/used" ]; then
    echo "not ok cite: src/ cites $(tr '\n' ' ' <"$tmp/used")but there is no $bib"
    exit 1
  fi
  echo "skip cite: no $bib yet, and src/ uses no key"
  exit
fi
sed -n 's/^@[A-Za-z]*{[ ]*\([^, ]*\),.*/\1/p' "$bib" | sort >"$tmp/all"
sort -u "$tmp/all" >"$tmp/keys"
for key in $(comm -23 "$tmp/used" "$tmp/keys"); do
  echo "not ok cite $key: cited in src/, not in $bib"
done >"$tmp/bad"
uniq -d "$tmp/all" | sed "s|.*|not ok cite &: twice in $bib|" >>"$tmp/bad"
while read -r key; do
  grep -rqw --include='*.[ch1-9]' -e "$key" src man ||
    echo "not ok cite $key: in $bib, cited nowhere"
done <"$tmp/keys" >>"$tmp/bad"
if [ -s "$tmp/bad" ]; then
  cat "$tmp/bad"
  bad=1
else
  echo 'ok cite'
fi
exit "$bad"
