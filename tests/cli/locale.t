# SPDX-License-Identifier: GPL-3.0-or-later
#
# Numbers: read to the nearest double, written with the fewest digits that read
# back to it, the same in every locale.
. "$srcdir/tests/cli/lib.sh"

# ---- digits ------------------------------------------------------------------

# The first point of a curve is that of the problem, to the last bit.
while read -r number written; do
  printf '{"points":[[%s,1],[0,2]]}\n' "$number" >&3
  printf '[%s,1]\n' "$written" >&4
done 3>in 4>want <<'END'
0 0
-0 -0
-0.0 -0
0e99 0
-0E-99 -0
1 1
-1.0 -1
100 100
1e2 100
1E+2 100
12.50 12.5
0.1 0.1
0.30000000000000004 0.30000000000000004
0.1000000000000000055511151231257827021181583404541015625 0.1
0.000001 0.000001
1e-6 0.000001
0.0000001 1e-7
1.5e-7 1.5e-7
123456789.125 123456789.125
9007199254740993 9007199254740992
9007199254740993.0000000000000000000000000000001 9007199254740994
123456789012345680000 123456789012345680000
999999999999999900000 999999999999999900000
1e21 1e21
1234567890123456789012345 1.2345678901234568e24
1e22 1e22
1e23 1e23
8.98e300 8.98e300
1e307 1e307
2.2250738585072014e-308 2.2250738585072014e-308
2.225073858507201e-308 2.225073858507201e-308
1.5e-320 1.5e-320
5e-324 5e-324
4.9e-324 5e-324
3e-324 5e-324
2e-324 0
-1e-400 -0
END
run planar <in
expect 'numbers of all sizes' 0
json get 'segments[0].control_points[0]' out >found
equal_files 'numbers keep their digits and lose superfluous ones' want found

# What was written is read and written again: nothing changes any more.
json get 'segments[0].control_points[0]' out |
  sed 's/.*/{"points":[&,[0,2]]}/' >in
mv out before
run planar <in
equal_files 'numbers are the same the second time' before out
sed 's/{"points":\[\[\(.*\),1\],\[0,2\]\]}/\1,1\n0,2\n/' in >in.csv
run planar in.csv
equal_files 'numbers are the same in CSV' before out

# The largest double may be written, but no curve reaches it.
feed '{"points":[[0,0],[1,1]],"knots":[-1.7976931348623157e308,0]}' planar
equal 'the largest double' '0 [-1.7976931348623157e308,0]' \
  "$status $(get 'segments[0].interval')"
feed '{"points":[[0,0],[1,1]],"knots":[-1.7976931348623159e308,0]}' planar
equal 'the next number is none' '1 "not-finite"' "$status $(get error.code)"

# ---- locales -----------------------------------------------------------------

# Those of this machine that write 1,5; one is made where there is none.
commas() {
  for name in $(locale -a 2>/dev/null); do
    if [ "$(LC_ALL=$name locale decimal_point 2>/dev/null)" = , ]; then
      echo "$name"
    fi
  done
}

name=$(commas | sed -n 1p)
if [ -z "$name" ]; then
  mkdir locales
  localedef -f UTF-8 -i de_DE locales/de_DE.UTF-8 >cmd.out 2>&1
  LOCPATH=$PWD/locales
  export LOCPATH
  name=de_DE.UTF-8
fi
if [ "$(LC_ALL=$name locale decimal_point 2>/dev/null)" != , ]; then
  echo "skip numbers with a comma: no such locale, and none could be made"
fi

printf '%s\n' "$good" "$bad" '{"points":[[0,0],[1,0],[0,0]]}' \
  '{"points":[[0.5,0],[1.25,1e-9],[2,0]],"knots":[0,0.5,1.5]}' \
  '{"points":[[0,0],[1,1,1]]}' '{"points":[[0,0],[1,5' >in.json
printf 'x,y\n0.5,0\n1.25,.5\n+2.,0\n' >in.csv
printf '%s\n' '{"points":[[0,0.5,1.5],[1.25,1e-9,0],[2,0,1]],' \
  '"tension":0.75,"tangents":[[0.5,0,1],[1,1.5,0],[0,0,0.25]]}' \
  '{"points":[[0,0,0],[1,1,1]],"tension":-0.5}' >space.json
printf 'x,y,z,dx,dy,dz\n0.5,0,1,1,1,0.5\n1.25,.5,+2.,1,0,1.5\n' >space.csv
for arguments in 'planar in.json' 'planar in.csv' 'planar -f csv in.json' \
  'planar -d 0.5,-.25 -S points[0][0]=0.25:0.75:3 in.json' \
  'planar --set=knots=[0,0.5,2.5] in.csv' 'planar --jobs=1.5 in.json' \
  'planar --help' 'spatial-hermite space.json' 'spatial-hermite space.csv' \
  'spatial-hermite -f csv --angles=[0.5,1.5] space.json' \
  'spatial-hermite --basis=atph --alpha=0.5 --criterion=F1 space.csv'; do
  # shellcheck disable=SC2086
  run $arguments
  mv out out.c
  mv err err.c
  status_c=$status
  for variable in LC_ALL LC_NUMERIC LANG; do
    status=0
    # shellcheck disable=SC2086
    env LC_ALL= "$variable=$name" "$PHSPLINE" $arguments >out 2>err ||
      status=$?
    equal "$variable=$name, $arguments: status" "$status_c" "$status"
    equal_files "$variable=$name, $arguments: results" out.c out
    equal_files "$variable=$name, $arguments: messages" err.c err
  done
done
