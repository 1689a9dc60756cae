/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of formats (see format.h). */
#include "io/format.h"

#include "curve/kind/kind.h"
#include "curve/surface/grid.h"
#include "io/dxf_out.h"
#include "io/gcode_out.h"
#include "io/geojson_out.h"
#include "io/npy_out.h"
#include "io/obj_out.h"
#include "io/opendrive_out.h"
#include "io/stl_out.h"
#include "io/svg_out.h"

static void json_solved(struct ph_buf *buf, const struct ph_print *print,
                        const struct ph_solved *s) {
  ph_json_result(buf, s->heading, s->result, print->pretty);
}

static void json_failed(struct ph_buf *buf, const struct ph_print *print,
                        const struct ph_heading *heading,
                        const struct ph_diag *diag, const char *file) {
  ph_json_error(buf, heading, diag, file, print->pretty);
}

static void table_header(struct ph_buf *buf, const struct ph_print *print,
                         const struct ph_swept *swept, size_t swept_n) {
  ph_csv_header(buf, &print->shape, swept, swept_n);
}

static void table_solved(struct ph_buf *buf, const struct ph_print *print,
                         const struct ph_solved *s) {
  const struct ph_csv_heading heading = {
      s->id, s->heading->swept, s->heading->swept_n,
      s->heading->file ? s->heading->file : "-", s->number};
  ph_csv_result(buf, &print->shape, &heading, s->result);
}

static void array_header(struct ph_buf *buf, const struct ph_print *print,
                         const struct ph_swept *swept, size_t swept_n) {
  (void)swept, (void)swept_n;
  ph_npy_header(buf, &print->shape, 0);
}

static void array_finish(struct ph_buf *buf, const struct ph_print *print,
                         size_t bytes) {
  ph_npy_header(buf, &print->shape, bytes);
}

/* Units: how many millimetres, and what $INSUNITS of DXF is. */
static const struct {
  double size;
  const char *code;
} units[PH_SHEET_N] = {
    [PH_SHEET_MM] = {1, "4"},
    [PH_SHEET_CM] = {10, "5"},
    [PH_SHEET_M] = {1000, "6"},
    [PH_SHEET_INCH] = {25.4, "1"},
};

/* Path i of a result: the offset that it is of, or NULL, and whether its
 * subpaths that end where they began are closed. */
static const struct ph_offset *path_of(const struct ph_solved *s, size_t i,
                                       bool *closed) {
  const struct ph_offset *o =
      i > 0 && i <= s->result->offsets_n ? &s->result->offsets[i - 1] : NULL;
  *closed = s->result->curve.closed || (o && o->loops.mode);
  return o;
}

/* One line, also where there is no path: lines are those of the problems. */
static void path_solved(struct ph_buf *buf, const struct ph_print *print,
                        const struct ph_solved *s) {
  bool closed;
  (void)print;
  for (size_t i = 0; i < s->paths_n; i++) {
    path_of(s, i, &closed);
    ph_svg_path(buf, &s->paths[i], closed);
  }
  ph_buf_puts(buf, "\n");
}

/* The flat pattern of a surface: its outline, then the rulings between strips,
 * apart, as what cuts and bends is to tell them. */
static void pattern_solved(struct ph_buf *buf, const struct ph_solved *s,
                           const struct ph_curve *curve,
                           const struct ph_pieces *path,
                           struct ph_svg_name *name) {
  const size_t rulings = ph_flat_rulings(curve);
  struct ph_pieces part = *path;
  part.n -= rulings;
  ph_svg_element(buf, name, &part, rulings > 0 || s->result->curve.closed,
                 !s->downward, s->box);
  part.control_points += 8 * part.n;
  part.n = rulings;
  name->rulings = true;
  ph_svg_element(buf, name, &part, false, !s->downward, s->box);
  name->rulings = false;
}

static void drawing_frame(struct ph_buf *buf, const struct ph_print *print,
                          const double box[4]) {
  ph_svg_header(buf, box, units[print->unit].size);
}

static void drawing_solved(struct ph_buf *buf, const struct ph_print *print,
                           const struct ph_solved *s) {
  struct ph_svg_name name = {s->id, NULL, false, s->heading->swept,
                             s->heading->swept_n};
  const struct ph_result *r = s->result;
  bool closed;
  (void)print;
  for (size_t i = 0; i < s->paths_n; i++) {
    const struct ph_offset *o = path_of(s, i, &closed);
    const struct ph_parallel *parallel =
        i > 0 && !o ? &r->parallels[i - 1] : NULL;
    name.distance = o ? &o->distance : parallel ? &parallel->distance : NULL;
    if (ph_kind_of(&r->curve)->parts == PH_STRIPS_PARTS) {
      pattern_solved(buf, s, parallel ? &parallel->curve : &r->curve,
                     &s->paths[i], &name);
    } else {
      ph_svg_element(buf, &name, &s->paths[i], closed, !s->downward, s->box);
    }
  }
}

static void path_failed(struct ph_buf *buf, const struct ph_print *print,
                        const struct ph_heading *heading,
                        const struct ph_diag *diag, const char *file) {
  (void)print, (void)heading, (void)diag, (void)file;
  ph_buf_puts(buf, "\n");
}

static void mesh_solved(struct ph_buf *buf, const struct ph_print *print,
                        const struct ph_solved *s) {
  (void)print;
  ph_obj_out(buf, s->id, s->number == 1, s->tilings, s->tilings_n);
}

static void triangles_solved(struct ph_buf *buf, const struct ph_print *print,
                             const struct ph_solved *s) {
  (void)print;
  ph_stl_out(buf, s->tilings, s->tilings_n);
}

static void lines_header(struct ph_buf *buf, const struct ph_print *print,
                         const struct ph_swept *swept, size_t swept_n) {
  (void)print, (void)swept, (void)swept_n;
  ph_geojson_header(buf);
}

static void lines_solved(struct ph_buf *buf, const struct ph_print *print,
                         const struct ph_solved *s) {
  (void)print;
  ph_geojson_out(buf, s->heading, s->result);
}

static void nurbs_header(struct ph_buf *buf, const struct ph_print *print,
                         const struct ph_swept *swept, size_t swept_n) {
  (void)swept, (void)swept_n;
  ph_dxf_header(buf, units[print->unit].code);
}

static void nurbs_solved(struct ph_buf *buf, const struct ph_print *print,
                         const struct ph_solved *s) {
  (void)print;
  ph_dxf_out(buf, s->id, s->number, s->downward, s->result, s->paths);
}

static void roads_header(struct ph_buf *buf, const struct ph_print *print,
                         const struct ph_swept *swept, size_t swept_n) {
  (void)print, (void)swept, (void)swept_n;
  ph_opendrive_header(buf);
}

static void roads_solved(struct ph_buf *buf, const struct ph_print *print,
                         const struct ph_solved *s) {
  const struct ph_svg_name name = {s->id, NULL, false, s->heading->swept,
                                   s->heading->swept_n};
  (void)print;
  ph_opendrive_out(buf, &name, s->number, s->downward, &s->result->curve);
}

static void moves_header(struct ph_buf *buf, const struct ph_print *print,
                         const struct ph_swept *swept, size_t swept_n) {
  (void)swept, (void)swept_n;
  ph_gcode_header(buf, print->feed);
}

static void moves_solved(struct ph_buf *buf, const struct ph_print *print,
                         const struct ph_solved *s) {
  (void)print;
  ph_gcode_out(buf, s->id, s->downward, s->result);
}

const struct ph_format_row ph_formats[PH_FORMAT_N] = {
    [PH_FORMAT_JSON] = {.is_objects = true,
                        .is_parted = true,
                        .solved = json_solved,
                        .failed = json_failed},
    [PH_FORMAT_CSV] = {.is_table = true,
                       .is_parted = true,
                       .header = table_header,
                       .solved = table_solved},
    [PH_FORMAT_TEXT] = {.is_table = true,
                        .is_parted = true,
                        .is_text = true,
                        .header = table_header,
                        .solved = table_solved},
    [PH_FORMAT_NPY] = {.is_table = true,
                       .is_binary = true,
                       .header = array_header,
                       .finish = array_finish,
                       .solved = table_solved},
    [PH_FORMAT_SVG_PATH] = {.is_cubics = true,
                            .is_parted = true,
                            .solved = path_solved,
                            .failed = path_failed},
    [PH_FORMAT_SVG] = {.is_cubics = true,
                       .is_drawing = true,
                       .is_sheet = true,
                       .frame = drawing_frame,
                       .footer = ph_svg_footer,
                       .solved = drawing_solved},
    [PH_FORMAT_GEOJSON] = {.is_lines = true,
                           .joint = sizeof PH_GEOJSON_JOINT - 1,
                           .header = lines_header,
                           .footer = ph_geojson_footer,
                           .solved = lines_solved},
    [PH_FORMAT_DXF] = {.is_nurbs = true,
                       .is_sheet = true,
                       .header = nurbs_header,
                       .footer = ph_dxf_footer,
                       .solved = nurbs_solved},
    [PH_FORMAT_OBJ] = {.is_mesh = true, .solved = mesh_solved},
    [PH_FORMAT_STL] = {.is_mesh = true,
                       .is_single = true,
                       .solved = triangles_solved},
    [PH_FORMAT_OPENDRIVE] = {.is_road = true,
                             .header = roads_header,
                             .footer = ph_opendrive_footer,
                             .solved = roads_solved},
    [PH_FORMAT_GCODE] = {.is_moves = true,
                         .is_lines = true,
                         .header = moves_header,
                         .footer = ph_gcode_footer,
                         .solved = moves_solved},
};

const char *ph_format_name(enum ph_format format) {
  static const char *const names[PH_FORMAT_N] = {
#define X(symbol, name) name,
      PH_FORMATS(X, X)
#undef X
  };
  return names[format];
}
