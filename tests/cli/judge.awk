# SPDX-License-Identifier: GPL-3.0-or-later
#
# What tests of curves against reference values share: `why' becomes the first
# thing that is not as wanted.  "absent" and "" are no numbers.

function wanted(what, found, value) {
  if (why == "") why = what " " found ", wanted " value
}
function is_number(text) {
  return text != "absent" && text != ""
}
function at_most(what, found, most) {
  if (!is_number(found) || !(found + 0 <= most))
    wanted(what, found, "at most " most)
}
# To an absolute tolerance.
function close_to(what, found, value, tol) {
  if (!is_number(found) || !is_number(value) ||
      !((found - value) ^ 2 <= tol ^ 2))
    wanted(what, found, value)
}
# To a relative one.
function near(what, found, value, tol) {
  close_to(what, found, value, tol * value)
}
# The numbers of a text, into list[1] and so on; returns how many.
function numbers(text, list) {
  gsub(/[^-+0-9.eE]+/, " ", text)
  gsub(/^ | $/, "", text)
  return split(text, list, " ")
}
