/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * terminal TEXT COMMAND [ARGUMENT]...: runs a command whose standard input and
 * standard error are a terminal, at which TEXT is typed, and then the key that
 * ends the input.  What the command says there is copied to standard error.
 * The exit status is the command's, 128 and the signal that ended it, or 127.
 */
#define _XOPEN_SOURCE 700 /* posix_openpt and its kin */
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

static void fail(const char *what) {
  perror(what);
  exit(127);
}

/* The other end, which neither echoes what is typed nor changes line ends. */
static int open_plain(int master) {
  struct termios mode;
  int slave = open(ptsname(master), O_RDWR | O_NOCTTY);
  if (slave < 0 || tcgetattr(slave, &mode) != 0) {
    fail("terminal");
  }
  mode.c_lflag &= ~(tcflag_t)ECHO;
  mode.c_oflag &= ~(tcflag_t)OPOST;
  if (tcsetattr(slave, TCSANOW, &mode) != 0) {
    fail("terminal");
  }
  return slave;
}

/* Until the command has closed its end: an error, or an end of file. */
static void copy(int from, int to) {
  char buffer[4096];
  ssize_t n;
  while ((n = read(from, buffer, sizeof buffer)) > 0) {
    if (write(to, buffer, (size_t)n) != n) {
      fail("terminal");
    }
  }
}

int main(int argc, char **argv) {
  int master = posix_openpt(O_RDWR | O_NOCTTY);
  int slave, status = 0;
  pid_t child;
  if (argc < 3 || master < 0 || grantpt(master) != 0 || unlockpt(master) != 0) {
    fputs("usage: terminal TEXT COMMAND [ARGUMENT]...\n", stderr);
    return 127;
  }
  slave = open_plain(master);
  if (write(master, argv[1], strlen(argv[1])) < 0 ||
      write(master, "\004", 1) != 1) { /* ^D */
    fail("terminal");
  }
  child = fork();
  if (child == 0) {
    dup2(slave, STDIN_FILENO);
    dup2(slave, STDERR_FILENO);
    close(slave);
    close(master);
    execvp(argv[2], argv + 2);
    fail("terminal");
  }
  close(slave);
  copy(master, STDERR_FILENO);
  if (child < 0 || waitpid(child, &status, 0) < 0) {
    fail("terminal");
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}
