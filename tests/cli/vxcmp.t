#!/bin/sh
# vxcmp: same, different, trouble.
. tests/tap.sh

input=data/tracks/thesis-straight.yaml
vxtrack -o "$dir/a.trk" $input
vxtrack --set name=thesis-table-1 -o "$dir/same.trk" $input
vxtrack --set name=other -o "$dir/name.trk" $input
vxtrack --set railpad.stiffness=300.3e6 -o "$dir/stiff.trk" $input
vxtrack --set length=30.6 -o "$dir/long.trk" $input
vxvehicle -o "$dir/w.veh" data/vehicles/wheelset.yaml
ok $? "files to compare"

# compares STATUS WHAT ARGUMENTS...: nothing on stderr; what was printed stays in $dir/out.
compares()
{
    want=$1 what=$2
    shift 2
    vxcmp "$@" >"$dir/out" 2>"$dir/err"
    is "$? $(wc -c <"$dir/err" | tr -d ' ')" "$want 0" "$what"
}

compares 0 "a file is the same as itself" "$dir/a.trk" "$dir/a.trk"
is "$(cat "$dir/out")" "" "and nothing is printed"
compares 0 "the history is not compared" "$dir/a.trk" "$dir/same.trk"
compares 1 "a key differs" "$dir/a.trk" "$dir/name.trk"
is "$(cat "$dir/out")" "key NAME: thesis-table-1 and other" "and is named"
compares 0 "a key is ignored" --ignore NAME "$dir/a.trk" "$dir/name.trk"
compares 0 "only arrays are compared" --only pad.k --only pad.c "$dir/a.trk" "$dir/name.trk"

compares 1 "a stiffness differs" "$dir/a.trk" "$dir/stiff.trk"
is "$(cut -d: -f1 "$dir/out" | tr '\n' ' ')" "pad.k K.x " "in the railpads and in the matrix"
is "$(head -n 1 "$dir/out")" "pad.k: largest difference 3e+05 N/m at [1,1], 300000000 and 300300000; rms 3e+05; 100 of 100 differ" \
    "with the largest difference and its place"
compares 1 "0.1 % is more than relative 0.9e-3" --rel 0.9e-3 --only pad.k "$dir/a.trk" "$dir/stiff.trk"
compares 0 "and less than 1.1e-3" --rel 1.1e-3 --only pad.k "$dir/a.trk" "$dir/stiff.trk"
compares 1 "more than 2.9e5 N/m" --max 2.9e5 --only pad.k "$dir/a.trk" "$dir/stiff.trk"
compares 0 "and less than 3.1e5 N/m" --max 3.1e5 --only pad.k "$dir/a.trk" "$dir/stiff.trk"
compares 1 "its root mean square is more than 2.9e5 N/m" --rms 2.9e5 --only pad.k "$dir/a.trk" "$dir/stiff.trk"
compares 0 "and less than 3.1e5 N/m" --rms 3.1e5 --only pad.k "$dir/a.trk" "$dir/stiff.trk"
compares 0 "the larger of two tolerances holds" --rel 1e-9 --max 3.1e5 --only pad.k "$dir/a.trk" "$dir/stiff.trk"
compares 0 "arrays are ignored" --ignore pad.k --ignore K.x "$dir/a.trk" "$dir/stiff.trk"
compares 1 "another number of sleepers is another shape, whatever the tolerance" --rel 1 --only pad.k "$dir/a.trk" "$dir/long.trk"
is "$(cat "$dir/out")" "pad.k is 2x50 and 2x51" "and is told"

vxcmp - "$dir/a.trk" <"$dir/a.trk"
ok $? "one of the files may be standard input"
fails 2 "both cannot" vxcmp - -
fails 2 "a file that is not there is trouble" vxcmp "$dir/a.trk" "$dir/none"
fails 2 "another kind is trouble" vxcmp "$dir/a.trk" "$dir/w.veh"
fails 2 "a text is trouble" vxcmp "$dir/a.trk" $input
fails 2 "a name that neither has is trouble" vxcmp --only pad.q "$dir/a.trk" "$dir/a.trk"
fails 2 "one file is misuse" vxcmp "$dir/a.trk"
fails 2 "three files are misuse" vxcmp "$dir/a.trk" "$dir/a.trk" "$dir/a.trk"
fails 2 "a tolerance that is no number" vxcmp --rel 1e-3x "$dir/a.trk" "$dir/a.trk"
fails 2 "a tolerance below zero" vxcmp --rel -1 "$dir/a.trk" "$dir/a.trk"
fails 2 "a tolerance of nan" vxcmp --rel nan "$dir/a.trk" "$dir/a.trk"
fails 2 "a tolerance left out" vxcmp "$dir/a.trk" "$dir/a.trk" --rel
vxcmp "$dir/a.trk" "$dir/stiff.trk" >/dev/full 2>"$dir/err"
is "$? $(wc -l <"$dir/err" | tr -d ' ')" "2 1" "a full disk is trouble"
done_testing
