/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * defaults COMMAND [ARGUMENT]...: runs a command, in its own process, with the
 * signals as a shell at a terminal leaves them.  Elsewhere SIGPIPE may be
 * ignored, and a shell ignores SIGINT for what it runs in the background.
 */
#include <signal.h>
#include <stdio.h>
#include <unistd.h>

int main(int argc, char **argv) {
  static const int signals[] = {SIGHUP, SIGINT, SIGPIPE, SIGQUIT, SIGTERM};
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, NULL);
  for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) {
    signal(signals[i], SIG_DFL);
  }
  if (argc > 1) {
    execvp(argv[1], argv + 1);
  }
  perror("defaults");
  return 127;
}
