#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The manual: its pages format without a warning and fit 80 columns, and it says
# what the program's tables say, no less and no more.
#
# Tables are expanded by the C preprocessor from the headers that hold them;
# pages are compared by the items of their lists (.It), by section.
set -eu
export LC_ALL=C COLUMNS=120
cd "${srcdir:-$(dirname "$0")/../..}"
program=${PHSPLINE:-build/plain/phspline}
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
bad=0

fail() {
  echo "not ok man $1"
  bad=1
}

# same NAME FILE FILE: whether two lists hold the same lines, in any order
same() {
  sort "$2" >"$tmp/left"
  sort "$3" >"$tmp/right"
  if [ ! -s "$2" ] || [ ! -s "$3" ]; then
    fail "$1: a list is empty"
  elif cmp -s "$tmp/left" "$tmp/right"; then
    echo "ok man $1"
  else
    fail "$1: < in the program, > in the manual"
    diff "$tmp/left" "$tmp/right" | grep '^[<>]'
  fi
}

# table HEADER MACRO PARAMETERS BODY: the rows of an X-macro, one a line; string
# literals lose their quotes.
table() {
  printf '#include "%s"\n#undef NULL\n#define X(%s) @ %s\n%s(X)\n' \
    "$1" "$3" "$4" "$2" |
    ${CC:-cc} -E -P -Isrc -x c - | tr '\n@' ' \n' |
    awk 'NR > 1 { gsub(/"/, ""); gsub(/ *\| */, "|"); $1 = $1; print }'
}

# items PAGE SECTION MACRO: what the lists of a section name with the macro
items() {
  awk -v section="$2" -v macro="$3" '
    /^\.Sh / { inside = $0 == ".Sh " section }
    inside && $1 == ".It" && $2 == macro {
      sub(/^\.It [A-Z][a-z] /, "")
      sub(/ Op Ar .*/, "")
      gsub(/\\:/, "") # where a line may break
      n = split($0, name, / , /)
      for (i = 1; i <= n; i++) print name[i]
    }' "$1"
}

# ---- form ----

# rendered PAGE: as plain text for 80 columns, one byte for each character
rendered() {
  groff -mdoc -Tutf8 -P-c -P-b -P-u -rLL=78n "$1" | tr -d '\200-\277'
}

for page in man/*.[1-9]; do
  if ! command -v groff >/dev/null; then
    echo "skip man $page: no groff"
  elif groff -mdoc -Tutf8 -ww -z "$page" >"$tmp/log" 2>&1 &&
    [ ! -s "$tmp/log" ] && rendered "$page" >"$tmp/text" &&
    ! awk 'length > 80 { print "too long: " $0 }' "$tmp/text" | grep .; then
    echo "ok man $page"
  else
    fail "$page: groff warns, or a line does not fit"
    cat "$tmp/log"
  fi
  if command -v mandoc >/dev/null &&
    ! mandoc -T lint -W warning "$page" >"$tmp/log" 2>&1; then
    fail "$page: mandoc warns"
    cat "$tmp/log"
  fi
  # references to our own pages
  sed -n 's/^\.Xr \(phspline[a-z-]*\) \([1-9]\).*/\1.\2/p' "$page" |
    sort -u >"$tmp/references"
  while read -r other; do
    test -f "man/$other" || fail "$page: refers to $other, which is not there"
  done <"$tmp/references"
done

# ---- commands and options ----

if ! "$program" --help >"$tmp/help"; then
  fail "help: $program --help does not end with status 0"
  exit 1
fi
sed -n '/^Commands:/,/^$/s/^  \([a-z][a-z-]*\)  .*/\1/p' "$tmp/help" \
  >"$tmp/commands"
{
  cat "$tmp/commands"
  printf 'help\nschema\n'
} >"$tmp/list"
items man/phspline.1 DESCRIPTION Cm >"$tmp/page"
same commands "$tmp/list" "$tmp/page"

# options USE: those of the commands that solve, or that verify
options() {
  table cli/option.h PH_OPTIONS 'symbol, use, letter, name, argument, help' \
    'use letter name argument' | grep -E "^($1|ALL) " | sed "s/^[A-Z_]* //
    s/^'\(.\)' /-\1, --/; s/^0 /--/; s/ NULL\$//; s/ /=/2
    s/^\(--[^ ]*\) /\1=/"
}

# option_items PAGE: in the same form
option_items() {
  items "$1" OPTIONS Fl |
    awk '/^-/ { print "-" $0; next } { letter = $0; getline
      print "-" letter ", " "-" substr($0, 4) }' | sed 's/ Ns = Ns Ar /=/'
}

options 'CURVE|SOLVE|DRAW' >"$tmp/options"
options 'SURFACE|ANY_SURFACE' | sort >"$tmp/options.surface"
options NONE | sort | comm -13 - "$tmp/options.surface" >"$tmp/list"
option_items man/phspline-cone.1 >"$tmp/page"
same 'options of surfaces' "$tmp/list" "$tmp/page"
options 'PATCHES|ANY_SURFACE' | sort >"$tmp/options.patches"
options NONE | sort | comm -13 - "$tmp/options.patches" >"$tmp/list"
option_items man/phspline-bubble.1 | sort >"$tmp/page"
same 'options of patches' "$tmp/list" "$tmp/page"
options 'SURFACE|ANY_SURFACE|SOLVE|DRAW' >"$tmp/options.surface"
options 'PATCHES|ANY_SURFACE|SOLVE' >"$tmp/options.patches"
option_items man/phspline.1 >"$tmp/page"
same options "$tmp/options" "$tmp/page"
options VERIFY >"$tmp/options.verify"
option_items man/phspline-verify.1 >"$tmp/page"
same 'options of verify' "$tmp/options.verify" "$tmp/page"

# help_options NAME FILE LIST [FIELDS]: an option that is a field is listed as
# such
help_options() {
  sed -n 's/^ \{2,6\}\(\(-., \)*--[^ ]*\).*/\1/p' "$2" >"$tmp/page"
  sed 's/.*/--&=/' "${4:-/dev/null}" >"$tmp/not"
  awk 'FILENAME == ARGV[1] { field[$0] = 1; next }
    { name = $0; sub(/=.*/, "=", name) }
    !(name in field)' "$tmp/not" "$3" >"$tmp/list"
  same "options in $1" "$tmp/list" "$tmp/page"
}
help_options --help "$tmp/help" "$tmp/options"

# ---- fields ----

: >"$tmp/fields"
while read -r command; do
  page=man/phspline-$command.1
  if [ ! -f "$page" ] || ! "$program" help "$command" >"$tmp/help.$command"; then
    fail "$command: no page or no help"
    continue
  fi
  if [ "$command" = verify ]; then # its records are results
    help_options 'help verify' "$tmp/help.verify" "$tmp/options.verify"
    continue
  fi
  sed -n '/^Fields/,/^$/s/^  \([a-z][a-z_]*\) .*/\1/p' "$tmp/help.$command" \
    >"$tmp/list"
  items "$page" 'PROBLEM FIELDS' Cm >"$tmp/page"
  same "fields of $command" "$tmp/list" "$tmp/page"
  cat "$tmp/list" >>"$tmp/fields"
  # each word that a field may have is told there
  sed -n '/^Fields/,/^$/p' "$tmp/help.$command" | grep -o '"[^"]*"' |
    tr -d '"' | sort -u >"$tmp/words"
  sed -n '/^\.Sh PROBLEM FIELDS/,/^\.Sh [^P]/p' "$page" | tr -s ' ,:=' '\n' |
    sort -u >"$tmp/page"
  sed 's/:.*//' "$tmp/words" | sort -u | comm -23 - "$tmp/page" >"$tmp/unknown"
  if [ -s "$tmp/unknown" ]; then
    fail "words of $command: not in the manual: $(tr '\n' ' ' <"$tmp/unknown")"
  else
    echo "ok man words of $command: $(wc -l <"$tmp/words")"
  fi
  cp "$tmp/list" "$tmp/fields.$command"
  options=$tmp/options
  test "$command" != cone || options=$tmp/options.surface
  test "$command" != bubble || options=$tmp/options.patches
  help_options "help $command" "$tmp/help.$command" "$options" \
    "$tmp/fields.$command"
done <"$tmp/commands"
sort -u "$tmp/fields" -o "$tmp/fields"
table curve/problem.h PH_FIELDS 'symbol, name' 'name' >"$tmp/list"
same "fields of all commands" "$tmp/list" "$tmp/fields"
{
  printf 'id\nmeta\n'
  cat "$tmp/fields"
} >"$tmp/list"
items man/phspline.5 PROBLEMS Cm >"$tmp/page"
same "problems" "$tmp/list" "$tmp/page"

# no page speaks of an option that is none; examples may use other programs
cat "$tmp/options" "$tmp/options.surface" "$tmp/options.patches" \
  "$tmp/options.verify" |
  sed 's/.*--//; s/=.*//' | sort -u - "$tmp/fields" >"$tmp/list"
for page in man/*.[1-9]; do
  awk '/^\.Sh / { skip = /EXAMPLE/ } !skip && !/^\.\\"/' "$page" |
    sed 's/\\-/-/g' | grep -oE '(Fl -|--)[a-z][a-z_-]*' |
    sed 's/^Fl -//; s/^--//' | sort -u >"$tmp/page"
  comm -13 "$tmp/list" "$tmp/page" >"$tmp/unknown"
  if [ -s "$tmp/unknown" ]; then
    fail "$page: no option: $(tr '\n' ' ' <"$tmp/unknown")"
  fi
done

# ---- codes, results, tables ----

table base/status.h PH_STATUS 'symbol, code, class, meaning' 'class code' |
  sed -n 's/^RECORD //p; s/^INTERNAL //p' >"$tmp/list"
items man/phspline.1 DIAGNOSTICS Sy >"$tmp/page"
same "codes" "$tmp/list" "$tmp/page"

table curve/result.h PH_DIAGNOSTICS 'symbol, name, type, what' 'name' >"$tmp/list"
items man/phspline.5 CERTIFICATE Cm >"$tmp/page"
same "diagnostics" "$tmp/list" "$tmp/page"
table check/verify.h PH_CHECKS 'symbol, name' 'name' >"$tmp/checks"
items man/phspline-verify.1 CHECKS Cm >"$tmp/page"
same "checks of verify" "$tmp/checks" "$tmp/page"
cat man/*.[1-9] | grep -oE '[a-z0-9_]+_error' | sort -u >"$tmp/page"
sed -n 's/.*{"\([a-z_]*_error\)", MAY.*/\1/p' src/io/members_offset.def \
  >"$tmp/trimming"
cat "$tmp/list" "$tmp/checks" "$tmp/trimming" | grep '_error$' | sort -u \
  >"$tmp/errors"
same "errors of the certificate" "$tmp/errors" "$tmp/page"

table curve/result.h PH_CURVES 'symbol, kind, name' 'name' >"$tmp/list"
items man/phspline.5 RESULTS Cm >"$tmp/page"
same "curves" "$tmp/list" "$tmp/page"

table io/csv_out.h PH_TABLES 'symbol, name, what' 'name' >"$tmp/tables"
items man/phspline.1 OPTIONS Cm >"$tmp/page"
same "tables of --table" "$tmp/tables" "$tmp/page"
items man/phspline.5 'CSV OUTPUT' Cm >"$tmp/page"
same "tables" "$tmp/tables" "$tmp/page"
while read -r name; do
  with='planar --sample=1' # with offsets, samples have further columns
  case $name in
  offsets) with='planar --offset=1' ;;
  strips | development | located) with='cone --columns=x,y,z' ;;
  patches | edges) with='bubble --columns=x,y,z' ;;
  esac
  # several words
  # shellcheck disable=SC2086
  printf '0,0\n1,0\n' | "$program" $with --table="$name" 2>/dev/null |
    sed -n 1p
done <"$tmp/tables" >"$tmp/list"
items man/phspline.5 'CSV OUTPUT' Cm >"$tmp/names"
sed -n '/^\.Sh CSV OUTPUT/,/^\.El/s/^\.Li \(id,.*\)/\1/p' man/phspline.5 |
  sed 's/\\://g' >"$tmp/page"
same "columns of tables" "$tmp/list" "$tmp/page"

# names of CSV columns that at least one command takes
sed -n '/^} names\[\]/,/^};/p' src/io/split_columns.c | tr '{' '\n' |
  sed -n 's/^"\([a-z_]*\)".*/\1/p' >"$tmp/names"
while read -r name; do
  while read -r command; do
    "$program" "$command" --columns="$name" /dev/null 2>&1 |
      grep -q 'is unknown' || echo "$name"
  done <"$tmp/commands" | sort -u
done <"$tmp/names" >"$tmp/list"
items man/phspline.5 'CSV INPUT' Cm >"$tmp/page"
same "columns of CSV input" "$tmp/list" "$tmp/page"
exit "$bad"
