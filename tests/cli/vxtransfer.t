#!/bin/sh
# vxtransfer: what it writes, and what it refuses.
. tests/tap.sh
. tests/passage.sh

vxtrack -o "$dir/s.trk" data/tracks/thesis-straight.yaml
hammer() { vxrun --track "$dir/s.trk" --set step=1e-4 --set sampling=1e4 --set force.duration=2 --set force.blows=2 "$@" data/cases/hammer.yaml; }
hammer -o "$dir/h.run"
ok $? "a run with a prescribed force"
is "$(vxinfo "$dir/h.run" | awk '$1 == "series" {print $2}' | tr '\n' ' ')" "time station force.F probe.z " "has force and probes"
is "$(vxdump --csv "$dir/h.run" probe.x probe.on | awk -F, 'NR > 1 {printf "%.3f %d ", $1, $2}')" "0.300 0 0.600 0 0.300 3 " "where the case wants them"
is "$(vxdump --csv "$dir/h.run" force.F | sed 1d | awk '$1 > m {m = $1} END {printf "%.3f", m}')" "904.508" "the force at its samples"

vxtransfer --to 500 -o "$dir/a.frf" "$dir/h.run" && vxinfo "$dir/a.frf" >"$dir/info"
ok $? "to a file"
like "$(cat "$dir/info")" "^FORCE= both" "says what was loaded"
like "$(cat "$dir/info")" "^array  *coherence  *f64  *0 " "without coherence of one segment"
like "$(cat "$dir/info")" "^CMD= vxrun" "with its history"
hammer | vxtransfer --to 500 - >"$dir/b.frf"
vxcmp "$dir/a.frf" "$dir/b.frf" >/dev/null
ok $? "in a pipe, the same"
vxtransfer --segment 1 --to 500 "$dir/h.run" | vxinfo - | grep -q '^array  *coherence  *f64  *491 '
ok $? "with coherence of two segments"
vxtransfer --probe 3 "$dir/h.run" | vxinfo - | grep -q '^MOTION= sleeper'
ok $? "of another probe"
vxtransfer --segment 1 "$dir/h.run" | vxplot - >"$dir/h.png" && [ -s "$dir/h.png" ]
ok $? "drawn with its coherence"

plain_tables && coach
vxtrack --set from=-60 --set length=120 -o "$dir/t.trk" data/tracks/thesis-straight.yaml
cat >"$dir/train.yaml" <<'END'
case: {name: train, track: t.trk, vehicle: coach.veh, contact_left: l.ctab, contact_right: r.ctab, speed_kmh: 80, start: -30, end: -29.9}
END
vxrun -o "$dir/train.run" "$dir/train.yaml"

# refuses STATUS WORD WHAT ARGUMENT...
refuses()
{
    status=$1 word=$2 what=$3
    shift 3
    fails $status "$what" vxtransfer -o "$dir/x.frf" "$@"
    like "$(cat "$dir/err")" "$word" "... $word"
    [ ! -e "$dir/x.frf" ]
    ok $? "... and leaves no file"
}
refuses 1 "a train ran here" "a train" "$dir/train.run"
refuses 1 "the run has 3" "a probe that is not there" --probe 4 "$dir/h.run"
refuses 1 "not multiples of 1 Hz" "frequencies between bins" --segment 1 --step 0.5 "$dir/h.run"
refuses 1 "is not within the" "a segment longer than the run" --segment 3 "$dir/h.run"
refuses 1 "beyond half the sampling rate" "too high a frequency" --to 6000 "$dir/h.run"
refuses 2 "lies below" "a range the wrong way" --from 100 --to 50 "$dir/h.run"
refuses 1 "a .trk file where a .run file is wanted" "another kind" "$dir/s.trk"
fails 1 "a full disk" vxtransfer -o /dev/full "$dir/h.run"

# What vxrun makes of such a case.
refuses_run()
{
    word=$1 what=$2
    shift 2
    fails 1 "$what" vxrun --track "$dir/s.trk" -o "$dir/x.run" "$@" data/cases/hammer.yaml
    like "$(cat "$dir/err")" "$word" "... $word"
}
refuses_run "instead of vehicle" "a vehicle beside the force" --vehicle "$dir/coach.veh"
refuses_run "force.at: 20 m is not on the rails" "a force beside the track" --set force.at=20
refuses_run "probe.2.at: -15 m is not on the rails" "a probe beside the track" --set probe.2.at=-15
vxtrack -o "$dir/mass.trk" data/tracks/moving-mass.yaml
fails 1 "a force on a moving mass" vxrun --track "$dir/mass.trk" data/cases/hammer.yaml
like "$(cat "$dir/err")" "fixed in space" "... fixed in space"
refuses_run "leaves nothing" "a rest as long as all" --set force.kind=noise --set force.rest=4
refuses_run "must lie beyond force.from" "a band the wrong way" --set force.to=10
refuses_run "beyond the limit of the explicit scheme" "too long a step" --set scheme=explicit --set step=2e-4 --set sampling=5e3
vxpost --balance "$dir/h.run" >"$dir/out" 2>"$dir/err"
is "$?" 1 "there is no balance of a track without a train"
vxpost --wheels "$dir/h.run" | wc -l | grep -qx ' *1'
ok $? "nor a wheel"
done_testing
