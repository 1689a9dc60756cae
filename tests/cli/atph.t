# SPDX-License-Identifier: GPL-3.0-or-later
#
# The fields and options of algebraic-trigonometric splines: angles, every
# solution, the fairest curve, conversion to Bezier curves, offsets.
. "$srcdir/tests/cli/lib.sh"

points='"points":[[0,0],[1,1],[2,0],[3,1]]'
atph="$points,\"basis\":\"atph\""
many='"points":[[0,0],[1,1],[2,0],[3,1],[4,0],[5,1],[6,0],[7,1],[8,0],[9,1],'\
'[10,0],[11,1],[12,0],[13,1]]'

# refused NAME PROBLEM MESSAGE [ARGUMENT...]: an error record
refused() {
  name=$1 text=$2 message=$3
  shift 3
  feed "{$text}" planar -q "$@"
  expect "$name" 1 "phspline: -:1: record 1: $message"
  code=${message##*\[}
  equal "$name: the record" "\"error\" \"${code%]}\" absent" \
    "$(get status) $(get error.code) $(get segments)"
}

# ---- angles ------------------------------------------------------------------

segments='[{interval:[number],alpha:number,control_points:[[number]],'\
'preimage:[[number]],length:number}]'

feed "{$atph}" planar
expect 'basis atph' 0
equal 'basis atph: kind, segments' "\"atph\" $segments" \
  "$(get curve) $(shape_of segments)"
for k in 0 1 2; do
  json get "segments[$k].alpha" out
done >chordal
holds 'chordal: equal chords, the largest is half of pi' \
  'n == 3 && x[1] == 1.5707963267948966 && x[1] == x[2] && x[2] == x[3]' \
  <chordal
mv out default
feed "{$atph,\"alpha\":\"chordal\"}" planar
equal_files 'alpha "chordal" is the default' default out
feed "{$points}" planar --basis=atph --alpha=chordal
equal_but_set 'basis and alpha as options' default out
feed "{$atph,\"alpha\":\"chordal:1.5707963267948966\"}" planar
equal_files 'chordal:V' default out
feed '{"points":[[0,0],[3,4],[3,14]],"basis":"atph","alpha":"chordal:1"}' planar
equal 'chordal:V is the largest, the others are as their chords' '0.5 1' \
  "$(get 'segments[0].alpha') $(get 'segments[1].alpha')"
feed "{$atph,\"alpha\":0.5}" planar
mv out number
equal 'one number for all' '0.5 0.5 0.5' "$(json get 'segments[0].alpha' number) \
$(json get 'segments[1].alpha' number) $(json get 'segments[2].alpha' number)"
feed "{$atph,\"alpha\":[0.5,0.5,0.5]}" planar
equal_files 'a number for each' number out
feed "{$atph,\"alpha\":[0.5,1,0.25]}" planar
equal 'knots are the sums of the angles' '[0,0.5] [0.5,1.5] [1.5,1.75]' \
  "$(get 'segments[0].interval') $(get 'segments[1].interval') $(
    get 'segments[2].interval')"
feed "{$atph,\"alpha\":[1,1,1,1],\"closed\":true}" planar
expect 'a closed curve has one more' 0

feed "{$atph,\"alpha\":[1,2.5,1]}" planar
equal 'alpha above 2 pi/3 is warned of' "0 1 [2.5]" \
  "$status $(get 'warnings[0].segment') [$(get 'segments[1].alpha')]"
feed "{$atph,\"alpha\":2.09}" planar --strict
expect 'alpha below 2 pi/3' 0

between='must be between 0 and pi, found'
kinds='must be "chordal", "chordal:V", a number or an array of numbers, found'
refused 'alpha 0' "$atph,\"alpha\":0" "alpha: $between 0 [bad-value]"
refused 'alpha below 0' "$atph,\"alpha\":-1" "alpha: $between -1 [bad-value]"
refused 'alpha pi' "$atph,\"alpha\":3.141592653589793" \
  "alpha: $between 3.1415926535897931 [bad-value]"
refused 'one alpha 0' "$atph,\"alpha\":[1,0,1]" \
  "alpha[1]: $between 0 [bad-value]"
for list in '[1,1]' '[1,1,1,1]'; do
  n=$(printf '%s' "$list" | tr -cd 1 | wc -c | tr -d ' ')
  refused "alpha $list" "$atph,\"alpha\":$list" \
    "alpha: must have 3 numbers, one for each segment, found $n [bad-shape]"
done
refused 'alpha of ph' "$points,\"alpha\":1" \
  'alpha: is for "basis":"atph" [bad-value]'
refused 'chordal:x' "$atph,\"alpha\":\"chordal:x\"" \
  "alpha: $kinds \"chordal:x\"; did you mean \"chordal:V\"? [bad-value]"
refused 'chordal:4' "$atph,\"alpha\":\"chordal:4\"" \
  "alpha: $between 4 [bad-value]"
refused 'chordal:0' "$atph,\"alpha\":\"chordal:0\"" \
  "alpha: $between 0 [bad-value]"
refused 'a basis that is none' "$points,\"basis\":\"at\"" \
  'basis: must be "ph" or "atph", found "at" [bad-value]'

# ---- every solution ----------------------------------------------------------

# solutions NAME COUNT PROBLEM
solutions() {
  feed "{$3,\"solutions\":\"all\"}" planar -q
  expect "$1" 0
  json get solutions out | sed 's/},{"good"/}\n{"good"/g; s/^\[//; s/\]$//' \
    >each
  true_that "$1: $2" count "$2" each
  json get good each | grep -c true >good.n
  equal "$1: one is the good one" 1 "$(cat good.n)"
  json get diagnostics.energy each >energies
  sort -g energies >sorted
  # mirror images have the same, but for rounding
  numbers "$1: by energy" 1e-9 sorted energies
  sort -u energies >apart
  true_that "$1: no two alike" count "$2" apart
  equal "$1: the record is the first" \
    "$(get segments) $(get diagnostics.energy)" \
    "$(sed -n 1p each | json get segments) $(sed -n 1p energies)"
}

# No symmetry: mirror images would have the same energy.
odd='"points":[[0,0],[1,1.3],[2.2,0.1],[3,1.1],[4,0.4]]'
solutions 'all, atph, open' 32 "$odd,\"basis\":\"atph\""
equal 'all: the shape of a solution' "good:bool,segments:$segments,length:number" \
  "$(sed -n 1p each | json shape |
    sed 's/^{\(.*\),diagnostics:.*/\1/')"
solutions 'all, ph, open' 32 "$odd"
solutions 'all, atph, closed' 32 "$odd,\"basis\":\"atph\",\"closed\":true"
solutions 'all, ph, closed' 32 "$odd,\"closed\":true"
refused 'all of more than twelve segments' "$many,\"solutions\":\"all\"" \
  'solutions: must be "good" for more than 12 segments, found 13 [bad-value]'
refused 'solutions that are none' "$points,\"solutions\":\"al\"" \
  'solutions: must be "good" or "all", found "al"; did you mean "all"? [bad-value]'

# ---- the fairest curve -------------------------------------------------------

for basis in ph atph; do
  for functional in E MV IES IMV; do
    feed "{$odd,\"basis\":\"$basis\",\"minimize\":\"$functional\"}" planar -q
    name="minimize $functional, $basis"
    expect "$name" 0
    path=diagnostics.$functional
    [ "$functional" = E ] && path=diagnostics.energy
    {
      get diagnostics.functional && echo
      get diagnostics.functional_start && echo
      get $path
    } | holds "$name: less than at the start, and what it is" \
      'n == 3 && x[1] < x[2] && (x[1] - x[3]) ^ 2 < 1e-20 * x[1] ^ 2'
  done
done
feed "{$odd,\"basis\":\"atph\",\"minimize\":\"IES\",\"free\":\"scale\"}" planar
get diagnostics.functional >scale
feed "{$odd,\"basis\":\"atph\",\"minimize\":\"IES\",\"free\":\"each\"}" planar
mv out each
{
  json get diagnostics.functional each
  cat scale
} | holds 'each angle does better than one factor' 'n == 2 && x[1] < x[2]'
feed "{$odd,\"basis\":\"atph\",\"minimize\":\"IES\"}" planar
equal_files 'free is "each" by default' each out
refused 'one factor on the knots of ph' \
  "$points,\"minimize\":\"E\",\"free\":\"scale\"" 'free: must be "each" for '\
'"basis":"ph": the knots of PH quintics have no scale of their own [bad-value]'
refused 'free without minimize' "$atph,\"free\":\"scale\"" \
  'free: is for "minimize" [bad-value]'
refused 'a functional that is none' "$atph,\"minimize\":\"F\"" \
  'minimize: must be "E", "MV", "IES" or "IMV", found "F" [bad-value]'

# ---- Bezier curves -----------------------------------------------------------

feed "{$atph}" planar --convert=bezier --tolerance=1e-7
expect 'convert' 0
equal 'convert: kind, segments' \
  '"bezier" [{interval:[number],control_points:[[number]],length:number}]' \
  "$(get curve) $(shape_of segments)"
get diagnostics.conversion_error |
  holds 'convert: within the tolerance' 'n == 1 && x[1] > 0 && x[1] <= 1e-7'
equal 'convert: the length stays' "$(json get length default)" "$(get length)"

# Each segment: knots and twelve coordinates on a line.
json get segments out | sed 's/},{/}\n{/g' |
  sed 's/"length":[^}]*//; s/"[a-z_]*"//g; s/[^-+0-9.e]/ /g' >pieces
# What has to hold at the ends and at joints, with derivatives by the knots.
cat >joints.awk <<'EOF'
function near(a, b, tol) { if ((a - b) ^ 2 > tol ^ 2) bad = NR }
{
  h = $2 - $1
  for (c = 0; c < 2; c++) {
    r = $(3 + c)
    d = 5 * ($(5 + c) - $(3 + c)) / h
    dd = 20 * ($(7 + c) - 2 * $(5 + c) + $(3 + c)) / h ^ 2
    if (NR > 1) {
      near(r, end[c], 0); near(d, end1[c], 1e-12); near(dd, end2[c], 1e-10)
    } else near(r, 0, 0)
    end[c] = $(13 + c)
    end1[c] = 5 * ($(13 + c) - $(11 + c)) / h
    end2[c] = 20 * ($(13 + c) - 2 * $(11 + c) + $(9 + c)) / h ^ 2
  }
  if (NF != 14) bad = NR
  for (k = 1; k < 3; k++)
    if (end[0] == k && end[1] == k % 2) met++
}
END {
  if (bad || NR < 6 || met != 2 || end[0] != 3 || end[1] != 1) {
    print "line " bad " of " NR ", " met " points"; exit 1
  }
}
EOF
true_that 'convert: through the points, C2 at the joints' \
  awk -f joints.awk pieces
feed "{$points}" planar
mv out ph
feed "{$points}" planar --convert=bezier
equal 'convert: a PH curve is its own' \
  "$(json get segments ph) 0" \
  "$(get segments) $(get diagnostics.conversion_error)"
feed "{$atph}" planar --convert=bezier --tolerance=1e-30
expect 'convert: a tolerance below rounding' 1 "phspline: -:1: record 1: \
tolerance: is 1e-30, and coordinates are rounded by up to 1.07e-14: no \
approximation is known to be nearer [no-convergence]
$(failed 1 1)"
for value in 0 -1 x 1e999 ''; do
  feed "{$atph}" planar --tolerance="$value"
  expect "--tolerance=$value" 2 "phspline: --tolerance must be a number greater \
than 0, found '$value'
Try 'phspline planar --help'." ''
done
feed "{$atph}" planar --convert=spline
expect '--convert=spline' 2 "phspline: --convert must be bezier, found 'spline'
Try 'phspline planar --help'." ''

# ---- offsets -----------------------------------------------------------------

feed "{$atph,\"alpha\":[1,1.5,0.5]}" planar --offset=0.2 --tolerance=1e-6
expect 'an offset' 0
equal 'an offset: its shape' '[{distance:number,degree:number,segments:'\
'[{segment:number,interval:[number],numerator:[[number]],denominator:'\
'[number]}],beziers:[{segment:number,interval:[number],control_points:'\
'[[number]]}],error:number,cusps:[],gaps:[]}]' "$(shape_of offsets)"

# The first Bezier pieces against r + numerator / denominator, r by Simpson's
# rule from the preimage.
{
  floats 'segments[0].alpha'
  floats 'segments[0].preimage'
  floats 'offsets[0].segments[0].numerator'
  floats 'offsets[0].segments[0].denominator'
  for i in 0 1; do
    floats "offsets[0].beziers[$i].interval"
    floats "offsets[0].beziers[$i].control_points"
  done
} >offset
cat >offset.awk <<'EOF'
function s0(t) { return sin((a - t) / 2) / sin(a / 2) }
function s1(t) { return sin(t / 2) / sin(a / 2) }
function w(t, i,   p, q) {
  p = s0(t)
  q = s1(t)
  return x[2 + i] * p ^ 2 + 2 * c * x[4 + i] * p * q + x[6 + i] * q ^ 2
}
function hodograph(t, i) {
  return i ? 2 * w(t, 0) * w(t, 1) : w(t, 0) ^ 2 - w(t, 1) ^ 2
}
function basis(j, t,   n) {
  n = j % 4 == 0 ? 1 : j == 2 ? 4 * c * c + 2 : 4 * c
  return n * s0(t) ^ (4 - j) * s1(t) ^ j
}
function exact(t, i,   sum, h, k, up, down) {
  h = t / 200
  for (k = 0; k <= 200; k++)
    sum += (k % 200 == 0 ? 1 : k % 2 ? 4 : 2) * hodograph(k * h, i)
  for (k = 0; k < 5; k++) {
    up += x[8 + 2 * k + i] * basis(k, t)
    down += x[18 + k] * basis(k, t)
  }
  return sum * h / 3 + up / down
}
function bezier(at, u, i,   k, sum, n) {
  split("1 5 10 10 5 1", n, " ")
  for (k = 0; k < 6; k++)
    sum += n[k + 1] * x[at + 2 * k + i] * u ^ k * (1 - u) ^ (5 - k)
  return sum
}
{ x[NR] = $1 + 0 }
END {
  a = x[1]; c = cos(a / 2)
  for (piece = 0; piece < 2; piece++) {
    at = 23 + 14 * piece
    for (k = 0; k <= 16; k++) {
      t = a * (x[at] + (x[at + 1] - x[at]) * k / 16)
      for (i = 0; i < 2; i++) {
        d = exact(t, i) - bezier(at + 2, k / 16, i)
        if (d * d > worst) worst = d * d
      }
    }
  }
  print NR " numbers, " sqrt(worst)
  exit !(NR == 50 && worst <= 1e-12)
}
EOF
true_that 'an offset: its Bezier curves are near its quotients' \
  awk -f offset.awk offset
get 'offsets[0].error' |
  holds 'an offset: within the tolerance' 'n == 1 && x[1] > 0 && x[1] <= 1e-6'

cusps='the offset at distance 2 has cusps, where the radius of curvature '\
'equals it: 2, the first in segment 1 at 0.665078 of its interval [offset-cusp]'
feed "{$atph}" planar --offset=0.1,2
expect 'an offset with cusps' 0 "phspline: -:1: record 1: warning: $cusps"
equal 'an offset with cusps: the record' '"offset-cusp" 1 absent' \
  "$(get 'warnings[0].code') $(get 'warnings[0].segment') $(
    get 'warnings[1]')"
feed "{$atph}" planar --offset=2 --strict -q
expect 'an offset with cusps, --strict' 1 "phspline: -:1: record 1: $cusps"

# ---- two good curves ---------------------------------------------------------

two='{"points":[[0,1],[6,3],[8,1],[7,2],[3,7]],"basis":"atph"}'
feed "$two" planar
equal 'another good curve' '0 "ambiguous" absent' \
  "$status $(get 'warnings[0].code') $(get 'warnings[0].segment')"
feed "$two" planar --strict -q
equal 'another good curve, --strict' '1 "ambiguous"' "$status $(get error.code)"

# ---- threads -----------------------------------------------------------------

awk 'BEGIN {
  for (i = 0; i < 120; i++) {
    text = ""
    for (k = 0; k < 3 + i % 4; k++)
      text = text (k ? "," : "") "[" k "," (k * k * i + k) % 7 "]"
    more = i % 5 == 1 ? ",\"solutions\":\"all\"" : \
      i % 5 == 2 ? ",\"minimize\":\"IES\"" : i % 5 == 3 ? ",\"alpha\":1.2" : \
      i % 5 == 4 ? ",\"closed\":true" : ""
    print "{\"points\":[" text "],\"basis\":\"atph\"" more "}"
  }
}' >some.jsonl
run planar --jobs=1 --offset=0.1 some.jsonl
mv out out.1
mv err err.1
equal 'many: results' 120 "$(wc -l <out.1 | tr -d ' ')"
run planar --jobs=2 --offset=0.1 some.jsonl
equal_files 'many, on two threads: results' out.1 out
equal_files 'many, on two threads: messages' err.1 err

# ---- rounding ------------------------------------------------------------------

# coordinates that are rounded to 5e-4, of a curve of a million
far='{"points":[[-1336436111841.5156,4648400603669.74],[-1336435613865.7344,
  4648401080405.641],[-1336435123812.1191,4648401455998.396],[-1336434562000.3044,
  4648401882396.039],[-1336435018939.5334,4648402149143.228],[-1336434685425.04,
  4648402480977.326]],"basis":"atph"}'
for option in --convert=bezier '-d 100' '-f svg-path' '-f dxf' '-f geojson'; do
  # shellcheck disable=SC2086 # two words
  feed "$far" planar -q $option
  equal "far from the origin, $option" 0 "$status"
done
for option in '--convert=bezier --tolerance=1e-3' '-d 100 --tolerance=1e-3' \
  '-f svg --tolerance=1e-3' '-f dxf --tolerance=1e-3'; do
  # shellcheck disable=SC2086 # two words
  feed "$far" planar -q $option
  expect "nearer than rounding, $option" 1 'phspline: -:1: record 1: tolerance: is 0.001, and coordinates are rounded by up to 0.0165: no approximation is known to be nearer [no-convergence]'
done
