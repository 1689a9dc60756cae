/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fuzz target: results, verified.  The first line of an input is a result, the
 * rest, if there is any, the problem that it solves; both JSON.
 *
 * Whatever they hold, the outcome is a verdict or a failure of the record, told
 * in one line of JSON, and the same a second time.
 */
#include "fuzz.h"

#include "cli/pairing.h"
#include "cli/verify.h"
#include "io/json_scan.h"

#include <string.h>

/* Whether text[n] is one JSON value. */
static bool result_is_json(const char *text, size_t n) {
  struct ph_json_scan scan = {0};
  const char *end = text + n;
  return ph_json_scan(&scan, text, n, true) == PH_JSON_DONE &&
         ph_json_blanks(text + scan.at, end) == end;
}

static struct ph_record result_record(const char *text, size_t n) {
  const char *begin = ph_json_blanks(text, text + n);
  return (struct ph_record){.text = begin,
                            .n = n - (size_t)(begin - text),
                            .file = "-",
                            .line = 1,
                            .number = 1};
}

static enum ph_status result_verify(const struct ph_record *record,
                                    const struct ph_paired *paired,
                                    struct ph_buf *out) {
  const struct ph_options options = {.command = ph_command_find("verify"),
                                     .problems = paired ? "-" : NULL};
  static const struct ph_worker none;
  struct ph_worker worker = none;
  struct ph_item item = {.record = *record, .paired = paired};
  struct ph_buf err = {0};
  struct ph_json_scan scan = {0};
  ph_verify_work(&options, &worker, &item, out, &err);
  FUZZ_REQUIRE(!out->failed && !err.failed);
  FUZZ_REQUIRE(item.status == PH_OK ||
               ph_status_class(item.status) == PH_CLASS_RECORD);
  FUZZ_REQUIRE((item.status == PH_OK) == (err.n == 0));
  FUZZ_REQUIRE(ph_json_scan(&scan, out->data, out->n, true) == PH_JSON_DONE);
  FUZZ_REQUIRE(memchr(out->data, '\n', out->n) == out->data + scan.at);
  ph_buf_free(&err);
  ph_worker_free(&worker);
  return item.status;
}

FUZZ_TARGET(result, data, n) {
  const char *text = (const char *)data;
  const char *line = n ? memchr(text, '\n', n) : NULL;
  size_t first = line ? (size_t)(line - text) : n, rest = n - first;
  struct ph_record record;
  struct ph_paired paired = {.index = 0};
  const struct ph_paired *problem = NULL;
  struct ph_buf one = {0}, two = {0};
  enum ph_status status;
  if (!n || !result_is_json(text, first)) {
    return 0;
  }
  record = result_record(text, first);
  if (rest && result_is_json(line, rest)) {
    paired.record = result_record(line, rest);
    problem = &paired;
  }
  status = result_verify(&record, problem, &one);
  FUZZ_REQUIRE(result_verify(&record, problem, &two) == status);
  FUZZ_REQUIRE(one.n == two.n && memcmp(one.data, two.data, one.n) == 0);
  ph_buf_free(&one);
  ph_buf_free(&two);
  return 0;
}
