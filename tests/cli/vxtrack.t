#!/bin/sh
# vxtrack: what it builds, and what it refuses.  Run from the project root.
bin=build/bin
tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT
n=0

ok() {      # status text
	n=$((n + 1))
	if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; fi
}

# Fails with the status, one line on stderr that holds the word, nothing on stdout.
refuses() { # status word text command...
	want=$1 word=$2 text=$3
	shift 3
	"$@" >"$tmp/out" 2>"$tmp/err" </dev/null
	got=$?
	[ $got -eq "$want" ] && [ ! -s "$tmp/out" ] && [ "$(wc -l <"$tmp/err")" -eq 1 ] && grep -q -e "$word" "$tmp/err"
	ok $? "$text" || :
	[ $got -eq "$want" ] || sed 's/^/# /' "$tmp/err"
}

track=data/tracks/thesis-straight.yaml
turnout=data/tracks/60E1-R760-1-15-diverging.yaml

$bin/vxtrack -o "$tmp/a.trk" $track && $bin/vxinfo "$tmp/a.trk" >"$tmp/info"
ok $? "the straight track builds"
grep -q 'A.p  *i64  *301 ' "$tmp/info"
ok $? "with 300 degrees of freedom"
$bin/vxtrack $track >"$tmp/b.trk" && cmp -s "$tmp/a.trk" "$tmp/b.trk"
ok $? "on standard output the same bytes, for -o leaves no trace"
[ "$($bin/vxtrack - <$track | $bin/vxinfo --content - | cut -c1-16)" = "$($bin/vxinfo --content "$tmp/a.trk" | cut -c1-16)" ]
ok $? "from standard input the same content"
$bin/vxtrack --set railpad.stiffness=150e6 $track >"$tmp/c.trk"
[ "$($bin/vxinfo --content "$tmp/c.trk" | cut -c1-16)" != "$($bin/vxinfo --content "$tmp/a.trk" | cut -c1-16)" ]
ok $? "--set changes the content"
$bin/vxinfo --history "$tmp/c.trk" | grep -q 'railpad.stiffness=150e6'
ok $? "and is part of the history"

for f in $turnout data/tracks/60E1-R760-1-15-through.yaml; do
	$bin/vxtrack -o "$tmp/t.trk" "$f" && $bin/vxinfo "$tmp/t.trk" | grep -q 'sleeper.x  *f64  *254 '
	ok $? "$f builds with 254 sleepers"
done

# The table of the page is the schema's: every key is there with its unit and default.
$bin/vxtrack --schema | awk -F'\t' 'NR > 1 { printf ".It %s Ta %s Ta %s Ta %s\n", $1, $3, $5, $6 }' >"$tmp/rows"
grep '^\.It .* Ta ' man/track-input.5 | grep -v '^.It Sy' | cmp -s - "$tmp/rows"
ok $? "track-input(5) has the rows of --schema"

# Zone 3 is the left rail of sleepers 70 to 90, around station 48: softer pads there and nowhere else.
$bin/vxtrack --set zone.3.railpad.stiffness=16e6 -o "$tmp/z.trk" $turnout
$bin/vxtrack -o "$tmp/r.trk" $turnout
static() { $bin/vxfreq --static --load 1000 --excite "$2" --x "$3" "$1" | awk '/^deflection/ { print $2 }'; }
awk -v a="$(static "$tmp/z.trk" left 48)" -v b="$(static "$tmp/r.trk" left 48)" 'BEGIN { exit !(a > 1.5 * b) }'
ok $? "--set zone.3.railpad.stiffness=16e6 softens the left rail in the crossing"
awk -v a="$(static "$tmp/z.trk" right 20)" -v b="$(static "$tmp/r.trk" right 20)" 'BEGIN { exit !(a == b) }'
ok $? "but not the rails in the switch"

$bin/vxtrack --schema | grep -q '^railpad.stiffness	number or table	N/m	'
ok $? "--schema names the keys with type and unit"
$bin/vxtrack --master | grep -q 'elements_per_bay: 1'
ok $? "--master shows the defaults"
$bin/vxtrack -h | grep -q '^vxtrack \[--set KEY=VALUE\]'
ok $? "-h prints the usage"

refuses 2 "unknown option" "an unknown option" $bin/vxtrack --sets a=1 $track
refuses 2 "input is missing" "no input" $bin/vxtrack
refuses 2 "one operand too many" "two inputs" $bin/vxtrack $track $track
refuses 2 "exclude" "--schema with --master" $bin/vxtrack --schema --master
refuses 2 "stands alone" "--schema with an input" $bin/vxtrack --schema $track
refuses 1 "No such file" "an input that is not there" $bin/vxtrack "$tmp/none.yaml"
refuses 1 "stifness" "a key that is not there" $bin/vxtrack --set railpad.stifness=1e8 $track
short() { printf 'track:\n  name: short\n  from: 0\n  length: 12\n  rail: {bending_stiffness: 6.11e6, mass: 60%s}\n' "$1"
	printf '  sleeper: {spacing: 0.6, mass: 380, roll_inertia: 155.09, length: 2.6}\n  railpad: {stiffness: 300e6, damping: 50e3}\n'
	printf '  ballast: {stiffness: 280e6, damping: 120e3}\n'; }
short ', mass_model: consistent' | $bin/vxtrack - >"$tmp/s.trk"
ok $? "consistent mass wants no pitch inertia"
short '' >"$tmp/s.yaml"
refuses 1 "rail.pitch_inertia: a lumped rail needs it" "lumped mass without pitch inertia" $bin/vxtrack "$tmp/s.yaml"
short ', mass_model: consistent, beam: timoshenko' >"$tmp/s.yaml"
refuses 1 "rail.shear_stiffness: a timoshenko rail needs it" "a Timoshenko rail without shear stiffness" $bin/vxtrack "$tmp/s.yaml"
short ', mass_model: consistent, beam: timoshenko, shear_stiffness: 2.49e8' >"$tmp/s.yaml"
refuses 1 "rail.rotary_inertia: a timoshenko rail with" "or rotary inertia" $bin/vxtrack "$tmp/s.yaml"
refuses 1 "greater than 0" "a negative stiffness in a table" $bin/vxtrack --set 'rail.left.bending_stiffness={station: [0, 1], value: [6e6, -6e6]}' $track
refuses 1 "places must increase" "a table that runs backwards" $bin/vxtrack --set 'rail.left.bending_stiffness={station: [1, 0], value: [6e6, 6e6]}' $track
refuses 1 "elements_per_bay" "no element in a bay" $bin/vxtrack --set rail.elements_per_bay=0 $track

# Every rail model goes through receptance, modes and statics, and gives about the same track.
for model in lumped consistent; do
	for beam in euler timoshenko; do
		for bay in 1 3 8; do
			$bin/vxtrack --set rail.mass_model=$model --set rail.beam=$beam --set rail.elements_per_bay=$bay -o "$tmp/m.trk" $track &&
				$bin/vxfreq --receptance --to 200 --peaks "$tmp/m.trk" >"$tmp/peaks" &&
				$bin/vxfreq --modes 4 --near 129 --text "$tmp/m.trk" >"$tmp/modes" &&
				$bin/vxfreq --static --load 1000 --at midspan "$tmp/m.trk" >"$tmp/static" &&
				awk '/^peak/ { exit !($2 > 117 && $2 < 121) }' "$tmp/peaks" && [ "$(wc -l <"$tmp/modes")" -eq 4 ] &&
				awk '/^deflection/ { exit !($2 > 5.0e-6 && $2 < 5.9e-6) }' "$tmp/static"
			ok $? "$model mass, $beam, $bay elements a bay: receptance, modes and statics"
		done
	done
done

refuses 1 "must be one of lumped, consistent" "a mass model that is not there" $bin/vxtrack --set rail.mass_model=full $track
refuses 1 "must be one of euler, timoshenko" "a beam that is not there" $bin/vxtrack --set rail.beam=shear $track
refuses 1 "greater than 0" "no mass" $bin/vxtrack --set rail.mass=0 $track
refuses 1 "whole number" "half a bay" $bin/vxtrack --set length=30.3 $track
refuses 1 "too short" "ballast springs that cross" $bin/vxtrack --set ballast.edge=1.3 $track
refuses 1 "two zones" "a railpad in two zones" $bin/vxtrack --set zone.1.sleepers='[[1, 21]]' $turnout
refuses 1 "whole numbers" "a range that runs backwards" $bin/vxtrack --set zone.1.sleepers='[[20, 1]]' $turnout
refuses 1 "longer than 31" "a long name" $bin/vxtrack --set zone.1.name=a-name-of-more-than-thirty-one-letters $turnout
refuses 1 "beyond" "a curve that runs backwards" $bin/vxtrack --set curve.2.from=-1 $turnout
sed 's/stiffness: 300e6/stiffness: 300 MN/' $track >"$tmp/unit.yaml"
refuses 1 "unit.yaml:[0-9]*:[0-9]*: error: " "a unit in a number, told with its place" $bin/vxtrack "$tmp/unit.yaml"
if [ -c /dev/full ]; then
	refuses 1 "No space" "a full disk" sh -c "$bin/vxtrack $track >/dev/full"
else
	ok 0 "a full disk # SKIP no /dev/full"
fi
echo "1..$n"
