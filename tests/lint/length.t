#!/bin/sh
# Short files, short functions.  The ten longest functions are printed.
. tests/tap.sh

# "lines file:line name", a line for each function; its braces stand in the first column.
functions()
{
    awk '
        FNR == 1 {name = ""}
        /^[a-zA-Z_].*\(/ && !/;[ \t]*$/ {name = $0; sub(/\(.*/, "", name); sub(/.*[ *]/, "", name); from = FNR}
        /^\{/ {open = FNR}
        /^\}/ && name != "" {print FNR - open - 1, FILENAME ":" from, name; name = ""}' "$@"
}

functions $(find formats tools -name '*.c') | sort -rn >"$dir/functions"
head -n 10 "$dir/functions" | sed 's/^/# /'
awk '{n[NR] = $1} END {print "# " NR " functions, median " n[int((NR + 1) / 2)] " lines"}' "$dir/functions"
is "$(awk '$1 > 60' "$dir/functions")" "" "no function is longer than 60 lines"
is "$(grep ' main$' "$dir/functions" | awk '$1 > 60')" "" "no main is longer than 60 lines"
is "$(wc -l tools/vx*.c | awk '$1 > 300 && $2 != "total"')" "" "no program is longer than 300 lines"
is "$(wc -l $(find formats tools -name '*.h') | awk '$1 > 150 && $2 != "total"')" "" "no header is longer than 150 lines"
is "$(awk 'length($0) > 160 {print FILENAME ":" FNR ": " length($0) " columns"}' $(find formats tools tests -name '*.[ch]'))" "" "no line is longer than 160 columns"
is "$(grep -nE '[[:space:]]+$|	' $(find formats tools -name '*.[ch]') | cut -c 1-100)" "" "no tabs, nothing behind a line"
done_testing
