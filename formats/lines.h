/* A text file, line by line, so that a refusal can say which. */
#ifndef VX_FORMATS_LINES_H
#define VX_FORMATS_LINES_H

/* Gives each line of the file, with its end, to `line`, until that returns a reason, which then has "line N: " before it.  Numbers count
 * from 1; a line that holds a 0 byte is refused.  path "-" is standard input. */
const char *lines_read(const char *path, const char *(*line)(void *to, long number, char *text), void *to);

#endif
