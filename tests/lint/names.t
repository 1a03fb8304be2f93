#!/bin/sh
# Names that are not to be: functions without a check, folders without a subject, files of no use.
. tests/tap.sh

none()
{
    is "$1" "" "$2"
}

sources=$(find formats tools tests -name '*.[ch]')
none "$(grep -nE '\b(atoi|atol|atof|strcpy|strcat|sprintf|vsprintf|gets|rand|srand|strtok|system|popen|tmpnam)[[:space:]]*\(' $sources)" \
    "no function that cannot fail loudly"
none "$(find . -path ./.git -prune -o -path ./build -prune -o -path ./out -prune -o -type d \
    \( -name common -o -name utils -o -name util -o -name misc -o -name helpers -o -name lib \) -print)" "no folder without a subject"
none "$(find . -path ./.git -prune -o -path ./build -prune -o -path ./out -prune -o \
    \( -name '*.bak' -o -name '*.orig' -o -name '*.rej' -o -name '*~' \) -print)" "no files left over"
none "$(grep -nE '^#[[:space:]]*if[[:space:]]+0|TODO|FIXME|XXX' $sources | grep -v XXXXXX)" "nothing switched off or put off"
none "$(grep -nE '^[[:space:]]*typedef[[:space:]]+struct' $sources)" "no typedefs of structs"
none "$(grep -nE '\bfloat\b *[a-z*(]|\(float' $(find tools -name '*.[ch]' ! -path 'tools/draw/*' ! -path 'tools/integrate/record*.[ch]' ! -path 'tools/integrate/facing.c' ! -path 'tools/contact/row.[ch]' ! -path 'tools/contact/spot.h' ! -path 'tools/contact/link.[ch]' ! -path 'tools/contact/lookup.c' ! -path 'tools/contact/table.c') |
    grep -v '^[^:]*:[0-9]*: *\(/\*\| \*\)')" "float only where it is stored or drawn"
none "$(grep -nE '(/home/|/root/|/tmp/[a-z])' $(find formats tools pipelines data man -type f) Makefile)" "no path of one machine"
for f in $(find formats tools -name '*.c' ! -path 'tools/vx*'); do
    [ -f "${f%.c}.h" ] || grep -q "^/\* " "$f" || echo "$f"
done >"$dir/bare"
none "$(cat "$dir/bare")" "a source without a header of its own begins with what it is"
done_testing
