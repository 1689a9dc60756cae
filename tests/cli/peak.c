/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * peak FILE COMMAND [ARGUMENT]...: runs a command and writes to FILE how much
 * memory it held at most, in kB (ru_maxrss of Linux and the BSDs).  The exit
 * status is the command's, 128 and the signal that ended it, or 127.
 */
#define _DEFAULT_SOURCE /* wait4, struct rusage */
#include <stdio.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

int main(int argc, char **argv) {
  struct rusage usage;
  int status = 0;
  pid_t child;
  FILE *file;
  if (argc < 3) {
    fputs("usage: peak FILE COMMAND [ARGUMENT]...\n", stderr);
    return 127;
  }
  child = fork();
  if (child == 0) {
    execvp(argv[2], argv + 2);
    perror("peak");
    _exit(127);
  }
  file = fopen(argv[1], "w");
  if (child < 0 || !file || wait4(child, &status, 0, &usage) < 0) {
    perror("peak");
    return 127;
  }
  fprintf(file, "%ld\n", usage.ru_maxrss);
  if (fclose(file) != 0) {
    return 127;
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}
