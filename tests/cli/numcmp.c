/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * numcmp TOLERANCE FILE1 FILE2: compares two texts whose numbers may differ.
 *
 * Two numbers a, b agree when |a - b| <= TOLERANCE max(1, |a|, |b|); all other
 * bytes have to be equal.  So numbers near 0 are compared absolutely, as those
 * of data of size 1 have to be.  Exit status 1 and the place of the first
 * difference when the texts do not agree.
 */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static char *read_file(const char *name) {
  FILE *file = fopen(name, "r");
  size_t room = 1 << 16, n = 0;
  char *data = malloc(room);
  if (!file || !data) {
    fprintf(stderr, "numcmp: cannot read %s\n", name);
    exit(2);
  }
  for (size_t got; (got = fread(data + n, 1, room - n - 1, file)) > 0;) {
    n += got;
    if (n == room - 1) {
      char *more = realloc(data, room *= 2);
      if (!more) {
        exit(2);
      }
      data = more;
    }
  }
  data[n] = '\0';
  fclose(file);
  return data;
}

static int begins_number(const char *p) {
  return isdigit((unsigned char)p[*p == '-']);
}

static int agree(double a, double b, double tolerance) {
  double size = fmax(1, fmax(fabs(a), fabs(b)));
  return fabs(a - b) <= tolerance * size;
}

int main(int argc, char **argv) {
  char *a, *b;
  const char *p, *q;
  double tolerance;
  size_t line = 1;
  int differ;
  if (argc != 4) {
    fputs("usage: numcmp TOLERANCE FILE1 FILE2\n", stderr);
    return 2;
  }
  tolerance = strtod(argv[1], NULL);
  p = a = read_file(argv[2]);
  q = b = read_file(argv[3]);
  for (;;) {
    if (begins_number(p) && begins_number(q)) {
      char *p_end, *q_end;
      if (!agree(strtod(p, &p_end), strtod(q, &q_end), tolerance)) {
        break;
      }
      p = p_end;
      q = q_end;
    } else if (!*p || *p != *q) {
      break;
    } else {
      line += *p == '\n';
      p++;
      q++;
    }
  }
  differ = *p || *q;
  if (differ) {
    printf("line %zu: %.40s\n    and: %.40s\n", line, p, q);
  }
  free(a);
  free(b);
  return differ;
}
