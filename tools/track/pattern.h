/* The entries of a banded matrix, full and symmetric, marked one by one and then listed by column. */
#ifndef VX_TRACK_PATTERN_H
#define VX_TRACK_PATTERN_H

#include <stdint.h>

struct pattern {
    int64_t dofs;
    int64_t half;             /* bandwidth: |i - j| of the entries at most */
    unsigned char *mark;      /* [dofs][2 half + 1] column j, row i at i - j + half */
};

const char *pattern_new(struct pattern *p, int64_t dofs, int64_t half);
void pattern_free(struct pattern *p);

void pattern_mark(struct pattern *p, int64_t i, int64_t j);
int64_t pattern_count(const struct pattern *p);

/* Ap [dofs + 1], Ai [count] rows increasing in each column. */
void pattern_list(const struct pattern *p, int64_t *Ap, int64_t *Ai);

#endif
