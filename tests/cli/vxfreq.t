#!/bin/sh
# vxfreq: receptance, modes and static load from the command line.  Run from the project root.
bin=build/bin
tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT
n=0

ok() {      # status text
	n=$((n + 1))
	if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; fi
}

refuses() { # status word text command...
	want=$1 word=$2 text=$3
	shift 3
	"$@" >"$tmp/out" 2>"$tmp/err" </dev/null
	got=$?
	[ $got -eq "$want" ] && [ ! -s "$tmp/out" ] && [ "$(wc -l <"$tmp/err")" -eq 1 ] && grep -q -e "$word" "$tmp/err"
	ok $? "$text" || :
	[ $got -eq "$want" ] || sed 's/^/# /' "$tmp/err"
}

# The k-th peak (or dip) lies within the tolerance of the frequency and, where it is given, within 2 % of the amplitude.
extremum() { # file what k Hz tolerance amplitude
	awk -v what="$2" -v k="$3" -v f="$4" -v t="$5" -v a="$6" '
		$1 == what && ++i == k { good = $2 >= f - t && $2 <= f + t && (a == "" || ($3 >= 0.98 * a && $3 <= 1.02 * a)) }
		END { exit !good }' "$1"
}

track=data/tracks/thesis-straight.yaml
$bin/vxtrack -o "$tmp/t.trk" $track

$bin/vxtrack $track | $bin/vxfreq --receptance --at sleeper --excite both --from 10 --to 1500 --step 1 - >"$tmp/x.frf" &&
	$bin/vxinfo "$tmp/x.frf" | grep -q 'receptance  *f64  *1491 x 2 '
ok $? "the pipe from input to receptance: 1491 frequencies"
$bin/vxfreq --receptance --at sleeper --excite both --from 10 --to 1500 --step 1 -o "$tmp/y.frf" "$tmp/t.trk"
[ "$($bin/vxinfo --content "$tmp/x.frf" | cut -c1-16)" = "$($bin/vxinfo --content "$tmp/y.frf" | cut -c1-16)" ]
ok $? "the same content from a file"
$bin/vxinfo --history "$tmp/x.frf" | grep -q '^vxtrack data/tracks/thesis-straight.yaml$'
ok $? "the history tells of vxtrack"

$bin/vxfreq --receptance --peaks "$tmp/t.trk" >"$tmp/peaks"
extremum "$tmp/peaks" peak 1 119 2 1.006e-8; ok $? "both rails over a sleeper: first peak 119 Hz, 1.006e-8 m/N"
extremum "$tmp/peaks" peak 2 486 5 2.79e-9; ok $? "second peak 486 Hz"
extremum "$tmp/peaks" peak 3 901 5; ok $? "third peak 901 Hz"
extremum "$tmp/peaks" dip 1 256 2; ok $? "first dip 256 Hz"
$bin/vxfreq --receptance --peaks --excite left "$tmp/t.trk" >"$tmp/peaks"
extremum "$tmp/peaks" peak 1 121 2 8.87e-9; ok $? "one rail: first peak 121 Hz, 8.87e-9 m/N"
extremum "$tmp/peaks" peak 2 494 5 2.61e-9; ok $? "second peak 494 Hz, 2.61e-9 m/N"
$bin/vxfreq --receptance --peaks --hermite --at midspan --from 800 --to 1000 "$tmp/t.trk" |
	awk '$1 == "peak" && $3 > most { most = $3; f = $2 } END { exit !(f >= 905 && f <= 909) }'
ok $? "halfway by Hermite's polynomials: pinned-pinned at 907 Hz"

# A receptance does not change where force and motion change places.
cross() { # excite at motion motion-at
	$bin/vxfreq --receptance --excite "$1" --at "$2" --motion "$3" --motion-at "$4" --from 10 --to 1500 --step 10 "$tmp/t.trk" >"$tmp/c.frf" &&
		$bin/vxdump --csv "$tmp/c.frf" receptance | grep -v '^[a-z#]'
}
answers() { # text place1 place2, each "who where"
	cross $2 $3 >"$tmp/one" && cross $3 $2 >"$tmp/other" && paste -d, "$tmp/one" "$tmp/other" |
		awk -F, 'function size(x) { return x < 0 ? -x : x }
			size($1 - $3) + size($2 - $4) <= 1e-9 * (size($1) + size($2)) { good++ } END { exit !(good == 150 && NR == 150) }'
	ok $? "$1"
}
answers "the right rail at 2.1 m answers the left one at 0.45 m as this answers that" "left 0.45" "right 2.1"
answers "so do rail and sleeper" "left 0" "sleeper 3"
$bin/vxfreq --receptance --quantity accelerance --excite left --at 0.45 "$tmp/t.trk" >"$tmp/a.frf" &&
	$bin/vxinfo "$tmp/a.frf" | grep -q 'accelerance  *f64  *1491 x 2  .m/s2/N.' && $bin/vxinfo "$tmp/a.frf" | grep -q 'hermite  *f64  *1491 x 2'
ok $? "an accelerance at a station, exact and by the thesis' polynomials"

! { $bin/vxfreq --receptance --at 0.3 "$tmp/t.trk" | $bin/vxinfo - | grep -q 'hermite  *f64  *1491'; }
ok $? "no second curve at a station above a sleeper, where polynomials are exact"

$bin/vxfreq --static --load 1e6 "$tmp/t.trk" >"$tmp/static"
awk '/^deflection/ { k = 1e6 / $2; good = $3 == "m" && k > 0.99 * 200.9e6 && k < 1.01 * 200.9e6 } END { exit !good }' "$tmp/static"
ok $? "static stiffness 200.9 MN/m"
$bin/vxtrack --set ballast.stiffness=400e6 --set railpad.stiffness=150e6 $track | $bin/vxfreq --static --load 93.2e3 - >"$tmp/static"
awk '/^seat force/ { f = $3 > 42.2e3 && $3 < 44e3 } /^pad compression/ { c = $3 > 0.282e-3 && $3 < 0.294e-3 } END { exit !(f && c) }' \
	"$tmp/static"
ok $? "93.2 kN on ballast of 400 and pads of 150 MN/m: seat force 43.1 kN, compression 0.288 mm"

$bin/vxtrack --set 'zone=[{name: soft, sleepers: [[-5, 5]], rail: right, railpad: {stiffness: 40e6}}]' $track |
	$bin/vxfreq --static --load 60e3 - >"$tmp/static"
awk '/left rail/ { l[++i] = $1 $2 $3 } /right rail/ { r[++j] = $1 $2 $3 }
	END { exit !(i == 3 && j == 3 && l[1] != r[1] && l[2] != r[2] && l[3] != r[3]) }' "$tmp/static"
ok $? "both rails, each with its own deflection, seat force and compression"
$bin/vxfreq --static --load 60e3 --excite right "$tmp/t.trk" | awk '!/right rail/ { bad++ } END { exit !(NR == 3 && !bad) }'
ok $? "one rail loaded, one told"
$bin/vxfreq --static --load 60e3 --axles -1.25,1.25 --bearers "$tmp/t.trk" >"$tmp/static"
awk 'NR > 1 { l += $3; r += $4; b += $5 } END { exit !(NR == 51 && l > 119999 && l < 120001 && r > 119999 && r < 120001 && b > 239999 && b < 240001) }' \
	"$tmp/static"
ok $? "pads and ballast of all sleepers bear the axles"
$bin/vxtrack --set 'ballast.gap={number: [0, 1, 2], value: [0, 1e-3, 0]}' $track | $bin/vxfreq --static --load 60e3 --axles 0.3 --bearers - |
	awk '$2 == 1 { void = $5 * $5 } NR > 1 { b += $5 } END { exit !(void < 1e-6 && b > 119999 && b < 120001) }'
ok $? "none of it by the ballast below a void"

$bin/vxtrack data/tracks/60E1-R760-1-15-diverging.yaml | $bin/vxfreq --stiffness --every 0.3 - >"$tmp/k"
awk 'NR > 1 && $1 > -60 && $1 < -40 && ($4 < 196e6 || $4 > 202e6) { bad++ }
	NR > 1 { if ($4 < 1.1e8 || $5 < 1.1e8 || $2 <= $4 || $3 <= $5) bad++ }
	END { exit !(NR > 500 && !bad) }' "$tmp/k"
ok $? "stiffness along the turnout: 200 MN/m on the run-in, more where the other rail is free"
$bin/vxfreq --static --load 93.2e3 --axles -1.25,1.25 --every 0.25 "$tmp/t.trk" >"$tmp/bowl"
awk 'NR == 1 { good = $1 == "station[m]" && $2 == "left[m]" && $3 == "right[m]" }
	$1 * $1 < 4 && $2 > 0.40e-3 && $2 < 0.50e-3 { deep++ }
	END { exit !(good && deep && NR > 110) }' "$tmp/bowl"
ok $? "the bowl under two axles of a bogie"

for f in 129.0 505.1; do
	$bin/vxfreq --modes 8 --near $f --text "$tmp/t.trk" |
		awk -v f=$f '/in phase/ && $2 > f - 0.1 && $2 < f + 0.1 { good = 1 } END { exit !good }'
	ok $? "an in-phase mode at $f Hz"
done
$bin/vxfreq --modes 8 --near 826 --text "$tmp/t.trk" | awk '/in phase/ && $2 > 825 && $2 < 827 { good = 1 } END { exit !good }'
ok $? "an in-phase mode at 826 Hz"
$bin/vxfreq --modes 8 "$tmp/t.trk" >"$tmp/a.mod" && $bin/vxfreq --modes 8 -o "$tmp/b.mod" "$tmp/t.trk" && cmp -s "$tmp/a.mod" "$tmp/b.mod"
ok $? "modes twice are the same bytes"
$bin/vxfreq --modes 20 --near 505 --damped --text "$tmp/t.trk" >"$tmp/damped"
awk '$3 < 0.1 || $3 > 0.4 || $2 < before { bad++ } { before = $2 } END { exit !(NR == 20 && !bad) }' "$tmp/damped"
ok $? "twenty damped modes of the rails on their pads"
$bin/vxfreq --modes 6 --damped "$tmp/t.trk" >"$tmp/a.mod" && $bin/vxinfo "$tmp/a.mod" | grep -q 'imaginary  *f64  *6 x 300'
ok $? "with complex shapes"
$bin/vxvehicle data/vehicles/manchester-passenger.yaml | $bin/vxfreq --modes 18 --text - >"$tmp/modes"
[ "$(wc -l <"$tmp/modes")" -eq 18 ] && grep -q 'carbody bounce' "$tmp/modes" && grep -q 'bogie pitch' "$tmp/modes"
ok $? "a coach has eighteen modes with its wheelsets held, among them carbody bounce"

# A void of 0.2 mm: a small load finds no ballast there, 60 kN a rail close it, and with it standing there the receptance is that without void.
$bin/vxtrack --set 'ballast.gap={number: [0, 1, 2], value: [0, 0.2e-3, 0]}' -o "$tmp/v.trk" data/tracks/thesis-straight.yaml
$bin/vxtrack --set 'ballast.stiffness={number: [0, 1, 2], value: [280e6, 1e-9, 280e6]}' \
	--set 'ballast.damping={number: [0, 1, 2], value: [120e3, 0, 120e3]}' -o "$tmp/none.trk" data/tracks/thesis-straight.yaml
at() { $bin/vxfreq --stiffness "$@" --every 0.3 | awk '$1 > 0.29 && $1 < 0.31 { print $4 }'; }
[ "$(at "$tmp/v.trk")" = "$(at "$tmp/none.trk")" ] && [ "$(at --load 1000 "$tmp/v.trk")" = "$(at "$tmp/none.trk")" ]
ok $? "static stiffness over a void is that without ballast there, of small loads"
awk -v a="$(at "$tmp/v.trk")" -v b="$(at --load 60000 "$tmp/v.trk")" -v c="$(at --load 200000 "$tmp/v.trk")" \
	-v d="$(at "$tmp/t.trk")" 'BEGIN { exit !(1.4 * a < b && b < c && c < d) }'
ok $? "rises with the load, and stays below that of a track without voids"
[ "$($bin/vxfreq --static --load 60000 --axles 0.3 --every 0.3 "$tmp/v.trk" | awk '$1 > 0.29 && $1 < 0.31 { print $2 }')" = 0.000372618 ]
ok $? "the bowl has the deflection of --static"
peaks() { $bin/vxfreq --receptance --peaks --to 600 --x 0.3 "$@"; }
peaks --preload 60000 "$tmp/v.trk" >"$tmp/p1" && peaks "$tmp/t.trk" | cmp -s - "$tmp/p1"
ok $? "under a wheel of 60 kN the receptance is that of ballast without voids"
peaks "$tmp/v.trk" >"$tmp/p1" && peaks "$tmp/none.trk" | cmp -s - "$tmp/p1"
ok $? "without it that of no ballast there"
refuses 2 "does not go with" "a preload of modes" $bin/vxfreq --modes 3 --preload 1000 "$tmp/t.trk"
refuses 2 "does not go with" "a load of a receptance" $bin/vxfreq --receptance --load 1000 "$tmp/t.trk"

$bin/vxfreq -h | grep -q '^vxfreq --modes N'
ok $? "-h prints the usage"
refuses 2 "one of" "no task" $bin/vxfreq "$tmp/t.trk"
refuses 2 "one of" "two tasks" $bin/vxfreq --receptance --modes 3 "$tmp/t.trk"
refuses 2 "load" "--static without a load" $bin/vxfreq --static "$tmp/t.trk"
refuses 2 "lies below" "a range that runs backwards" $bin/vxfreq --receptance --from 100 --to 10 "$tmp/t.trk"
refuses 2 "is not a number" "a number with a unit" $bin/vxfreq --receptance --from 10Hz "$tmp/t.trk"
refuses 2 "must be one of" "a third rail" $bin/vxfreq --receptance --excite middle "$tmp/t.trk"
refuses 2 "go with" "a quantity of modes" $bin/vxfreq --modes 3 --quantity mobility "$tmp/t.trk"
refuses 2 "does not go with" "axles of a receptance" $bin/vxfreq --receptance --axles 3 "$tmp/t.trk"
refuses 2 "must be" "an axle beyond the track" $bin/vxfreq --static --load 1 --axles 3,99 "$tmp/t.trk"
refuses 2 "does not go with" "a table into a file" $bin/vxfreq --stiffness -o "$tmp/k" "$tmp/t.trk"
refuses 2 "loads rails" "a static load on a sleeper" $bin/vxfreq --static --load 1 --excite sleeper "$tmp/t.trk"
refuses 2 "must be -14.7" "a station beyond the track" $bin/vxfreq --receptance --at 15.1 "$tmp/t.trk"
refuses 2 "^vxfreq: --x: 99 must be -14.7" "a sleeper nearest to what is beyond the track" $bin/vxfreq --static --load 1 --x 99 "$tmp/t.trk"
refuses 2 "^vxfreq: --direction lateral" "sideways on a vertical track" $bin/vxfreq --receptance --direction lateral "$tmp/t.trk"
refuses 2 "must be sleeper, midspan or a station" "a place that is none" $bin/vxfreq --receptance --at bridge "$tmp/t.trk"
refuses 1 "of a track" "damped modes of a vehicle" sh -c "$bin/vxvehicle data/vehicles/wheelset.yaml | $bin/vxfreq --modes 1 --damped -"
refuses 2 "--from does not go with --modes" "a range of modes" $bin/vxfreq --modes 3 --from 10 "$tmp/t.trk"
refuses 2 "--near does not go with --stiffness" "a frequency of a stiffness" $bin/vxfreq --stiffness --near 5 "$tmp/t.trk"
refuses 2 "--every does not go with" "a table of one place" $bin/vxfreq --static --load 1 --every 1 "$tmp/t.trk"
refuses 2 "does not go with" "--text without --modes" $bin/vxfreq --receptance --text "$tmp/t.trk"
refuses 2 "input is missing" "no input" $bin/vxfreq --receptance
refuses 1 "where a .trk file is wanted" "a receptance where a track is wanted" $bin/vxfreq --receptance "$tmp/x.frf"
refuses 1 "between 1 and 150" "too many modes" $bin/vxfreq --modes 200 "$tmp/t.trk"
size=$(wc -c <"$tmp/t.trk")
for part in 0 1 63 64 700 5000 $((size - 1)); do
	head -c $part "$tmp/t.trk" >"$tmp/cut.trk"
	refuses 1 "cut.trk" "a track cut after $part bytes" $bin/vxfreq --receptance "$tmp/cut.trk"
done
echo "1..$n"
