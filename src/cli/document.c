/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The output as a whole (see document.h). */
#include "cli/document.h"

#include "io/svg_out.h"

#include <string.h>

static const struct ph_format_row *format_of(const struct ph_document *d) {
  return &ph_formats[d->options->format];
}

static enum ph_status write_buf(struct ph_document *d, struct ph_buf *buf,
                                struct ph_diag *diag) {
  const enum ph_status status =
      buf->failed ? ph_fail_memory(diag)
                  : ph_output_write(d->output, buf->data, buf->n, diag);
  ph_buf_free(buf);
  return status;
}

/* Whether the part of the input, or all, begins where it does. */
static bool is_first(const struct ph_split_part *part) {
  return part->how == PH_PART_SHARD   ? part->shard == 0
         : part->how == PH_PART_RANGE ? part->begin == 0
                                      : true;
}

enum ph_status ph_document_begin(struct ph_document *d,
                                 const struct ph_options *o,
                                 struct ph_output *output,
                                 struct ph_diag *diag) {
  struct ph_buf buf = {0};
  struct ph_print print;
  struct ph_swept *swept;
  *d = (struct ph_document){
      .options = o, .output = output, .box = PH_SVG_NOTHING};
  if (format_of(d)->finish && !output->temporary) {
    return ph_fail(diag, PH_E_OUTPUT, NULL,
                   "cannot write %s as %s: it is no regular file", output->name,
                   ph_format_name(o->format));
  }
  if (!format_of(d)->header || !is_first(&o->input.part)) {
    return PH_OK;
  }
  swept = ph_malloc((o->sweeps_n + 1) * sizeof *swept);
  if (!swept) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; i < o->sweeps_n; i++) {
    swept[i] = (struct ph_swept){.name = o->sweeps[i].name};
  }
  print = ph_options_print(o);
  format_of(d)->header(&buf, &print, swept, o->sweeps_n);
  ph_free(swept);
  return write_buf(d, &buf, diag);
}

enum ph_status ph_document_add(struct ph_document *d, const char *bytes,
                               size_t n, struct ph_diag *diag) {
  const size_t joint = d->joined || n == 0 ? 0 : format_of(d)->joint;
  if (format_of(d)->frame) {
    ph_buf_put(&d->kept, bytes, n);
    return d->kept.failed ? ph_fail_memory(diag) : PH_OK;
  }
  d->joined |= n > 0;
  d->bytes += n - joint;
  return ph_output_write(d->output, bytes + joint, n - joint, diag);
}

enum ph_status ph_document_end(struct ph_document *d, struct ph_diag *diag) {
  struct ph_buf buf = {0};
  if (format_of(d)->frame) {
    const struct ph_print print = ph_options_print(d->options);
    format_of(d)->frame(&buf, &print, d->box);
    ph_buf_put(&buf, d->kept.data, d->kept.n);
  }
  if (format_of(d)->finish) {
    const struct ph_print print = ph_options_print(d->options);
    enum ph_status status;
    format_of(d)->finish(&buf, &print, d->bytes);
    status = buf.failed ? ph_fail_memory(diag)
                        : ph_output_rewrite(d->output, buf.data, buf.n, diag);
    ph_buf_free(&buf);
    return status;
  }
  if (format_of(d)->footer) {
    format_of(d)->footer(&buf);
  }
  return write_buf(d, &buf, diag);
}

void ph_document_free(struct ph_document *d) {
  ph_buf_free(&d->kept);
}
