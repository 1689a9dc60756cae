/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fuzz target: the splitter and the readers of SVG and GPX (see stream.h), also
 * with records that may not be long. */
#include "stream.h"

FUZZ_TARGET(xml, data, n) {
  static const struct ph_split_options any = {.format = PH_SPLIT_XML};
  static const struct ph_split_options few = {.format = PH_SPLIT_SVG,
                                              .most = 100};
  struct ph_buf log = {0};
  if (!ph_split_xml_can()) {
    return 0;
  }
  stream_by_line = true;
  stream_check(data, n, &any);
  if (n <= STREAM_MAX) {
    stream_run(data, n, STREAM_MAX, &few, &log);
  }
  ph_buf_free(&log);
  stream_by_line = false;
  return 0;
}
