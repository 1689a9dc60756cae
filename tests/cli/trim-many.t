# SPDX-License-Identifier: GPL-3.0-or-later
#
# Trimmed offsets of random curves beside buffers of GEOS, and what holds of
# them however they are moved: see trim_many.py.  PH_LONG=1 takes 1000 curves.
. "$srcdir/tests/cli/lib.sh"

curves=40
[ "${PH_SHORT-}" = 1 ] && curves=10
[ "${PH_LONG-}" = 1 ] && curves=1000
status=77
why="no python3"
for p in python3 /usr/bin/python3; do
  command -v "$p" >/dev/null || continue
  status=0
  "$p" "$srcdir/tests/cli/trim_many.py" "$PHSPLINE" "$curves" >found 2>&1 ||
    status=$?
  why=$(sed -n '$p' found)
  [ "$status" -eq 77 ] || break
done
case $status in
  0) pass "$why" ;;
  77) echo "skip random curves beside GEOS: $why (python3-shapely)" ;;
  *) fail 'random curves beside GEOS' "$(sed -n '1,20p' found)" ;;
esac
