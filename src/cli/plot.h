/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The figure of a run (--plot): drawings that workers make, collected in the
 * order of the input, and the file that they end in.
 *
 * There are limits, so that a figure can be looked at and memory is bounded: of
 * panels and of results in each (plot/figure.h), and of places in all.  What is
 * beyond is counted, not drawn.
 */
#ifndef PH_CLI_PLOT_H
#define PH_CLI_PLOT_H

#include "cli/option.h"
#include "cli/output.h"
#include "plot/drawing.h"

struct ph_plot {
  const struct ph_options *options;
  struct ph_output output;
  struct ph_drawing **drawings; /* [n] */
  size_t n, room;
  size_t panels;
  size_t panel;  /* number of the record of the last one */
  size_t inside; /* drawings in it */
  size_t places; /* in all of them */
  bool full;     /* no panel will be added */
  size_t solved; /* results, drawn or not */
};

/* ph_plot_read_size: reads the WIDTHxHEIGHT of --plot-size.
 * ret  PH_OK | PH_E_USAGE */
enum ph_status ph_plot_read_size(const char *text, struct ph_options *options,
                                 struct ph_diag *diag);

/* ph_plot_check: whether --plot and what belongs to it make sense.
 * ret  PH_OK | PH_E_USAGE */
enum ph_status ph_plot_check(const struct ph_options *options,
                             struct ph_diag *diag);

/* ph_plot_open: begins; without --plot, nothing happens here and below.
 * ret  PH_OK | PH_E_OUTPUT | PH_E_NO_MEMORY */
enum ph_status ph_plot_open(struct ph_plot *plot,
                            const struct ph_options *options,
                            struct ph_diag *diag);

/* ph_plot_wants: whether a drawing of that record may still be shown; once it
 * is not, no drawing that comes later in the order of the input is. */
bool ph_plot_wants(const struct ph_plot *plot, size_t record);

/* What a result is called. */
struct ph_plot_subject {
  const char *id; /* plain text; NULL: it has none */
  size_t record;  /* its number */
  const struct ph_swept *swept;
  size_t swept_n;
};

/*
 * ph_plot_draw: draws a result, in a worker.
 *
 * in   scratch  takes little memory
 * out  drawing  to be freed; NULL on failure
 * ret  as of ph_drawing_make
 */
enum ph_status ph_plot_draw(const struct ph_plot_subject *subject,
                            const struct ph_problem *problem,
                            const struct ph_result *result,
                            struct ph_arena *scratch,
                            struct ph_drawing **drawing, struct ph_diag *diag);

/*
 * ph_plot_add: a solved problem, the next one in the order of the input.
 *
 * in   drawing  the plot's from now on, whatever is returned; NULL: it was not
 *               wanted
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_plot_add(struct ph_plot *plot, struct ph_drawing *drawing,
                           struct ph_diag *diag);

/* ph_plot_write: writes the file and gives it its name.  Drawing is the work of
 * a process of its own, whose crash or hang is a failure like others: results
 * are to be written before, and threads to have ended.
 * ret  PH_OK | PH_E_OUTPUT | PH_E_NO_MEMORY | PH_E_INTERNAL */
enum ph_status ph_plot_write(struct ph_plot *plot, struct ph_diag *diag);

/* ph_plot_free: a file that was not written leaves no trace. */
void ph_plot_free(struct ph_plot *plot);

#endif
