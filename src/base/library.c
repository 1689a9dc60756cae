/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Shared libraries that are loaded when they are needed (see library.h). */
#include "base/library.h"

#if defined PH_CAIRO_NAME || defined PH_TEEM_NAME

#include <dlfcn.h>
#include <string.h>

bool ph_library_load(const char *library,
                     const struct ph_library_symbol *symbols, size_t n,
                     void *to, const char **why) {
  void *handle = dlopen(library, RTLD_NOW | RTLD_LOCAL);
  bool all = handle;
  for (size_t i = 0; all && i < n; i++) {
    void *found = dlsym(handle, symbols[i].name);
    memcpy((char *)to + symbols[i].offset, &found, sizeof found);
    all = found;
  }
  *why = all ? NULL : dlerror();
  return all;
}

#endif
