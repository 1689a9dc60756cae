# SPDX-License-Identifier: GPL-3.0-or-later
#
# Curves of tc --mode=g2 move with their points: hostile families (hostile.py),
# begun elsewhere, backward, mirrored, turned, shifted, and at sizes from 1e-9 to
# 1e9, give the same cubics and joints.  SETS says how many of each family, 6 if
# it does not, and 2 where every step takes long (PH_SHORT=1).
. "$srcdir/tests/cli/lib.sh"
python=/usr/bin/python3
hostile=$srcdir/tests/cli/hostile.py
moved=$srcdir/tests/cli/moved.py

if ! "$python" -c '' 2>/dev/null; then
  echo 'ok without python3 # SKIP'
  exit 0
fi

# same NAME LIMIT WANTED HOW...: of the problems in the file in
same() {
  case=$1
  limit=$2
  wanted=$3
  shift 3
  run tc -q --mode=g2 in
  mv out one
  for how; do
    "$python" "$moved" "$how" <in >there
    run tc -q --mode=g2 there
    equal "$case: $how" "$wanted" "$("$python" "$moved" "$how" "$limit" one out)"
  done
}

families=$("$python" "$hostile" names)
if [ "${PH_SHORT-}" = 1 ]; then
  sets=${SETS:-2}
else
  sets=${SETS:-6}
fi
for name in $families convex mixed; do
  "$python" "$hostile" "$name" "$sets" 7
done >in
same 'coordinates as they are' 1e-9 "$((17 * sets)) 0" \
  shift reverse mirror quarter grow shrink
same 'coordinates are rounded' 1e-6 "$((17 * sets)) 0" turn away big small
"$python" "$moved" shift <in >other
run tc -q --mode=g2 in
mv out one
run tc -q --mode=g2 other
true_that 'others differ' test \
  "$("$python" "$moved" mirror 1e-6 one out | cut -d ' ' -f 2)" -gt "$sets"
