#!/bin/sh
# A receptance test in time against the direct receptance of the same track: the time integration against a method that knows no time.
. tests/tap.sh

vxtrack -o "$dir/s.trk" data/tracks/thesis-straight.yaml
ok $? "track"

# hammer NAME SETTING...: its run
hammer()
{
    name=$1
    shift
    vxrun --track "$dir/s.trk" "$@" -o "$dir/$name.run" data/cases/hammer.yaml
}

# compare A.frf B.frf: the largest |a - b|/|b| from 30 to 1500 Hz, the same outside 880 to 935 Hz, and to 800 Hz, in per cent
compare()
{
    vxdump --csv "$1" frequency "${3:-receptance}" | sed 1d >"$dir/a.csv"
    vxdump --csv "$2" frequency "${3:-receptance}" | sed 1d >"$dir/b.csv"
    awk -F, '
        function keep(k) {if (e > most[k]) most[k] = e}
        NR == FNR {re[$1] = $2; im[$1] = $3; next}
        $1 >= 30 && $1 <= 1500 && $1 in re {
            n++
            e = 100*sqrt((re[$1] - $2)^2 + (im[$1] - $3)^2)/sqrt($2^2 + $3^2)
            keep(1)
            if ($1 < 880 || $1 > 935) keep(2)
            if ($1 <= 800) keep(3)
        }
        END {if (n == 1471) print most[1], most[2], most[3]}' "$dir/a.csv" "$dir/b.csv"
}

hammer sleeper --set force.blows=1
ok $? "a blow above a sleeper"
hammer midspan --set force.blows=1 --set force.at=0.6 --set 'probe=[{at: 0.6}]'
ok $? "and one between two"
for at in sleeper midspan; do
    vxtransfer -o "$dir/t.frf" "$dir/$at.run"
    [ $at = midspan ] && x=0.6 || x=0.3
    vxfreq --receptance --at $x -o "$dir/d.frf" "$dir/s.trk"
    set -- $(compare "$dir/t.frf" "$dir/d.frf")
    between "$2" 0 1 "$at, outside 880 to 935 Hz, per cent"
    [ $at = midspan ] || between "$1" 0 1 "$at, all from 30 to 1500 Hz, per cent"
    between "$3" 0 0.05 "$at, up to 800 Hz, per cent"
done
set -- $(compare "$dir/t.frf" "$dir/d.frf" hermite)
between "$2" 0 1 "midspan by Hermite's polynomials, outside 880 to 935 Hz, per cent"

# Twice the step, four times the difference.
vxtransfer -o "$dir/t.frf" "$dir/sleeper.run"
vxfreq --receptance --at sleeper -o "$dir/d.frf" "$dir/s.trk"
fine=$(compare "$dir/t.frf" "$dir/d.frf" | cut -d' ' -f2)
hammer coarse --set force.blows=1 --set step=2e-5 --set sampling=5e4
vxtransfer -o "$dir/t.frf" "$dir/coarse.run"
between "$(compare "$dir/t.frf" "$dir/d.frf" | awk -v fine="$fine" '{print $2/fine}')" 3.8 4.2 "with twice the step the difference grows by"

# The implicit scheme, on the same track and on one that only it can move.
hammer implicit --set force.blows=1 --set force.duration=1 --set scheme=implicit
vxtransfer -o "$dir/t.frf" "$dir/implicit.run"
between "$(compare "$dir/t.frf" "$dir/d.frf" | cut -d' ' -f1)" 0 1 "implicit, sleeper, all from 30 to 1500 Hz, per cent"
vxtrack --set rail.mass_model=consistent --set rail.elements_per_bay=2 -o "$dir/c.trk" data/tracks/thesis-straight.yaml
for x in 0.3 0.6; do
    vxrun --track "$dir/c.trk" --set force.blows=1 --set force.duration=1 --set scheme=implicit --set force.at=$x --set 'probe=[]' -o "$dir/c.run" \
        data/cases/hammer.yaml
    vxtransfer -o "$dir/t.frf" "$dir/c.run"
    vxfreq --receptance --at $x -o "$dir/d.frf" "$dir/c.trk"
    between "$(compare "$dir/t.frf" "$dir/d.frf" | cut -d" " -f3)" 0 1 "implicit, consistent mass, at $x m, up to 800 Hz, per cent"
done

# Elsewhere: the right rail half a bay ahead under a force on the left one, and the sleeper.
hammer cross --set force.blows=1 --set force.rail=left --set 'probe=[{on: right, at: 0.6}, {on: sleeper, at: 0.3}]'
vxtransfer -o "$dir/t.frf" "$dir/cross.run"
vxfreq --receptance --excite left --at 0.3 --motion right --motion-at 0.6 -o "$dir/d.frf" "$dir/s.trk"
set -- $(compare "$dir/t.frf" "$dir/d.frf")
between "$2" 0 3 "across the track, outside 880 to 935 Hz, per cent"
between "$3" 0 1 "across the track, up to 800 Hz, per cent"
vxtransfer --probe 2 -o "$dir/t.frf" "$dir/cross.run"
vxfreq --receptance --excite left --at sleeper --motion sleeper -o "$dir/d.frf" "$dir/s.trk"
between "$(compare "$dir/t.frf" "$dir/d.frf" | cut -d' ' -f3)" 0 1 "the sleeper, up to 800 Hz, per cent"

# Other forces: a sweep with a rest, and noise in segments.
vxfreq --receptance --at sleeper -o "$dir/d.frf" "$dir/s.trk"
hammer sweep --set force.kind=sweep --set force.from=5 --set force.to=1600 --set force.duration=5 --set force.rest=1
vxtransfer -o "$dir/t.frf" "$dir/sweep.run"
between "$(compare "$dir/t.frf" "$dir/d.frf" | cut -d' ' -f1)" 0 1 "a sweep, all from 30 to 1500 Hz, per cent"
hammer noise --set force.kind=noise --set force.duration=10 --set step=2e-5 --set sampling=5e4
vxtransfer --segment 1 --window hann -o "$dir/t.frf" "$dir/noise.run" 2>"$dir/said"
like "$(cat "$dir/said")" '9 of 1491 frequencies are left out.* from 19 to 1500 Hz' "noise from 20 Hz on says nothing below"
vxtransfer --from 20 --segment 1 --window hann -o "$dir/t.frf" "$dir/noise.run"
vxfreq --receptance --at sleeper --from 20 -o "$dir/d.frf" "$dir/s.trk"
between "$(compare "$dir/t.frf" "$dir/d.frf" | cut -d' ' -f3)" 0 2 "noise, up to 800 Hz, per cent"
between "$(vxdump --csv "$dir/t.frf" coherence | sed 1d | sort -g | head -n 1)" 0.99 1 "its lowest coherence"
done_testing
