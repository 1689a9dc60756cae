# SPDX-License-Identifier: GPL-3.0-or-later
#
# How fair planar curves are, as their records say: at every size of the data.
. "$srcdir/tests/cli/lib.sh"

# sizes FIELDS: one problem of every size; the first, in the middle of the range
sizes() {
  for e in 0 -300 -130 -108 -105 -100 100 105 108 130 300; do
    echo "{\"points\":[[0,0],[1e$e,1e$e],[2e$e,0],[3e$e,1e$e]],$1}"
  done
}

# same PATH TOLERANCE: of all records, like that of the first
same() {
  floats "$1" | awk -v tolerance="$2" 'NR == 1 { one = $1 + 0 }
    { off = ($1 - one) / one; far += !(off * off <= tolerance * tolerance) }
    END { print NR, far + 0 }'
}

# ---- IES and IMV are the same at every size, and MV is where it can be -------

for fields in '"basis":"ph"' '"basis":"atph"' '"solutions":"all"' \
  '"minimize":"IMV"'; do
  sizes "$fields" >p
  run planar p
  expect "$fields" 0
  # a minimum is flat
  tolerance=1e-12
  [ "$fields" != '"minimize":"IMV"' ] || tolerance=1e-6
  equal "$fields: IES" '11 0' "$(same diagnostics.IES $tolerance)"
  equal "$fields: IMV" '11 0' "$(same diagnostics.IMV $tolerance)"
  equal "$fields: MV, or none" 'in no no no no in in no no no no' \
    "$(json get diagnostics.MV out | sed 's/^[0-9].*/in/; s/absent/no/' |
      tr '\n' ' ' | sed 's/ $//')"
  mv out r
  run verify r
  expect "$fields: verified" 0
done

# The minimum of MV is out of range where MV is.
sizes '"minimize":"MV"' >p
run planar p
expect 'minimum of MV' 0
equal 'minimum of MV, or none' 'in no no no no in in no no no no' \
  "$(json get diagnostics.functional out | sed 's/^[0-9].*/in/; s/absent/no/' |
    tr '\n' ' ' | sed 's/ $//')"
