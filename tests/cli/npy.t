# SPDX-License-Identifier: GPL-3.0-or-later
#
# --format=npy: tables that numpy.load reads, with the numbers of the CSV ones.
. "$srcdir/tests/cli/lib.sh"

plane='{"points":[[0,0],[1,2],[3,0],[4,1]]}'
space='{"points":[[0,0,0],[1,2,1],[3,0,0],[4,1,2]]}'
printf '%s\n' "$plane" '{"points":[[0,0]]}' "$plane" >plane.jsonl
printf '%s\n' "$space" "$space" >space.jsonl
echo x,y >empty.csv

# same ROWS COMMAND FILE TABLE [OPTION...]
same() {
  name="$2 $4" rows=$1 command=$2 file=$3 table=$4
  shift 4
  run "$command" -q --table="$table" "$@" "$file"
  mv out want.csv
  csv=$status
  run "$command" -q --format=npy --table="$table" -o found.npy "$@" "$file"
  equal "$name: status" "$csv" "$status"
  equal "$name: rows" "$rows" \
    "$("$python" "$srcdir/tests/cli/npy.py" found.npy want.csv 2>&1)"
}

python=
for p in python3 /usr/bin/python3; do
  [ -z "$python" ] && "$p" -c 'import numpy' 2>/dev/null && python=$p
done
if [ "$python" ]; then
  same 36 planar plane.jsonl control-points
  same 6 planar plane.jsonl lengths
  same 24 planar plane.jsonl samples --sample=3
  same 72 planar plane.jsonl samples --sample=3 -d 0.1,0.2
  same 120 planar plane.jsonl offsets -d 0.1,0.2
  same 36 spatial-hermite space.jsonl control-points
  same 24 spatial-hermite space.jsonl samples --sample=3 --frame=rmf
  same 240 spatial-hermite space.jsonl offsets -d 0.1
  same 0 planar empty.csv lengths
else
  printf 'SKIP  %s\n' 'arrays: no NumPy'
fi

run planar -f npy plane.jsonl
expect 'no file' 2 "phspline: --format=npy needs --output
Try 'phspline planar --help'." ''
run planar -f npy -o /dev/null plane.jsonl
expect 'no regular file' 4 \
  'phspline: cannot write /dev/null as npy: it is no regular file' ''
run planar -f npy --shard=0/2 -o x.npy plane.jsonl
equal 'no part' 2 "$status"
equal 'rows begin at a multiple of 64' 0 \
  "$(run planar -q -f npy --table=lengths -o x.npy plane.jsonl
    echo $((($(wc -c <x.npy) - 6 * 6 * 8) % 64)))"

