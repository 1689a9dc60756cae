/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Texts that come from outside, made fit for a page. */
#ifndef PH_PLOT_TEXT_H
#define PH_PLOT_TEXT_H

#include <stddef.h>

struct ph_page;

enum { PH_PLOT_TEXT_MAX = 256 };

/*
 * ph_plot_text: valid UTF-8, all of which is shown (ph_shown_length); a byte or
 * character that is not becomes a question mark.
 *
 * out  clean  NUL-terminated; with "..." at the end when there was more
 */
void ph_plot_text(const char *text, char clean[PH_PLOT_TEXT_MAX]);

/* ph_plot_text_number: a whole number. */
void ph_plot_text_number(size_t number, char text[PH_PLOT_TEXT_MAX]);

/* ph_plot_text_round: if the text is a number, and has more than 6 digits,
 * rounds what it has after the point to 6 significant digits. */
void ph_plot_text_round(char text[PH_PLOT_TEXT_MAX]);

/* ph_plot_text_fit: shortens a clean text, at its end and with "...", until it
 * is no wider than `width` in letters of a size. */
void ph_plot_text_fit(struct ph_page *page, double size, double width,
                      char clean[PH_PLOT_TEXT_MAX]);

#endif
