# SPDX-License-Identifier: GPL-3.0-or-later
#
# Offsets of curves in space: four for each distance, along the vectors of the
# frame that the preimage carries.
. "$srcdir/tests/cli/lib.sh"

hermite='"points":[[0,0,0],[1,1,0],[2,0,1],[3,1,3]],'\
'"tangents":[[1,0,0],[0,1,1],[1,-2,0],[0,0,3]]'

# solve TEXT [ARGUMENT...]: without warnings
solve() {
  text=$1
  shift
  feed "{$text}" spatial-hermite -q "$@"
}

# ---- polynomial segments -----------------------------------------------------

solve "$hermite" --offset=0.25,-0.5
expect 'offsets' 0
piece='{distance:number,vector:string,degree:number,segments:[{segment:number,'\
'interval:[number],control_points:[[number]],weights:[number]}],cusps:['
equal 'offsets: their shape' \
  "[$piece],gaps:[]}|$piece{segment:number,t:number}],gaps:[]}]" \
  "$(shape_of offsets)"
equal 'offsets: four for each distance' \
  '0.25 "e2" -0.25 "e2" 0.25 "e3" -0.25 "e3" -0.5 "e2" 0.5 "e2" -0.5 "e3" 0.5 "e3" absent' \
  "$(for i in 0 1 2 3 4 5 6 7; do
    printf '%s %s ' "$(get "offsets[$i].distance")" "$(get "offsets[$i].vector")"
  done)$(get 'offsets[8]')"
equal 'offsets: of degree 9, a piece for each segment' '9 0 1 2 [0,1] absent' \
  "$(get 'offsets[0].degree') $(get 'offsets[0].segments[0].segment') $(
    get 'offsets[0].segments[1].segment') $(
    get 'offsets[0].segments[2].segment') $(
    get 'offsets[0].segments[2].interval') $(get 'offsets[0].segments[3]')"

# The rational Bezier curves against r + d e, with r and the frame from the
# control points and the preimage.
cat >offset.awk <<'EOF'
function bezier(n, at, step, u,   b, i, k) {
  for (i = 0; i <= n; i++) b[i] = x[at + step * i]
  for (k = n; k > 0; k--)
    for (i = 0; i < k; i++) b[i] += u * (b[i + 1] - b[i])
  return b[0]
}
# the coefficient of c (1 x, 2 y, 3 z) of A j A* (e = 2) or A k A* (e = 3)
function frame(e, c, u,   a0, a1, a2, a3, size) {
  a0 = bezier(2, 19, 4, u); a1 = bezier(2, 20, 4, u)
  a2 = bezier(2, 21, 4, u); a3 = bezier(2, 22, 4, u)
  size = a0 ^ 2 + a1 ^ 2 + a2 ^ 2 + a3 ^ 2
  if (e == 2 && c == 1) return 2 * (a1 * a2 - a0 * a3) / size
  if (e == 2 && c == 2) return (a0 ^ 2 - a1 ^ 2 + a2 ^ 2 - a3 ^ 2) / size
  if (e == 2 && c == 3) return 2 * (a2 * a3 + a0 * a1) / size
  if (e == 3 && c == 1) return 2 * (a1 * a3 + a0 * a2) / size
  if (e == 3 && c == 2) return 2 * (a2 * a3 - a0 * a1) / size
  return (a0 ^ 2 - a1 ^ 2 - a2 ^ 2 + a3 ^ 2) / size
}
# the offset: points times weights from 51 on, as a quotient
function offset(c, u,   up, down, i, b, w, p) {
  p = 1
  for (i = 0; i <= 9; i++) {
    b = p * u ^ i * (1 - u) ^ (9 - i)
    p = p * (9 - i) / (i + 1)
    w = x[62 + i]
    up += b * w * x[32 + 3 * i + c - 1]
    down += b * w
  }
  return up / down
}
{ x[NR] = $1 }
END {
  if (NR != 71) { print NR " numbers"; exit 1 }
  for (u = 0; u <= 1; u += 0.125)
    for (c = 1; c < 4; c++) {
      d = offset(c, u) - bezier(5, c, 3, u) - x[31] * frame(e, c, u)
      if (!(d * d < 1e-24)) { print "u " u ", " c ": off by " d; exit 1 }
    }
}
EOF
for i in 0 1 2 3; do
  for k in 0 2; do
    {
      floats "segments[$k].control_points"
      floats "segments[$k].preimage"
      floats "offsets[$i].distance"
      floats "offsets[$i].segments[$k].control_points"
      floats "offsets[$i].segments[$k].weights"
    } >numbers
    true_that "offset $i of segment $k is r + d e" \
      awk -v e=$((2 + i / 2)) -f offset.awk numbers
  done
done

# The frame begins as upright as it can, and goes on from segment to segment.
solve '"points":[[0,0],[1,0],[2,1]]' --offset=0.5
expect 'offsets of plane data' 0
floats 'offsets[0].segments[0].control_points[0]' |
  holds 'e2 is to the left, in the plane' \
    'n == 3 && x[3] == 0 && x[2] > 0.4'
floats 'offsets[2].segments[0].control_points[0]' |
  holds 'e3 is upwards' 'n == 3 && x[1]^2 < 1e-30 && x[2]^2 < 1e-30 &&
    (x[3] - 0.5)^2 < 1e-30'
solve '"points":[[0,0,0],[0,0,1]]' --offset=0.5
{
  floats 'offsets[0].segments[0].control_points[0]'
  floats 'offsets[2].segments[0].control_points[0]'
} | holds 'a vertical tangent: e3 is along x' 'n == 6 && (x[4] - 0.5)^2 < 1e-30 &&
  x[5]^2 < 1e-30 && x[6]^2 < 1e-30 && (x[2] + 0.5)^2 < 1e-30'
solve "$hermite" --offset=0.25
for i in 0 1 2 3; do
  floats "offsets[$i].segments[0].control_points[9]" >one
  floats "offsets[$i].segments[1].control_points[0]" >two
  numbers "offset $i goes on in the next segment" 1e-14 one two
done

# ---- algebraic-trigonometric segments ----------------------------------------

atph="$hermite,\"basis\":\"atph\",\"alpha\":1,\"criterion\":\"cc\""
solve "$atph" --offset=0.25 --tolerance=1e-5
expect 'offsets of atph' 0
equal 'offsets of atph: their shape' '[{distance:number,vector:string,'\
'degree:number,segments:[{segment:number,interval:[number],'\
'numerator:[[number]],denominator:[number]}],beziers:[{segment:number,'\
'interval:[number],control_points:[[number]]}],error:number,cusps:[],gaps:[]}]' \
  "$(shape_of offsets)"
equal 'offsets of atph: four' '-0.25 "e3" absent' \
  "$(get 'offsets[3].distance') $(get 'offsets[3].vector') $(get 'offsets[4]')"
for i in 0 1 2 3; do
  get "offsets[$i].error" | holds "offset $i of atph: within the tolerance" \
    'n == 1 && x[1] > 0 && x[1] <= 1e-5'
  {
    floats 'segments[0].control_points[0]'
    floats "offsets[$i].segments[0].numerator[0]"
    floats "offsets[$i].segments[0].denominator" | sed -n 1p
    floats "offsets[$i].beziers[0].control_points[0]"
  } | holds "offset $i of atph: the displacement at the start" 'n == 10 &&
    (x[1] + x[4] / x[7] - x[8])^2 < 1e-26 &&
    (x[2] + x[5] / x[7] - x[9])^2 < 1e-26 &&
    (x[3] + x[6] / x[7] - x[10])^2 < 1e-26 &&
    ((x[4] / x[7])^2 + (x[5] / x[7])^2 + (x[6] / x[7])^2 - 0.0625)^2 < 1e-26'
done
solve "$atph" --convert=bezier --offset=0.25 --tolerance=1e-5
expect 'offsets beside a conversion' 0
equal 'offsets beside a conversion: kind' '"bezier" 0.25' \
  "$(get curve) $(get 'offsets[0].distance')"

# ---- tables, warnings, failures ----------------------------------------------

solve "\"id\":\"a\",$hermite" -f csv --table=offsets --offset=0.25
equal 'the table' 'id,distance,segment,index,x,y,z,weight,vector 121' \
  "$(sed -n 1p out) $(wc -l <out | tr -d ' ')"
cut -d , -f 1-3,9 out | sort -u | sed 1,3d | wc -l | tr -d ' ' >found
awk -F, 'NR > 1 { n[$1 "," $2 "," $3 "," $9]++ } END {
  for (k in n) { rows++; if (n[k] != 10) bad = 1 }
  print bad + 0, rows }' out >found
equal 'the table: ten rows for each piece' '0 12' "$(cat found)"

# An arc of a circle, nearly, of radius 1: the smallest distance with a cusp.
turn='"points":[[0,0,0],[2,1,0],[4,0,1]],"tangents":[[0,1,0],[1,0,0],[1,-1,1]]'
feed "{$turn}" spatial-hermite --offset=0.01 --strict
expect 'an offset within the radius of curvature' 0
feed "{$turn}" spatial-hermite --offset=0.8
says='the offset at distance -0.8 along e2 turns back, where the radius of
curvature towards it is smaller: 1 times, first in segment 0 at'
says=$(printf %s "$says" | tr '\n' ' ')
equal 'an offset beyond it' "phspline: -:1: record 1: warning: $says U of its \
interval [offset-cusp]" "$(sed 's/at 0.1[0-9]* of/at U of/' err)"
equal 'an offset beyond it: a warning' '0 "offset-cusp" 0 absent' \
  "$status $(get 'warnings[0].code') $(get 'warnings[0].segment') $(
    get 'warnings[1]')"
feed "{$turn}" spatial-hermite --offset=0.8 --strict
equal 'an offset beyond it: --strict' '1 "offset-cusp"' \
  "$status $(get error.code)"

# A curve of the speed (1 - 2 u)^4, up to rounding: it hardly moves in between.
solve '"points":[[0,0,0],[1,0,0]],"derivatives":[[5,0,0],[5,0,0]],
  "axis":"bisector","angles":[0,0]' --offset=0.1 -f csv --table=offsets
expect 'a curve that nearly stands still' 0
cut -d , -f 8 out | sed 1d >weights
awk '!($1 > 0) { bad = 1 } END { exit bad || NR < 40 }' weights
equal 'a curve that nearly stands still: weights are positive' 0 $?
# Sizes at which squares leave the range of numbers.
for size in 1e-160 1e160; do
  for more in '' "\"basis\":\"atph\",\"alpha\":1,\"criterion\":\"cc\","; do
    solve "$more\"points\":[[0,0,0],[$size,$size,0]]" \
      --offset=$size
    equal "offsets of the size $size $more" 0 "$status"
    "$PHSPLINE" verify out >verdict.json
    equal "offsets of the size $size $more: verify" 0 $?
  done
done
solve '"points":[[0,0,0],[1.7e308,1.7e308,0]]' --offset=1.7e308
equal 'an offset that is too large' '1 "too-large"' "$status $(get error.code)"
for basis in ph atph; do
  solve '"points":[[-3e307,-3e307,-3e307],[3e307,-2e307,-1e307],[2e307,3e307,-3e307]]' \
    --basis=$basis --offset=1
  equal "an offset of a curve of $basis that is too fast" '1 "too-large"' \
    "$status $(get error.code)"
done
for value in '' x '1,' 0x1 1e999; do
  solve "$hermite" --offset="$value"
  equal "--offset=$value" 2 "$status"
done
solve "$hermite" --offset=0
expect 'the distance 0' 0
