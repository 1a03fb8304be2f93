#!/bin/sh
# vxdump: columns, repeatable MAT and HDF5, what does not fit is refused.
. tests/tap.sh

input=data/tracks/thesis-straight.yaml
vxtrack -o "$dir/t.trk" $input
ok $? "a track to export"

vxdump --csv "$dir/t.trk" sleeper.number sleeper.x sleeper.mass >"$dir/csv"
ok $? "three columns"
is "$(head -n 1 "$dir/csv")" "sleeper.number (1),sleeper.x (m),sleeper.mass (kg)" "names and units"
is "$(wc -l <"$dir/csv" | tr -d ' ')" 51 "a row for each of 50 sleepers"
is "$(sed -n 2p "$dir/csv")" "-24,-14.699999999999999,380" "the first sleeper, half a spacing from the start"
is "$(vxdump "$dir/t.trk" sleeper.number sleeper.x sleeper.mass)" "$(cat "$dir/csv")" "CSV is the default"
is "$(vxdump - sleeper.number sleeper.x sleeper.mass <"$dir/t.trk")" "$(cat "$dir/csv")" "standard input"
is "$(vxdump "$dir/t.trk" rail.spacing)" "rail.spacing (m)
1.5" "a scalar"
is "$(vxdump "$dir/t.trk" pad.k | head -n 1 | cut -d, -f2,50)" "pad.k[2] (N/m),pad.k[50] (N/m)" "columns of an array with two dims"
is "$(vxdump "$dir/t.trk" pad.k | wc -l | tr -d ' ')" 3 "and its two rows"

for format in csv mat hdf5; do
    vxdump --$format -o "$dir/one" "$dir/t.trk" K.x
    ok $? "--$format to a file"
    vxdump --$format "$dir/t.trk" K.x | cmp -s - "$dir/one"
    ok $? "--$format gives the same bytes on a pipe"
    vxdump --$format "$dir/t.trk" K.x >/dev/full 2>"$dir/err"
    is "$? $(wc -l <"$dir/err" | tr -d ' ')" "1 1" "--$format notices a full disk"
    vxdump --$format -o /dev/full "$dir/t.trk" K.x 2>"$dir/err"
    is "$? $(wc -l <"$dir/err" | tr -d ' ')" "1 1" "--$format notices it with -o too"
done
is "$(vxdump --mat "$dir/t.trk" | head -c 38)" "MATLAB 5.0 MAT-file, written by Veksel" "everything as MAT"
vxdump --hdf5 "$dir/t.trk" | head -c 8 | od -A n -t x1 | grep -q '89 48 44 46 0d 0a 1a 0a'
ok $? "everything as HDF5"

# A long track gives time to interrupt; were it too fast, nothing would be left either.
vxtrack --set length=6000 -o "$dir/long.trk" $input
vxdump -o "$dir/cut" "$dir/long.trk" A.i K.x M.x C.x &
while kill -0 $! 2>/dev/null && [ -z "$(find "$dir" -name 'cut.*')" ]; do :; done
seen=$(find "$dir" -name 'cut.*' | wc -l)
kill -TERM $! 2>/dev/null
wait $! 2>/dev/null
status=$?
[ -z "$(find "$dir" -name 'cut.*')" ]
ok $? "terminated, it leaves no temporary (there were $((seen)), status $status)"

rm -f "$dir/new"
fails 1 "arrays of two lengths" vxdump -o "$dir/new" "$dir/t.trk" x pad.k
like "$(cat "$dir/err")" 'x has 50 rows, pad.k has 2: name arrays of one length' "says so"
[ ! -e "$dir/new" ] && [ -z "$(find "$dir" -name 'new*')" ]
ok $? "and leaves no file"
fails 1 "an array that is not there" vxdump "$dir/t.trk" pad.q
like "$(cat "$dir/err")" 'there is no array pad.q' "says so"
fails 1 "a file that is not there" vxdump "$dir/none"
fails 1 "a folder that is not there" vxdump -o "$dir/none/out.csv" "$dir/t.trk" x
fails 1 "a text" vxdump $input
fails 2 "two formats" vxdump --csv --mat "$dir/t.trk"
fails 2 "no input" vxdump --csv
done_testing
