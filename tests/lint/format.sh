#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# C sources look as .clang-format says; tables (*_table.h) are left alone.
set -eu
cd "${srcdir:-$(dirname "$0")/../..}"
bad=0

if ! command -v clang-format >/dev/null; then
  echo 'skip format: no clang-format'
  exit
fi
for file in $(find src tests bench -name '*.[ch]' 2>/dev/null | sort); do
  case $file in *_table.h) continue ;; esac
  if ! log=$(clang-format --dry-run -Werror "$file" 2>&1); then
    echo "not ok format $file: clang-format -i would change it"
    echo "$log" | sed -n 1,6p
    bad=1
  fi
done
if [ "$bad" -eq 0 ]; then
  echo 'ok format'
fi
exit "$bad"
