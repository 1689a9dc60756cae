/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gauss-Legendre rules (see quad.h).  GSL has them to 27 digits up to 20
 * nodes; its handler is off (main), so that a failed allocation is NULL. */
#include "kernel/quad.h"

#include <gsl/gsl_integration.h>

bool ph_quad_gauss(struct ph_quad *rule, size_t n) {
  gsl_integration_glfixed_table *table = gsl_integration_glfixed_table_alloc(n);
  if (!table) {
    return false;
  }
  rule->n = n;
  for (size_t i = 0; i < n; i++) {
    gsl_integration_glfixed_point(0.0, 1.0, i, &rule->node[i], &rule->weight[i],
                                  table);
  }
  gsl_integration_glfixed_table_free(table);
  return true;
}
