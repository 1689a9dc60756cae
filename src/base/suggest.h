/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What messages say about a word of the input: the word itself, made safe to
 * print, and the name that was probably meant.
 */
#ifndef PH_BASE_SUGGEST_H
#define PH_BASE_SUGGEST_H

#include <stdbool.h>
#include <stddef.h>

/* An excerpt has at most 40 bytes, then "..." where it was cut; with room for
 * those and a zero. */
enum { PH_EXCERPT_MAX = 44 };

/* Room for the clause of ph_did_you_mean. */
enum { PH_DID_YOU_MEAN_MAX = 96 };

/*
 * ph_utf8_length: the length in bytes of the character that begins at p.
 *
 * in   p, end  p < end; never looks at or beyond end
 * ret  1..4; 0 when the bytes are not UTF-8 (RFC 3629: no overlong forms, no
 *      surrogates, nothing beyond U+10FFFF); -1 when they are the beginning of
 *      a character and the text ends inside it
 */
int ph_utf8_length(const char *p, const char *end);

/*
 * ph_shown_length: the length in bytes of the character that begins at p, if a
 * terminal or a page shows it as such; 0 otherwise.
 *
 * That is 0 of bytes that are not UTF-8, and of what has no width of its own
 * but an effect on the rest: control characters (U+0000 to U+001F, U+007F to
 * U+009F), marks of direction (U+061C, U+200E, U+200F, U+202A to U+202E, U+2066
 * to U+2069), line and paragraph separators (U+2028, U+2029), what is invisible
 * (U+200B to U+200D, U+2060 to U+2065, U+206A to U+206F, U+FEFF, U+E0000 to
 * U+E007F), U+FFFE and U+FFFF.
 *
 * in   p, end  p < end; never looks at or beyond end
 */
size_t ph_shown_length(const char *p, const char *end);

/*
 * ph_show: a text as messages show it: bytes of what is not shown (see above)
 * as \x1b, and cut where a character does not fit, with "...".
 *
 * out  shown[size]  NUL-terminated; size >= 4
 * ret  shown
 */
const char *ph_show(const char *text, size_t n, char *shown, size_t size);

/* ph_excerpt: ph_show of a word or two in the middle of a message. */
const char *ph_excerpt(const char *text, size_t n,
                       char excerpt[PH_EXCERPT_MAX]);

/* ph_word_is: whether word[n] is the name, upper and lower case alike. */
bool ph_word_is(const char *word, size_t n, const char *name);

/* The nearest name so far to a word that is none of the names. */
struct ph_suggest {
  const char *word;
  size_t n;
  const char *best; /* not NUL-terminated; NULL: none is near */
  size_t best_n;
  size_t distance; /* of best */
};

/* ph_suggest_init: begins the search for the name nearest to word[n]. */
void ph_suggest_init(struct ph_suggest *suggest, const char *word, size_t n);

/* ph_suggest_try: offers one name.  The first of equally near ones is kept;
 * a name is near when at most two letters are wrong (missing, superfluous,
 * replaced or swapped with their neighbour): fewer than the word has, and no
 * more than the name has; and nearest when it begins with the word, of three
 * letters at least. */
void ph_suggest_try(struct ph_suggest *suggest, const char *name, size_t n);

/* ph_suggest_list: offers every name of a list "a|b|c". */
void ph_suggest_list(struct ph_suggest *suggest, const char *names);

/*
 * ph_did_you_mean: the end of a message: ; did you mean "points"?
 *
 * out  clause  NUL-terminated; empty when no name is near
 * ret  whether one is
 */
bool ph_did_you_mean(const struct ph_suggest *suggest,
                     char clause[PH_DID_YOU_MEAN_MAX]);

#endif
