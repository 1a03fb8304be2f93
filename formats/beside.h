/* A file named by an input lies beside it, unless its name begins at the root. */
#ifndef VX_FORMATS_BESIDE_H
#define VX_FORMATS_BESIDE_H

/* The path, allocated; NULL without memory. */
char *beside_path(const char *file, const char *input);

/* The same in place of *file, which is allocated and may be NULL. */
const char *beside_place(char **file, const char *input);

#endif
