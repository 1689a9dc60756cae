# SPDX-License-Identifier: GPL-3.0-or-later
#
# Reads what `gcov -n' prints for each object and prints a line for each source
# file (headers are left out: they come once for every includer) and their sum.
#
#   File 'src/base/mem.c'
#   Lines executed:97.30% of 37

/^File '/ {
  split($0, part, "'")
  file = part[2]
  sub(/^\.\//, "", file)
}

/^Lines executed:/ && file ~ /\.c$/ {
  split($0, part, /[:% ]+/)
  n = $NF
  hit = int(part[3] * n / 100 + 0.5)
  lines[file] = n
  hits[file] = hit
  file = ""
}

/^No executable lines/ {
  file = ""
}

END {
  sort = "sort -n"
  for (f in lines) {
    total += lines[f]
    all += hits[f]
    printf "%6.1f %%  %5d of %5d  %s\n", 100 * hits[f] / lines[f], hits[f], \
      lines[f], f | sort
  }
  close(sort)
  if (total == 0) {
    print "coverage: gcov reported no file"
    exit 1
  }
  printf "%6.1f %%  %5d of %5d  all lines\n", 100 * all / total, all, total
}
