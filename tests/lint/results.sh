#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# bench/README quotes the rows of bench/RESULTS.md as they are there.
set -eu
cd "${srcdir:-$(dirname "$0")/../..}"

if ! [ -f bench/RESULTS.md ]; then
  echo 'skip results: no bench/RESULTS.md, which make bench writes'
elif ! sh bench/quote bench/RESULTS.md bench/README check; then
  echo 'not ok results: bench/README; sh bench/quote bench/RESULTS.md bench/README'
  exit 1
else
  echo 'ok results'
fi
