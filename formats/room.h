/* Zeroed memory that lives as long as the thing it is taken for, released at once: a chain that hangs on the thing's `store`. */
#ifndef VX_FORMATS_ROOM_H
#define VX_FORMATS_ROOM_H

#include <stddef.h>
#include <stdint.h>

/* Room for n items of this size, zeroed and aligned for any type; NULL without memory or where n * size overflows. */
void *room_take(void **store, int64_t n, size_t size);

/* Releases all of it; *store is NULL after. */
void room_release(void **store);

#endif
