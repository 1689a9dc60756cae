/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fuzz target: the splitter and the reader of CSV (see stream.h): as a user
 * gives a file, with its columns named, with another delimiter, and with
 * records that may not be long.
 */
#include "stream.h"

FUZZ_TARGET(csv, data, n) {
  static const struct ph_split_options options[] = {
      {.format = PH_SPLIT_AUTO},
      {.format = PH_SPLIT_CSV, .columns = "id,x,-,y,knot"},
      {.format = PH_SPLIT_CSV, .delimiter = ';'},
      {.format = PH_SPLIT_CSV, .most = 24},
      {.format = PH_SPLIT_CSV,
       .delimiter = '\t',
       .columns = "id,x,y",
       .most = 9}};
  for (size_t i = 0; i < sizeof options / sizeof options[0]; i++) {
    stream_check(data, n, &options[i]);
  }
  return 0;
}
