/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fuzz target: the splitter and the readers of JSON and GeoJSON (see stream.h),
 * also with records that may not be long. */
#include "stream.h"

FUZZ_TARGET(json, data, n) {
  static const struct ph_split_options options[] = {
      {.format = PH_SPLIT_JSON},
      {.format = PH_SPLIT_AUTO, .most = 24},
      {.format = PH_SPLIT_GEOJSON}};
  for (size_t i = 0; i < sizeof options / sizeof options[0]; i++) {
    stream_check(data, n, &options[i]);
  }
  return 0;
}
