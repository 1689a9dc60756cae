# SPDX-License-Identifier: GPL-3.0-or-later
#
# Parts of the input, --shard and --range: the outputs and messages of all parts
# one after another are those of one part, byte for byte.  (How files are cut:
# tests/unit/io/t_split_cut.c.)
. "$srcdir/tests/cli/lib.sh"

# 240 curves, of which one in six fails, in one of several ways.
awk 'BEGIN {
  for (i = 1; i <= 240; i++) {
    kind = i % 6 ? 0 : int(i / 6) % 5 + 1
    points = "\"points\":[[0,0],[1," i "],[2,0],[3,1]]"
    if (kind == 1) points = "\"points\":[[0,0],[0,0]]"
    if (kind == 2) points = "\"points\":[[0,0],"
    if (kind == 3) points = "\"points\":[[0,0]]}"
    if (kind == 4) points = "\"closd\":true"
    if (kind == 5) points = "\"points\":[[0,0],[1,1e999]]"
    print "{" (i % 2 ? "\"id\":\"n" i "\"," : "") points "}"
  }
}' >all.jsonl
awk 'BEGIN {
  print "id,x,y"
  for (i = 1; i <= 240; i++) {
    kind = i % 6 ? 0 : int(i / 6) % 4 + 1
    id = i % 4 ? "n" i : ""
    if (id == "") print ""
    if (kind == 1) print id ",0,0\n" id ",0,0"
    else if (kind == 2) print id ",0,zero\n" id ",1,1"
    else if (kind == 3) print id ",0,0\n" id ",1,1\n\"" id ",2,0"
    else if (kind == 4) print id ",0"
    else print id ",0,0\n# " i "\n\"" id "\",1," i "\n" id ",2,0"
  }
}' >all.csv

# parts NAME N ARGUMENT...: as one
parts() {
  name=$1 n=$2
  shift 2
  run planar --shard=0/1 "$@"
  equal "$name: status" 1 "$status"
  mv out one.out
  grep -v 'records failed$' err >one.err
  : >all.out
  : >all.err
  k=0
  while [ $k -lt "$n" ]; do
    run planar --shard=$k/"$n" -o part.out "$@"
    [ "$status" -le 1 ] || fail "$name: part $k" "status $status"
    cat part.out >>all.out
    grep -v 'records failed$' err >>all.err
    k=$((k + 1))
  done
  equal_files "$name, $n parts: results" one.out all.out
  equal_files "$name, $n parts: messages" one.err all.err
}

for n in 2 3 7 31; do
  one_in 3 || continue
  parts 'JSON to JSON' "$n" all.jsonl
  parts 'CSV to JSON' "$n" all.csv
done
# ... and of CSV the ten rows with an open quote stand alone
equal "a record for each" 250 "$(wc -l <one.out | tr -d " ")"
equal 'each in six fails' 40 "$(grep -c '"status":"error"' one.out)"
true_that 'none has a line' sh -c '! grep -q "\"line\"" one.out'
equal 'a failure has its byte' "$(grep -c '"status":"error"' one.out)" \
  "$(grep -c '"byte":' one.out)"
for table in 'csv --table=lengths' 'text --table=samples --sample=2' svg-path; do
  # shellcheck disable=SC2086  # options
  parts "$table" 5 -f $table all.jsonl all.csv
done
equal 'a table has one header' 1 \
  "$(run planar --shard=0/1 --table=lengths all.csv; grep -c '^id,' out)"
parts 'several jobs and a sweep' 3 -j 4 -S knots=uniform,chordal all.jsonl

# Names: what has an id by it, else by @BYTE, which is where it begins.
run planar --table=lengths --shard=0/1 -q all.jsonl
sed -n 's/^@\([0-9]*\),0,.*/\1/p' out >bytes
true_that 'rows without an id' test -s bytes
equal 'begin where their names say' "$(wc -l <bytes)" "$(while read -r byte; do
  tail -c +$((byte + 1)) all.jsonl | head -c 10
  echo
done <bytes | grep -c '^{"points":$')"

# The message.
printf '%s\n' "$good" '{"id":7,"points":[[0,0]]}' '{"points":[[0,' >three.jsonl
run planar --range=1: three.jsonl
first=$((${#good} + 1))
expect 'messages' 1 "phspline: three.jsonl: byte $first: record 7: points: \
must be at least 2, found 1 [too-few-points]
phspline: three.jsonl: byte $((first + 26)): the text ends inside an array \
[syntax]
$(failed 2 2)"
equal 'error records' "$first $((first + 26))" \
  "$(sed 's/.*"byte":\([0-9]*\).*/\1/' out | tr '\n' ' ' | sed 's/ $//')"

# --range: the same by bytes.
run planar --range=0:1 three.jsonl
equal "records of a range" 1 "$(wc -l <out | tr -d " ")"
run planar --range=1: -q three.jsonl
equal "records of a range" 2 "$(wc -l <out | tr -d " ")"
run planar --range=1:$((first + 1)) -q three.jsonl
equal "records of a range" 1 "$(wc -l <out | tr -d " ")"
run planar --range=1:1 three.jsonl
expect 'an empty range' 0 '' ''
run planar --range=999999: three.jsonl
expect 'a range behind the end' 0 '' ''

# Standard input where it is a file; results.
run planar --shard=0/1 -q <three.jsonl
equal 'standard input' 3 "$(wc -l <out | tr -d ' ')"
run planar -q all.jsonl
grep '"status":"ok"' out >results.jsonl
run verify --shard=0/1 results.jsonl
mv out one.out
run verify --shard=0/2 results.jsonl
mv out all.out
run verify --shard=1/2 results.jsonl
cat out >>all.out
equal_files 'results are verified in parts' one.out all.out

# What cannot be.
run planar --shard=0/2 </dev/null
expect 'no regular file' 3 'phspline: --shard needs regular files: standard input is not one' ''
echo 'old' >keep
run planar --shard=0/2 -o keep none.jsonl
expect 'no file' 3 'phspline: cannot open none.jsonl: No such file or directory' ''
equal 'the output is kept' old "$(cat keep)"
echo "[$good]" >array.json
run planar --shard=1/2 array.json
expect 'an array' 3 'phspline: cannot cut array.json: it is an array; --shard and --range are of JSON Lines' ''
