/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Standard output, or files replaced at the end (see output.h). */
#define _XOPEN_SOURCE 700 /* SIGXCPU, SIGXFSZ, PATH_MAX */
#include "cli/output.h"

#include "base/mem.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Those with a temporary file, for the signal handler; signals are blocked
 * while the list changes. */
static struct ph_output *volatile doomed;

static const int signals[] = {SIGINT,  SIGTERM, SIGHUP,
                              SIGPIPE, SIGQUIT, SIGXCPU};

/* As many symbolic links lead to a file at most. */
enum { LINKS_MAX = 40 };

/* Digits of a descriptor's number at most. */
enum { DIGITS_MAX = 9 };

/* So much of a file's name, which may have 255 bytes, is in the temporary's. */
enum { NAME_KEPT = 200 };

static void on_signal(int number) {
  for (const struct ph_output *o = doomed; o; o = o->next) {
    unlink(o->temporary);
  }
  signal(number, SIG_DFL);
  raise(number);
}

/* Signals that were ignored from the start (nohup) stay ignored. */
static void catch_signals(void) {
  for (size_t i = 0; i < sizeof signals / sizeof signals[0]; i++) {
    struct sigaction action, old;
    if (sigaction(signals[i], NULL, &old) == 0 && old.sa_handler != SIG_IGN) {
      memset(&action, 0, sizeof action);
      action.sa_handler = on_signal;
      action.sa_flags = SA_NODEFER;
      sigemptyset(&action.sa_mask);
      sigaction(signals[i], &action, NULL);
    }
  }
}

/* The temporary file of an output is no more, or has got its name. */
static void forget(struct ph_output *output) {
  sigset_t set, old;
  struct ph_output *before;
  sigemptyset(&set);
  for (size_t i = 0; i < sizeof signals / sizeof signals[0]; i++) {
    sigaddset(&set, signals[i]);
  }
  sigprocmask(SIG_BLOCK, &set, &old);
  if (doomed == output) {
    doomed = output->next;
  } else {
    for (before = doomed; before->next != output; before = before->next) {
    }
    before->next = output->next;
  }
  sigprocmask(SIG_SETMASK, &old, NULL);
  ph_free(output->temporary);
  output->temporary = NULL;
}

void ph_output_prepare(void) {
  for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++) {
    if (fcntl(fd, F_GETFD) < 0) { /* the wrong way round */
      open("/dev/null", (fd == STDIN_FILENO ? O_WRONLY : O_RDONLY) | O_CLOEXEC);
    }
  }
  signal(SIGXFSZ, SIG_IGN); /* a file that may not grow is a failed write */
}

bool ph_output_bytes(int descriptor, const char *bytes, size_t n) {
  while (n > 0) {
    ssize_t done = write(descriptor, bytes, n);
    if (done < 0 && errno != EINTR) {
      return false;
    }
    if (done > 0) {
      bytes += done;
      n -= (size_t)done;
    }
  }
  return true;
}

static enum ph_status failed(const char *what, const char *name,
                             struct ph_diag *diag) {
  return ph_fail(diag, PH_E_OUTPUT, NULL, "cannot %s %s: %s", what, name,
                 strerror(errno));
}

/* DIRECTORY/.NAME.XXXXXX for mkstemp. */
static char *temporary_name(const char *target) {
  static const char suffix[] = ".XXXXXX";
  const char *slash = strrchr(target, '/');
  size_t directory = slash ? (size_t)(slash + 1 - target) : 0;
  size_t n = strlen(target + directory);
  char *name = ph_malloc(directory + 1 + NAME_KEPT + sizeof suffix);
  if (name) {
    n = n < NAME_KEPT ? n : NAME_KEPT;
    memcpy(name, target, directory);
    name[directory] = '.';
    memcpy(name + directory + 1, target + directory, n);
    memcpy(name + directory + 1 + n, suffix, sizeof suffix);
  }
  return name;
}

/* DIRECTORY/NAME, of the first n bytes of a path and a name. */
static char *join(const char *path, size_t n, const char *name) {
  size_t name_n = strlen(name) + 1;
  char *joined = ph_malloc(n + name_n);
  if (joined) {
    memcpy(joined, path, n);
    memcpy(joined + n, name, name_n);
  }
  return joined;
}

/* The number of one of our own descriptors that a path is the name of, such as
 * /proc/self/fd/1, or -1.  Such a name is no place that a file could be put at:
 * what stands behind it has been opened by somebody else, who is to say from
 * where on it is written. */
static int descriptor_of(const char *path) {
  static const char *const homes[] = {"/dev/fd", "/proc/self/fd",
                                      "/proc/thread-self/fd"};
  const char *slash = strrchr(path, '/');
  size_t digits = slash ? strspn(slash + 1, "0123456789") : 0;
  char *directory, *real;
  int number = -1;
  if (digits == 0 || digits > DIGITS_MAX || slash[1 + digits]) {
    return -1;
  }
  directory = join(path, (size_t)(slash + 1 - path), "");
  real = directory ? realpath(directory, NULL) : NULL;
  for (size_t i = 0; real && i < sizeof homes / sizeof homes[0]; i++) {
    char *home = realpath(homes[i], NULL);
    if (home && strcmp(home, real) == 0) {
      number = atoi(slash + 1);
    }
    free(home);
  }
  free(real);
  ph_free(directory);
  return number;
}

/* What a symbolic link points to is replaced or made, not the link; a name of
 * one of our descriptors is followed no further. */
static char *resolve(const char *file) {
  char link[PATH_MAX];
  char *path = join("", 0, file);
  for (int i = 0; path && i < LINKS_MAX && descriptor_of(path) < 0; i++) {
    ssize_t n = readlink(path, link, sizeof link - 1);
    const char *slash = strrchr(path, '/');
    char *next;
    if (n <= 0) {
      break;
    }
    link[n] = '\0';
    next = join(path, *link != '/' && slash ? (size_t)(slash + 1 - path) : 0,
                link);
    ph_free(path);
    path = next;
  }
  return path;
}

/* Owner and permissions of the file that is replaced, or those of a new one.
 * Only root can give files away, and others can give one only to a group of
 * theirs: a group that never had the file gets no more than everybody. */
static enum ph_status set_mode(const struct ph_output *output,
                               const struct stat *existing,
                               struct ph_diag *diag) {
  int fd = output->descriptor;
  mode_t mask = umask(0);
  mode_t mode = existing ? existing->st_mode & 0777 : 0666 & ~mask;
  umask(mask);
  if (existing && fchown(fd, existing->st_uid, existing->st_gid) != 0 &&
      fchown(fd, (uid_t)-1, existing->st_gid) != 0) {
    mode &= ~(mode_t)S_IRWXG | (mode & S_IRWXO) << 3;
  }
  return fchmod(fd, mode) == 0 ? PH_OK
                               : failed("set the mode of", output->name, diag);
}

/* Takes over output->target. */
static enum ph_status open_temporary(struct ph_output *output,
                                     const struct stat *existing,
                                     struct ph_diag *diag) {
  sigset_t all, old;
  output->temporary = temporary_name(output->target);
  if (!output->temporary) {
    return ph_fail_memory(diag);
  }
  catch_signals();
  sigfillset(&all);
  sigprocmask(SIG_BLOCK, &all, &old); /* no signal between making and noting */
  output->descriptor = mkstemp(output->temporary);
  if (output->descriptor >= 0) {
    output->next = doomed;
    doomed = output;
  }
  sigprocmask(SIG_SETMASK, &old, NULL);
  if (output->descriptor < 0) {
    failed("create", output->name, diag);
    ph_free(output->temporary);
    output->temporary = NULL;
    return PH_E_OUTPUT;
  }
  if (fcntl(output->descriptor, F_SETFD, FD_CLOEXEC) != 0) {
    return failed("create", output->name, diag);
  }
  return set_mode(output, existing, diag);
}

/* A descriptor that was handed to the program, to write to where it stands.
 * Those that the program opened itself are closed when it executes another:
 * nobody can have meant one of these. */
static enum ph_status open_descriptor(struct ph_output *output, int number,
                                      struct ph_diag *diag) {
  int flags = fcntl(number, F_GETFD);
  int mode = fcntl(number, F_GETFL);
  if (flags < 0 || flags & FD_CLOEXEC || (mode & O_ACCMODE) == O_RDONLY) {
    errno = EBADF;
  } else {
    output->descriptor = fcntl(number, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  }
  return output->descriptor >= 0 ? PH_OK : failed("open", output->name, diag);
}

/* A file that is there, or not. */
static enum ph_status open_named(struct ph_output *output,
                                 struct ph_diag *diag) {
  const char *file = output->name;
  struct stat info;
  if (stat(file, &info) != 0) {
    return errno == ENOENT ? open_temporary(output, NULL, diag)
                           : failed("create", file, diag);
  }
  if (!S_ISREG(info.st_mode)) {
    output->descriptor = open(file, O_WRONLY | O_CLOEXEC);
    return output->descriptor >= 0 ? PH_OK : failed("open", file, diag);
  }
  if (faccessat(AT_FDCWD, file, W_OK, AT_EACCESS) != 0) {
    return failed("replace", file, diag);
  }
  return open_temporary(output, &info, diag);
}

enum ph_status ph_output_open(struct ph_output *output, const char *file,
                              bool sync, struct ph_diag *diag) {
  int number;
  memset(output, 0, sizeof *output);
  output->sync = sync;
  output->descriptor = STDOUT_FILENO;
  output->name = "standard output";
  if (!file || strcmp(file, "-") == 0) {
    return PH_OK;
  }
  output->name = file;
  output->descriptor = -1;
  output->target = resolve(file);
  if (!output->target) {
    return ph_fail_memory(diag);
  }
  number = descriptor_of(output->target);
  return number >= 0 ? open_descriptor(output, number, diag)
                     : open_named(output, diag);
}

/* What a name leads to; that of standard output is NULL or "-". */
static bool look_up(const char *file, struct stat *info) {
  return (!file || strcmp(file, "-") == 0 ? fstat(STDOUT_FILENO, info)
                                          : stat(file, info)) == 0;
}

/* Whether two names lead to one file or directory that is there. */
static bool same_existing(const char *a, const char *b) {
  struct stat x, y;
  return look_up(a, &x) && look_up(b, &y) && x.st_dev == y.st_dev &&
         x.st_ino == y.st_ino;
}

/* The directory of a path, with its slash: cuts the path there; `base` is the
 * name in it. */
static const char *split_path(char *path, char *base, size_t size) {
  char *slash = strrchr(path, '/');
  snprintf(base, size, "%s", slash ? slash + 1 : path);
  if (!slash) {
    return "./";
  }
  slash[1] = '\0';
  return path;
}

/* Whether two names lead to one file that is not there yet. */
static bool same_new(const char *a, const char *b) {
  char *x = resolve(a), *y = resolve(b);
  char x_base[NAME_MAX + 1], y_base[NAME_MAX + 1];
  bool same = false;
  if (x && y) {
    const char *x_dir = split_path(x, x_base, sizeof x_base);
    const char *y_dir = split_path(y, y_base, sizeof y_base);
    same = strcmp(x_base, y_base) == 0 && same_existing(x_dir, y_dir);
  }
  ph_free(x);
  ph_free(y);
  return same;
}

bool ph_output_same(const char *a, const char *b) {
  return same_existing(a, b) || (a && b && same_new(a, b));
}

enum ph_status ph_output_unlike(const struct ph_output *output,
                                const char *input, struct ph_diag *diag) {
  struct stat x, y;
  bool same = !output->temporary && fstat(output->descriptor, &x) == 0 &&
              S_ISREG(x.st_mode) &&
              (strcmp(input, "-") == 0 ? fstat(STDIN_FILENO, &y)
                                       : stat(input, &y)) == 0 &&
              x.st_dev == y.st_dev && x.st_ino == y.st_ino;
  return same ? ph_fail(diag, PH_E_OUTPUT, NULL,
                        "cannot write %s: it is the input %s", output->name,
                        input)
              : PH_OK;
}

enum ph_status ph_output_write(struct ph_output *output, const char *bytes,
                               size_t n, struct ph_diag *diag) {
  return ph_output_bytes(output->descriptor, bytes, n)
             ? PH_OK
             : failed("write", output->name, diag);
}

enum ph_status ph_output_rewrite(struct ph_output *output, const char *bytes,
                                 size_t n, struct ph_diag *diag) {
  return lseek(output->descriptor, 0, SEEK_SET) == 0
             ? ph_output_write(output, bytes, n, diag)
             : failed("write", output->name, diag);
}

/* Waits until what was written to a file or directory is on the disk; some
 * kinds, and file systems that are read only, cannot be waited for. */
static bool reaches_disk(int descriptor) {
  int result;
  do {
    result = fsync(descriptor);
  } while (result != 0 && errno == EINTR);
  return result == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS;
}

/* The same for the directory that has got a new name; one that may be written
 * to, but not read, cannot be opened for that. */
static bool name_reaches_disk(char *target) {
  const int flags = O_RDONLY | O_DIRECTORY | O_CLOEXEC;
  char *name = strrchr(target, '/');
  char first = name ? name[1] : '\0';
  bool ok;
  int fd;
  if (name) { /* its directory, for a moment */
    name[1] = '\0';
  }
  fd = open(name ? target : ".", flags);
  if (name) {
    name[1] = first;
  }
  ok = fd >= 0 ? reaches_disk(fd) : errno == EACCES;
  if (fd >= 0) {
    int why = errno;
    close(fd);
    errno = why;
  }
  return ok;
}

/* Whether the file that is there has the bytes of the temporary one. */
static bool is_unchanged(const struct ph_output *output) {
  static const size_t block = 1 << 14;
  char old[1 << 14], new[1 << 14];
  int fd = open(output->target, O_RDONLY | O_CLOEXEC | O_NOCTTY);
  bool same = fd >= 0;
  off_t at = 0;
  ssize_t n = 1;
  while (same && n > 0) {
    n = pread(output->descriptor, new, block, at);
    same = n >= 0 && pread(fd, old, block, at) == n &&
           memcmp(old, new, (size_t)n) == 0;
    at += n;
  }
  if (fd >= 0) {
    close(fd);
  }
  return same;
}

enum ph_status ph_output_commit(struct ph_output *output,
                                struct ph_diag *diag) {
  int descriptor = output->descriptor;
  bool sync = output->sync && output->temporary;
  if (output->if_changed && output->temporary && is_unchanged(output)) {
    ph_output_discard(output);
    return PH_OK;
  }
  if (sync && !reaches_disk(descriptor)) {
    return failed("write", output->name, diag);
  }
  output->descriptor = -1;
  if (close(descriptor) != 0) {
    return failed("write", output->name, diag);
  }
  if (output->temporary) {
    if (rename(output->temporary, output->target) != 0) {
      return failed("replace", output->name, diag);
    }
    forget(output);
  }
  return !sync || name_reaches_disk(output->target)
             ? PH_OK
             : failed("write the directory of", output->name, diag);
}

void ph_output_discard(struct ph_output *output) {
  if (output->descriptor >= 0) {
    close(output->descriptor);
    output->descriptor = -1;
  }
  if (output->temporary) {
    unlink(output->temporary);
    forget(output);
  }
  ph_free(output->target);
  output->target = NULL;
}
