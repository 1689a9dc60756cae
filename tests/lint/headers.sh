#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Each header of src/ compiles alone, and twice in a row, under its guard
# PH_ROOM_NAME_H.  COMPILE is the Makefile's compiler command.
set -eu
cd "${srcdir:-$(dirname "$0")/../..}"
compile=${COMPILE:-cc -std=c11 -D_POSIX_C_SOURCE=200809L -Wall -Wextra -Isrc}
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
bad=0

for header in $(find src -name '*.h' | sort); do
  name=${header#src/}
  guard=PH_$(echo "$name" | tr 'a-z/.-' 'A-Z___')
  printf '#include "%s"\n#include "%s"\n' "$name" "$name" >"$tmp/alone.c"
  why=
  # compiler flags are words
  # shellcheck disable=SC2086
  if ! $compile -I"$(pwd)/src" -Werror -fsyntax-only "$tmp/alone.c" \
    >"$tmp/log" 2>&1; then
    why='does not compile alone'
  elif ! grep -q "^#ifndef $guard\$" "$header" ||
    ! grep -q "^#define $guard\$" "$header"; then
    why="its guard is not $guard"
  fi
  if [ -z "$why" ]; then
    echo "ok header $name"
  else
    echo "not ok header $name: $why"
    cat "$tmp/log"
    bad=1
  fi
done
exit "$bad"
