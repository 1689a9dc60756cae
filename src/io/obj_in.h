/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Meshes in the OBJ format as problems: a file is a problem. */
#ifndef PH_IO_OBJ_IN_H
#define PH_IO_OBJ_IN_H

#include "base/mem.h"
#include "io/record.h"

/*
 * ph_obj_in: reads points (v), normals (vn) and faces (f) into the fields of
 * these names.
 *
 * Numbers of points and normals count from 1, or with a minus sign from the
 * last one before that line backwards.  Normals are those that corners of faces
 * name; all corners at a point must have the same one, or none at all has any.
 * Comments, groups, names, materials, texture coordinates, lines and points are
 * ignored; other words, as of free-form curves, are refused.  A backslash joins
 * a line to the next one.
 *
 * in   record   text of OBJ (record->mesh) whose status is PH_OK
 * out  problem  faces have three corners or more
 * ret  PH_OK | PH_E_SYNTAX | PH_E_BAD_VALUE | PH_E_BAD_SHAPE |
 *      PH_E_NOT_FINITE | PH_E_NO_MEMORY; diag has the line, and unless the
 *      words of a line are wrong, the field
 */
enum ph_status ph_obj_in(const struct ph_record *record,
                         const struct ph_schema *schema, struct ph_arena *arena,
                         struct ph_problem *problem, struct ph_diag *diag);

/* ph_obj_line: the line of points[i], normals[i] or faces[i], as
 * ph_record_line. */
size_t ph_obj_line(const struct ph_record *record, const char *path);

#endif
