#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Our scripts give shellcheck nothing to say.  SC1091: files that a script reads
# are checked by themselves; SC2154: tests get srcdir from the environment.
set -eu
cd "${srcdir:-$(dirname "$0")/../..}"
bad=0

if ! command -v shellcheck >/dev/null; then
  echo 'skip shellcheck: no shellcheck'
  exit
fi

list() {
  find tests bench data .ci -type f \( -name '*.sh' -o -name '*.t' \
    -o -path 'bench/*' ! -name '*.*' ! -name README \) 2>/dev/null
  find .ci -type f ! -name '*.awk'
}

for file in $(list | sort -u); do
  shell="sh"
  case $(sed -n 1p "$file") in *bash*) shell=bash ;; esac
  if log=$(shellcheck -s "$shell" -e SC1091,SC2154 "$file" 2>&1); then
    continue
  fi
  echo "not ok shellcheck $file"
  echo "$log"
  bad=1
done
if [ "$bad" -eq 0 ]; then
  echo 'ok shellcheck'
fi
exit "$bad"
