/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The members of the objects that records consist of, as one table (members.c):
 * results are written (json_out.c), read (json_result.c) and described
 * (cli/schema.c) by its rows.  A new member of a struct is a row; one of a type
 * of its own is also a form here, and a case where its forms are written and
 * read.
 */
#ifndef PH_IO_MEMBERS_H
#define PH_IO_MEMBERS_H

#include "curve/result.h"

/* The curves, or segments, that have a member. */
enum ph_of {
  PH_OF_ANY,
  PH_OF_ATPH,
  PH_OF_SQUARE,   /* with a preimage */
  PH_OF_CUBIC,    /* of Tschirnhausen */
  PH_OF_SPHERE,   /* on a sphere */
  PH_OF_FLAT,     /* all others */
  PH_OF_SPACE,    /* of these, those in space */
  PH_OF_RATIONAL, /* with rational offsets */
  PH_OF_QUOTIENT, /* with quotients in their place */
  PH_OF_TENSION,  /* segments that have one */
  PH_OF_INTERVALS,
  PH_OF_LENGTHS, /* curves of prescribed lengths */
  PH_OF_SURFACE,
  PH_OF_CIRCULAR,  /* strips of circular cones */
  PH_OF_GENERAL,   /* of other cones, or beside these */
  PH_OF_DIRECTRIX, /* of other cones */
  PH_OF_LOOPS,     /* offsets in the plane that were put together */
  PH_OF_RAW        /* offsets that were not */
};

enum ph_need {
  PH_MAY,  /* left out where it is not known */
  PH_TOLD, /* never left out, but a result can be read without */
  PH_MUST  /* never left out */
};

/* Where a member is, as offsets in the struct of its object. */
struct ph_where {
  enum {
    PH_AT,  /* here, or in the struct of arrays of a list here */
    PH_EACH /* in the array that there is a pointer to, NULL: nowhere */
  } how;
  size_t at;
  size_t n; /* 1 + where its number is; 0: there is one.  If this number is 0,
               it is left out, unless it is a list that may be empty */
  bool joined; /* PH_EACH: of a curve that is `joined', what one ends with is
                  what the next one begins with */
};

/*
 * A type is
 *
 *   a name of members.c, of an object or a struct ph_type, or of cli/schema.c
 *   [N]TYPE, an array of N, [+]TYPE, of one or more, []TYPE, of any number
 *
 * where N is a digit, or a letter of struct ph_sizes.
 */
struct ph_member {
  const char *name; /* NULL ends a list */
  enum ph_need need;
  enum ph_of of;
  const char *type;
  const struct ph_type *as; /* NULL: it is written and read apart */
  struct ph_where where;
  const char *what; /* NULL: a number that is told elsewhere */
};

struct ph_members {
  const char *name; /* of the object */
  bool shared;      /* it is the same for all commands and kinds */
  const struct ph_member *rows;
  size_t size; /* of its struct; 0: its members are in arrays */
};

/* ph_members_of: those of an object, which must be one of members.c. */
const struct ph_members *ph_members_of(const char *name);

/* ph_members_find: the same, or NULL. */
const struct ph_members *ph_members_find(const char *name);

/* ph_members_result: the object that a result is, by what it consists of. */
static inline const char *ph_members_result(enum ph_parts parts) {
  return parts == PH_SEGMENTS_PARTS ? "result"
         : parts == PH_STRIPS_PARTS ? "surface"
                                    : "patchwork";
}

/* ---- members in memory --------------------------------------------------- */

/* How a member is in memory. */
enum ph_form {
  PH_AS_NOTHING, /* it is APART */
  PH_AS_DOUBLE,
  PH_AS_RADIUS, /* a double, greater than 0 */
  PH_AS_SIZE,
  PH_AS_RANGE, /* two of these, the first and the last of something */
  PH_AS_SIGN,  /* signed char */
  PH_AS_FLAG,  /* bool */
  PH_AS_TEXT,
  PH_AS_VECTOR, /* a text, "e2" or "e3" */
  PH_AS_ENUM,   /* by its word */
  PH_AS_AMONG,  /* an index, or null: PH_NO_SEGMENT */
  PH_AS_KNOTS,  /* a number and that of the next segment */
  PH_AS_OPEN,   /* numbers, null in place of each that is not finite, and of all
                   if none is: NaN */
  PH_AS_LIST,   /* of structs */
  PH_AS_OBJECT, /* a struct */
  PH_AS_SEGMENTS,
  PH_AS_PIECES,
  PH_AS_BEZIERS,
  PH_AS_SAMPLES,
  PH_AS_IMAGES,
  PH_AS_BOUNDS, /* the intervals of pairs of strips */
  PH_AS_CERTIFICATE,
  PH_AS_DIAGNOSTIC_SET,
  PH_AS_WARNING_LIST
};

struct ph_type {
  const char *name; /* of the words, or the object */
  enum ph_form form;
  size_t size;
  size_t least, most; /* PH_AS_SIZE; PH_AS_ENUM: of the first word */
};

/* The numbers that types have letters for: D, the dimension of the curve; P, a
 * segment's control points; W, the coefficients of its preimage, of Q numbers
 * each; O, the control points of an offset's piece, L of a loop's; S, segments;
 * N, nodes of a spline on a sphere; I, intervals of the record. */
struct ph_sizes {
  size_t of['Z' - 'A' + 1];
  bool joined; /* the curve is */
};

/* A member of which it is known how it is in memory. */
struct ph_slot {
  const struct ph_member *row;
  enum ph_form form;
  bool numbers;        /* an array of any number of them */
  bool indirect;       /* where it is, there is a pointer to it */
  size_t n, dimension; /* numbers: n; n vectors of dimension; else 0 */
  size_t size;         /* of all in memory */
  size_t stride;       /* from one to the next */
  size_t most;         /* as of the type, or the last segment */
};

enum { PH_SLOTS_MAX = 25 };

/* No curve or offset that is written has a higher degree, by far. */
enum { PH_CLAIM_DEGREE_MAX = 15 };

/* ... and no patch by one parameter. */
#define PH_BIDEGREE_MAX 32

/* ph_sizes_enter: takes from a curve, offset or pieces what the members of its
 * segments, pieces or polynomial pieces are as large as. */
void ph_sizes_enter(struct ph_sizes *sizes, enum ph_form form,
                    const void *from);

/* ph_slots: the members of an object, but for those apart.  ret how many */
size_t ph_slots(const struct ph_members *of, const struct ph_sizes *sizes,
                struct ph_slot slots[PH_SLOTS_MAX]);

#endif
