# SPDX-License-Identifier: GPL-3.0-or-later
#
# The examples and figures of [BYR11, ch. 4-5], as an independent program has
# found them with 40 digits.
#
# A problem of tests/vectors/tc.jsonl brings what is known about it in `meta',
# which comes back with its result:
#   kind        what is asked for: `one' cubic with given tangents, a `pair'
#               with given derivatives, two whose joint is on the `chord', or at
#               the `edge' of the angles that are possible there, to tolerance
#   tolerance   relative; of a pair: to the chord, energies and curvatures may
#               differ by 100 times that
#   count       of solutions, of which without_loop, with_loop
#   solutions   all of them, best first
#   admissible  whether there is one at this joint_angle
. "$srcdir/tests/cli/lib.sh"

cat >judge-tc.awk <<'EOF'
# The value of a member of an object: a number, a word or a list.
function member(text, name,   at) {
  at = index(text, "\"" name "\":")
  if (!at) return "absent"
  text = substr(text, at + length(name) + 3)
  match(text, /^\[[^]\[]*\]|^[^],}]*/)
  return substr(text, 1, RLENGTH)
}
function size(x, y) {
  return sqrt(x * x + y * y)
}
# The segments: points[k, 1] to points[k, 8], w[k, 1] to w[k, 4]; returns how
# many.
function read_segments(text,   k, c, p, at) {
  for (k = 0; match(text, /"interval":[^}]*"length"/); k++) {
    at = substr(text, RSTART, RLENGTH)
    text = substr(text, RSTART + RLENGTH)
    gsub(/"[a-z_]*"/, "", at)
    if (numbers(at, p) != 14) return -1
    for (c = 1; c <= 8; c++) points[k, c] = p[2 + c]
    for (c = 1; c <= 4; c++) w[k, c] = p[10 + c]
  }
  return k
}
# The angle that cubic k turns by, from its preimages; has_loop: whether it has
# one.
function turning(k,   a, b, r, q) {
  a = w[k, 1] ^ 2 + w[k, 2] ^ 2
  b = w[k, 3] ^ 2 + w[k, 4] ^ 2
  r = w[k, 1] * w[k, 3] + w[k, 2] * w[k, 4]
  q = w[k, 1] * w[k, 4] - w[k, 2] * w[k, 3]
  has_loop = r < 0 && sqrt(3) * size(q, 0) <= (a < b ? a : b) - r
  return 2 * atan2(q, r)
}
function leg(i) {
  return size(points[0, i + 2] - points[0, i],
    points[0, i + 3] - points[0, i + 1])
}
function word(what, found, value) {
  if (found != value) wanted(what, found, value)
}
# One cubic of g1.
function judge_one(known, found,   tol) {
  tol = $6
  word("cubics", read_segments($14), 1)
  near("|D|", size(member(found, "D"), 0), member(known, "D_abs"), tol)
  near("first leg", leg(1), member(known, "d01"), tol)
  near("last leg", leg(5), member(known, "d23"), tol)
  near("length", $12, member(known, "length"), tol)
  near("turning", turning(0), member(known, "turning"), tol)
  word("the loop of its preimage", has_loop, member(known, "loop") == "true")
  word("loops", member(found, "loops"), has_loop)
  near("energy", member(found, "energy"), member(known, "energy"), tol)
  near("max_curvature", member(found, "max_curvature"),
    member(known, "max_abs_curvature"), tol)
  near("rotation_index", 8 * atan2(1, 1) * member(found, "rotation_index"),
    member(known, "turning"), tol)
}
# One pair of c1.
function judge_pair(known, found,   tol, chord, joint, turned, loops, k, n) {
  tol = $6
  word("cubics", read_segments($14), 2)
  chord = size(points[1, 7] - points[0, 1], points[1, 8] - points[0, 2])
  numbers(member(known, "joint"), joint)
  numbers(member(known, "turning"), turned)
  split(member(known, "loops"), loops, /[],\[]/)
  for (k = 0; k < 2; k++) {
    close_to("joint[" k "]", points[0, 7 + k], joint[k + 1], tol * chord)
    word("where it goes on", points[1, 1 + k], points[0, 7 + k])
    near("turning of cubic " k, turning(k), turned[k + 1], tol)
    word("the loop of cubic " k, has_loop, loops[k + 2] == "true")
    n += has_loop
  }
  word("loops", member(found, "loops"), n)
  close_to("length", $12, member(known, "length"), tol * chord)
  word("regular", member(found, "regular"), member(known, "regular"))
  word("simple", member(found, "simple"), member(known, "simple"))
  word("standard", member(found, "root") == "\"++\"",
    member(known, "standard") == "true")
  near("energy", member(found, "energy"), member(known, "energy"), 100 * tol)
  near("max_curvature", member(found, "max_curvature"),
    member(known, "max_abs_curvature"), 100 * tol)
}
function judge_solution(known, found) {
  if (($1 < $7) != (known != "absent") ||
      (known == "absent") != (found == "absent"))
    wanted("solution " $1, found, known)
  else if (known != "absent" && $5 == "\"one\"") judge_one(known, found)
  else if (known != "absent") judge_pair(known, found)
}
# Next to the edge a curve is so large that its certificate may refuse it.
function judge_outcome(solved) {
  if ($5 == "\"edge\"" && solved && $4 == "\"no-convergence\"") return
  word("status", $3, solved ? "\"ok\"" : "\"error\"")
  word("code", $4, solved ? "absent" : "\"infeasible\"")
}
BEGIN { FS = "\t" }
{
  why = $2 in first ? first[$2] : ""
  if ($10 == "absent") {
    judge_outcome($7 > 0)
    if ($8 != "absent") {
      word("count", $7, $8 + $9)
      loops[$2] += member($13, "loops") == 1
      if ($1 == 4) word("solutions with a loop", loops[$2], $9)
    }
    judge_solution($11, $13)
  } else judge_outcome($10 == "true")
  first[$2] = why
  if (!$1) {
    order[++n] = $2
    kinds[$5]++
  }
}
END {
  for (i = 1; i <= n; i++) {
    why = first[order[i]]
    gsub(/"/, "", order[i])
    print (why == "" ? "ok " : "not ok ") order[i] (why == "" ? "" : ": " why)
  }
  found = kinds["\"one\""] " " kinds["\"pair\""] " " kinds["\"chord\""] " " \
    kinds["\"edge\""]
  print (found == "15 5 10 8" ? "ok" : "not ok") " 15 problems of one cubic, " \
    "5 of a pair, 10 with joints on the chord and 8 on the edge: " found
}
EOF

run tc -q "$srcdir/tests/vectors/tc.jsonl"
equal 'some of them have no solution' 1 "$status"
# of every solution that there could be a row, and one that there is not
for i in 0 1 2 3 4; do
  table id status error.code meta.kind meta.tolerance meta.count \
    meta.without_loop meta.with_loop meta.admissible "meta.solutions[$i]" \
    "solutions[$i].length" "solutions[$i].diagnostics" \
    "solutions[$i].segments" | sed "s/^/$i	/"
done >rows
awk -f "$srcdir/tests/cli/judge.awk" -f judge-tc.awk rows ||
  fail 'the judge' "status $?"

# ---- the best one ------------------------------------------------------------

# Asked for alone it is the same.
table id meta.kind solutions[0].segments solutions[0].length >want
run tc -q --override=solutions=best "$srcdir/tests/vectors/tc.jsonl"
table id meta.kind segments length >found
awk -F '	' '$3 != "absent"' want >want.solved
awk -F '	' '$3 != "absent" && $2 ~ /one|pair/' found >found.solved
true_that 'the best one: of 14' count 14 want.solved
equal_files 'the best one is the first of all' want.solved found.solved
