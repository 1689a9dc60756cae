#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The manual: pages format without a warning, and each long option stands both
# in `phspline COMMAND --help' and in phspline-COMMAND.1 or phspline.1.
# Examples are not searched for options: they may be another program's.
set -eu
cd "${srcdir:-$(dirname "$0")/../..}"
program=${PHSPLINE:-build/plain/phspline}
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
bad=0

fail() {
  echo "not ok man $1"
  bad=1
}

# The long options that a page, or a help text, names.
page_options() {
  awk '/^\.Sh / { skip = /EXAMPLE/ } !skip' "$@" | grep -v '^\.\\"' |
    sed 's/\\-/-/g; s/\\&//g' |
    grep -Eo '(Fl -|--)[a-z][a-z0-9_-]*' | sed 's/^Fl -/--/; s/_/-/g' |
    sort -u || true
}

help_options() {
  grep -Eo -e '--[a-z][a-z0-9_-]*' "$1" | sed 's/_/-/g' | sort -u || true
}

# ... and, as each field of a problem is an option too, the names that begin
# an indented line.
help_names() {
  help_options "$1"
  sed -n 's/^  *\([a-z][a-z0-9_-]*\)\([ =].*\)*$/--\1/p' "$1" | sed 's/_/-/g'
}

pages=$(find man -name '*.[1-9]' 2>/dev/null | sort)
if [ -z "$pages" ]; then
  echo 'skip man: no pages yet'
  exit
fi

for page in $pages; do
  if command -v groff >/dev/null; then
    groff -mdoc -Tutf8 -ww -z "$page" >"$tmp/log" 2>&1 || true
    if [ -s "$tmp/log" ]; then
      fail "$page: groff warns"
      cat "$tmp/log"
    else
      echo "ok man $page"
    fi
  else
    echo "skip man $page: no groff"
  fi
  if command -v mandoc >/dev/null; then
    mandoc -T lint -W warning "$page" >"$tmp/log" 2>&1 || {
      fail "$page: mandoc warns"
      cat "$tmp/log"
    }
  fi
  if man --version >/dev/null 2>&1; then
    MANROFFSEQ='' MANWIDTH=80 man --warnings -E UTF-8 -l -Tutf8 -Z "$page" \
      2>"$tmp/log" >/dev/null || true
    # other systems' man may not know these options, which is no fault of ours
    if grep -q 'warning' "$tmp/log"; then
      fail "$page: man warns"
      cat "$tmp/log"
    fi
  fi
done

if ! "$program" --help >"$tmp/help" 2>&1; then
  fail "help: $program --help does not end with status 0"
  exit 1
fi
cp "$tmp/help" "$tmp/help.main"
help_options "$tmp/help" >"$tmp/main.help"
page_options man/phspline.1 >"$tmp/main.page"
cp "$tmp/main.help" "$tmp/all.help"
for page in man/phspline-*.1; do
  test -f "$page" || continue
  command=${page#man/phspline-}
  command=${command%.1}
  if ! "$program" "$command" --help >"$tmp/help" 2>&1; then
    fail "help: phspline $command --help does not end with status 0"
    continue
  fi
  help_options "$tmp/help" >"$tmp/command.help"
  page_options "$page" >"$tmp/command.page"
  help_names "$tmp/help" | sort -u - "$tmp/main.help" >"$tmp/helps"
  sort -u "$tmp/all.help" "$tmp/helps" -o "$tmp/all.help"
  sort -u "$tmp/main.page" "$tmp/command.page" >"$tmp/pages"
  {
    comm -23 "$tmp/command.help" "$tmp/pages" | sed 's/$/ only in --help/'
    comm -13 "$tmp/helps" "$tmp/command.page" | sed 's/$/ only in the page/'
  } >"$tmp/diff"
  if [ -s "$tmp/diff" ]; then
    fail "options of $command: $(tr '\n' ',' <"$tmp/diff")"
  else
    echo "ok man options of $command"
  fi
done
{
  comm -23 "$tmp/main.help" "$tmp/main.page" | sed 's/$/ only in --help/'
  comm -13 "$tmp/all.help" "$tmp/main.page" | sed 's/$/ only in the page/'
} >"$tmp/diff"
if [ -s "$tmp/diff" ]; then
  fail "options of phspline: $(tr '\n' ',' <"$tmp/diff")"
else
  echo 'ok man options of phspline'
fi
# every command that --help lists (indented, then two blanks) has its page
sed -n "s/^  \([a-z][a-z-]*\)  .*/\1/p" "$tmp/help.main" >"$tmp/commands"
while read -r command; do
  test -f "man/phspline-$command.1" || fail "phspline-$command.1: no such page"
done <"$tmp/commands"
exit "$bad"
