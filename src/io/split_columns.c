/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What the columns of CSV mean (see split.h): by --columns, by the header of
 * the file, or by the number of columns; and what delimits them.
 *
 * Of the cells, those of the first row are looked at: a header, or data.
 */
#include "io/split.h"

#include "base/mem.h"
#include "base/suggest.h"

#include <stdint.h>
#include <string.h>

/* ---- the names of columns ------------------------------------------- */

/* The one list of column names: what a column fills.  The first name of a
 * component is the one that messages use. */
static const struct {
  const char *name;
  int field;
  size_t component;
  bool vector; /* the field holds vectors */
} names[] = {
    {"id", PH_CSV_ID, 0, false},        {"x", PH_F_POINTS, 0, true},
    {"y", PH_F_POINTS, 1, true},        {"z", PH_F_POINTS, 2, true},
    {"x_m", PH_F_POINTS, 0, true},      {"y_m", PH_F_POINTS, 1, true},
    {"z_m", PH_F_POINTS, 2, true},      {"knot", PH_F_KNOTS, 0, false},
    {"alpha", PH_F_ALPHA, 0, false},    {"tension", PH_F_TENSION, 0, false},
    {"length", PH_F_LENGTHS, 0, false}, {"tx", PH_F_TANGENTS, 0, true},
    {"ty", PH_F_TANGENTS, 1, true},     {"tz", PH_F_TANGENTS, 2, true},
    {"dx", PH_F_DERIVATIVES, 0, true},  {"dy", PH_F_DERIVATIVES, 1, true},
    {"dz", PH_F_DERIVATIVES, 2, true},  {"lon", PH_F_LONLAT, 0, true},
    {"lat", PH_F_LONLAT, 1, true},      {"longitude", PH_F_LONLAT, 0, true},
    {"latitude", PH_F_LONLAT, 1, true}, {"rx", PH_F_RULINGS, 0, true},
    {"ry", PH_F_RULINGS, 1, true},      {"rz", PH_F_RULINGS, 2, true},
    {"nx", PH_F_NORMALS, 0, true},      {"ny", PH_F_NORMALS, 1, true},
    {"nz", PH_F_NORMALS, 2, true},
};

enum { NAMES = sizeof names / sizeof *names };

static const struct ph_field *row_of(const struct ph_schema *schema,
                                     int field) {
  for (size_t i = 0; i < schema->fields_n; i++) {
    if ((int)schema->fields[i].id == field) {
      return &schema->fields[i];
    }
  }
  return NULL;
}

/* Whether the command has a use for columns of names[i]. */
static bool is_used(const struct ph_schema *schema, size_t i) {
  const struct ph_field *row = row_of(schema, names[i].field);
  if (names[i].field == PH_CSV_ID) {
    return true;
  }
  if (!row) {
    return false;
  }
  return names[i].vector ? row->kinds & PH_VECTORS &&
                               row->dimensions >> (names[i].component + 1) != 0
                         : row->kinds & PH_NUMBERS;
}

/* The index of a name that the command knows, or NAMES. */
static size_t find_name(const struct ph_schema *schema, const char *text,
                        size_t n) {
  size_t i = 0;
  while (i < NAMES &&
         !(ph_word_is(text, n, names[i].name) && is_used(schema, i))) {
    i++;
  }
  return i;
}

/* ---- names of the user's own ----------------------------------------- */

/* Whether --columns says x=Easting,... : which columns are meant, by name. */
static bool by_name(const struct ph_split *split) {
  return split->options.columns && strchr(split->options.columns, '=');
}

/* The item NAME=HEADER of --columns whose HEADER a cell is, found by walking
 * through `text`; text when there is none.
 * out  name  what stands for */
static bool next_choice(const char **text, const char *end,
                        struct ph_csv_cell *name, struct ph_csv_cell *header) {
  struct ph_csv_cell item;
  const char *equals;
  if (*text > end) {
    return false;
  }
  *text = ph_csv_cell(*text, end, ',', &item) + 1;
  equals = item.n ? memchr(item.text, '=', item.n) : NULL;
  name->text = header->text = item.text;
  name->n = header->n = item.n;
  if (equals) {
    name->n = (size_t)(equals - item.text);
    header->text = equals + 1;
    header->n = item.n - name->n - 1;
  }
  return true;
}

/* Whether --columns chooses a cell of the header; what stands for then. */
static bool find_choice(const struct ph_split *split,
                        const struct ph_csv_cell *cell,
                        struct ph_csv_cell *name) {
  const char *text = split->options.columns, *end = text + strlen(text);
  struct ph_csv_cell header;
  while (next_choice(&text, end, name, &header)) {
    if (header.n == cell->n && memcmp(header.text, cell->text, cell->n) == 0) {
      return true;
    }
  }
  return false;
}

/* Whether a cell is a name of a column that is read. */
static bool is_name(const struct ph_split *split,
                    const struct ph_csv_cell *cell) {
  struct ph_csv_cell name;
  return by_name(split) ? find_choice(split, cell, &name)
                        : find_name(split->schema, cell->text, cell->n) < NAMES;
}

/* ---- lists of names ------------------------------------------------- */

struct list { /* of names being read */
  struct ph_split *split;
  bool option; /* of --columns */
  bool points; /* among them are coordinates */
  struct ph_diag *diag;
};

/* The field of the failures of a list, and what its reader can do. */
static const char *where(const struct list *list) {
  return list->option ? "--columns" : NULL;
}

static const char *advice(const struct list *list,
                          const struct ph_csv_cell *cell) {
  static const char *const wkt[] = {"wkt", "geom", "geometry", "the_geom"};
  for (size_t i = 0; i < sizeof wkt / sizeof *wkt; i++) {
    if (!list->points && ph_word_is(cell->text, cell->n, wkt[i])) {
      return " (ogr2ogr -f GeoJSON converts WKT)";
    }
  }
  return list->option   ? ""
         : list->points ? " (--ignore-columns skips it)"
         : row_of(list->split->schema, PH_F_LONLAT)
             ? " (--columns=lon=NAME,lat=NAME takes columns by their names)"
             : " (--columns=x=NAME,y=NAME takes columns by their names)";
}

static enum ph_status unknown_column(const struct list *list, size_t i,
                                     const struct ph_csv_cell *cell) {
  const struct ph_schema *schema = list->split->schema;
  struct ph_suggest suggest;
  char clause[PH_DID_YOU_MEAN_MAX], excerpt[PH_EXCERPT_MAX];
  const char *elsewhere = "";
  if (cell->n == 0) {
    return ph_fail(list->diag, PH_E_UNKNOWN_FIELD, where(list),
                   "column %zu has no name%s", i + 1, advice(list, cell));
  }
  ph_suggest_init(&suggest, cell->text, cell->n);
  for (size_t k = 0; k < NAMES; k++) {
    if (is_used(schema, k)) {
      ph_suggest_try(&suggest, names[k].name, strlen(names[k].name));
    } else if (names[k].field == PH_F_LONLAT &&
               ph_word_is(cell->text, cell->n, names[k].name)) {
      elsewhere = ", but not to sphere";
    }
  }
  ph_did_you_mean(&suggest, clause);
  return ph_fail(list->diag, PH_E_UNKNOWN_FIELD, where(list),
                 "column \"%s\" is unknown to %s%s%s%s",
                 ph_excerpt(cell->text, cell->n, excerpt), schema->command,
                 elsewhere, clause, *elsewhere ? "" : advice(list, cell));
}

/* Whether the numbers of columns of names[k] belong to segments. */
static bool is_of_segments(const struct ph_schema *schema, size_t k) {
  const struct ph_field *row = row_of(schema, names[k].field);
  return row && row->kinds & PH_SEGMENTS;
}

/* An item NAME=HEADER of --columns. */
static enum ph_status check_choice(const struct list *list,
                                   const struct ph_csv_cell *item,
                                   struct ph_csv_cell *name) {
  const char *equals = item->n ? memchr(item->text, '=', item->n) : NULL;
  char excerpt[PH_EXCERPT_MAX];
  *name = *item;
  if (!equals || equals == item->text || equals + 1 == item->text + item->n) {
    return ph_fail(list->diag, PH_E_USAGE, where(list),
                   "takes names of columns, or NAME=HEADER for all of them, "
                   "found \"%s\"",
                   ph_excerpt(item->text, item->n, excerpt));
  }
  name->n = (size_t)(equals - item->text);
  return PH_OK;
}

/* Whether a column is not for us, as some are; else what it is called here. */
static bool is_skipped(const struct list *list, const struct ph_csv_cell *cell,
                       const struct ph_csv_columns *columns,
                       struct ph_csv_cell *name) {
  const struct ph_split *split = list->split;
  size_t k;
  *name = *cell;
  if (list->option) {
    return cell->n == 1 && *cell->text == '-';
  }
  if (by_name(split)) {
    return !find_choice(split, cell, name);
  }
  k = find_name(split->schema, cell->text, cell->n);
  return columns->results
             ? k == NAMES || (names[k].field != PH_CSV_ID &&
                              names[k].field != PH_F_POINTS)
             : k == NAMES && split->options.ignore_columns && list->points;
}

/* Column i, which is named by a cell. */
static enum ph_status read_column(const struct list *list, size_t i,
                                  const struct ph_csv_cell *cell,
                                  struct ph_csv_columns *columns) {
  struct ph_csv_column *column = &columns->column[i];
  struct ph_csv_cell name;
  char excerpt[PH_EXCERPT_MAX];
  size_t k;
  if (is_skipped(list, cell, columns, &name)) {
    *column = (struct ph_csv_column){PH_CSV_SKIP, 0, "-", false};
    return PH_OK;
  }
  if (list->option && by_name(list->split) &&
      check_choice(list, cell, &name) != PH_OK) {
    return list->diag->status;
  }
  k = find_name(list->split->schema, name.text, name.n);
  if (k == NAMES) {
    return unknown_column(list, i, &name);
  }
  *column =
      (struct ph_csv_column){names[k].field, names[k].component, names[k].name,
                             is_of_segments(list->split->schema, k)};
  for (size_t j = 0; j < i; j++) {
    if (columns->column[j].field == column->field &&
        columns->column[j].component == column->component) {
      return ph_fail(list->diag, PH_E_BAD_VALUE, where(list),
                     "columns %zu and %zu (\"%s\") are the same%s", j + 1,
                     i + 1, ph_excerpt(cell->text, cell->n, excerpt),
                     list->option ? "" : " (--columns can skip it)");
    }
  }
  return PH_OK;
}

/* Whether each vector has all its components. */
static enum ph_status check_vectors(const struct list *list,
                                    const struct ph_csv_columns *columns) {
  unsigned have[PH_FIELD_N] = {0}; /* bit c: component c */
  for (size_t i = 0; i < columns->n; i++) {
    if (columns->column[i].field < PH_FIELD_N) {
      have[columns->column[i].field] |= 1u << columns->column[i].component;
    }
  }
  for (size_t k = 0; k < NAMES; k++) {
    const struct ph_field *row = row_of(list->split->schema, names[k].field);
    unsigned set = row && names[k].vector ? have[row->id] : 0;
    unsigned dimension = 0;
    while (set >> dimension) {
      dimension++;
    }
    /* The component is missing when a later one, or too little, is there. */
    if (set && !(set >> names[k].component & 1) &&
        (names[k].component < dimension ||
         (names[k].component == dimension &&
          !(row->dimensions >> dimension & 1)))) {
      return ph_fail(list->diag, PH_E_MISSING_FIELD, where(list),
                     "column \"%s\" is missing: %s needs it for %s",
                     names[k].name, list->split->schema->command,
                     ph_field_name(row->id));
    }
  }
  return PH_OK;
}

/* Whether the header has all that --columns chooses. */
static enum ph_status check_choices(const struct list *list, const char *p,
                                    const char *end, char separator) {
  const char *text = list->split->options.columns;
  const char *text_end = text + strlen(text);
  struct ph_csv_cell name, header;
  while (next_choice(&text, text_end, &name, &header)) {
    struct ph_suggest suggest;
    char clause[PH_DID_YOU_MEAN_MAX], excerpt[PH_EXCERPT_MAX];
    bool found = false;
    ph_suggest_init(&suggest, header.text, header.n);
    for (const char *at = p; at <= end; at++) {
      struct ph_csv_cell cell;
      at = ph_csv_cell(at, end, separator, &cell);
      found |=
          cell.n == header.n && memcmp(cell.text, header.text, cell.n) == 0;
      ph_suggest_try(&suggest, cell.text, cell.n);
    }
    if (!found) {
      ph_did_you_mean(&suggest, clause);
      return ph_fail(list->diag, PH_E_MISSING_FIELD, NULL,
                     "the header row has no column \"%s\", which --columns "
                     "names%s",
                     ph_excerpt(header.text, header.n, excerpt), clause);
    }
  }
  return PH_OK;
}

/* Whether a header is that of samples or control points (csv_out.h). */
static bool is_of_results(const struct ph_split *split, const char *p,
                          const char *end, char separator) {
  static const char *const first[] = {"id", "segment", "index"};
  size_t i = 0;
  if (split->options.columns || !row_of(split->schema, PH_F_POINTS)) {
    return false;
  }
  for (; i < 3 && p <= end; i++, p++) {
    struct ph_csv_cell cell;
    p = ph_csv_cell(p, end, separator, &cell);
    if (!ph_word_is(cell.text, cell.n, first[i]) &&
        !(i == PH_CSV_WITHIN && ph_word_is(cell.text, cell.n, "t"))) {
      return false;
    }
  }
  return i == 3;
}

static size_t count_cells(const char *p, const char *end, char separator) {
  struct ph_csv_cell cell;
  size_t n = 1;
  p = ph_csv_cell(p, end, separator, &cell);
  while (p < end) {
    p = ph_csv_cell(p + 1, end, separator, &cell);
    n++;
  }
  return n;
}

/* Whether there are coordinates among the names: those of vectors. */
static bool has_points(const struct ph_split *split, const char *p,
                       const char *end, char separator) {
  for (; p <= end; p++) {
    struct ph_csv_cell cell;
    size_t k;
    p = ph_csv_cell(p, end, separator, &cell);
    k = find_name(split->schema, cell.text, cell.n);
    if (k < NAMES && names[k].vector) {
      return true;
    }
  }
  return false;
}

enum ph_status ph_split_columns(struct ph_split *split, const char *text,
                                size_t n, char separator, bool option,
                                struct ph_csv_columns **columns,
                                struct ph_diag *diag) {
  const char *p = text;
  const char *end = ph_csv_row_end(text, text + n);
  struct list list = {split, option, has_points(split, text, end, separator),
                      diag};
  size_t cells = count_cells(p, end, separator);
  enum ph_status status = PH_OK;
  if (cells > (SIZE_MAX - sizeof **columns) / sizeof *(*columns)->column) {
    return ph_fail_memory(diag);
  }
  *columns = ph_malloc(sizeof **columns + cells * sizeof *(*columns)->column);
  if (!*columns) {
    return ph_fail_memory(diag);
  }
  (*columns)->older = split->all_columns;
  (*columns)->delimiter = split->delimiter;
  (*columns)->results = !option && is_of_results(split, text, end, separator);
  (*columns)->n = cells;
  split->all_columns = *columns;
  for (size_t i = 0; i < cells && status == PH_OK; i++) {
    struct ph_csv_cell cell;
    const char *after = ph_csv_cell(p, end, separator, &cell);
    status = read_column(&list, i, &cell, *columns);
    if (status != PH_OK) {
      diag->column = (size_t)(cell.text - cell.quoted - text) + 1;
    }
    p = after + 1;
  }
  if (status == PH_OK && !option && by_name(split)) {
    status = check_choices(&list, text, end, separator);
  }
  return status == PH_OK ? check_vectors(&list, *columns) : status;
}

/* ---- the first row -------------------------------------------------- */

/* What the cells of a row look like. */
struct census {
  size_t cells;
  size_t numbers;
  size_t commas; /* numbers but for a decimal comma */
  size_t names;
  size_t blanks;
};

/* Counts the cells of a row; with columns, those of fields only. */
static struct census take_census(const struct ph_split *split, const char *p,
                                 const char *end, char separator,
                                 const struct ph_csv_columns *columns) {
  struct census census = {0, 0, 0, 0, 0};
  end = ph_csv_row_end(p, end);
  for (;; p++) {
    struct ph_csv_cell cell;
    size_t i = census.cells++;
    double x;
    p = ph_csv_cell(p, end, separator, &cell);
    if (!columns || (i < columns->n && columns->column[i].field < PH_FIELD_N)) {
      census.blanks += cell.n == 0;
      census.numbers += ph_csv_number(cell.text, cell.n, &x);
      census.commas += ph_csv_decimal_comma(&cell);
      census.names += is_name(split, &cell);
    } else {
      census.blanks++;
    }
    if (p == end) {
      return census;
    }
  }
}

/* Whether a separator makes a header of the row, which may have names that are
 * to be ignored. */
static bool makes_header(const struct ph_split *split, const char *p,
                         const char *end, char separator, bool ignore) {
  const char *names_end = ph_csv_row_end(p, end);
  struct census census = take_census(split, p, end, separator, NULL);
  bool some = by_name(split) || (ignore && split->options.ignore_columns);
  return census.cells > 1 &&
         (census.names == census.cells || (some && census.names > 1) ||
          is_of_results(split, p, names_end, separator));
}

/* What separates the cells of a row, of which there should be `expected`, if it
 * is known: commas, unless something else gives that number of cells, or all
 * numbers, or all names; or where there is no comma. */
static char find_delimiter(const struct ph_split *split, const char *p,
                           const char *end, size_t expected) {
  static const char all[] = {',', ';', '\t', PH_CSV_WORDS};
  enum { ALL = sizeof all };
  struct census census[ALL];
  for (size_t i = 0; i < ALL; i++) {
    census[i] = take_census(split, p, end, all[i], NULL);
    if (expected > 1 && census[i].cells == expected) {
      return all[i];
    }
  }
  for (size_t i = 0; i < ALL; i++) {
    bool both = all[i] == '\t' && memchr(p, ' ', (size_t)(end - p));
    if (census[i].numbers > 0 && census[i].cells > 1 && !both &&
        census[i].numbers + census[i].blanks == census[i].cells) {
      return all[i];
    }
  }
  for (size_t i = 0; i < ALL; i++) {
    if (makes_header(split, p, end, all[i], true)) {
      return all[i];
    }
  }
  for (size_t i = 1; i < ALL; i++) {
    if (census[i].commas > 0 && census[i].cells > 1 &&
        census[i].numbers + census[i].commas + census[i].blanks ==
            census[i].cells) {
      return all[i];
    }
  }
  for (size_t i = 0; i + 1 < ALL; i++) { /* words may be those of a sentence */
    if (census[i].cells > 1) {
      return all[i];
    }
  }
  return ',';
}

void ph_split_find_delimiter(struct ph_split *split, const char *p,
                             const char *end) {
  struct ph_csv_columns *columns = split->csv.columns;
  size_t expected = columns ? columns->n : 0;
  if (split->options.columns && !by_name(split)) {
    const char *text = split->options.columns;
    expected = count_cells(text, text + strlen(text), ',');
  }
  split->delimiter = find_delimiter(split, p, end, expected);
  if (columns) {
    columns->delimiter = split->delimiter;
  }
}

/* The columns by --columns; *data: the first row is no header. */
static enum ph_status columns_by_option(struct ph_split *split, const char *row,
                                        const char *end, bool *data,
                                        struct ph_diag *diag) {
  const char *text = split->options.columns;
  struct census census;
  enum ph_status status = ph_split_columns(split, text, strlen(text), ',', true,
                                           &split->csv.columns, diag);
  if (status != PH_OK) {
    return status;
  }
  census = take_census(split, row, end, split->delimiter, split->csv.columns);
  *data = census.numbers > 0 || census.blanks == census.cells;
  if (census.cells > split->csv.columns->n) {
    return ph_fail(diag, PH_E_BAD_SHAPE, NULL,
                   "the row has %zu cells, but --columns names %zu "
                   "(- skips a column)",
                   census.cells, split->csv.columns->n);
  }
  return PH_OK;
}

/* The columns by the first row of a file: its header, or data. */
static enum ph_status columns_by_row(struct ph_split *split, const char *row,
                                     const char *end, bool *data,
                                     struct ph_diag *diag) {
  struct census census = take_census(split, row, end, split->delimiter, NULL);
  size_t numbers = census.numbers + census.commas;
  bool numeric = numbers > 0 && numbers + census.blanks == census.cells;
  char excerpt[PH_EXCERPT_MAX];
  enum ph_status status;
  *data = numbers > 0 && census.names == 0;
  if (!*data && census.cells == 1 && census.names == 0 && split->guessed) {
    const char *text_end = ph_csv_row_end(row, end);
    return ph_fail(diag, PH_E_SYNTAX, NULL,
                   "expected JSON, or CSV with a header row, found \"%s\"",
                   ph_excerpt(row, (size_t)(text_end - row), excerpt));
  }
  if (!*data) {
    return ph_split_columns(split, row, (size_t)(end - row), split->delimiter,
                            false, &split->csv.columns, diag);
  }
  if (by_name(split)) {
    return ph_fail(diag, PH_E_SYNTAX, NULL,
                   "the file has no header row with the names of --columns");
  }
  if (numeric && census.cells == 2 && row_of(split->schema, PH_F_LONLAT)) {
    return ph_fail(
        diag, PH_E_SYNTAX, NULL,
        "the file has no header row: --columns=lon,lat or "
        "--columns=lat,lon must say which of its 2 columns is which");
  }
  if (numeric && census.cells == 3 && !split->options.ignore_columns &&
      find_name(split->schema, "z", 1) == NAMES) {
    return ph_fail(diag, PH_E_UNKNOWN_FIELD, NULL,
                   "the file has no header row and 3 columns, and %s takes x "
                   "and y (--columns=x,y,- skips the third)",
                   split->schema->command);
  }
  if (numeric && (census.cells == 2 || census.cells == 3)) {
    status = ph_split_columns(split, "x,y,z", 2 * census.cells - 1, ',', false,
                              &split->csv.columns, diag);
    diag->column = 0; /* the name does not stand in the file */
    return status;
  }
  return ph_fail(diag, PH_E_SYNTAX, NULL,
                 "the file has no header row: --columns must name its %zu "
                 "column%s",
                 census.cells, census.cells == 1 ? "" : "s");
}

enum ph_status ph_split_find_columns(struct ph_split *split, bool *data,
                                     struct ph_diag *diag) {
  const char *row = split->data + split->start;
  const char *end = row + split->csv.scan.at;
  if (ph_split_is_foreign(row, end, diag)) {
    return diag->status;
  }
  return split->options.columns && !by_name(split)
             ? columns_by_option(split, row, end, data, diag)
             : columns_by_row(split, row, end, data, diag);
}

bool ph_split_is_header(const struct ph_split *split, const char *p,
                        const char *end, char *separator) {
  *separator = split->delimiter;
  if (split->options.columns && !by_name(split)) {
    return false;
  }
  if (split->delimiter == PH_CSV_ANY) {
    *separator = find_delimiter(split, p, end, 0);
  }
  return makes_header(split, p, end, *separator, false);
}
