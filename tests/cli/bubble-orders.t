# SPDX-License-Identifier: GPL-3.0-or-later
#
# `bubble': how fast surfaces come near to a sphere, an ellipsoid and a torus
# when meshes of them, with their normals, become finer: largest distances of
# samples of the exact surfaces, and the orders from one mesh to the next.  The
# manual has the table (phspline-papers, BUBBLE), of which PH_LONG=1 takes all, and
# others the coarser meshes; the coarsest where every step takes long (PH_SHORT=1).
#
# shellcheck disable=SC2154,SC2016  # what lib.sh sets; programs of jq
. "$srcdir/tests/cli/lib.sh"

# mesh SURFACE N: of the torus 2 N by N faces; else those of a cube, N by N at
# equal angles
mesh() {
  jq -nc --arg s "$1" --argjson n "$2" '
  (4 * (1 | atan)) as $pi |
  def unit: (map(. * .) | add | sqrt) as $l | map(. / $l);
  if $s == "torus" then
    {points: [range(2*$n) as $i | range($n) as $j | ($i*$pi/$n) as $a | (2*$j*$pi/$n) as $b |
       [(3+($b|cos))*($a|cos), (3+($b|cos))*($a|sin), ($b|sin)]],
     normals: [range(2*$n) as $i | range($n) as $j | ($i*$pi/$n) as $a | (2*$j*$pi/$n) as $b |
       [($b|cos)*($a|cos), ($b|cos)*($a|sin), ($b|sin)]],
     faces: [range(2*$n) as $i | range($n) as $j | ((($i+1)%(2*$n))*$n) as $k | (($j+1)%$n) as $l |
       [$i*$n+$j, $k+$j, $k+$l, $i*$n+$l]]}
  else
    # faces of a cube, each n by n at equal angles; points are found by their place on the cube
    [range(6) as $f | range($n) as $i | range($n) as $j | [[$i,$j],[$i+1,$j],[$i+1,$j+1],[$i,$j+1]] |
      map(if $f < 2 then [.[0],.[1],$f*$n] elif $f < 4 then [.[1],($f-2)*$n,.[0]] else [($f-4)*$n,.[0],.[1]] end)] as $q |
    ([$q[][]] | unique) as $p | ($p | to_entries | map({key: (.value|tostring), value: .key}) | from_entries) as $at |
    ($p | map(map((. * 2 / $n - 1) * $pi / 4 | tan) | unit)) as $u |
    (if $s == "sphere" then [1,1,1] else [3,2,1] end) as $x |
    {points: ($u | map([., $x] | transpose | map(.[0]*.[1]))), normals: ($u | map([., $x] | transpose | map(.[0]/.[1]))),
     faces: ($q | map(map($at[tostring])))}
  end'
}
# distance SURFACE: the largest, of samples; of the ellipsoid the first order of it
distance() {
  jq -r --arg s "$1" '
   [.samples[].point | if $s == "torus" then
     (((.[0]*.[0]+.[1]*.[1]) | sqrt) - 3) as $r | ($r*$r + .[2]*.[2] | sqrt) - 1
     else (if $s == "sphere" then [1,1,1] else [3,2,1] end) as $x | ([., $x] | transpose) |
       ((map(.[0]/.[1] | . * .) | add) - 1) / 2 / (map(.[0]/.[1]/.[1] | . * .) | add | sqrt) end | fabs] | max'
}

sizes='8 16'
[ "${PH_LONG-}" != 1 ] || sizes='8 16 32'
[ "${PH_SHORT-}" != 1 ] || sizes=8
for surface in sphere ellipsoid torus; do
  for n in $sizes; do
    m=$n
    test $surface = torus || m=$((n / 2))
    mesh $surface "$m" >"$n.json"
  done
  for continuity in 0 1 2; do
    for n in $sizes; do
      "$PHSPLINE" bubble -q --degree=exact --continuity=$continuity --sample=4 \
        "$n.json" | distance $surface
    done | awk -v s=$surface -v c="$continuity" '{ e[NR] = $1 } END {
      printf "%s %d", s, c
      for (i = 1; i <= NR; i++) printf " %.2g", e[i]
      for (i = 2; i <= NR; i++) printf " %.1f", log(e[i - 1] / e[i]) / log(2)
      print "" }'
  done
done >found
cat >known <<'END'
sphere 0 0.037 0.0095 0.0024 2.0 2.0
sphere 1 3.1e-05 5.4e-07 8.7e-09 5.8 6.0
sphere 2 3.8e-08 4.5e-11 4.5e-14 9.7 9.9
ellipsoid 0 0.095 0.027 0.0071 1.8 1.9
ellipsoid 1 0.003 0.00042 4.6e-05 2.9 3.2
ellipsoid 2 0.0075 0.001 0.00011 2.8 3.3
torus 0 0.14 0.038 0.0096 1.9 2.0
torus 1 0.0028 0.00022 1.5e-05 3.7 3.9
torus 2 0.0057 0.00058 5.7e-05 3.3 3.3
END
# of sizes that were not measured the columns are left out, and the finest sphere
# of degree 2 is rounding
awk -v n="$(echo "$sizes" | wc -w)" '{
  if ($1 $2 == "sphere2") $5 = $7 = "rounding"
  line = $1 " " $2
  for (i = 3; i < 3 + n; i++) line = line " " $i
  for (i = 6; i < 5 + n; i++) line = line " " $i
  print line }' known >wanted
awk '$1 $2 == "sphere2" && NF == 7 { $5 = $7 = "rounding" } { print }' found \
  >found.table
equal_files 'the table' wanted found.table
if [ "${PH_LONG-}" = 1 ]; then
  true_that 'the finest sphere: to rounding' awk '/^sphere 2/ { exit $5 > 1e-13 }' \
    found
fi
