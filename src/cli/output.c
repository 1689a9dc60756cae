/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Standard output, or a file replaced at the end (see output.h). */
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

/* The temporary file for the signal handler; signals are blocked while it
 * changes. */
static char *volatile doomed;

static const int signals[] = {SIGINT,  SIGTERM, SIGHUP,
                              SIGPIPE, SIGQUIT, SIGXCPU};

/* As many symbolic links lead to a file at most. */
enum { LINKS_MAX = 40 };

/* So much of a file's name, which may have 255 bytes, is in the temporary's. */
enum { NAME_KEPT = 200 };

static void on_signal(int number) {
  if (doomed) {
    unlink(doomed);
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

static void set_doomed(char *name) {
  sigset_t set, old;
  sigemptyset(&set);
  for (size_t i = 0; i < sizeof signals / sizeof signals[0]; i++) {
    sigaddset(&set, signals[i]);
  }
  sigprocmask(SIG_BLOCK, &set, &old);
  doomed = name;
  sigprocmask(SIG_SETMASK, &old, NULL);
}

void ph_output_prepare(void) {
  for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++) {
    if (fcntl(fd, F_GETFD) < 0) { /* the wrong way round */
      open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
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
  return ph_fail(diag, PH_OUTPUT, NULL, "cannot %s %s: %s", what, name,
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

/* What a symbolic link points to is replaced or made, not the link. */
static char *resolve(const char *file) {
  char link[PATH_MAX];
  char *path = join("", 0, file);
  for (int i = 0; path && i < LINKS_MAX; i++) {
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

static enum ph_status open_temporary(struct ph_output *output,
                                     const struct stat *existing,
                                     struct ph_diag *diag) {
  sigset_t all, old;
  mode_t mask = umask(0);
  mode_t mode = existing ? existing->st_mode & 0777 : 0666 & ~mask;
  umask(mask);
  output->target = resolve(output->name);
  output->temporary = output->target ? temporary_name(output->target) : NULL;
  if (!output->temporary) {
    return ph_fail_memory(diag);
  }
  catch_signals();
  sigfillset(&all);
  sigprocmask(SIG_BLOCK, &all, &old); /* no signal between making and noting */
  output->descriptor = mkstemp(output->temporary);
  if (output->descriptor >= 0) {
    doomed = output->temporary;
  }
  sigprocmask(SIG_SETMASK, &old, NULL);
  if (output->descriptor < 0) {
    failed("create", output->name, diag);
    ph_free(output->temporary);
    output->temporary = NULL;
    return PH_OUTPUT;
  }
  if (existing &&
      fchown(output->descriptor, existing->st_uid, existing->st_gid) != 0) {
    /* only root can give files away: it is ours then */
  }
  if (fchmod(output->descriptor, mode) != 0) {
    return failed("set the mode of", output->name, diag);
  }
  return PH_OK;
}

enum ph_status ph_output_open(struct ph_output *output, const char *file,
                              struct ph_diag *diag) {
  struct stat info;
  bool exists;
  memset(output, 0, sizeof *output);
  output->descriptor = STDOUT_FILENO;
  output->name = "standard output";
  if (!file || strcmp(file, "-") == 0) {
    return PH_OK;
  }
  output->name = file;
  exists = stat(file, &info) == 0;
  if (!exists || S_ISREG(info.st_mode)) {
    return open_temporary(output, exists ? &info : NULL, diag);
  }
  output->descriptor = open(file, O_WRONLY | O_CLOEXEC);
  return output->descriptor >= 0 ? PH_OK : failed("open", file, diag);
}

enum ph_status ph_output_write(struct ph_output *output, const char *bytes,
                               size_t n, struct ph_diag *diag) {
  return ph_output_bytes(output->descriptor, bytes, n)
             ? PH_OK
             : failed("write", output->name, diag);
}

enum ph_status ph_output_commit(struct ph_output *output,
                                struct ph_diag *diag) {
  int descriptor = output->descriptor;
  output->descriptor = -1;
  if (close(descriptor) != 0) {
    return failed("write", output->name, diag);
  }
  if (output->temporary) {
    if (rename(output->temporary, output->target) != 0) {
      return failed("replace", output->name, diag);
    }
    set_doomed(NULL);
    ph_free(output->temporary);
    output->temporary = NULL;
  }
  return PH_OK;
}

void ph_output_discard(struct ph_output *output) {
  if (output->descriptor >= 0) {
    close(output->descriptor);
    output->descriptor = -1;
  }
  if (output->temporary) {
    unlink(output->temporary);
    set_doomed(NULL);
    ph_free(output->temporary);
    output->temporary = NULL;
  }
  ph_free(output->target);
  output->target = NULL;
}
