# SPDX-License-Identifier: GPL-3.0-or-later
#
# Draws Bezier splines as text: the curve solid, its offsets dotted.
#
#   LC_ALL=C awk -f picture.awk [-v style=ascii] [-v cols=76] [-v rows=30]
#                [-v unit=km] FILE...
#
# Each FILE is a CSV table with a header row, known by its columns:
#   phspline --format=csv --table=control-points   id,segment,index,x,y
#   phspline --format=csv --table=offsets          the same and weight
#   points that were interpolated                  x,y
# Points are marked where they lie far enough apart to be told from the curve.
# Fields must not be quoted, and lines that begin with # are skipped.
#
# Method: every piece is evaluated by de Casteljau's algorithm, on (wx, wy, w)
# for rational pieces, into a polyline, and that is set on a raster of 2 x 4
# dots per character (style=braille, the default: UTF-8, written as bytes, so
# the locale must be C) or of one character (style=ascii).  A character cell
# is taken to be twice as high as wide, so lengths agree in both directions.
#
# POSIX awk; it reads only the tables and computes nothing but the picture.

BEGIN {
  FS = ","
  table = "\n"  # the name of no file
  if (cols == "") cols = 76
  if (rows == "") rows = 30
  ascii = (style == "ascii")
  dots_x = ascii ? 1 : 2     # raster points per character, across
  dots_y = ascii ? 1 : 4     # and down
  squeeze = ascii ? 0.5 : 1  # height of the raster's unit square in rows
}

{ sub(/\r$/, "") }
/^#/ || /^[ \t]*$/ { next }

# A header begins a table; it may stand once per file.
FNR == 1 || FILENAME != table {
  table = FILENAME
  split("", col)
  for (i = 1; i <= NF; i++) col[$i] = i
  if (!("x" in col) || !("y" in col)) {
    print "picture.awk: " FILENAME ": no columns x and y" | "cat >&2"
    failed = 1
    exit 2
  }
  next
}

!("index" in col) {
  marks++
  mark_x[marks] = $col["x"] + 0
  mark_y[marks] = $col["y"] + 0
  next
}

# An offset of a PH quintic has degree 9; a segment whose offset consists of
# several pieces numbers their control points through.
{
  rational = "weight" in col
  k = $col["index"] + 0
  if (rational ? k % 10 == 0 : k == 0) {
    pieces++
    first[pieces] = controls + 1
    dotted[pieces] = rational
  }
  controls++
  size[pieces]++
  w[controls] = rational ? $col["weight"] + 0 : 1
  wx[controls] = w[controls] * $col["x"]
  wy[controls] = w[controls] * $col["y"]
}

# Sets (out_x, out_y) to the point of piece p at t.
function evaluate(p, t,    n, i, a, b, c, j) {
  n = size[p]
  for (i = 1; i <= n; i++) {
    j = first[p] + i - 1
    a[i] = wx[j]
    b[i] = wy[j]
    c[i] = w[j]
  }
  for (; n > 1; n--) {
    for (i = 1; i < n; i++) {
      a[i] += t * (a[i + 1] - a[i])
      b[i] += t * (b[i + 1] - b[i])
      c[i] += t * (c[i + 1] - c[i])
    }
  }
  out_x = a[1] / c[1]
  out_y = b[1] / c[1]
}

# Widens the bounding box by a point.
function cover(x, y) {
  if (!covered++) {
    left = right = x
    bottom = top = y
  }
  if (x < left) left = x
  if (x > right) right = x
  if (y < bottom) bottom = y
  if (y > top) top = y
}

function raster_x(x) { return (x - left) * scale }
function raster_y(y) { return (top - y) * scale * squeeze }

# The weight of a dot within a braille character: 1 2 4 64 down its left
# column, 8 16 32 128 down its right one.
function weight_of(i, j) {
  if (j == 3) return i ? 128 : 64
  return (i ? 8 : 1) * (j == 0 ? 1 : j == 1 ? 2 : 4)
}

# Sets the dot at column x, row y of the raster; what: 1 curve, 0 offset.
function dot(x, y, what,    c, r) {
  x = int(x + 0.5)
  y = int(y + 0.5)
  c = int(x / dots_x)
  r = int(y / dots_y)
  if (ascii) {
    if (what || !((r, c) in cell)) cell[r, c] = what
    return
  }
  if (!((x, y) in lit)) {
    lit[x, y] = 1
    cell[r, c] += weight_of(x % 2, y % 4)
  }
}

# Adds the direction of a step to those of its cell (as doubled angles, which
# do not tell forth from back), for the choice of an ASCII character.
function lean(x, y, dx, dy,    c, r, length_) {
  length_ = sqrt(dx * dx + dy * dy)
  if (length_ > 0) {
    c = int(x + 0.5)
    r = int(y + 0.5)
    lean_c[r, c] += (dx * dx - dy * dy) / length_
    lean_s[r, c] += 2 * dx * dy / length_
    height[r, c] += (r - y) * length_
    height_n[r, c] += length_
  }
}

# A solid line, from raster point (x0, y0) to (x1, y1).
function stroke(x0, y0, x1, y1,    n, i, dx, dy) {
  dx = x1 - x0
  dy = y1 - y0
  n = (dx < 0 ? -dx : dx) > (dy < 0 ? -dy : dy) ? dx : dy
  n = int(n < 0 ? -n : n) * 2 + 1
  for (i = 0; i <= n; i++) {
    dot(x0 + dx * i / n, y0 + dy * i / n, 1)
    if (ascii) {
      lean(x0 + dx * i / n, y0 + dy * i / n, dx / n, -dy / n / squeeze)
    }
  }
}

# A dotted line: one dot every `gap` units, counted on from the line before.
function dash(x0, y0, x1, y1,    dx, dy, length_, at) {
  dx = x1 - x0
  dy = y1 - y0
  length_ = sqrt(dx * dx + dy * dy / (squeeze * squeeze))
  for (at = gap - carried; at <= length_; at += gap) {
    dot(x0 + dx * at / length_, y0 + dy * at / length_, 0)
  }
  carried = length_ - (at - gap)
}

function draw(p, steps,    i) {
  for (i = 1; i <= steps; i++) {
    if (dotted[p]) {
      dash(raster_x(px[p, i - 1]), raster_y(py[p, i - 1]),
           raster_x(px[p, i]), raster_y(py[p, i]))
    } else {
      stroke(raster_x(px[p, i - 1]), raster_y(py[p, i - 1]),
             raster_x(px[p, i]), raster_y(py[p, i]))
    }
  }
}

# A mark is a blot of 3 x 3 dots, or a letter.
function mark(x, y,    i, j) {
  if (ascii) {
    marked[int(y + 0.5), int(x + 0.5)] = 1
    return
  }
  x = int(x + 0.5)
  y = int(y + 0.5)
  for (i = -1; i <= 1; i++) {
    for (j = -1; j <= 1; j++) {
      if (x + i >= 0 && y + j >= 0) dot(x + i, y + j, 1)
    }
  }
}

# The ASCII character for a cell that the curve passes: by its mean direction,
# and by its mean height in the cell where it is level.
function slope(r, c,    angle, h) {
  angle = atan2(lean_s[r, c], lean_c[r, c]) * 90 / 3.14159265
  if (angle > 75 || angle < -75) return "|"
  if (angle > 30) return "/"
  if (angle < -30) return "\\"
  h = height[r, c] / height_n[r, c]
  return h < -0.2 ? "_" : h > 0.25 ? "'" : "-"
}

function character(r, c) {
  if ((r, c) in marked) return "o"
  if (!((r, c) in cell)) return " "
  if (ascii && !cell[r, c]) return "."
  # A curve that only cuts the corner of a cell is left to its neighbours.
  if (ascii) return height_n[r, c] < 0.6 ? " " : slope(r, c)
  # U+2800 + n, in UTF-8: 342, 240 + n / 64, 200 + n mod 64 (octal)
  return "\342" lead[int(cell[r, c] / 64) + 1] tail[cell[r, c] % 64 + 1]
}

# A bar of 1, 2 or 5 times a power of ten units, at most a quarter of the
# picture's longer side.
function bar(    limit, n, line) {
  limit = (right - left > top - bottom ? right - left : top - bottom) / 4
  n = 1
  while (n > limit) n /= 10
  while (n * 10 <= limit) n *= 10
  n *= (n * 5 <= limit) ? 5 : (n * 2 <= limit) ? 2 : 1
  line = "|"
  while (length(line) < n * scale / dots_x - 1) line = line "-"
  return line "| " n (unit == "" ? "" : " " unit)
}

END {
  if (failed) exit 2
  if (!pieces) exit 0
  split("\240 \241 \242 \243", lead, " ")
  split("\200 \201 \202 \203 \204 \205 \206 \207 \210 \211 \212 \213 " \
        "\214 \215 \216 \217 \220 \221 \222 \223 \224 \225 \226 \227 " \
        "\230 \231 \232 \233 \234 \235 \236 \237 \240 \241 \242 \243 " \
        "\244 \245 \246 \247 \250 \251 \252 \253 \254 \255 \256 \257 " \
        "\260 \261 \262 \263 \264 \265 \266 \267 \270 \271 \272 \273 " \
        "\274 \275 \276 \277", tail, " ")

  # Enough chords to look smooth: few long pieces need more than many short.
  steps = 12 + int(1000 / pieces)
  for (p = 1; p <= pieces; p++) {
    for (i = 0; i <= steps; i++) {
      evaluate(p, i / steps)
      px[p, i] = out_x
      py[p, i] = out_y
      cover(out_x, out_y)
      if (i && !dotted[p]) {
        travel += sqrt((out_x - px[p, i - 1]) ^ 2 + (out_y - py[p, i - 1]) ^ 2)
      }
    }
  }
  scale = 0
  if (right > left) scale = (cols * dots_x - 1) / (right - left)
  limit = (rows * dots_y - 1) / squeeze
  if (top > bottom && (!scale || limit / (top - bottom) < scale)) {
    scale = limit / (top - bottom)
  }

  gap = ascii ? 2 : 3
  for (p = 1; p <= pieces; p++) if (dotted[p]) draw(p, steps)
  for (p = 1; p <= pieces; p++) if (!dotted[p]) draw(p, steps)
  if (marks && travel * scale / marks >= (ascii ? 3 : 6)) {
    for (i = 1; i <= marks; i++) mark(raster_x(mark_x[i]), raster_y(mark_y[i]))
  }

  rows = int(raster_y(bottom) / dots_y + 0.5 / dots_y) + 1
  for (r = 0; r < rows; r++) {
    line = ""
    blank = ""
    for (c = 0; c < cols; c++) {
      one = character(r, c)
      if (one == " ") {
        blank = blank " "
      } else {
        line = line blank one
        blank = ""
      }
    }
    print line
  }
  if (scale) print bar()
}
