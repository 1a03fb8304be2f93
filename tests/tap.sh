# TAP for shell tests, sourced from the project root: . tests/tap.sh
#
# Programs are in build/bin, which is on PATH, without a cache of tables; $dir is a scratch folder that goes with the test.

unset VX_CACHE
PATH=$PWD/build/bin:$PATH
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT
tap_run=0
tap_failed=0

# ok STATUS WHAT: holds where STATUS is 0.
ok()
{
    tap_run=$((tap_run + 1))
    if [ "$1" -eq 0 ]; then
        echo "ok $tap_run - $2"
    else
        echo "not ok $tap_run - $2"
        tap_failed=$((tap_failed + 1))
    fi
}

# is GOT WANT WHAT
is()
{
    if [ "$1" = "$2" ]; then
        ok 0 "$3"
    else
        ok 1 "$3"
        printf 'got:\n%s\nshould be:\n%s\n' "$1" "$2" | sed 's/^/# /'
    fi
}

# like GOT PATTERN WHAT: the text holds the basic regular expression.
like()
{
    printf '%s\n' "$1" | grep -q -e "$2"
    tap_like=$?
    ok $tap_like "$3"
    [ $tap_like -eq 0 ] || printf 'got:\n%s\nshould match: %s\n' "$1" "$2" | sed 's/^/# /'
}

# between GOT LEAST MOST WHAT: a number within its bounds; says it.
between()
{
    echo "# $4: $1"
    awk -v got="$1" -v least="$2" -v most="$3" 'BEGIN {exit !(got ~ /^[-+.0-9]/ && got + 0 >= least + 0 && got + 0 <= most + 0)}'
    ok $? "$4: from $2 to $3"
}

# fails STATUS WHAT COMMAND...: this exit status, one line on stderr that begins with the program's name, nothing on stdout.
# The line stays in $dir/err.
fails()
{
    tap_want=$1 tap_what=$2
    shift 2
    "$@" >"$dir/out" 2>"$dir/err" </dev/null
    tap_got=$?
    tap_why=
    [ $tap_got -eq "$tap_want" ] || tap_why="exit status $tap_got, should be $tap_want"
    [ "$(wc -l <"$dir/err")" -eq 1 ] || tap_why="$tap_why; $(wc -l <"$dir/err") lines on stderr, should be one"
    grep -q "^${1##*/}: " "$dir/err" || tap_why="$tap_why; the line does not begin with ${1##*/}:"
    [ -s "$dir/out" ] && tap_why="$tap_why; there is something on stdout"
    [ -z "$tap_why" ]
    ok $? "$tap_what"
    [ -z "$tap_why" ] || { echo "$tap_why" | sed 's/^; //'; cat "$dir/err"; } | sed 's/^/# /'
}

# skip_all WHY: the whole test, where what it needs is absent.
skip_all()
{
    echo "1..0 # SKIP $1"
    exit 0
}

done_testing()
{
    echo "1..$tap_run"
    [ $tap_failed -eq 0 ]
    exit
}
