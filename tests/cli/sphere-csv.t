# SPDX-License-Identifier: GPL-3.0-or-later
#
# Points on a sphere as CSV: longitude and latitude or coordinates, tensions of
# nodes, and the tables that are printed.  (CSV itself: csv.t; samples of other
# curves: sample.t.)
. "$srcdir/tests/cli/lib.sh"

# table NAME TEXT PROBLEM [ARGUMENT...]: CSV, which is for printf, gives the
# curve that the JSON problem gives
table() {
  name=$1 text=$2
  printf '%s\n' "$3" >problem.json
  shift 3
  # shellcheck disable=SC2059
  printf "$text" >table.csv
  run sphere -q -f csv problem.json
  mv out want.csv
  run sphere -q -f csv "$@" table.csv
  expect "$name" 0
  equal_files "$name: the curve" want.csv out
}

# refused NAME STATUS TEXT STDERR: CSV, which is for printf, that cannot be read
refused() {
  # shellcheck disable=SC2059
  printf "$3" >table.csv
  run sphere table.csv
  expect "$1" "$2" "phspline: table.csv:$4
$(failed 1 1)"
}

lonlat='"lonlat":[[0,0],[10,20],[40,30],[60,-10]]'
points='"points":[[1,0,0],[0.6,0.8,0],[0,0.6,0.8],[-0.6,0,0.8]]'

# ---- longitude and latitude --------------------------------------------------

table 'lon, lat' 'lon,lat\n0,0\n10,20\n40,30\n60,-10\n' "{$lonlat}"
table 'lat, lon' 'LAT,Lon\n0,0\n20,10\n30,40\n-10,60\n' "{$lonlat}"
table 'longitude, latitude' \
  'Longitude,latitude\n0,0\n10,20\n40,30\n60,-10\n' "{$lonlat}"
table 'a first line with the names' \
  '# lat, lon\n0,0\n20,10\n30,40\n-10,60\n' "{$lonlat}"
table '--columns=lon,lat' '0,0\n10,20\n40,30\n60,-10\n' "{$lonlat}" \
  --columns=lon,lat
table '--columns=lat,lon, with others' \
  'a,0,0,7\na,20,10,8\na,30,40,\na,-10,60,x\n' "{$lonlat,\"id\":\"a\"}" \
  --columns=id,lat,lon,-
table 'on another sphere' 'lon,lat\n0,0\n10,20\n40,30\n60,-10\n' \
  "{$lonlat,\"radius\":6371,\"center\":[1,2,3]}" --radius=6371 \
  --center='[1,2,3]'
table 'the first point again' \
  'lon,lat\n0,0\n10,20\n40,30\n60,-10\n360,0\n' \
  "{$lonlat,\"closed\":true}" --closed
table 'degrees beyond 180' 'lon,lat\n360,0\n-350,20\n-320,30\n60,-10\n' \
  "{\"lonlat\":[[360,0],[-350,20],[-320,30],[60,-10]]}"

refused 'two columns without names' 3 '0,0\n10,20\n' '1: record 1: the file has '\
'no header row: --columns=lon,lat or --columns=lat,lon must say which of its '\
'2 columns is which [syntax]'
refused 'x, y' 3 'x,y\n0,0\n10,20\n' '1: record 1: column "z" is missing: '\
'sphere needs it for points [missing-field]'
refused 'lon alone' 3 'lon\n0\n10\n' '1: record 1: column "lat" is missing: '\
'sphere needs it for lonlat [missing-field]'
refused 'lon twice' 3 'lon,lat,longitude\n0,0,0\n' '1: record 1: columns 1 and '\
'3 ("longitude") are the same (--columns can skip it) [bad-value]'
refused 'a name that is none' 3 'lon,latt\n0,0\n' '1: record 1: column "latt" '\
'is unknown to sphere; did you mean "lat"? (--ignore-columns skips it) '\
'[unknown-field]'
refused 'both lon, lat and x, y, z' 1 \
  'lon,lat,x,y,z\n0,0,1,0,0\n90,0,0,1,0\n' '2: record 1: lonlat: excludes '\
'points: give one of them [bad-value]'
refused 'an empty cell' 1 'lon,lat\n0,0\n10,\n' '3: record 1: lonlat[1]: needs '\
'a number in column lat, found an empty cell [bad-value]'
refused 'a latitude that is none' 1 '# a\nlon,lat\n0,0\n# b\n10,95\n' '5: '\
'record 1: lonlat[1][1]: must be between -90 and 90 degrees, found 95; '\
'the longitude comes first [bad-value]'
feed 'lon,lat
0,0
' planar
expect 'of planar it is no column' 3 "phspline: -:1: record 1: column \"lon\" \
is unknown to planar, but not to sphere [unknown-field]
$(failed 1 1)"

# ---- coordinates, and numbers of nodes ---------------------------------------

table 'x, y, z' 'z,y_m,X\n0,0,1\n0,0.8,0.6\n0.8,0.6,0\n0.8,0,-0.6\n' \
  "{$points}"
table 'three columns without names' \
  '1,0,0\n0.6,0.8,0\n0,0.6,0.8\n-0.6,0,0.8\n' "{$points}"
table 'columns lon and lat that are empty' \
  'x,y,z,lon,lat\n1,0,0,,\n0.6,0.8,0,,\n0,0.6,0.8,,\n-0.6,0,0.8,,\n' \
  "{$points}"
table 'knots' 'lon,lat,knot\n0,0,-1\n10,20,0\n40,30,2.5\n60,-10,3\n' \
  "{$lonlat,\"knots\":[-1,0,2.5,3]}"
table 'tensions, one for each point' \
  'lon,lat,tension\n0,0,0\n10,20,5\n40,30,2.5\n60,-10,0\n' \
  "{$lonlat,\"shape\":false,\"tension\":[0,5,2.5,0]}" --shape=false
table 'tensions of a closed curve' \
  'tension,lon,lat\n1,0,0\n5,10,20\n2.5,40,30\n3,60,-10\n' \
  "{$lonlat,\"shape\":false,\"closed\":true,\"tension\":[1,5,2.5,3]}" \
  --shape=false --closed
table 'tensions of a closed curve, the first point again' \
  'tension,lon,lat\n1,0,0\n5,10,20\n2.5,40,30\n3,60,-10\n1,0,0\n' \
  "{$lonlat,\"shape\":false,\"closed\":true,\"tension\":[1,5,2.5,3]}" \
  --shape=false --closed
refused 'a tension is missing' 1 'lon,lat,tension\n0,0,\n10,20,5\n40,30,0\n' \
  '2: record 1: tension[0]: needs a number in column tension, found an empty '\
'cell [bad-value]'
table 'options of fields' 'lon,lat\n0,0\n10,20\n40,30\n60,-10\n' \
  "{$lonlat,\"shape\":\"warn\",\"increase\":\"times:2\",\"tension\":1,
  \"criterion\":\"legacy\",\"epsilon\":0.1,\"knots\":\"uniform\",
  \"ends\":\"clamped\",\"end_tangents\":[[0,0,1],[0,0,-1]]}" --shape=warn \
  --increase=times:2 --tension=1 --criterion=legacy --epsilon=.1 \
  --knots=uniform --ends=clamped --end_tangents='[[0,0,1],[0,0,-1]]'

# ---- records -----------------------------------------------------------------

feed "{$lonlat}" sphere -q -n 2
equal 'what a record has' '"sphere" "ok" "spherical-nu" 3 3 false' \
  "$(get command) $(get status) $(get curve) $(get dimension) $(get degree) \
$(get closed)"
equal 'a segment' \
  '[{interval:[number],control_points:[[number]],length:number}]' \
  "$(shape_of segments)"
equal 'the sphere' '[0,0,0] 1' "$(get center) $(get radius)"
floats tensions | holds 'a tension for each point' 'n == 4'
floats indicators | holds 'an indicator for each point' \
  'n == 4 && x[1] == 0 && x[2] == -1 && x[4] == 0'
equal 'a sample' '[{segment:number,t:number,s:number,point:[number],'\
'tangent:[number],curvature:number,lonlat:[number]}]' "$(shape_of samples)"
feed "{$lonlat,\"closed\":true}" sphere -q
floats indicators | holds 'closed: an indicator for each point' 'n == 4'
feed "{$lonlat}" sphere -q --offset=0.125
equal 'an offset' '[{distance:number,length:number,cusps:[],gaps:[],samples:[{'\
'segment:number,t:number,s:number,point:[number],tangent:[number],'\
'curvature:number,lonlat:[number]}]}]' "$(shape_of offsets)"
equal 'an offset: no degree, no segments' '0.125 absent absent' "$(get \
'offsets[0].distance') $(get 'offsets[0].degree') $(get 'offsets[0].segments')"

# ---- tables ------------------------------------------------------------------

# A quarter of the equator of a sphere on which a degree is 1 long.
degrees='"radius":57.29577951308232,"lonlat":[[0,0],[90,0]]'
r=57.29577951308232
h=40.51423422706977
feed "{$degrees,\"id\":\"a\"}" sphere -n 2 -f csv --table=samples
expect 'samples' 0
equal 'samples: columns' \
  'id,segment,t,s,x,y,z,tx,ty,tz,curvature,lon,lat' "$(sed -n 1p out)"
cat >want <<END
id,segment,t,s,x,y,z,tx,ty,tz,curvature,lon,lat
a,0,0,0,$r,0,0,0,1,0,0,0,0
a,0,0.5,45,$h,$h,0,-0.7071067811865476,0.7071067811865476,0,0,45,0
a,0,1,90,0,$r,0,-1,0,0,0,90,0
END
numbers 'samples: a quarter of the equator' 1e-13 want out
# The circle of latitude 10: its points, its curvature tan(10 deg)/r, and its
# length 90 cos(10 deg).
feed "{$degrees,\"id\":\"a\",\"center\":[0,0,1]}" sphere -n 1 -f csv \
  --table=offsets -d 10,-10
expect 'offsets' 0
x=56.42532787936148 z=10.94930770045298 d=-8.949307700452980
k=0.003077486373463237
cat >want <<END
id,distance,segment,t,s,x,y,z,tx,ty,tz,curvature,lon,lat
a,10,0,0,0,$x,0,$z,0,1,0,$k,0,10
a,10,0,1,88.63269777109872,0,$x,$z,-1,0,0,$k,90,10
a,-10,0,0,0,$x,0,$d,0,1,0,-$k,0,-10
a,-10,0,1,88.63269777109872,0,$x,$d,-1,0,0,-$k,90,-10
END
numbers 'offsets: the circles of latitude 10 and -10' 1e-13 want out
feed "{$degrees}" sphere -f csv --table=offsets -d 10
true_that 'offsets without --sample have 17 samples a segment' count 18 out
feed "{$degrees}" sphere -f csv --table=lengths
cat >want <<END
id,segment,t0,t1,length,cumulative
1,0,0,1.5707963267948966,90,90
END
numbers 'lengths' 1e-14 want out
feed "{$degrees}" sphere -f csv
cat >want <<END
id,segment,index,x,y,z
1,0,0,$r,0,0
1,0,1,49.61960058796128,28.64788975654116,0
1,0,2,28.64788975654116,49.61960058796128,0
1,0,3,0,$r,0
END
numbers 'control points: a third of the way each' 1e-13 want out
run sphere -q -f csv --table=samples -n 1 --sweep=model=exact,nielson - <<'END'
{"id":"a","lonlat":[[0,0],[10,20],[20,0]]}
{"id":"bad","lonlat":[[0,0],[180,0]]}
END
equal 'samples: swept, and a problem that fails' \
  '1 id,segment,t,s,x,y,z,tx,ty,tz,curvature,lon,lat,model a 8' "$status \
$(sed -n 1p out) $(sed 1d out | cut -d, -f1 | uniq -c |
    awk '{ print $2, $1 }')"

# ---- rest, cusps -------------------------------------------------------------

# At a rest end there is no curvature, but a tangent.
turn='"lonlat":[[0,0],[10,20],[20,0]],"shape":false'
feed "{$turn,\"ends\":\"rest\"}" sphere -n 1
equal 'a rest end' 'absent true' "$(get 'samples[0].curvature') \
$(get 'samples[0].tangent' | awk -F'[][,]' '{
    print ($2^2 + $3^2 + $4^2 - 1)^2 < 1e-28 ? "true" : "false" }')"
feed "{$turn,\"ends\":\"rest\"}" sphere -n 1 -f csv --table=samples
cut -d, -f11 out | sed 's/^$/none/; s/^-.*/number/' | tr '\n' ' ' >found
equal 'a rest end: its cell is empty' 'curvature none number number none ' \
  "$(cat found)"
# The curve turns right, and so to its right it has an offset with two cusps.
feed "{$turn,\"id\":\"a\"}" sphere --offset=-0.1
expect 'cusps' 0 "phspline: -:1: record a: warning: $(get 'warnings[0].message' |
  tr -d '"') [offset-cusp]"
equal 'cusps: the warning' 'the offset at distance -0.1 has cusps, where the '\
'curve bends as a circle of that radius on the sphere: 2, the first in segment '\
'0 at T of its interval' "$(get 'warnings[0].message' |
  sed 's/"//g; s/ at 0\.[0-9]* of/ at T of/')"
equal 'cusps: where' '[{segment:number,t:number}] 0 1' \
  "$(shape_of 'offsets[0].cusps') $(get 'offsets[0].cusps[0].segment') \
$(get 'offsets[0].cusps[1].segment')"
feed "{$turn}" sphere --offset=0.1 --strict
expect 'none to the left' 0

# ---- usage -------------------------------------------------------------------

run sphere --convert=bezier problem.json
expect '--convert' 2 "phspline: --convert: the curves of sphere are no Bezier \
curves
Try 'phspline sphere --help'."
run sphere -f csv --table=samples problem.json
expect '--table=samples alone' 2 "phspline: --table=samples needs --sample, --spacing, --chord-error or --at
Try 'phspline sphere --help'."
run sphere --shape=wran problem.json
expect '--shape=wran' 2 "phspline: --shape: shape must be true, false or \
\"warn\", found \"wran\"; did you mean \"warn\"?
Try 'phspline sphere --help'."
run sphere --increase=plus problem.json
expect '--increase=plus' 2 "phspline: --increase: increase must be \"minimal\", \
\"plus:V\" or \"times:V\", found \"plus\"; did you mean \"plus:V\"?
Try 'phspline sphere --help'."
