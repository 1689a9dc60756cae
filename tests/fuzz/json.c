/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fuzz target: the splitter and the reader of JSON (see stream.h). */
#include "stream.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n) {
  const struct ph_split_options options = {PH_SPLIT_JSON, 0, NULL, 0};
  stream_check(data, n, &options);
  return 0;
}
