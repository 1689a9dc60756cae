# SPDX-License-Identifier: GPL-3.0-or-later
#
# Surfaces over the meshes of [BYR11, chapter 6], as an independent program has
# found them: area, volume and the middles of patches of the quotients, of
# continuity 0, 1 and 2.
#
# A problem of tests/vectors/bubble.jsonl brings in `meta' what is known about
# it.  Patches are polynomials, whose normals here jump by 1e-9 at most.
. "$srcdir/tests/cli/lib.sh"

lines=$(wc -l <"$srcdir/tests/vectors/bubble.jsonl")
line=0
while [ "$line" -lt "$lines" ]; do
  line=$((line + 1))
  sed -n "${line}p" "$srcdir/tests/vectors/bubble.jsonl" >problem.json
  run bubble --tolerance=1e-9 problem.json
  id=$(get id)
  expect "$id" 0
  jq -c '.meta | .area, (.volume // empty), .patch_centres' problem.json >known
  # a middle by the basis at 1/2, from the square of control points
  jq -c 'def choose(n; k): reduce range(k) as $i (1; . * (n - $i) / ($i + 1));
    def middle: (.bidegree[0]) as $n | .control_points as $p |
      [range($n + 1) | choose($n; .) / pow(2; $n)] as $b |
      [range(3) as $k | reduce range($p | length) as $i (0;
        . + $b[$i % ($n + 1)] * $b[$i / ($n + 1) | floor] * $p[$i][$k])];
    .area, (.volume // empty), [.patches[:24][] | middle]' out >found
  numbers "$id: area, volume, middles" 1e-8 known found
  true_that "$id: nothing is folded, normals fit" jq -e '.diagnostics |
    .folded == 0 and .interpolation_error < 1e-15 and
    .continuity_error < 1e-14' out
  run bubble --degree=exact --sample=2 problem.json
  jq -c '.area, (.volume // empty), [.patches[].face as $i |
    .samples[9 * $i + 4].point][:24]' out >found
  numbers "$id: exact area, volume, middles" 1e-8 known found
  "$PHSPLINE" verify --problems=problem.json out >verdict
  equal "$id: verified" '"ok"' "$(json get status verdict)"
done
