#!/bin/bash
# bench.sh FILE.tsv: CPU seconds, user and system, median of three, and memory, against the budget of each job and the limit that its
# smallest possible work was measured to take.  "-": there is none.  Prints the same as a table with the ratio to the limit.
#
# The jobs are those of users: a passage of 120 m in the turnout, contact tables, a receptance; then every stage of the demo alone.
set -e
out=${1:?usage: bench.sh FILE.tsv}
PATH=$PWD/build/bin:$PATH
export OPENBLAS_NUM_THREADS=1
unset VX_CACHE
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT

# cpu COMMAND...: seconds of one run, user and system.
cpu()
{
    local TIMEFORMAT='%3U %3S'
    { time "$@" >/dev/null 2>"$dir/err"; } 2>"$dir/time" || { cat "$dir/err" >&2; exit 1; }
    awk '{print $1 + $2}' "$dir/time"
}

# median COMMAND...
median()
{
    for _ in 1 2 3; do
        cpu "$@" || exit 1
    done | sort -g | sed -n 2p
}

# peak COMMAND...: MB.
peak()
{
    "$PWD/build/tests/bench/peak" "$@"
}

row()
{
    printf '%s\t%s\t%s\t%s\t%s\n' "$@" >>"$dir/tsv"
}

# job NAME BUDGET LIMIT COMMAND...: in seconds.
job()
{
    local name=$1 budget=$2 limit=$3 seconds
    shift 3
    seconds=$(median "$@")
    row "$name" "$seconds" s "$budget" "$limit"
}

# ---- what the jobs need ----

turnout=data/turnouts/60E1-R760-1-15.yaml
thirty='[{from: 0, to: 12, step: 0.75}, {from: 46, to: 48.4, step: 0.2}]'
for side in l r; do
    vxprofile --side $side -o "$dir/w$side.prof" data/profiles/S1002.yaml
    vxprofile --side $side -o "$dir/t$side.prof" $turnout
    vxcontact --wheel "$dir/w$side.prof" --rail "$dir/t$side.prof" --yaw exact -o "$dir/t$side.ctab"
done
# The rail that carries switch and nose: the left one diverging, the right one on the through route.
vxprofile --side l --set turnout.stations="$thirty" -o "$dir/thirty-l.prof" $turnout
vxprofile --side r --set turnout.stations="$thirty" --set turnout.route=through -o "$dir/thirty-r.prof" $turnout
vxprofile --side l -o "$dir/full-l.prof" $turnout
vxprofile --side r --set turnout.route=through -o "$dir/full-r.prof" $turnout
vxtrack -o "$dir/t.trk" data/tracks/60E1-R760-1-15-diverging.yaml
vxtrack --set from=-60 --set length=120 -o "$dir/straight.trk" data/tracks/thesis-straight.yaml
vxvehicle -o "$dir/coach.veh" data/vehicles/manchester-passenger.yaml

passage()
{
    vxrun --track "$dir/t.trk" --vehicle "$dir/coach.veh" --contact-left "$dir/tl.ctab" --contact-right "$dir/tr.ctab" "$@" \
        data/cases/diverging-80.yaml
}

# both_tables NAME: of NAME-l.prof and NAME-r.prof.
both_tables()
{
    for side in l r; do
        vxcontact --wheel "$dir/w$side.prof" --rail "$dir/$1-$side.prof" --yaw exact -o "$dir/$1-$side.ctab"
    done
}

# The largest forces of a variant: other railpads from the front of the switch on, the run-in of 31 m left out, no histories.
maxima='channels={wheels: false, bodies: false, pads: false, ballast: false, sleepers: false, rails: false}'
variant()
{
    passage --creep "$dir/f.creep" --start "$dir/s.state" --set "$maxima" "$@"
}

# variants N: in one process, N lines.
variants()
{
    for k in $(seq "$1"); do
        echo "-o $dir/v$k.run --track $dir/v$k.trk"
    done | variant --batch -
}

starts()
{
    for _ in 1 2 3 4 5 6 7 8 9 10; do
        passage --set end=-59.999 -o "$dir/start.run"
    done
}

# ---- the budgets ----

printf 'name\tvalue\tunit\tbudget\tlimit\n' >"$dir/tsv"
job "passage, 120 m, 80 km/h, FASTSIM 10x10" 0.6 0.43 passage -o "$dir/d.run"
vxcreep --table -o "$dir/f.creep"
job "the same with the fast creep law" 0.3 0.13 passage --creep "$dir/f.creep" -o "$dir/d.run"
"$PWD/build/tests/bench/creep" "$dir/f.creep" >"$dir/creep"
row "creep force, FASTSIM 10x10" "$(awk '$1 == "fastsim" {print $2}' "$dir/creep")" ns - 370
row "creep force, table" "$(awk '$1 == "table" {print $2}' "$dir/creep")" ns 100 -
for k in 1 2 3 4 5 6 7 8; do
    vxtrack --set zone.1.railpad.stiffness=$((40 * k))e6 -o "$dir/v$k.trk" data/tracks/60E1-R760-1-15-diverging.yaml
done
passage --creep "$dir/f.creep" --set end=-28 --save-state -29 -o "$dir/s.run"
job "variant restarted from 31 m, extremes alone" 0.15 0.03 variant --track "$dir/v1.trk" -o "$dir/v.run"
row "variant in a batch of eight" "$(median variants 8 | awk '{print $1/8}')" s 0.15 0.03
row "start-up" "$(median starts | awk '{print $1/10}')" s 0.03 -
job "contact table, 30 sections, 2 sides, 21 yaws, 0.1 mm" 3 - both_tables thirty
sections=$(vxinfo "$dir/full-l.prof" | awk '$2 == "station" {print $4}')
job "contact table, full turnout, $sections sections, 2 sides" 3 - both_tables full
mkdir "$dir/cache"
VX_CACHE=$dir/cache both_tables full
VX_CACHE=$dir/cache job "the same from the cache" - - both_tables full
"$PWD/build/tests/bench/lookup" "$dir/full-l.ctab" >"$dir/lookup"
row "contact look-up, along a run" "$(awk '$1 == "along" {print $2}' "$dir/lookup")" ns 150 -
row "contact look-up, at random" "$(awk '$1 == "random" {print $2}' "$dir/lookup")" ns 150 "$(awk '$1 == "chain" {print $2}' "$dir/lookup")"
job "receptance, 120 m track, 1451 frequencies" 0.5 0.17 \
    vxfreq --receptance --excite both --at sleeper --from 50 --to 1500 --step 1 "$dir/straight.trk"
job "assembly, 120 m, the straight track" 0.05 - vxtrack --set from=-60 --set length=120 -o "$dir/straight.trk" data/tracks/thesis-straight.yaml
fine="--set rail.mass_model=consistent --set rail.beam=timoshenko --set rail.elements_per_bay=8"
job "assembly, 120 m, Timoshenko, eight elements a bay" 0.05 - \
    vxtrack $fine --set from=-60 --set length=120 -o "$dir/fine.trk" data/tracks/thesis-straight.yaml
job "receptance of it, 1451 frequencies" - - vxfreq --receptance --from 50 --to 1500 -o "$dir/fine.frf" "$dir/fine.trk"

row "memory of vxtrack for it" "$(peak vxtrack $fine --set from=-60 --set length=120 -o "$dir/fine.trk" data/tracks/thesis-straight.yaml)" MB 100 -
row "memory of vxfreq for it" "$(peak vxfreq --receptance --from 50 --to 1500 -o "$dir/fine.frf" "$dir/fine.trk")" MB 100 -

# long METRES: assembly, eleven frequencies, one static solution.
long()
{
    vxtrack $fine --set length="$1" -o "$dir/long.trk" data/tracks/thesis-straight.yaml
    vxfreq --receptance --from 100 --to 1100 --step 100 -o "$dir/long.frf" "$dir/long.trk"
    vxfreq --static --load 1000 "$dir/long.trk"
}
# Linear in length: the seconds of a kilometre are those of the first ones.
for metres in 1200 2400 4800 10200; do
    seconds=$(median long $metres)
    row "track, 11 frequencies, statics: $metres m, eight elements" "$seconds" s - -
    first=${first:-$(awk -v s="$seconds" -v m=$metres 'BEGIN {print s/m}')}
    row "seconds of a metre of $metres m over those of 1200 m" "$(awk -v s="$seconds" -v m=$metres -v f="$first" 'BEGIN {print s/m/f}')" 1 - -
done
passage -v -o "$dir/d.run" 2>"$dir/account"
row "memory of one run" "$(sed -n 's/.*peak memory \([0-9]*\) MB.*/\1/p' "$dir/account")" MB 100 -

# ---- the stages of the demo, one command each ----

job "stage vxprofile, left turnout" - - vxprofile --side l -o "$dir/tl.prof" $turnout
job "stage vxcontact, left turnout" - - vxcontact --wheel "$dir/wl.prof" --rail "$dir/tl.prof" --yaw exact -o "$dir/tl.ctab"
job "stage vxtrack" - - vxtrack -o "$dir/t.trk" data/tracks/60E1-R760-1-15-diverging.yaml
job "stage vxvehicle" - - vxvehicle -o "$dir/coach.veh" data/vehicles/manchester-passenger.yaml
job "stage vxrun" - - passage -o "$dir/d.run"
job "stage vxpost, by zone" - - vxpost --table -o "$dir/zones.csv" "$dir/d.run"
job "stage vxplot, vertical forces" - - vxplot --figure vertical -o "$dir/vertical.png" "$dir/d.run"

mv "$dir/tsv" "$out"
awk -F'\t' '
    {
        ratio = NR == 1 ? "over limit" : $5 == "-" ? "-" : sprintf("%.2f", $2/$5)
        beyond = NR != 1 && $4 != "-" && $2 + 0 > $4 + 0 ? "  beyond its budget" : ""
        printf "%-56s %8s %-5s %7s %7s %11s%s\n", $1, $2, $3, $4, $5, ratio, beyond
    }' "$out"
