/* The key `sections` of the profile input: measured sections along the track and how bodies are made of them: profile-input(5). */
#ifndef VX_FORMATS_SECTIONS_TEXT_H
#define VX_FORMATS_SECTIONS_TEXT_H

#include "formats/slices.h"
#include "formats/yaml.h"

/* Where sections are named: a .slcs, an index beside numbered files, or one by one. */
struct sections_list {
    char *file;                    /* .slcs */
    char *index, *files;           /* numbers and stations; name with '*' for the number, beside the index */
    struct yaml_list list;         /* struct sections_entry */
};

struct sections_entry { double station; char *file; };
struct sections_name { char *name; };
struct sections_extra { char *name; struct sections_list from; };

struct sections_text {
    struct sections_list from;
    struct yaml_list extra;        /* struct sections_extra: bodies that stand in lists of their own */
    struct yaml_list names;        /* struct sections_name: of the bodies in the order in which they begin */
    int64_t reference;             /* section from 1, whose top is z = 0 and whose gauge face stands at half a gauge; 0 without this key */
    double position;               /* m, y of the sections' origin in track axes instead; 0 where the gauge says it */
    double at;                     /* m, station of the lists' 0 */
    double cut_depth;              /* m below the reference's top; deeper surface parts one body from the next */
    double every;                  /* m, most between two sections made; 0: where a body has moved 0.5 mm */
};

extern const struct yaml_schema sections_text_schema;

const char *sections_text_check(const struct sections_text *t);

/* Names of files, counted from the folder of input, become paths. */
const char *sections_text_place(struct sections_text *t, const char *input);

/* The sections a list names. */
const char *sections_text_slices(const struct sections_list *l, struct slices *s);

#endif
