# SPDX-License-Identifier: GPL-3.0-or-later
#
# Jobs from the file that there is to the file that the next program wants, as
# phspline-examples(7) has them: what comes out is read by other programs.
. "$srcdir/tests/cli/lib.sh"

data=$srcdir/data
# python MODULE...: one that has these modules, in $python
python() {
  for python in python3 /usr/bin/python3 ''; do
    if [ -n "$python" ] && (for m; do "$python" -c "import $m" || exit 1; done) \
      >python.out 2>&1; then
      return
    fi
  done
  echo "ok without $* # SKIP"
  return 1
}

# ---- a GPX track to equally spaced GeoJSON --------------------------------------

run sphere --radius=6371000 --spacing=100 --format=geojson "$data/walk.gpx"
cp out walk.geojson
if command -v ogr2ogr >/dev/null; then
  ogr2ogr -f CSV walk.csv walk.geojson -lco GEOMETRY=AS_WKT 2>ogr.err
  # chords of great circles, by the haversine
  sed -n 's/^"LINESTRING (\([^)]*\)).*/\1/p' walk.csv | tr ',' '\n' |
    awk '{ d = atan2(0, -1) / 180; x = $1 * d; y = $2 * d
      if (NR > 1) {
        h = sin((y - b) / 2) ^ 2 + cos(y) * cos(b) * sin((x - a) / 2) ^ 2
        s[NR] = 2 * 6371000 * atan2(sqrt(h), sqrt(1 - h)) }
      a = x; b = y }
      END { for (i = 2; i < NR; i++) if (!(s[i] > 97 && s[i] <= 100)) bad = 1
        print NR, bad + 0 }' >found
  equal 'GDAL finds points 100 m apart' '14 0' "$(cat found)"
else
  echo 'ok without ogr2ogr # SKIP'
fi

# ---- an SVG drawing to trimmed offsets in DXF -----------------------------------

run tc --tolerance=0.01 --offset=3 --offset-mode=trimmed "$data/bracket.svg"
jq -c '.length, .offsets[0].length' out >wanted
"$PHSPLINE" tc --tolerance=0.01 --offset=3 --offset-mode=trimmed --format=dxf \
  "$data/bracket.svg" -o bracket.dxf
if python ezdxf; then
  "$python" - >found <<'END'
import ezdxf
for e in ezdxf.readfile("bracket.dxf").modelspace():
    assert e.dxftype() == "SPLINE"
    p = [v for v in e.construction_tool().approximate(20000)]
    assert max(v.y for v in p) < 0  # the drawing is upright: y was downward
    print(sum(a.distance(b) for a, b in zip(p, p[1:])))
END
  numbers 'ezdxf finds the lengths of curves and offsets' 1e-5 wanted found
fi

# ---- 200 files to one table; pandas and numpy in and out --------------------------

i=0
while [ $((i += 1)) -le 200 ]; do
  printf '0,0\n2,%s\n5,0\n' $i >part$i.csv
done
run planar --sweep=knots=chordal,uniform --table=lengths --with-file part*.csv
cp out lengths.csv
equal 'a sweep over 200 files' '801 200' \
  "$(wc -l <out) $(cut -d, -f8 out | sed 1d | sort -u | wc -l)"
# the lengths of the control points by quadrature, which is not ours
if python numpy; then
  run planar --sweep=knots=chordal,uniform --table=control-points --with-file \
    part*.csv
  cp out points.csv
  "$python" - >found <<'END'
import csv, numpy
v = {}
for r in csv.DictReader(open("points.csv")):
    key = r["file"], r["knots"], r["segment"]
    v.setdefault(key, []).append([float(r["x"]), float(r["y"])])
x, w = numpy.polynomial.legendre.leggauss(20)
t = (x[:, None] + 1) / 2
worst = n = 0
for r in csv.DictReader(open("lengths.csv")):
    p = numpy.array(v[r["file"], r["knots"], r["segment"]])
    d = [5 * c * t ** i * (1 - t) ** (4 - i) * q for i, (c, q) in
         enumerate(zip((1, 4, 6, 4, 1), numpy.diff(p, axis=0)))]
    length = (w * numpy.hypot(*sum(d).T)).sum() / 2
    worst = max(worst, abs(length / float(r["length"]) - 1))
    n += 1
print(n, worst < 1e-12)
END
  equal 'numpy finds the lengths' '800 True' "$(cat found)"
fi
# what DataFrame.to_csv writes has its index in a column without a name
if python numpy; then
  "$python" - >found <<'END'
import csv, numpy
a = numpy.linspace(0, 2 * numpy.pi, 41)
xy = numpy.column_stack([numpy.cos(a), numpy.sin(a)])
numpy.savetxt("circle.txt", xy)
try:
    import pandas
    f = pandas.DataFrame({"when": a, "east": xy[:, 0], "north": xy[:, 1]})
    f.to_csv("frame.csv")
except ImportError:
    with open("frame.csv", "w", newline="") as f:
        w = csv.writer(f, lineterminator="\n")
        w.writerow(["", "when", "east", "north"])
        w.writerows([i, t, p[0], p[1]] for i, (t, p) in enumerate(zip(a, xy)))
END
  run planar --spacing=0.1 --table=samples --format=text circle.txt
  cp out numpy.txt
  run planar --spacing=0.1 --table=samples --columns=x=east,y=north frame.csv
  cp out pandas.csv
  "$python" - >found <<'END'
import numpy
a = numpy.loadtxt("numpy.txt")
b = numpy.genfromtxt("pandas.csv", delimiter=",", names=True)
assert (a[:, 4] == b["x"]).all() and (a[:, 5] == b["y"]).all()
assert abs(numpy.hypot(b["x"], b["y"]) - 1).max() < 1e-4
print(b["s"][-1])
END
  awk 'BEGIN { printf "%.17g\n", 2 * atan2(0, -1) }' >wanted
  numbers 'numpy and pandas, in and out' 1e-5 wanted found
fi

# ---- a ribbon's shape, and a flight route -----------------------------------------

run arclength --spacing=1 --table=samples "$data/huard-2014-morphosense.csv"
cp out ribbon.csv
if python numpy; then
  "$python" - >found <<'END'
import numpy
t = numpy.genfromtxt("ribbon.csv", delimiter=",", names=True)
p = numpy.column_stack([t["x"], t["y"], t["z"]])
d = numpy.linalg.norm(numpy.diff(p, axis=0), axis=1)
assert (abs(d[:-1] - 1) < 1e-4).all()
print(t["s"][-1])
END
  echo 1185.59 >wanted
  numbers 'the shape of a ribbon, a point every mm' 1e-5 wanted found
fi
printf 'lon,lat\n13.4,52.5\n-21.9,64.1\n-73.8,40.6\n' >route.csv
run sphere --radius=6371 --spacing=100 -q --table=samples route.csv
cp out waypoints.csv
if python numpy; then
  "$python" - >found <<'END'
import numpy
t = numpy.genfromtxt("waypoints.csv", delimiter=",", names=True)
x, y = numpy.radians(t["lon"]), numpy.radians(t["lat"])
p = numpy.column_stack([numpy.cos(y) * numpy.cos(x), numpy.cos(y) * numpy.sin(x),
                        numpy.sin(y)])
d = 6371 * numpy.arccos(numpy.clip((p[1:] * p[:-1]).sum(axis=1), -1, 1))
assert (d[:-1] <= 100 + 1e-6).all() and (d[:-1] > 99.5).all()
print(len(t))
END
  echo 68 >wanted
  numbers 'a flight route, a waypoint every 100 km' 0 wanted found
fi
