/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How a file gets its name: on the disk first, then renamed, then the name on
 * the disk.  fsync and rename are this file's own: they note each call, and one
 * of them may fail. */
#define _XOPEN_SOURCE 700 /* mkdtemp */
#include "unit.h"

#include "base/buf.h"
#include "cli/output.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <sys/stat.h>
#include <unistd.h>

static char calls[64]; /* f: file, d: directory, r: rename */
static char fails;     /* which of these, with this error */
static int error;
static struct ph_diag diag;

static int note(char what) {
  size_t n = strlen(calls);
  ck_assert_uint_lt(n + 1, sizeof calls);
  calls[n] = what;
  calls[n + 1] = '\0';
  if (what != fails) {
    return 0;
  }
  errno = error;
  return -1;
}

/* The first call with EINTR is interrupted, the next is not. */
int fsync(int fd) {
  struct stat info;
  int result;
  ck_assert_int_eq(fstat(fd, &info), 0);
  result = note(S_ISDIR(info.st_mode) ? 'd' : 'f');
  if (error == EINTR) {
    fails = '\0';
  }
  return result;
}

int rename(const char *from, const char *to) {
  return note('r') == 0 ? renameat(AT_FDCWD, from, AT_FDCWD, to) : -1;
}

static char directory[] = "t_output.XXXXXX";

static void start(void) {
  ck_assert_ptr_nonnull(mkdtemp(strcpy(directory, "t_output.XXXXXX")));
  ck_assert_int_eq(chdir(directory), 0);
}

static void finish(void) {
  unlink("file");
  ck_assert_int_eq(chdir(".."), 0);
  ck_assert_int_eq(rmdir(directory), 0); /* nothing else was left */
}

/* What stands in the file; "" if there is none. */
static const char *content(void) {
  static char text[16];
  FILE *file = fopen("file", "r");
  text[0] = '\0';
  if (file) {
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
  }
  return text;
}

/* Replaces a file that says "old". */
static enum ph_status replace(const char *name, bool sync, char what, int why) {
  struct ph_output output;
  FILE *file = fopen("file", "w");
  enum ph_status status;
  ck_assert_ptr_nonnull(file);
  fputs("old", file);
  fclose(file);
  memset(&diag, 0, sizeof diag);
  calls[0] = '\0';
  fails = what;
  error = why;
  ck_assert_int_eq(ph_output_open(&output, name, sync, &diag), PH_OK);
  ck_assert_int_eq(ph_output_write(&output, "new", 3, &diag), PH_OK);
  status = ph_output_commit(&output, &diag);
  ph_output_discard(&output);
  fails = '\0';
  return status;
}

static void ck_replaced(const char *name, bool sync, const char *wanted) {
  ck_assert_int_eq(replace(name, sync, '\0', 0), PH_OK);
  ck_assert_str_eq(calls, wanted);
  ck_assert_str_eq(content(), "new");
}

PH_TEST(test_order) {
  char path[PATH_MAX];
  ck_replaced("file", true, "frd");
  ck_replaced("./file", true, "frd");
  ck_assert_ptr_nonnull(getcwd(path, sizeof path - 8));
  ck_replaced(strcat(path, "/file"), true, "frd");
  ck_replaced("file", false, "r");
}

PH_TEST(test_no_file) {
  ck_assert_int_eq(replace("/dev/null", true, '\0', 0), PH_OK);
  ck_assert_str_eq(calls, "");
  ck_assert_str_eq(content(), "old");
}

static void ck_failed(char what, int why, const char *wanted, const char *left,
                      const char *message) {
  ck_assert_int_eq(replace("file", true, what, why), PH_E_OUTPUT);
  ck_assert_str_eq(calls, wanted);
  ck_assert_str_eq(content(), left);
  ck_assert_str_eq(diag.message, message);
}

PH_TEST(test_failure) {
  ck_failed('f', EIO, "f", "old", "cannot write file: Input/output error");
  ck_failed('f', ENOSPC, "f", "old",
            "cannot write file: No space left on device");
  ck_failed('r', EACCES, "fr", "old", "cannot replace file: Permission denied");
  ck_failed('d', EIO, "frd", "new",
            "cannot write the directory of file: Input/output error");
}

/* What cannot be waited for is not. */
PH_TEST(test_no_sync_there) {
  static const int why[] = {EINVAL, ENOTSUP, EROFS};
  for (size_t i = 0; i < COUNT(why); i++) {
    ck_assert_int_eq(replace("file", true, 'f', why[i]), PH_OK);
    ck_assert_str_eq(calls, "frd");
    ck_assert_int_eq(replace("file", true, 'd', why[i]), PH_OK);
    ck_assert_str_eq(content(), "new");
  }
  ck_assert_int_eq(replace("file", true, 'f', EINTR), PH_OK);
  ck_assert_str_eq(calls, "ffrd");
}

PH_FIXTURE(start, finish)
