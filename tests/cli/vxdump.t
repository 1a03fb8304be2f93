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
# Profiles for other programs: written, read again, the same curve.  Nodes are those of a new resampling, so the distance of the one's
# nodes from the other's polyline is taken along its normal.
apart()
{
    vxdump "$1" y z >"$dir/a" && vxdump "$2" y z >"$dir/b"
    curves_apart 1e9
}

# The same of the columns in $dir/a and $dir/b, times a factor that makes nm or um of it; the first line is a heading.
curves_apart()
{
    awk -v nm="$1" -F, '
        FNR == 1 {next}
        NR == FNR {y[++n] = $1; z[n] = $2; next}
        {
            while (j < n - 1 && y[j + 1] < $1) j++
            j = j < 1 ? 1 : j
            if ($1 < y[1] || $1 > y[n]) next
            slope = (z[j + 1] - z[j]) / (y[j + 1] - y[j])
            d = ($2 - z[j] - slope * ($1 - y[j])) / sqrt(1 + slope * slope)
            d = d < 0 ? -d : d
            worst = d > worst ? d : worst; m++
        }
        END {printf "%.2f\n", (m > 100) ? nm * worst : 1e9}' "$dir/a" "$dir/b"
}
for shape in S1002:wheel:prw 60E1:rail:prr; do
    name=${shape%%:*} ending=${shape##*:} part=${shape#*:} part=${part%:*}
    for side in l r; do
        vxprofile --side $side -o "$dir/was.prof" data/profiles/$name.yaml
        vxdump --simpack -o "$dir/x.$ending" "$dir/was.prof" && vxdump --yz "$dir/was.prof" >"$dir/x.txt"
        ok $? "$name, side $side, as Simpack and as y z"
        vxprofile --side $side --set smoothing=0 -o "$dir/now.prof" "$dir/x.$ending"
        between "$(apart "$dir/was.prof" "$dir/now.prof")" 0 5 "$name, side $side, by way of Simpack: apart, nm"
        vxprofile --side $side --part $part --set smoothing=0 -o "$dir/now.prof" "$dir/x.txt"
        between "$(apart "$dir/was.prof" "$dir/now.prof")" 0 5 "$name, side $side, by way of y z: apart, nm"
    done
done
# Simpack's own way with wheels: y in the file towards the track's centre, keys that mirror it, flange first.
is "$(awk '$1 ~ /^(type|mirror.y|inversion)$/ && !seen[$1]++ {printf "%s=%s ", $1, $3}' "$dir/x.prr")" "type=0 mirror.y=0 inversion=0 " "keys of a rail"
vxprofile data/profiles/S1002.yaml | vxdump --simpack - >"$dir/x.prw"
is "$(awk '$1 ~ /^(type|mirror.y|inversion)$/ && !seen[$1]++ {printf "%s=%s ", $1, $3}' "$dir/x.prw")" "type=1 mirror.y=1 inversion=1 " "keys of a wheel"
is "$(awk '/point.begin/ {getline; print ($1 > 69)}' "$dir/x.prw")" 1 "its points begin at the flange"

vxprofile --side l -o "$dir/turnout.prof" data/turnouts/60E1-R760-1-15.yaml
fails 1 "which section" vxdump --yz "$dir/turnout.prof"
like "$(cat "$dir/err")" 'sections: say at which station' "says so"
fails 1 "which body" vxdump --yz --at 47.5 "$dir/turnout.prof"
like "$(cat "$dir/err")" 'bodies: say which' "says so"
fails 1 "a body that is not there" vxdump --simpack --at 0 --body nose "$dir/turnout.prof"
like "$(vxdump --yz --at 47.51 --body nose "$dir/turnout.prof" | head -n 1)" 'nose, station 47.5 m' "the section nearest to a station"
vxdump --slices --body nose -o "$dir/nose.slcs" "$dir/turnout.prof"
ok $? "slices of the nose"
slices=$(awk '/NSLC/ {print $1}' "$dir/nose.slcs")
is "$(ls "$dir/nose" | wc -l | tr -d ' ')" "$slices" "as many files as slices"
is "$(grep -c "'nose/slice_" "$dir/nose.slcs")" "$slices" "each named beside the .slcs"
[ -z "$(sed -n "s/.*'\(.*\)'.*/\1/p" "$dir/nose.slcs" | while read -r f; do [ -s "$dir/$f" ] || echo "$f"; done)" ]
ok $? "and there"
# Read again the heights count from another section, so the top of each counts; the points are those of lines along the track.
vxprofile --side l --set sections.position=0.7535 --set smoothing=0 -o "$dir/again.prof" "$dir/nose.slcs"
ok $? "vxprofile reads the slices"
level()
{
    vxdump --yz --at "$1" --body "$2" "$3" | awk '/^#/ {next} {y[++n] = $1; z[n] = $2; top = (n == 1 || $2 < top) ? $2 : top}
        END {print "y,z"; for (i = 1; i <= n; i++) printf "%.9f,%.9f\n", y[i], z[i] - top}'
}
for at in 46.8 47.5 54.2; do
    level $at nose "$dir/turnout.prof" >"$dir/a"
    level $at rail "$dir/again.prof" >"$dir/b"
    between "$(curves_apart 1e3)" 0 3 "the nose at $at m by way of slices: apart, um"
done
fails 1 "slices of a wheel" vxdump --slices -o "$dir/w.slcs" "$dir/was.prof"
fails 1 "slices into another ending" vxdump --slices --body nose -o "$dir/w.txt" "$dir/turnout.prof"
fails 1 "a track as Simpack" vxdump --simpack "$dir/t.trk"
fails 2 "slices without a file" vxdump --slices --body nose "$dir/turnout.prof"
fails 2 "--at for a table" vxdump --csv --at 3 "$dir/t.trk"
fails 2 "arrays of points" vxdump --yz "$dir/was.prof" y
fails 2 "two formats" vxdump --csv --mat "$dir/t.trk"
fails 2 "no input" vxdump --csv
done_testing
