# SPDX-License-Identifier: GPL-3.0-or-later
#
# Data of `tc' at the edge of what makes sense: lines, tangents along the chord
# and back, few points, nearly coincident ones, circles, extreme sizes.
. "$srcdir/tests/cli/lib.sh"

# solved NAME MEMBERS [ARGUMENT...]: the record is left in out
solved() {
  title=$1 members=$2
  shift 2
  feed "{$members}" tc "$@"
  expect "$title" 0
}

# is PATH VALUE [TOLERANCE]: one number of the last record
is() {
  get "$1" | holds "$title: $1" \
    "n == 1 && (x[1] - ($2))^2 <= (${3-1e-14})^2"
}

# simple: without a loop or a crossing, regular
simple() {
  equal "$title: it is simple" 'true true 0' "$(get diagnostics.regular) \
$(get diagnostics.simple) $(get diagnostics.loops)"
}

pi=3.141592653589793

# ---- along the chord, and back -----------------------------------------------

chord='"points":[[0,0],[2,0]]'
for mode in g1 g1-auto g1-fair g1-pair; do
  solved "straight on, $mode" "$chord,\"tangents\":[[3,0],[0.5,0]]" \
    --mode=$mode
  is length 2
  is diagnostics.energy 0 0
  is diagnostics.max_curvature 0 0
  simple
done
# one tangent back or both; the mirror image would do as well
for mode in g1-auto g1-fair g1-pair; do
  for tangents in '[[1,0],[-1,0]]' '[[-1,0],[1,0]]' '[[-1,0],[-1,0]]'; do
    solved "$tangents, $mode" "$chord,\"tangents\":$tangents" --mode=$mode
    equal "$tangents, $mode: two cubics" '[0,1]' \
      "$(get 'intervals[0].segments')"
    simple
  done
done
: >lengths
for sign in '' -; do
  for near in 0 1e-15 1e-13; do
    solved "back, off by $sign$near" \
      "$chord,\"tangents\":[[-1,$sign$near],[-1,$near]],\"mode\":\"g1-pair\""
    simple
    get length >>lengths
    echo >>lengths
  done
done
holds 'back, hardly off: the length does not leap' \
  'n == 6 && x[1] > 4 && (x[2] / x[1] - 1)^2 < 1e-12 &&
    (x[3] / x[1] - 1)^2 < 1e-12 && (x[5] / x[1] - 1)^2 < 1e-12 &&
    (x[6] / x[1] - 1)^2 < 1e-12' <lengths
solved 'derivatives back' \
  "$chord,\"derivatives\":[[-2,0],[-2,0]],\"solutions\":\"all\""
simple
is length '14 / 3'
equal 'derivatives back: four pairs, two of them mirror images' \
  "$(get 'solutions[0].length')" "$(get 'solutions[1].length')"
solved 'derivatives along the chord' "$chord,\"derivatives\":[[1,0],[2,0]]"
is length 2
is diagnostics.energy 0 0
# w0^2 + w2^2 = 3: two of the four pairs have a cusp where they meet
solved 'two of four with a cusp' \
  "$chord,\"derivatives\":[[3,2],[3,-2]],\"solutions\":\"all\"" -q
equal 'two of four with a cusp: these are last' 'true true false false' \
  "$(for i in 0 1 2 3; do get "solutions[$i].diagnostics.regular"; echo; done |
    tr '\n' ' ' | sed 's/ $//')"
equal 'two of four with a cusp: their energy is not known' 'absent absent' \
  "$(get 'solutions[2].diagnostics.energy') \
$(get 'solutions[3].diagnostics.energy')"

# ---- few points, a closed triangle -------------------------------------------

solved 'two points' '"points":[[1,1],[4,5]]'
is length 5
solved 'two points, ends of a circle' '"points":[[1,1],[4,5]],"ends":"circle"'
is length 5
solved 'two points, end tangents' \
  '"points":[[0,0],[4,0]],"end_tangents":[[0,1],[0,-1]],"mode":"spline"'
is diagnostics.rotation_index -0.5
simple
triangle='"points":[[0,0],[2,0],[1,1.7320508075688772]],"closed":true,
"mode":"spline"'
solved 'a closed triangle' "$triangle"
is diagnostics.rotation_index 1
simple
get intervals | grep -o '"length":[-0-9.e]*' | sed 's/.*://' |
  holds 'a closed triangle: three equal lengths' \
    'n == 3 && (x[1] - x[2])^2 < 1e-28 && (x[1] - x[3])^2 < 1e-28'
solved 'a figure of eight' '"points":[[0,0],[1,1],[2,0],[1,-1],[0,0],[-1,1],
  [-2,0],[-1,-1]],"closed":true,"mode":"spline"'
equal 'a figure of eight: it crosses itself' 'false 0' \
  "$(get diagnostics.simple) $(get diagnostics.loops)"
solved 'nearly back' '"points":[[0,0],[2,0],[0,1e-9]],"mode":"spline"'
simple
solved 'a point again' '"points":[[0,0],[1,1],[2,0],[2,2],[1,1],[0,3]],"mode":"spline"'

# ---- nearly coincident -------------------------------------------------------

for gap in 1e-6 1e-9 1e-11; do
  solved "the first two $gap apart" "\"points\":[[0,0],[$gap,0],[1,0],[2,1]],\"mode\":\"spline\""
  is length "2.5" 0.1
done
for gap in 1e-6 1e-12 1e-100; do
  solved "tangents, $gap apart" \
    "\"points\":[[0,0],[$gap,0],[1,0]],\"tangents\":[[1,1],[1,-1],[1,1]]"
done
solved 'hardly apart, far away' \
  '"points":[[1000000,0],[1000000.000000001,0],[1000001,0]],
  "mode":"spline"'
is length 1 1e-9

# ---- circles -----------------------------------------------------------------

# of N points the error of the length falls by 2^4 for each doubling of N
for given in points tangents; do
  for n in 8 16 32; do
    data=$(awk -v n=$n -v pi=$pi -v given=$given 'BEGIN {
      for (i = 0; i < n; i++) {
        c = cos(2 * pi * i / n)
        s = sin(2 * pi * i / n)
        p = p (i ? "," : "") sprintf("[%.17g,%.17g]", 3 * c, 3 * s)
        t = t (i ? "," : "") sprintf("[%.17g,%.17g]", -s, c)
      }
      print "\"points\":[" p "]"
      if (given == "tangents") print ",\"tangents\":[" t "]" }')
    solved "a circle by $n $given" "$data,\"closed\":true"
    is diagnostics.rotation_index 1
    simple
    is diagnostics.max_curvature '1 / 3' "4 / $n ^ 2"
    get length >>"circle.$given"
    echo >>"circle.$given"
  done
  awk -v pi=$pi '{ e = $1 / (6 * pi) - 1; print (e < 0 ? -e : e) }' \
    "circle.$given" >errors
  holds "circles by $given: fourth order" \
    'n == 3 && x[1] < 1e-2 && x[2] < x[1] / 12 && x[3] < x[2] / 12' <errors
done

# ---- sizes -------------------------------------------------------------------

# The same points, times a power of two: the same curve, times that, exactly.
scale='BEGIN { half = int(p / 2); a = 2^half; b = 2^(p - half) }'
printf '0 0 1 1\n3 1 1 -2\n4 -2 -1 -1\n-1 -3 -1 2\n' >unit
# vectors POWER FIRST: two columns as an array
vectors() {
  awk -v p="$1" -v c="$2" "$scale"'{ printf "%s[%.17g,%.17g]",
    (NR > 1 ? "," : ""), $c * a * b, $(c + 1) * a * b }' unit
}
# lengths of the curve and its control points, times a power
shape() {
  {
    get segments | grep -o '"control_points":[^p]*p' | tr -d '"a-df-z_:[]' |
      tr ',' '\n'
    get length
    echo
  } | awk -v p="$1" "$scale"'NF { printf "%.17g\n", $1 * a * b }'
}
for power in 0 -996 30 996; do
  for rest in ',"mode":"spline"' ',"closed":true,"mode":"spline"' \
    ",\"tangents\":[$(vectors 0 3)]" \
    ",\"derivatives\":[$(vectors $power 3)]"; do
    name=$(printf %s "$rest" | cut -c 3-9)
    [ "$name" = 'mode":"' ] && name=
    solved "size 2^$power ${name:-spline}" \
      "\"points\":[$(vectors $power 1)]$rest"
    simple_here=$(get diagnostics.simple)
    shape $((-power)) >"shape.${name:-spline}"
    if [ "$power" -eq 0 ]; then
      mv "shape.${name:-spline}" "want.${name:-spline}"
      echo "$simple_here" >"simple.${name:-spline}"
    else
      numbers "$title: the same curve" 0 "want.${name:-spline}" \
        "shape.${name:-spline}"
      equal "$title: simple or not" "$(cat "simple.${name:-spline}")" \
        "$simple_here"
    fi
  done
done
for size in 1e-150 1e150; do
  solved "size $size" "\"points\":[[0,0],[3$(printf %s $size | cut -c 2-),0],
    [3$(printf %s $size | cut -c 2-),4$(printf %s $size | cut -c 2-)]]"
  get length | holds "size $size: the length" \
    "n == 1 && x[1] / $size > 7 && x[1] / $size < 9"
done
solved 'far from the origin' \
  '"points":[[1000000,1000000],[1000003,1000001],[1000004,999998]]'
get length >found
solved 'at the origin' '"points":[[0,0],[3,1],[4,-2]]'
get length >want
numbers 'far from the origin: the same length' 0 want found
solved 'far from the origin, approximated' \
  '"curve":[[1000000,1000000],[1000003,1000001],[1000004,999998]]' \
  --tolerance=1e-6

# ---- a cubic that nearly stops at its end -----------------------------------------

# the curvature there is 2 |K| / |w|^4 of the preimage of the record itself, with
# K the product of its two ends: not of their difference, which is rounded
feed '{"points":[[221983.57209401947,-118641.4233935893],[221984.13398301948,'\
'-118640.5961805893],[221984.1357690195,-118640.5956825893],[221984.1375550194'\
'6,-118640.5961805893],[221984.69944401947,-118641.4233935893]],"closed":true,'\
'"tangents":[[0.5618888326497443,0.8272127536151191],[0.5628776841389546,0.826'\
'5402063410873],[1,-1.602754474774733e-14],[0.5628776841191286,-0.826540206354'\
'5889],[0.5643941241399999,-0.8255054649342075]],"mode":"g1-pair",'\
'"joint":"chord"}' tc -q
{
  floats 'segments[0].preimage'
  get diagnostics.max_curvature
} | holds 'a cubic that nearly stops: its curvature' \
  '(2 * (x[1] * x[4] - x[2] * x[3]) / (x[3]^2 + x[4]^2)^2 / x[5] - 1)^2 < 1e-18'

# ---- an offset a hundred million times as far as the curve is long -----------------

# where the curve is at rest its offset is at the distance in any direction, to a
# few roundings of the distance
accepted tc 'a far offset of a curve that begins at rest' --offset=0.52 <<'EOF'
{"points":[[2.216923256e-8,1.3841316186243e-8],[2.525986972e-8,
1.7326515945e-8]],"tangents":[[0.8,0.6],[0.663485766,0.748188906]],"mode":"g1"}
EOF
sed 's/"control_points":\[\[-0.31199997783076[0-9]*,/"control_points":\[\[-0.31199997783077,/' \
  any.result >bad
run verify -q bad
equal 'that offset, nearer by 1e-14' \
  '1 "offsets[0].segments[0].control_points"' "$status $(get error.field)"
