/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fuzz target: the splitter and the readers of SVG and GPX (see stream.h), also
 * with records that may not be long. */
#include "stream.h"

FUZZ_TARGET(xml, data, n) {
  static const struct ph_split_options any = {.format = PH_SPLIT_XML};
  static const struct ph_split_options few = {.format = PH_SPLIT_SVG,
                                              .most = 100};
  if (!ph_split_xml_can()) {
    return 0;
  }
  stream_by_line = true;
  stream_check(data, n, &any);
  stream_check(data, n, &few);
  stream_by_line = false;
  return 0;
}
