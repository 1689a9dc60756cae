# SPDX-License-Identifier: GPL-3.0-or-later
#
# Offsets of curves with corners: they are told, in parts, each with both of its
# ends, wherever they are written.
. "$srcdir/tests/cli/lib.sh"

angle='"curve":[[[0,0],[10,0]],[[10,0],[10,10]]]'
square='"curve":[[[0,0],[4,0]],[[4,0],[4,4]],[[4,4],[0,4]],[[0,4],[0,0]]]'
gap='warning: the offset at distance -3 has gaps, where the curve has corners:'
told="phspline: -:1: record 1: $gap 1, before segment 1 [offset-gap]"

# places: t, s, x, y of the rows of a table of text; blank lines stay
places() {
  awk '/^#/ { next } NF { print $2, $3, $4, $5, $6; next } { print "" }' out
}

# ---- samples -------------------------------------------------------------------

cat >wanted <<'end'
0 0 0 0 0
0 1 10 10 0
1 1 20 10 10

0 0 0 0 -3
0 1 10 10 -3

1 0 10 13 0
1 1 20 13 10


end
feed "{$angle}" tc --tolerance=0.01 --offset=-3 --chord-error=0.01 \
  --table=samples --format=text
expect 'chords' 0 "$told"
places >found
numbers 'chords: both ends of each part' 1e-13 wanted found
equal 'chords: blank lines' "$(grep -n '^$' wanted)" "$(grep -n '^$' found)"

cat >wanted <<'end'
0 0 0 0 -3
0 0.4 4 4 -3
0 0.8 8 8 -3
0 1 10 10 -3

1 0 10 13 0
1 0.2 12 13 2
1 0.6 16 13 6
1 1 20 13 10


end
feed "{$angle}" tc --tolerance=0.01 --offset=-3 --spacing=4 --table=samples \
  --format=text
expect 'spacing' 0 "$told"
places | sed '1,/^$/d' >found
numbers 'spacing: both ends of each part' 1e-13 wanted found
equal 'spacing: blank lines' "$(grep -n '^$' wanted)" "$(grep -n '^$' found)"

feed "{$angle}" tc --tolerance=0.01 --offset=-3 --chord-error=1 --table=samples \
  --format=csv
expect 'CSV' 0 "$told"
equal 'CSV: no blank lines' '8 0' "$(grep -c . out) $(grep -c '^$' out)"

feed "{$angle}" tc --tolerance=0.01 --offset=-3,2 --table=offsets --format=text
expect 'table of offsets' 0 "$told"
equal 'table of offsets: a blank line between parts' \
  '1:# 8: 15: 22: 29: 30:' "$(grep -n '^$\|^#' out | cut -c 1-3 |
    sed 's/ *$//' | tr '\n' ' ' | sed 's/ $//')"

# ---- records -------------------------------------------------------------------

feed "{$angle}" tc --tolerance=0.01 --offset=-3 --sample=1
expect 'a record' 0 "$told"
equal 'a record: its gaps and its warning' '[1] "offset-gap" 1' \
  "$(get 'offsets[0].gaps') $(get 'warnings[0].code') \
$(get 'warnings[0].segment')"
cp out record
run verify record
expect 'a record: verified' 0

feed "{$angle}" tc --tolerance=0.01 --offset=-3 --strict
expect '--strict' 1 "phspline: -:1: record 1: ${gap#warning: } 1, before \
segment 1 [offset-gap]
phspline: 1 of 1 records failed"
equal '--strict: the record' '"error" "offset-gap"' \
  "$(get status) $(get error.code)"

feed "{$angle}" tc --tolerance=0.01 --offset=-3 --quiet
expect '--quiet' 0

feed "{$square,\"closed\":true}" tc --tolerance=0.01 --offset=-3 --chord-error=1
expect 'a closed curve' 0 "phspline: -:1: record 1: $gap 4, before segments \
0, 1, 2, 3 [offset-gap]"
equal 'a closed curve: its gaps' '[0,1,2,3]' "$(get 'offsets[0].gaps')"
equal 'a closed curve: its samples' 8 \
  "$(get 'offsets[0].samples' | grep -o '"t"' | grep -c .)"
cp out record
run verify record
expect 'a closed curve: verified' 0

{
  printf '{"curve":[[[0,0],[1,0]]'
  for i in 1 2 3 4 5 6 7 8 9 10; do
    printf ',[[%d,%d],[%d,%d]]' $(((i + 1) / 2)) $((i / 2)) \
      $(((i + 2) / 2)) $(((i + 1) / 2))
  done
  printf ']}\n'
} >stairs
run tc --tolerance=0.01 --offset=-0.1 stairs
expect 'many gaps' 0 "phspline: stairs:1: record 1: warning: the offset at \
distance -0.1 has gaps, where the curve has corners: 10, before segments 1, 2, \
3, 4, 5, 6, 7, 8, ... [offset-gap]"

feed '{"points":[[0,0],[2,1],[3,0],[5,2]],"mode":"spline"}' tc \
  --offset=0.1
expect 'no corners' 0
equal 'no corners: no gaps' '[]' "$(get 'offsets[0].gaps')"

# In space the frame of a closed curve comes back turned.
closed='"points":[[0,0,0],[2,0,1],[3,2,0],[0,2,2]],"closed":true'
feed "{$closed}" spatial-hermite --offset=0.1 --chord-error=0.01
expect 'in space' 0 "phspline: -:1: record 1: warning: the offset at distance \
0.1 along e2 has gaps, where the frame turns at a joint: 1, before segment 0 \
[offset-gap]"
equal 'in space: all offsets' '[0] [0] [0] [0]' "$(get 'offsets[0].gaps') \
$(get 'offsets[1].gaps') $(get 'offsets[2].gaps') $(get 'offsets[3].gaps')"

# ---- drawings ------------------------------------------------------------------

# subpaths: how many begin, and how many are closed
subpaths() {
  echo "$(tr -cd M <out | wc -c) $(tr -cd Z <out | wc -c)" | tr -s ' '
}

feed "{$angle}" tc --tolerance=0.01 --offset=-3 --format=svg-path
expect 'svg-path' 0 "$told"
equal 'svg-path: a subpath each part' '3 0' "$(subpaths)"
true_that 'svg-path: where they begin' grep -q 'M0,-3C.*10,-3M13,0C' out
feed "{$square,\"closed\":true}" tc --tolerance=0.01 --offset=-3 --quiet \
  --format=svg-path
equal 'svg-path: a closed curve, its offset is open' '5 1' "$(subpaths)"
# one corner, at the closing joint: a drop
feed '{"curve":[[[0,0],[4,3],[4,-3],[0,0]]],"closed":true}' tc \
  --tolerance=0.01 --offset=-0.1 --format=svg-path
expect 'svg-path: a drop' 0 "phspline: -:1: record 1: warning: the offset at \
distance -0.1 has gaps, where the curve has corners: 1, before segment 0 \
[offset-gap]"
equal 'svg-path: a drop, its offset is open' '2 1' "$(subpaths)"
feed "{$closed}" spatial-hermite --offset=0.1 --format=svg-path --quiet
equal 'svg-path: closed in space, its offsets are open' '5 1' "$(subpaths)"
