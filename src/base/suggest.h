/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What messages say about a word of the input: the word itself, made safe to
 * print, and the name that was probably meant.
 */
#ifndef PH_BASE_SUGGEST_H
#define PH_BASE_SUGGEST_H

#include <stdbool.h>
#include <stddef.h>

/* An excerpt has at most 40 bytes, then "..." where it was cut. */
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
 * ph_excerpt: a text of the input as messages show it: cut to 40 bytes at a
 * character boundary, control characters and bytes that are no UTF-8 as \x1b.
 *
 * out  excerpt  NUL-terminated
 * ret  excerpt
 */
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
 * more than the name has. */
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
