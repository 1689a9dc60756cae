# SPDX-License-Identifier: GPL-3.0-or-later
#
# Tables 4.1 and 4.2 of [GON18], as an independent program has found them.
#
# A problem of tests/vectors/cone.jsonl brings what is known about it in `meta':
# `error', or `length', `development_angle' and, of each of its `pairs', what is
# read below, in that order.
. "$srcdir/tests/cli/lib.sh"

lines=$(wc -l <"$srcdir/tests/vectors/cone.jsonl")
line=0
while [ "$line" -lt "$lines" ]; do
  line=$((line + 1))
  sed -n "${line}p" "$srcdir/tests/vectors/cone.jsonl" >problem.json
  run cone -q problem.json
  id=$(get id)
  if [ "$(json get meta.error problem.json)" = true ]; then
    equal "$id: as printed" '1 "bad-value"' "$status $(get error.code)"
    continue
  fi
  expect "$id" 0
  jq -c '.meta | .pairs[], .length, .development_angle' problem.json >known
  jq -c '. as $r | (range(.pairs | length) | $r.strips[2 * .] as $a |
      $r.strips[2 * . + 1] as $b | $r.pairs[.] |
      [.center, .radius, .lambda, $a.frame.point, $b.frame.point, $a.vertex,
        $b.vertex, (($a, $b) | .contact.weights[1]),
        (($a, $b) | .geodesic_curvature), (($a, $b) | .half_angle),
        (($a, $b) | .sweep), (($a, $b) | .length),
        (($a, $b) | .development_angle), $b.contact.control_points[2]]),
    .length, ([.strips[].development_angle] | add)' out >found
  numbers "$id: pairs, length, angle" 1e-9 known found
  true_that "$id: frames" jq -e '.diagnostics.frame_error < 1e-10' out
  "$PHSPLINE" verify --problems=problem.json out >verdict
  equal "$id: verified" '"ok"' "$(json get status verdict)"
done
