/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Strings as JSON writes them (see json_text.h). */
#include "io/json_text.h"

#include "base/suggest.h"

#include <string.h>

size_t ph_json_quote(char *quoted, const char *text, size_t n) {
  static const char hex[] = "0123456789abcdef";
  const char *p = text, *end = text + n;
  char *to = quoted;
  *to++ = '"';
  while (p < end) {
    int length = ph_utf8_length(p, end);
    unsigned char c = (unsigned char)*p;
    if (length <= 0) {
      memcpy(to, "\\ufffd", 6);
      to += 6;
      p++;
    } else if (c < 0x20 || c == 0x7F) {
      memcpy(to, "\\u00", 4);
      to[4] = hex[c >> 4];
      to[5] = hex[c & 15];
      to += 6;
      p++;
    } else {
      if (c == '"' || c == '\\') {
        *to++ = '\\';
      }
      memcpy(to, p, (size_t)length);
      to += length;
      p += length;
    }
  }
  *to++ = '"';
  return (size_t)(to - quoted);
}
