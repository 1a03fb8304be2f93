/* How far a mistyped word is from one that is meant. */
#ifndef VX_FORMATS_WORD_H
#define VX_FORMATS_WORD_H

/* Letters to insert, delete or replace to make b of a (Levenshtein's distance); 99 where b has more than 62. */
int word_distance(const char *a, const char *b);

#endif
