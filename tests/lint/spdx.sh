#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Every source file and script names its licence in its first line (scripts
# with an interpreter line: in the second).
set -eu
cd "${srcdir:-$(dirname "$0")/../..}"
bad=0

list() {
  find src tests bench -type f \( -name '*.[ch]' -o -name '*.def' \
    -o -name '*.sh' -o -name '*.t' -o -name '*.awk' -o -name run \) 2>/dev/null
  find .ci Makefile configure.ac config.mk.in -type f
  find data -name '*.sh' 2>/dev/null
}

for file in $(list | sort); do
  if ! sed -n '1p; 2{x;/^#!/!d;x;p;}; 1h; 2q' "$file" |
    grep -q 'SPDX-License-Identifier: GPL-3.0-or-later'; then
    echo "not ok spdx $file: no SPDX line at its top"
    bad=1
  fi
done
if [ "$bad" -eq 0 ]; then
  echo 'ok spdx'
fi
exit "$bad"
