# SPDX-License-Identifier: GPL-3.0-or-later
#
# `cone': pairs of random elements, followed by other means, and refusals that
# another computation confirms: 1500 pairs, or PAIRS; 100,000 with PH_LONG=1, some
# minutes.
. "$srcdir/tests/cli/lib.sh"

[ "${PH_LONG-}" != 1 ] || PAIRS=${PAIRS:-100000}

for python in python3 /usr/bin/python3; do
  if "$python" -c 'import numpy' 2>/dev/null; then
    status=0
    "$python" "$srcdir/tests/cli/cone_pairs.py" "$PHSPLINE" "${PAIRS:-1500}" \
      "${PH_SEED:-1}" >found || status=$?
    equal 'pairs are met, and refusals confirmed' '0 1' \
      "$status $(wc -l <found | tr -d ' ')"
    sed 's/^/# /' found
    exit
  fi
done
echo 'skip pairs: no python3 with numpy was found'
