/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of commands (see command.h). */
#include "cli/command.h"

#include "curve/offset.h"
#include "solve/planar.h"

#include <string.h>

const struct ph_command ph_commands[] = {
    {&ph_method_planar, ph_cert_planar, ph_offset_planar,
     "printf '0,0\\n2,1\\n3,0\\n5,2\\n' | phspline planar\n"
     "phspline planar --closed --columns=x,y,-,- track.csv\n"
     "phspline planar --closed --offset=0.5 track.csv | jq .length\n"
     "phspline planar -f csv --table=lengths problems.jsonl -o lengths.csv\n"},
};

const size_t ph_commands_n = sizeof ph_commands / sizeof ph_commands[0];

const struct ph_command *ph_command_find(const char *name) {
  for (size_t i = 0; i < ph_commands_n; i++) {
    if (strcmp(ph_commands[i].method->schema.command, name) == 0) {
      return &ph_commands[i];
    }
  }
  return NULL;
}
