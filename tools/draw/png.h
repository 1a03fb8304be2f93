/* A picture as a PNG file: the same bytes for the same picture, no date in it. */
#ifndef VX_DRAW_PNG_H
#define VX_DRAW_PNG_H

#include <stdio.h>

/* rgb [height][width][3]; the resolution makes it 16 cm wide in print; history (or NULL) goes in as a comment. */
const char *png_put(FILE *out, int width, int height, const unsigned char *rgb, const char *history);

#endif
