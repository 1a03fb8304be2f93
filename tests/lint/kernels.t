#!/bin/sh
# Kernels compute: no input or output, no exit, no globals, no units but SI.
. tests/tap.sh

# The source without comments and strings, with its line numbers.
code()
{
    awk '
        {
            line = $0
            gsub(/\\./, "", line)
            gsub(/"[^"]*"/, "\"\"", line)
            out = ""
            while (length(line)) {
                if (comment) {
                    at = index(line, "*/")
                    if (!at) {line = ""; break}
                    line = substr(line, at + 2); comment = 0
                } else {
                    at = index(line, "/*")
                    if (!at) {out = out line; line = ""; break}
                    out = out substr(line, 1, at - 1); line = substr(line, at + 2); comment = 1
                }
            }
            if (out ~ /[^ \t]/) print FILENAME ":" FNR ": " out
        }' "$1"
}

for f in $(find tools -mindepth 2 -name '*.[ch]' ! -path 'tools/cli/*' | sort); do
    code "$f"
done >"$dir/kernels"

is "$(grep -E '[^a-z_](printf|fprintf|puts|putchar|perror|fopen|freopen|open|scanf|fscanf|exit|_exit|abort|getenv|signal)[ ]*\(' "$dir/kernels" |
    grep -v '^tools/draw/')" "" "no kernel reads, prints or exits"
is "$(grep -E '[^a-z_](printf|puts|putchar|perror|exit|_exit|abort)[ ]*\(' "$dir/kernels")" "" "drawing neither prints nor exits"
is "$(grep -E '^[^:]*:[0-9]*: (.*[^0-9.eE_a-zA-Z])?(3\.6|3600|180)(\.0*)?([^0-9.eE]|$)' "$dir/kernels" | grep -v '^tools/draw/')" "" "no kernel converts units"
is "$(grep -E ': (static )?(double|int|int64_t|size_t|char|struct [a-z_]+) [*a-z_A-Z0-9]+(\[[^]]*\])?( =[^(]*)?;' "$dir/kernels" |
    grep -E ':[0-9]+: [a-z]' | grep -v -e ': const' -e ': static const')" "" "no kernel keeps a global"
is "$(grep -nE '\b(time|clock|clock_gettime|gettimeofday|gethostname|getpid)[ ]*\(' $(find formats tools -name '*.c') | grep -v '^tools/vxrun.c')" "" \
    "nothing depends on when or where it runs"
done_testing
