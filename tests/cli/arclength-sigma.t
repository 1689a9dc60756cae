# SPDX-License-Identifier: GPL-3.0-or-later
#
# Directions that were measured: tangent_sigma of arclength, what is told of
# them, and what is not allowed.
. "$srcdir/tests/cli/lib.sh"

# Sensors on a ribbon (Huard et al. 2014, section 5.3), and a wave in the plane.
sensors='[0.3862,-0.0315,0.9219],[0.3775,-0.1613,0.9118],'\
'[0.4077,-0.1947,0.8921],[0.4444,-0.3071,0.8415],[0.3224,-0.4485,0.8336],'\
'[0.3913,-0.4889,0.7797],[0.2771,-0.5945,0.7548],[0.171,-0.7053,0.688]'
lengths='[170.05,169.5,168.26,169.33,169.53,168.82,170.1]'
ribbon="\"tangents\":[$sensors],\"lengths\":$lengths"
wave='"tangents":[[1,0.1],[1,0.3],[1,-0.1],[1,-0.4],[1,-0.2]],"lengths":2'

# solve PROBLEM [ARGUMENT...]: its members, without warnings
solve() {
  text="{$1}"
  shift
  feed "$text" arclength -q "$@"
}

# each N PATH: a number for each i < N in place of @
each() {
  i=0
  while [ $i -lt "$1" ]; do
    get "$(printf %s "$2" | sed "s/@/$i/")"
    echo
    i=$((i + 1))
  done
}

# f_of PROBLEM: F alone
f_of() {
  solve "$@"
  get diagnostics.F
  echo
}

for data in "$ribbon" "$wave"; do
  for refine in 1 2 3; do
    name="refine $refine, $(printf %.14s "$data" | tr -dc '0-9.-')"
    more="$data,\"refine\":$refine"
    solve "$more,\"tangent_sigma\":0.05"
    expect "$name: solved" 0
    {
      get diagnostics.tangent_rms
      echo
      get diagnostics.kkt_error
      echo
    } | holds "$name: by a standard deviation, and stationary" \
      'x[1] > 0.9 && x[1] < 1.1 && x[2] < 1e-6'
    equal "$name: a minimum" '"minimiser"' "$(get diagnostics.second_order)"
    mv out result
    printf '{%s,"tangent_sigma":0.05}\n' "$more" >problem
    run verify --problems=problem result
    expect "$name: verified" 0
    {
      f_of "$more"
      f_of "$more,\"tangent_sigma\":1e-7"
      f_of "$more,\"tangent_sigma\":0.01"
      f_of "$more,\"tangent_sigma\":0.05"
      f_of "$more,\"tangent_sigma\":10"
    } | holds "$name: from the exact curve to a straight one" \
      'x[2] < x[1] * (1 + 1e-9) && x[2] > x[1] * (1 - 1e-4) && x[3] < x[2] &&
       x[4] < x[3] && x[5] < 1e-6 * x[1]'
  done
done

# What is told is seen in the control points.
solve "$ribbon,\"tangent_sigma\":0.03"
cp out result
printf '{%s,"tangent_sigma":0.03}\n' "$ribbon" >problem
each 8 'tangent_deviations[@]' >angles
holds 'as many angles as tangents' 'n == 8 && x[8] > 0' <angles
for change in 's/"tangent_deviations":\[0\./&1/' 's/"tangent_rms":/&1/'; do
  sed "$change" result >false
  run verify --problems=problem false
  equal "a false claim, $change" 1 "$status"
done

# Turned, reversed, at another size: the same curve.
get_f() {
  f_of "$1,\"tangent_sigma\":0.03" >found
  holds "the same: $2" "x[1] > $3 * (1 - 1e-6) && x[1] < $3 * (1 + 1e-6)" <found
}
f=$(json get diagnostics.F result)
turned=$(printf '[%s]' "$sensors" | sed 's/\[\([^][,]*\),\([^,]*\),\([^],]*\)\]/[\2,\3,\1]/g')
get_f "\"tangents\":$turned,\"lengths\":$lengths" turned "$f"
cp result out
each 8 'tangent_deviations[@]' | sed '1!G;h;$!d' >angles
back=$(printf '[%s]' "$sensors" | sed 's/\],\[/\n/g; s/[][]//g' |
  sed '1!G;h;$!d' |
  awk -F, '{ printf "%s[%s,%s,%s]", (NR > 1 ? "," : ""), -$1, -$2, -$3 }')
gnol=$(printf %s "$lengths" | tr -d '[]' | tr , '\n' | sed '1!G;h;$!d' |
  tr '\n' , | sed 's/,$//')
get_f "\"tangents\":[$back],\"lengths\":[$gnol]" reversed "$f"
each 8 'tangent_deviations[@]' >back
numbers 'reversed: the angles, too' 1e-6 angles back
large=$(printf %s "$lengths" | tr -d '[]' | tr , '\n' |
  awk '{ printf "%s%.17g", (NR > 1 ? "," : ""), $1 * 1024 }')
get_f "\"tangents\":[$sensors],\"lengths\":[$large]" large \
  "$(awk "BEGIN { printf \"%.17g\", $f * 1024 }")"

# One for each: those of 0 are exact.
solve "$wave,\"tangent_sigma\":[0,0.1,0,0.1,0]"
expect 'one for each' 0
each 5 'tangent_deviations[@]' | holds 'one for each: 0 is exact' \
  'x[1] < 1e-11 && x[3] < 1e-11 && x[5] < 1e-11 && x[2] > 0.01 && x[4] > 0.01'
solve "$wave,\"tangent_sigma\":[0,0,0,0,0]"
equal 'all are exact' '0 absent' "$status $(get tangent_deviations)"

# With lengths that were measured, too.
solve "$ribbon,\"tangent_sigma\":0.02,\"length_sigma\":0.001"
expect 'with lengths' 0
{
  get diagnostics.tangent_rms
  echo
  get diagnostics.length_rms
  echo
} | holds 'with lengths: together' \
  '8 * x[1] ^ 2 + 7 * x[2] ^ 2 > 14.5 && 8 * x[1] ^ 2 + 7 * x[2] ^ 2 < 15.5'

# ---- no minimum, but a curve all the same ------------------------------------

# Turns of up to 2.8 between chords of 0.006 and 0.8, lengths 1 % above them:
# multipliers are as large as the proof of a minimum had not expected.
feed '{"points":[[0,0,0],[0.0801,0.1275,0.1084],[-0.4455,0.3567,0.7001],
[-0.4433,0.3508,0.6997],[-0.447,0.3603,0.7054],[-0.4411,0.3531,0.7138],
[-0.3981,-0.2152,0.7287]],"lengths":[0.18738,0.83316,0.00635,0.01183,0.01266,
0.58025],"length_sigma":0.01}' arclength
equal 'a steep minimum' '0 "minimiser" "minimiser"' \
  "$status $(get diagnostics.second_order) $(get 'diagnostics.starts[0].outcome')"
equal 'a steep minimum: nothing to tell' 0 "$(grep -c saddle err)"
mv out r
run verify r
expect 'a steep minimum: verified' 0

# Chords of 0.0001 and 0.6.
feed '{"points":[[0,0,0],[-6e-5,-0.00012,6e-5],[0.00017,-0.00108,-0.00046],
[0.0352,-0.46453,-0.37925],[0.0353,-0.4646,-0.37921],[-0.03818,-0.4984,-0.54992],
[-0.04879,-0.55662,-0.4747],[-0.04843,-0.55778,-0.47557]],"lengths":[0.000145,
0.001129,0.610882,0.000131,0.190791,0.096629,0.001522],"length_sigma":0.01}' \
  arclength
equal 'the same at near-cusps' '0 "minimiser"' \
  "$status $(get diagnostics.second_order)"
equal 'the same at near-cusps: nothing to tell' 0 "$(grep -c saddle err)"
mv out r
run verify r
expect 'the same at near-cusps: verified' 0

# Where every start creeps, whole steps lead on.
feed '{"points":[[0,0,0],[0.0058,0.004,-0.0039],[-0.0033,0.012,-0.0018],
[-0.0055,0.0076,-0.0028],[-0.011,0.011,0.0093],[0.1877,0.3286,-0.0331],
[-0.3404,0.8937,0.3554],[-0.3419,0.8803,0.3549]],"lengths":[0.0081,0.0125,0.0051,
0.0138,0.3825,0.8722,0.0136],"length_sigma":0.01}' arclength
equal 'starts that creep' 0 "$status"
mv out r
run verify r
expect 'starts that creep: verified' 0

# ---- what is not allowed -----------------------------------------------------

# bad CODE FIELD MESSAGE PROBLEM
bad() {
  feed "{$4}" arclength
  equal "$2 $3" "1 phspline: -:1: record 1: $2: $3 [$1]
$(failed 1 1)" "$status $(cat err)"
}

bad bad-value tangent_sigma 'needs tangents: points have none' \
  '"points":[[0,0,0],[1,0,0]],"lengths":2,"tangent_sigma":0.1'
bad bad-value tangent_sigma 'needs magnitudes free' \
  "$wave,\"magnitudes\":\"mean\",\"tangent_sigma\":0.1"
bad bad-value tangent_sigma 'must be 0 or between 1e-09 and 10, found -1' \
  "$wave,\"tangent_sigma\":-1"
bad bad-value 'tangent_sigma[2]' 'must be 0 or between 1e-09 and 10, found 11' \
  "$wave,\"tangent_sigma\":[0,1,11,1,1]"
bad bad-shape tangent_sigma 'must have 5 numbers, one for each tangent, found 2' \
  "$wave,\"tangent_sigma\":[1,1]"
bad bad-type tangent_sigma \
  'must be a number or an array of numbers, found a string' \
  "$wave,\"tangent_sigma\":\"1\""
bad bad-value length_sigma 'needs a tangent_sigma above 0: exact tangents '\
'contradict no lengths' "$wave,\"tangent_sigma\":0,\"length_sigma\":0.1"
