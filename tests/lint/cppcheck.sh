#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# cppcheck finds no error, no warning and nothing slow or unportable in src/.
# System headers are not looked into, and an analysis that gives up for size is
# no finding.  Right shifts of negative numbers are arithmetic with every
# compiler we know; a sanitizer watches the left shifts.
set -eu
cd "${srcdir:-$(dirname "$0")/../..}"

if ! command -v cppcheck >/dev/null; then
  echo 'skip cppcheck: no cppcheck'
  exit
fi
if cppcheck -q -j 2 --std=c11 --language=c --error-exitcode=1 \
  --enable=warning,performance,portability --inline-suppr \
  --suppress=missingIncludeSystem --suppress=normalCheckLevelMaxBranches \
  --suppress=shiftNegativeLHS --suppress=unmatchedSuppression \
  -D_POSIX_C_SOURCE=200809L -Isrc \
  --template='{file}:{line}: {severity}: {message} [{id}]' src; then
  echo 'ok cppcheck'
else
  echo 'not ok cppcheck: see above'
  exit 1
fi
