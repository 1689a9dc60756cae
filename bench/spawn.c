/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * spawn FILE COMMAND [ARGUMENT]...
 *
 * Runs a command with its output in FILE and prints what it took: wall seconds,
 * processor seconds, peak resident kilobytes.  Fails as the command does.  A
 * program of its own, because the peak of a new process begins with what the
 * process that started it had.
 */
#include "bench.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

static double wall(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double seconds(const struct timeval *t) {
  return (double)t->tv_sec + 1e-6 * (double)t->tv_usec;
}

static void become(const char *file, char **command) {
  int descriptor = open(file, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (descriptor < 0 || dup2(descriptor, STDOUT_FILENO) < 0) {
    perror(file);
    _exit(EXIT_FAILURE);
  }
  close(descriptor);
  execvp(command[0], command);
  perror(command[0]);
  _exit(EXIT_FAILURE);
}

int main(int argc, char **argv) {
  struct rusage usage;
  double start = wall(), elapsed;
  int status;
  pid_t child;
  if (argc < 3) {
    bench_die("spawn FILE COMMAND [ARGUMENT]...");
  }
  child = fork();
  if (child == 0) {
    become(argv[1], argv + 2);
  }
  if (child < 0 || waitpid(child, &status, 0) != child ||
      getrusage(RUSAGE_CHILDREN, &usage) != 0) {
    bench_die("cannot start a process");
  }
  elapsed = wall() - start;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    fprintf(stderr, "bench: %s failed\n", argv[2]);
    return WIFEXITED(status) ? WEXITSTATUS(status) : EXIT_FAILURE;
  }
  printf("%.6f %.6f %ld\n", elapsed,
         seconds(&usage.ru_utime) + seconds(&usage.ru_stime), usage.ru_maxrss);
  return 0;
}
