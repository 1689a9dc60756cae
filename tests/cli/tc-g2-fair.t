# SPDX-License-Identifier: GPL-3.0-or-later
#
# Cubics with continuous curvature through hostile points: tc --mode=g2 solves
# all, no energy times length is more than a tenth above that of the mode spline,
# and the curvature jumps where it says alone.  Families of hostile.py, 20 sets
# of each in a trial; FAMILIES names them, TRIALS says how many trials, 1 if it
# does not: phspline-tc(1) was measured with 10, of convex and mixed with 500.
# Where every step takes long (PH_SHORT=1), convex and mixed alone.
# shellcheck disable=SC2016  # programs of awk
. "$srcdir/tests/cli/lib.sh"
python=/usr/bin/python3
hostile=$srcdir/tests/cli/hostile.py

if ! "$python" -c '' 2>/dev/null; then
  echo 'skip: no python3'
  exit 0
fi

[ "${PH_SHORT-}" != 1 ] || FAMILIES=${FAMILIES:-convex mixed}

# judged NAME SEED: what hostile.py says of 20 sets
judged() {
  "$python" "$hostile" "$1" 20 "$2" >in
  run tc -q --mode=g2 in
  mv out g2
  run tc -q --mode=spline in
  "$python" "$hostile" judge g2 out
  if [ "$2" = 1 ]; then # the table of the manual
    mv out spline
    run planar -q in
    "$python" "$hostile" table "$1" g2 spline out >>all.table
  fi
}

for name in ${FAMILIES:-$("$python" "$hostile" names) convex mixed}; do
  seed=0
  while [ "$seed" -lt "${TRIALS:-1}" ]; do
    seed=$((seed + 1))
    judged "$name" "$seed"
  done | awk '{
    solved += $1; failed += $2; logs += $1 * log($3); worse += $4
    jump = jump < $5 ? $5 : jump; pairs += $6
  } END {
    printf "%d %d %.3g %d %.1e %d\n", solved, failed, exp(logs / solved),
      worse, jump, pairs
  }' >all
  echo "# $name: solved, failed, mean, worse, jump, pairs: $(cat all)"
  true_that "$name are solved, and fair" \
    awk '{ exit !($2 == 0 && $4 == 0 && $5 < 1e-9) }' all
done

if [ -z "${FAMILIES-}" ]; then
  sed -n '/Pa tests.cli.tc.-g2.-fair.t/,/^\.Ed/p' "$srcdir/man/phspline-tc.1" |
    grep '^[a-z_]*  *[0-9]* ' | sed 's/\\-/-/g' | awk '{ $1 = ""; print }' >wanted
  awk '{ $1 = ""; print }' all.table >found
  equal 'families in the table' "$(wc -l <wanted)" "$(wc -l <all.table)"
  numbers 'the table of the manual' 0.06 wanted found
fi

# ---- tracks ---------------------------------------------------------------------

"$python" "$hostile" track 40 40 >in
run tc -q in
"$python" "$hostile" jump out >all
echo "# tracks, jump: $(cat all)"
true_that 'the curvature of 40 tracks is continuous' \
  awk '{ exit !($1 == 40 && $2 <= 1e-10) }' all
equal 'but at inflections' 'inflection' \
  "$(jq -r '.joints[].kind' out | sort -u)"
