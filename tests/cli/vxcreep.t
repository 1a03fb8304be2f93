#!/bin/sh
# vxcreep: published values, and misuse refused in one line, with nothing on standard output.
set -u
bin=$PWD/build/bin
tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT
n=0

# is STATUS NAME COMMAND...: the exit status, and for a failure one line on stderr and none on stdout.
is() {
    want=$1 name=$2; shift 2
    n=$((n + 1))
    "$@" >"$tmp/out" 2>"$tmp/err"; got=$?
    if [ $got -eq "$want" ] && { [ "$want" -eq 0 ] || { [ ! -s "$tmp/out" ] && [ "$(wc -l <"$tmp/err")" -eq 1 ]; }; }; then
        echo "ok $n - $name"
    else
        echo "not ok $n - $name"
        echo "# exit $got, should be $want"; sed 's/^/# /' "$tmp/out" "$tmp/err" | head -5
    fi
}

# force COLUMN WANT WITHIN NAME: a column of the last output.
force() {
    n=$((n + 1))
    awk -v c="$1" -v want="$2" -v tol="$3" 'NR == 2 { d = $c - want; exit !(d <= tol && -d <= tol) }' "$tmp/out" &&
        echo "ok $n - $4" || { echo "not ok $n - $4"; sed 's/^/# /' "$tmp/out"; }
}

contact="--a 0.008 --b 0.004 --N 82000 --mu 0.3"
is 0 "the example of the man page" "$bin/vxcreep" $contact --xi 0 --eta -6.25e-4 --phi 0.625 --method exact --grid 44
n=$((n + 1)); head -1 "$tmp/out" | grep -q '^Fx\[N\].Fy\[N\].Mz\[N.m\]$' && echo "ok $n - has a header of names and units" || echo "not ok $n - header"
force 2 14942 62 "Fy is 0.6074 mu N within a quarter of a per cent of mu N (published, 44 elements)"
is 0 "the same by FASTSIM" "$bin/vxcreep" $contact --xi 0 --eta -6.25e-4 --phi 0.625
force 2 14942 1230 "within 0.05 mu N"
is 0 "a table" "$bin/vxcreep" --table --grid 20 -o "$tmp/t.creep"
is 0 "the same by table" "$bin/vxcreep" $contact --xi 0 --eta -6.25e-4 --phi 0.625 --method table "$tmp/t.creep"
force 2 14942 1230 "within 0.05 mu N"
is 0 "a check of the table" "$bin/vxcreep" --check 10000 --grid 20 "$tmp/t.creep"
n=$((n + 1)); awk 'NR == 2 {exit !($1 == 10000 && $2 < 0.012 && $3 < 0.1)}' "$tmp/out" && echo "ok $n - within 0.012 mu N rms" || echo "not ok $n - check"
is 0 "the table again" "$bin/vxcreep" --table --grid 20 -o "$tmp/u.creep"
n=$((n + 1)); cmp -s "$tmp/t.creep" "$tmp/u.creep" && echo "ok $n - has the same bytes" || echo "not ok $n - bytes"
is 0 "a sliding contact" "$bin/vxcreep" $contact --xi 0.5 --eta 0 --phi 0
force 1 24600 1e-6 "carries mu N, forwards where the wheel slips forwards"
is 0 "nothing moves" "$bin/vxcreep" $contact --xi 0 --eta 0 --phi 0
force 1 0 0 "no force"
is 0 "a small creepage" "$bin/vxcreep" --a 0.005 --b 0.005 --N 80000 --mu 0.3 --xi 1e-8 --eta 0 --phi 0 --poisson 0.25
force 1 0.08446 0.0012 "Fx = G a b C11 xi, C11 = 4.12"

is 0 "-h" "$bin/vxcreep" -h
n=$((n + 1)); grep -q '^vxcreep --a M --b M --N N --mu X --xi X --eta X --phi RADPM' "$tmp/out" && echo "ok $n - is the synopsis" || echo "not ok $n - -h"
is 2 "a seed without a check" "$bin/vxcreep" $contact --xi 0 --eta 0 --phi 0 --seed 2
is 2 "a shear modulus of a table" "$bin/vxcreep" --table --shear 8e10 -o "$tmp/none.creep"
is 2 "no option" "$bin/vxcreep"
is 2 "a creepage missing" "$bin/vxcreep" $contact --xi 0 --eta 0
is 2 "a negative axis" "$bin/vxcreep" --a -1 --b 0.004 --N 82000 --mu 0.3 --xi 0 --eta 0 --phi 0
is 2 "a number with a unit" "$bin/vxcreep" $contact --xi 0.1% --eta 0 --phi 0
is 2 "not a number" "$bin/vxcreep" $contact --xi nan --eta 0 --phi 0
is 2 "no grid" "$bin/vxcreep" $contact --xi 0 --eta 0 --phi 0 --grid 0
is 2 "half a grid" "$bin/vxcreep" $contact --xi 0 --eta 0 --phi 0 --grid 10.5
is 2 "an unknown method" "$bin/vxcreep" $contact --xi 0 --eta 0 --phi 0 --method polach
is 2 "a table that is not named" "$bin/vxcreep" $contact --xi 0 --eta 0 --phi 0 --method table
is 2 "a table of a table" "$bin/vxcreep" --table --method table
is 2 "a table of one contact" "$bin/vxcreep" --table --a 0.008
is 2 "table and check" "$bin/vxcreep" --table --check 10 "$tmp/t.creep"
is 2 "the exact theory on one element" "$bin/vxcreep" --table --method exact --grid 1
is 1 "no table there" "$bin/vxcreep" --check 10 "$tmp/none.creep"
head -c 4000 "$tmp/t.creep" >"$tmp/cut.creep"
is 1 "a table cut short" "$bin/vxcreep" --check 10 "$tmp/cut.creep"
is 1 "not a table" "$bin/vxcreep" --check 10 tests/cli/vxcreep.t
is 2 "an operand" "$bin/vxcreep" $contact --xi 0 --eta 0 --phi 0 extra
is 1 "a full disk" sh -c "'$bin/vxcreep' $contact --xi 0 --eta 0 --phi 0 >/dev/full"
echo "1..$n"
