#!/bin/sh
# vxrun: what it takes, where it finds its inputs, and what it refuses without leaving a file.
. tests/tap.sh
. tests/passage.sh

plain_tables && coach
ok $? "contact tables and coach"
vxtrack --set from=-60 --set length=120 -o "$dir/t.trk" data/tracks/thesis-straight.yaml
ok $? "track"
mkdir "$dir/cases"
cat >"$dir/cases/plain.yaml" <<'END'
case:
  name: plain
  track: ../t.trk
  vehicle: ../coach.veh
  contact_left: ../l.ctab
  contact_right: ../r.ctab
  speed_kmh: 80
  start: -30
  end: -29
END
plain=$dir/cases/plain.yaml

vxrun -o "$dir/a.run" "$plain"
ok $? "files that a case names lie beside the case"
grep -v 'track:\|vehicle:\|contact_' "$plain" >"$dir/bare.yaml"
vxrun --track "$dir/t.trk" --vehicle "$dir/coach.veh" --contact-left "$dir/l.ctab" --contact-right "$dir/r.ctab" -o "$dir/b.run" "$dir/bare.yaml"
ok $? "or are named on the command line"
vxcmp "$dir/a.run" "$dir/b.run" >/dev/null
ok $? "with the same result"
(cd "$dir/cases" && vxrun plain.yaml) | vxinfo - >"$dir/info"
ok $? "from its own folder, to standard output"
vxrun --set step=5e-5 -v -o "$dir/c.run" "$plain" >"$dir/out" 2>"$dir/err"
[ ! -s "$dir/out" ] && grep -q '^vxrun: 900 steps of 5e-05 s, limit 0.00017' "$dir/err"
ok $? "-v tells steps and limit on standard error"
grep -q '^vxrun: track explicit, 1200 degrees of freedom, 1.00 rounds of forces a step: lumped' "$dir/err"
ok $? "and which scheme moves the track, and why"
grep -q "^vxrun: wheels' work on the track [0-9.]* J: lost [0-9.]*, stored [-0-9.e]*, missing [0-9.]*e-0[4-9] of the loss" "$dir/err"
ok $? "and the account of its energy"
vxinfo --history "$dir/c.run" | grep -q 'vxrun --set step=5e-05 -v\|vxrun --set step=5e-5 -v'
ok $? "--set is part of the history"
records() { vxinfo "$1" | sed -n 's/^records *\([0-9]*\) .*/\1/p'; }
is "$(records "$dir/a.run")" 46 "46 samples at 1 kHz: 45 ms and the start"
vxrun --set sampling=1e7 -o "$dir/d.run" "$plain"
is "$(records "$dir/d.run")" 451 "every step where the sampling is finer"
vxrun --set channels.wheels=false --set channels.bodies=false --set channels.pads=false --set channels.ballast=false \
    --set channels.sleepers=false --set channels.rails=false -o "$dir/e.run" "$plain"
is "$(vxinfo "$dir/e.run" | awk '$1 == "series" {print $2}' | tr '\n' ' ')" "time station " "no channel but time and station"
vxpost --wheels "$dir/a.run" >"$dir/wheels.csv"
vxpost --wheels "$dir/e.run" | cmp -s - "$dir/wheels.csv"
ok $? "extremes do not depend on the channels kept"

# Friction: a number everywhere, an item of friction_on that holds everywhere, and a falling one that does not fall.
vxrun --set friction=0.1 -o "$dir/low.run" "$plain"
sed 's/^  end: .*/&\n  friction_on: [{friction: 0.1, side: left}, {friction: 0.1, side: right}]/' "$plain" >"$dir/cases/on.yaml"
vxrun -o "$dir/on.run" "$dir/cases/on.yaml"
vxdump --csv "$dir/low.run" wheel.T >"$dir/low.csv" && vxdump --csv "$dir/on.run" wheel.T | cmp -s - "$dir/low.csv"
ok $? "friction_on both sides is friction"
vxrun --set falling.limit=0.4 --set falling.decay=0 -o "$dir/level.run" "$plain"
vxcmp "$dir/level.run" "$dir/a.run" >/dev/null
ok $? "friction that does not fall is constant"
vxrun --set falling.limit=0.01 --set falling.decay=1e3 -o "$dir/fallen.run" "$plain"
! vxcmp "$dir/fallen.run" "$dir/a.run" >/dev/null
ok $? "friction that falls is not"

# Creep forces by table: named by the case or the option, near those of FASTSIM.
vxcreep --table --grid 20 -o "$dir/f.creep"
vxrun --creep "$dir/f.creep" -o "$dir/g.run" "$plain"
ok $? "--creep takes a table"
vxrun --set creep=../f.creep -o "$dir/h.run" "$plain" && vxcmp "$dir/g.run" "$dir/h.run" >/dev/null
ok $? "as does the case"
! vxcmp "$dir/a.run" "$dir/g.run" >/dev/null
ok $? "which is not FASTSIM"
vxcreep --table --grid 5 --poisson 0.3 -o "$dir/p.creep"
fails 1 "a table of another Poisson's ratio is refused" vxrun --creep "$dir/p.creep" -o "$dir/i.run" "$plain"
fails 1 "so is what is no table" vxrun --creep "$dir/t.trk" -o "$dir/i.run" "$plain"

vxrun --master >"$dir/master.yaml"
sed -e 's/name: .*/name: x/' -e 's/speed_kmh: .*/speed_kmh: 80/' -e '/^  dip:/,$d' "$dir/master.yaml" >"$dir/filled.yaml"
fails 2 "the master filled in, without a dip, lacks only its files" vxrun "$dir/filled.yaml"
like "$(cat "$dir/err")" "names no .trk file, and --track is not given" "and says so"
vxrun --schema | grep -q '^contact.law	word	-	hertz|linear	hertz	'
ok $? "--schema names the keys with range and default"

# The page's table is the schema's.
vxrun --schema | awk -F'\t' 'NR > 1 {words = $4; gsub(/[|]/, ", ", words)
    print ".It " $1 " Ta " $3 " Ta " $5 " Ta " $6 ($2 == "word" ? " (" words ")" : "")}' >"$dir/schema"
is "$(sed -n '/^\.It Sy key/,/^\.El/{/^\.It Sy key/d; /^\.El/d; p}' man/case-input.5 | diff - "$dir/schema")" "" "case-input(5) has the keys of --schema"

# refuses STATUS WORD WHAT ARGUMENT...: and leaves neither a .run nor a .part.
refuses()
{
    status=$1 word=$2 what=$3
    shift 3
    fails $status "$what" vxrun -o "$dir/x.run" "$@"
    like "$(cat "$dir/err")" "$word" "... $word"
    [ -e "$dir/x.run" ] || [ -e "$dir/x.run.part" ]
    [ $? -ne 0 ]
    ok $? "... and leaves no file"
}

fails 2 "no case" vxrun
fails 2 "two cases" vxrun "$plain" "$plain"
fails 2 "--schema with --master" vxrun --schema --master
fails 2 "--schema with a case" vxrun --schema "$plain"
fails 2 "--master with --set" vxrun --master --set step=1e-4
refuses 1 "No such file" "a case that is not there" "$dir/none.yaml"
refuses 2 "names no .trk file" "no track" "$dir/bare.yaml"
sed 's/speed_kmh: 80/speed_kmh: 80 km\/h/' "$plain" >"$dir/cases/unit.yaml"
refuses 1 "^vxrun: $dir/cases/unit.yaml:7:14: error: " "a unit in a number" "$dir/cases/unit.yaml"
sed 's/start:/strat:/' "$plain" >"$dir/cases/key.yaml"
refuses 1 "^vxrun: $dir/cases/key.yaml:8:3: error: unknown key strat in case, did you mean start?" "an unknown key" "$dir/cases/key.yaml"
sed '/speed_kmh/d' "$plain" >"$dir/cases/missing.yaml"
refuses 1 "speed_kmh" "a missing key" "$dir/cases/missing.yaml"
refuses 1 "stepp" "an unknown key in --set" --set stepp=1 "$plain"
refuses 1 "at least\|>= 1" "no speed" --set speed_kmh=0 "$plain"
refuses 1 "one of explicit" "a scheme that is not built" --set scheme=newmark "$plain"
refuses 1 "one of facing" "a direction there is not" --set direction=backwards "$plain"
refuses 1 "must lie before start" "a trailing end beyond its start" --set direction=trailing "$plain"
refuses 1 "a .veh file where a .trk file is wanted" "the wrong kind" --track "$dir/coach.veh" "$plain"
vxtrack -o "$dir/mass.trk" data/tracks/moving-mass.yaml
vxrun --track "$dir/mass.trk" -o "$dir/m.run" "$plain"
ok $? "a moving mass goes with the train"
refuses 1 "explicit scheme wants" "one in explicit steps" --track "$dir/mass.trk" --set scheme=explicit "$plain"
refuses 1 "a .ctab file where a .veh file is wanted" "another" --vehicle "$dir/l.ctab" "$plain"
refuses 1 "the route is diverging, but this track has no curve" "a straight track for the diverging route" --set route=diverging "$plain"
refuses 1 "r.ctab: is of side r, but --contact-left wants side l" "a table of the other side" --contact-left "$dir/r.ctab" "$plain"
refuses 1 "r.ctab: is of side r, but --contact-left wants side l" "both exchanged" --contact-left "$dir/r.ctab" --contact-right "$dir/l.ctab" "$plain"
head -c 100000 "$dir/l.ctab" >"$dir/cut.ctab"
refuses 1 "cut.ctab: truncated" "a table cut short" --contact-left "$dir/cut.ctab" "$plain"
refuses 1 "beyond the limit of the explicit scheme" "too long a step" --set scheme=explicit --set step=2e-4 "$plain"
refuses 1 "train_scheme: implicit wants scheme: implicit" "an implicit train on an explicit track" --set train_scheme=implicit --set scheme=explicit "$plain"
refuses 1 "limit of the wheelsets' spin at 1.39 m/s" "too long a step for so low a speed" --set speed_kmh=5 "$plain"
refuses 1 "the last wheelset would start at -71.56 m" "a start before the track" --set start=-50 "$plain"
refuses 1 "the front wheelset would end at 60.00 m" "an end beyond it" --set end=60 "$plain"
refuses 1 "must lie beyond start" "an end before the start" --set end=-31 "$plain"
refuses 1 "not a whole number of steps" "samples between steps" --set sampling=3000 "$plain"
vxvehicle --set wheelset.1.radius=0.45 --set coupling.1.at=[0,1.0,0.45] -o "$dir/small.veh" data/vehicles/manchester-passenger.yaml
refuses 1 "wheelset 1 has radius 0.45 m" "a wheel that is not the table's" --vehicle "$dir/small.veh" "$plain"
vxtrack --set from=-60 --set length=120 --set rail.elements_per_bay=2 -o "$dir/fine.trk" data/tracks/thesis-straight.yaml
refuses 1 "one rail node above every sleeper" "a finer track" --set scheme=explicit --track "$dir/fine.trk" "$plain"
for model in mass_model=consistent beam=timoshenko; do
    vxtrack --set from=-60 --set length=120 --set rail.$model -o "$dir/fine.trk" data/tracks/thesis-straight.yaml
    refuses 1 "wants lumped Euler-Bernoulli rails" "a track with $model" --set scheme=explicit --track "$dir/fine.trk" "$plain"
    vxrun -v --track "$dir/fine.trk" -o "$dir/f.run" "$plain" 2>"$dir/err"
    is "$? $(grep -c '^vxrun: track implicit, .*wants lumped Euler-Bernoulli rails' "$dir/err")" "0 1" "... which scheme: auto takes, and says why"
done
vxtrack --set from=-60 --set length=120 --set 'curve=[{from: -40, curvature: 0.05}]' -o "$dir/curve.trk" data/tracks/thesis-straight.yaml
refuses 1 "no quasi-static equilibrium found" "a start in a curve that no flange holds" --track "$dir/curve.trk" "$plain"

printf 'station (m), cross_level (mm)\n-100, 0.1\n100, 0.2\n' >"$dir/cases/level.csv"
printf 'station (m), gauge (mm)\n1, 0.1\n2, 0.2\n' >"$dir/cases/short.csv"
flawed()
{
    printf "$3" >"$dir/cases/flawed.csv"
    refuses 1 "flawed.csv: $1" "an irregularity with $2" --set irregularity.file=flawed.csv "$plain"
}
flawed "line 1: a heading must name each column" "no units" 'station, gauge\n1, 2\n'
flawed "line 1: unit of column 'gauge' must be m or mm, is 'cm'" "an odd unit" 'station (m), gauge (cm)\n1, 2\n'
flawed "line 1: column 'twist' is none of" "a quantity that is not known" 'station (m), twist (m)\n'
flawed "line 1: column 'gauge' is there twice" "a column twice" 'station (m), gauge (m), gauge (m)\n'
flawed "line 1: column 'station' is missing" "no station" 'gauge (m)\n1\n'
flawed "line 1: no column beside the station" "stations alone" 'station (m)\n1\n'
flawed "line 3: station 1 m must lie beyond" "a station twice" 'station (m), gauge (m)\n1, 0\n1, 0\n'
flawed "line 2: 'x' is not a number" "a word" 'station (m), gauge (m)\n1, x\n'
flawed "line 2: 'nan' is not a number" "nan" 'station (m), gauge (m)\n1, nan\n'
flawed "line 2: should be 2 numbers between commas" "a third number" 'station (m), gauge (m)\n1, 2, 3\n'
flawed "fewer than two lines" "one line" 'station (m), gauge (m)\n1, 2\n'
refuses 1 "irregularity: reaches from 1 to 2 m, but" "an irregularity that is too short" --set irregularity.file=short.csv "$plain"
refuses 1 "none.csv: No such file" "an irregularity that is not there" --set irregularity.file=none.csv "$plain"
refuses 1 "file and spectrum exclude each other" "irregularity twice" --set irregularity.file=level.csv --set irregularity.spectrum=erri-low "$plain"
refuses 1 "error: friction_on.1.from: 20 m lies beyond to, 10 m" "friction on nothing" --set 'friction_on=[{friction: 0.1, from: 20, to: 10}]' "$plain"
refuses 1 "shortest, 80 m, must be below longest" "wavelengths the wrong way" --set irregularity.spectrum=erri-low --set irregularity.shortest=80 "$plain"
refuses 1 "wheel_flat.1.wheelset is 9, but the vehicle has" "a flat on no wheelset" --set 'wheel_flat=[{wheelset: 9, length: 0.05}]' "$plain"
refuses 1 "--save-state: 20 m is not on the way from -30 to -29 m" "a state beyond the end" --save-state 20 "$plain"
fails 1 "a full disk" vxrun -o /dev/full "$plain"
vxrun "$plain" >/dev/full 2>"$dir/err"
is "$? $(cat "$dir/err")" "1 vxrun: standard output: write error: No space left on device" "a full standard output"
fails 1 "a folder that is not there" vxrun -o "$dir/no/x.run" "$plain"

# A wheel that leaves its table on the way: the .part keeps what was done, for those who want to see why.
for side in l r; do
    vxcontact --wheel "$dir/w$side.prof" --rail "$dir/r$side.prof" --yaw exact --u-max 0.004 -o "$dir/narrow-$side.ctab"
done
vxtrack --set from=-60 --set length=120 --set 'curve=[{from: -29, curvature: 0.002}]' -o "$dir/curve.trk" data/tracks/thesis-straight.yaml
fails 1 "a wheel that leaves its rail" vxrun --track "$dir/curve.trk" --contact-left "$dir/narrow-l.ctab" --contact-right "$dir/narrow-r.ctab" \
    --set end=30 -o "$dir/x.run" "$plain"
like "$(cat "$dir/err")" 'wheelset 1, .* wheel, station -[0-9.]* m: the wheel is .* mm beside its rail' "says where"
[ ! -e "$dir/x.run" ]
ok $? "leaves no .run"
is "$(vxinfo "$dir/x.run.part" | head -n 1 | grep -c 'NOT COMPLETE')" 1 "but a .part"
at=$(sed -n 's/.*station \(-[0-9.]*\) m.*/\1/p' "$dir/err")
last=$(vxdump --csv "$dir/x.run.part" station | tail -n 1)
between "$last" "$(echo "$at" | awk '{print $1 - 0.023}')" "$at" "with samples up to there"
like "$(vxinfo "$dir/x.state" | grep '^FAILED=')" 'wheelset 1, .* beside its rail' "and the state of the step that failed, with the reason"
fails 1 "from which no run goes on" vxrun --track "$dir/curve.trk" --start "$dir/x.state" --set end=30 -o "$dir/y.run" "$plain"
like "$(cat "$dir/err")" 'is what a run that failed has left' "which is said"
# A batch, whose lines are checked before any runs.
echo "-o $dir/v1.run" >"$dir/batch"
batch()
{
    status=$1 word=$2 what=$3
    shift 3
    fails $status "$what" vxrun "$@"
    like "$(cat "$dir/err")" "$word" "... $word"
}
batch 2 "--batch: every line names its own -o" "-o beside --batch" --batch "$dir/batch" -o "$dir/v0.run" "$plain"
batch 2 "--jobs does not go with a run" "--jobs alone" --jobs 2 "$plain"
batch 2 "--jobs must be from 1 to 64" "no job" --batch "$dir/batch" --jobs 0 "$plain"
batch 1 "none: No such file" "a batch that is not there" --batch "$dir/none" "$plain"
printf '# nothing\n\n' >"$dir/empty"
batch 1 "empty: has no variant" "a batch without a line" --batch "$dir/empty" "$plain"
echo "--set end=-20" >"$dir/nameless"
batch 1 "nameless: line 1: wants an output of its own, -o FILE" "a line without an output" --batch "$dir/nameless" "$plain"
printf '%s\n\n%s\n' "-o $dir/v1.run" "-o $dir/v1.run --set end=-20" >"$dir/twice"
batch 1 "v1.run is the output of line 1 too" "two lines with one output" --batch "$dir/twice" "$plain"
batch 1 "none.trk: No such file" "a batch whose own command has no track" --batch "$dir/batch" --track "$dir/none.trk" "$plain"
[ ! -e "$dir/v0.run" ] && [ ! -e "$dir/v1.run" ]
ok $? "none has run"
fails 2 "--schema with --start" vxrun --schema --start x.state
fails 2 "--save-state without -o" vxrun --save-state -29.5 "$plain"
done_testing
