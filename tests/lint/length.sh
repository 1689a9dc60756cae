#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Files have at most 600 lines, functions at most 60, counted from the line of
# the name to the closing brace.  Tables (*_table.h) may be longer.  Reads our
# format: a function begins in column one and ends with a brace in column one.
set -eu
cd "${srcdir:-$(dirname "$0")/../..}"
bad=0

for file in $(find src tests bench -name '*.[ch]' 2>/dev/null | sort); do
  case $file in *_table.h) continue ;; esac
  awk -v file="$file" '
    # a declaration or definition with parameters begins
    !inside && /^[A-Za-z_].*\(/ && !/=/ && !/\\$/ { start = NR }
    # ... it was a declaration, a macro call or an initialiser
    !inside && start && (/;[ \t]*$/ || /=/ || /^#/ || /^$/) { start = 0 }
    !inside && start && /\{[ \t]*$/ { inside = 1 }
    inside && /^\}/ {
      if (NR - start + 1 > 60) {
        print "not ok length " file ":" start ": function of " \
          NR - start + 1 " lines (60)"
        bad = 1
      }
      inside = start = 0
    }
    END {
      if (NR > 600) {
        print "not ok length " file ": " NR " lines (600)"
        bad = 1
      }
      exit bad
    }' "$file" || bad=1
done
if [ "$bad" -eq 0 ]; then
  echo 'ok length'
fi
exit "$bad"
