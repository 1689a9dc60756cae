# SPDX-License-Identifier: GPL-3.0-or-later
#
# B-splines: in records, where verify compares them with the curve, and as
# drawings, which another program reads; options that make no sense with them.
. "$srcdir/tests/cli/lib.sh"

python=
for p in python3 /usr/bin/python3; do
  if "$p" -c 'import ezdxf' 2>/dev/null; then
    python=$p
    break
  fi
done
if [ -z "$python" ]; then
  echo 'skip drawings are read elsewhere: no python3 with ezdxf (python3-ezdxf)'
fi

# ---- as they are, to verify and to another program ----------------------------

# same NAME LIMIT JQ COMMAND PROBLEMS ARGUMENT...: JQ is what the records of the
# good ones are to give, with the first line of PROBLEMS.
same() {
  case=$1
  limit=$2
  wanted=$3
  command=$4
  printf '%s\n' "$5" >problems
  shift 5
  "$PHSPLINE" "$command" -q --nurbs --sample=8 "$@" problems >records
  equal "$case" "$wanted" "$(jq -c 'def form: [.degree, .closed,
      (.knots | length), (.control_points | length), (.weights | length)];
    [(.nurbs | map(form)),
     (.offsets // [] | map(.nurbs // (.loops | map(.nurbs[])) | map(form)))]' \
    records | head -n 1)"
  true_that "$case: verify" "$PHSPLINE" verify -q --tolerance=1e-12 records
  [ -z "$python" ] && return
  "$PHSPLINE" "$command" -q -f dxf "$@" problems -o out.dxf
  true_that "$case: elsewhere" "$python" "$srcdir/tests/cli/dxf.py" out.dxf \
    records "$limit"
}

points='"points":[[0,0],[1,2],[3,-1],[4,4],[6,3]]'
plate='{"closed":true,"tolerance":0.01,"curve":[[[0,0],[10,0]],[[10,0],[10,4]],
  [[10,4],[0,4]],[[0,4],[0,0]]]}'
plate=$(printf '%s' "$plate" | tr -d '\n')
space='"points":[[0,0,0],[1,2,1],[3,-1,2],[4,4,0]]'

same 'polynomials' 1e-12 '[[[5,false,27,21,0]],[]]' planar "{$points}"
same 'a closed curve' 1e-12 '[[[5,true,32,26,0]],[]]' \
  planar "{$points,\"closed\":true}"
same 'rational offsets' 1e-12 \
  '[[[5,false,27,21,0]],[[[9,false,47,37,37]],[[9,false,47,37,37]]]]' \
  planar "{\"id\":\"a b\",$points}" --offset=0.1,-0.2
same 'trigonometric curves are quintic' 1e-12 '[[[5,false,127,121,0]],[[[5,false,197,191,0]]]]' planar \
  "{$points,\"basis\":\"atph\"}" --tolerance=1e-6 --offset=0.1
same 'cubics' 1e-12 '[[[3,false,29,25,0]],[[[5,false,47,41,41]]]]' tc "{$points,\"mode\":\"spline\"}" --offset=0.1
same 'offsets with gaps' 1e-12 '[[[3,true,17,13,0]],[[[5,false,12,6,6],[5,false,12,6,6],[5,false,12,6,6],[5,false,12,6,6]],[[5,false,12,6,6],[5,false,12,6,6],[5,false,12,6,6],[5,false,12,6,6]]]]' tc "$plate" --offset=-1,1
same 'joined' 1e-12 '[[[3,true,17,13,0]],[[[5,true,47,41,41]]]]' tc "$plate" --offset=-1 --offset-mode=joined
same 'trimmed' 1e-12 '[[[3,true,17,13,0]],[[[5,true,47,41,41]],[[5,true,27,21,21]]]]' tc "$plate" --offset=-1,1 --offset-mode=trimmed
same 'in space' 1e-12 '[[[5,false,22,16,0]],[[[9,false,38,28,28]],[[9,false,38,28,28]],[[9,false,38,28,28]],[[9,false,38,28,28]]]]' spatial-hermite "{$space}" --offset=0.1
same 'in space, trigonometric' 1e-12 '[[[5,false,107,101,0]],[[[5,false,112,106,0]],[[5,false,117,111,0]],[[5,false,132,126,0]],[[5,false,117,111,0]]]]' spatial-hermite \
  "{$space,\"basis\":\"atph\"}" --offset=0.1 --tolerance=1e-6
same 'lengths' 1e-12 '[[[5,false,37,31,0]],[]]' arclength "{$space,\"lengths\":[3,4,7]}"
same 'on a sphere' 1e-12 '[[[3,false,194,190,0]],[[[3,false,203,199,0]]]]' sphere \
  '{"lonlat":[[0,0],[40,10],[80,-20],[120,50]],"radius":2}' \
  --offset=0.1 --tolerance=1e-6
same 'closed on a sphere' 1e-12 '[[[3,true,188,184,0]],[]]' sphere \
  '{"lonlat":[[0,0],[40,10],[80,-20],[20,-50]],"closed":true}' \
  --tolerance=1e-6

# ---- what is refused ------------------------------------------------------------

# refused NAME MESSAGE ARGUMENT...
refused() {
  name=$1
  message=$2
  shift 2
  feed "{$points}" planar "$@"
  expect "$name" 2 "phspline: $message
Try 'phspline planar --help'." ''
}

refused 'samples of a drawing' "--format=dxf has no samples; it is of exact \
curves, or within --tolerance" -f dxf --sample=4
refused 'nurbs in a table' '--nurbs needs --format=json' -f csv --nurbs
refused 'both at once' '--nurbs needs --format=json' -f dxf --nurbs
refused 'of Bezier curves' "B-splines are of the curve as it was found; \
--convert does nothing there" --nurbs --convert=bezier
feed '{"points":[[0,0,0],[1,0,0]],"faces":[]}' bubble -f dxf
expect 'of patches' 2 "phspline: --format=dxf is of curves, bubble makes surfaces
Try 'phspline bubble --help'." ''
refused 'a unit of what has none' '--unit needs --format=svg or --format=dxf' \
  --unit=mm
refused 'an unknown unit' "--unit must be mm|cm|m|in, found 'ft'" -f svg \
  --unit=ft

# ---- flat patterns: the outline that svg-path has, and lines to bend along ----------

lamp=$srcdir/data/lampshade.csv
run cone --closed --height='[0,18]' --offset=1 -f dxf --unit=in "$lamp" -o flat.dxf
equal 'layers and unit' '70:1 LINE:ruling:46 SPLINE:curve:1 SPLINE:offset:1' "$(
  paste -d ' ' - - <flat.dxf | awk '
    $1 == 9 { header = $2 }
    $1 == 70 && header == "$INSUNITS" { unit = $2; header = "" }
    $1 == 0 { type = $2 }
    $1 == 8 && (type == "LINE" || type == "SPLINE") { n[type ":" $2]++ }
    END { printf "70:%s", unit
      for (i = split("LINE:ruling SPLINE:curve SPLINE:offset", k); i > 0; i--)
        text = " " k[i] ":" n[k[i]] text
      print text }')"
run cone --closed --height='[0,18]' -f svg-path "$lamp"
sed 's/Z.*//' out | tr -s 'MC ' '[\n*]' | sed '/^$/d' | tr , ' ' >wanted
run cone --closed --height='[0,18]' -f dxf "$lamp"
true_that 'no unit where none is given' test -z "$(grep INSUNITS out)"
paste -d ' ' - - <out | awk '$1 == 0 { type = $2 } type == "SPLINE" && $1 == 10 {
  x = $2 } type == "SPLINE" && $1 == 20 { print x, $2 }' >found
numbers 'the outline' 0 wanted found
if [ -n "$python" ]; then
  equal 'another program finds no fault' '[] [] 1 True' "$("$python" -c '
import ezdxf
d = ezdxf.readfile("flat.dxf")
a = d.audit()
print(a.errors, a.fixes, d.units, d.modelspace()[0].closed)')"
fi

near='{"points":[[0,0,0.004],[0,0,0]],"basis":"atph","alpha":[2],"knots":'
near="${near}[-1.79057151528321,-1.7905715152832045]}"
for option in --nurbs --convert=bezier; do
  feed "$near" spatial-hermite -q "$option"
  equal "pieces between knots that are all but one: $option" \
    '1 no-convergence' "$status $(jq -r .error.code out)"
done

# ---- streams ----------------------------------------------------------------------

printf '%s\n' "{\"id\":\"first\",$points}" '{"points":[[0,0]]}' \
  '{"id":"third\tand\nmore","points":[[0,0],[1,1],[2,0]]}' >problems
"$PHSPLINE" planar -f dxf -j 2 problems >out.dxf 2>err
equal 'a failure is told, the others are drawn' '1 2' "$? \
$(grep -c '^SPLINE$' out.dxf)"
equal 'handles differ' '' "$(awk 'NR % 2 { c = $0 + 0 }
  NR % 2 == 0 && (c == 5 || c == 105)' out.dxf | sort | uniq -d)"
true_that 'a label is one line' grep -q '^third and more$' out.dxf

printf '%s\n' "{$points}" "{$points}" >problems
"$PHSPLINE" planar -f dxf -S 'points[1][1]=2:3:3' problems >out.dxf
equal 'handles of a sweep differ' '6' "$(awk 'c == "SPLINE" { getline; print }
  { c = $0 }' out.dxf | sort -u | wc -l | tr -d ' ')"
