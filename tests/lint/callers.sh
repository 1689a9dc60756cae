#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# A function that a header of src/ declares is named in a file that is not its
# own (of src/, tests/ or bench/), or once more in a header, whose inline
# functions call it: what one file alone calls is static.
set -eu
cd "${srcdir:-$(dirname "$0")/../..}"

# shellcheck disable=SC2016 # $0 is that of awk
find src tests bench -name '*.[ch]' -o -name '*.def' -o -name '*.cc' | sort |
  xargs awk '
    function stem(file) { sub(/\.[a-z]+$/, "", file); return file }
    /^ *\/\*/ || /^ \*/ { next } # a comment
    # a declaration of a header, in column one
    FILENAME ~ /^src\/.*\.h$/ && !/^(static|typedef)/ &&
      /^[a-z].*ph_[a-z0-9_]+\(/ && match($0, /ph_[a-z0-9_]+\(/) {
      home[substr($0, RSTART, RLENGTH - 1)] = stem(FILENAME)
    }
    {
      line = $0
      header = FILENAME ~ /\.h$/
      while (match(line, /ph_[a-z0-9_]+/)) {
        name = substr(line, RSTART, RLENGTH)
        line = substr(line, RSTART + RLENGTH)
        in_header[name] += header
        if (!((name, stem(FILENAME)) in named)) {
          named[name, stem(FILENAME)]
          files[name]++
        }
      }
    }
    END {
      for (name in home) {
        if (files[name] < 2 && in_header[name] < 2) {
          print "not ok callers " home[name] ".h: " name
          bad = 1
        }
      }
      if (!bad) {
        print "ok callers"
      }
      exit bad
    }'
