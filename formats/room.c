#include "formats/room.h"

#include <stdlib.h>

/* The room after its head, which points to the room before it and keeps the alignment of malloc. */
union head {
    union head *next;
    max_align_t align;
};

void *room_take(void **store, int64_t n, size_t size)
{
    if (n < 0 || (uint64_t)n > (SIZE_MAX - sizeof(union head)) / size)
        return NULL;
    union head *h = calloc(1, sizeof *h + (size_t)n * size);
    if (!h)
        return NULL;
    h->next = *store;
    *store = h;
    return h + 1;
}

void room_release(void **store)
{
    for (union head *h = *store, *next; h; h = next) {
        next = h->next;
        free(h);
    }
    *store = NULL;
}
