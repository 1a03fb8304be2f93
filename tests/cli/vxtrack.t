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

$bin/vxtrack -o "$tmp/mass.trk" data/tracks/moving-mass.yaml && $bin/vxinfo "$tmp/mass.trk" | grep -q 'A.p  *i64  *7 '
ok $? "a moving mass builds, with six degrees of freedom"
$bin/vxfreq --receptance --peaks "$tmp/mass.trk" | awk '/^peak/ { f[++n] = $2 }
	END { exit !(n == 2 && f[1] > 118.3 && f[1] < 120.3 && f[2] > 482 && f[2] < 485) }'
ok $? "its receptance peaks at 119 and 483 Hz, and nowhere else"
$bin/vxtrack --set model=moving_mass --set length=0.6 $track | $bin/vxfreq --modes 3 --text - | grep -q '^1  124.4820 '
ok $? "the straight track's input makes one too"
refuses 2 "midspan: a moving mass has no span" "halfway between its sleepers" $bin/vxfreq --receptance --at midspan "$tmp/mass.trk"
refuses 1 "which a moving mass has" "a moving mass of two bays" $bin/vxtrack --set length=1.2 data/tracks/moving-mass.yaml
refuses 1 "held is for model: moving_mass alone" "sleepers held in roll under a fixed track" $bin/vxtrack --set sleeper.roll=held $track

# The table of the page is the schema's: every key is there with its unit and default.
$bin/vxtrack --schema | awk -F'\t' 'NR > 1 { words = $4; gsub(/[|]/, ", ", words); print ".It " $1 " Ta " $3 " Ta " $5 " Ta " $6 ($2 == "word" ? " (" words ")" : "") }' >"$tmp/rows"
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

# A turnout with nonsense in it, by --set: the line names the key and the rule.  KEY=VALUE | what the line must hold
while IFS='|' read -r set word; do
	refuses 1 "$word" "refused: $set" $bin/vxtrack --set "$set" $turnout
done <<'EOF'
railpad.stiffness=-300e6|railpad.stiffness=-300e6: error: stiffness must be greater than 0
railpad.damping=-1|damping must be at least 0
ballast.stiffness=0|stiffness must be greater than 0
ballast.damping=-1|damping must be at least 0
rail.bending_stiffness={station: [0, 1], value: [6e6, 0]}|bending_stiffness must be greater than 0
rail.right.bending_stiffness=-6e6|bending_stiffness must be greater than 0
rail.lateral.stiffness=-1|stiffness must be greater than 0
rail.lateral.mass=0|mass must be greater than 0
rail.pitch_inertia=0|pitch_inertia must be greater than 0
rail.mass=nan|mass: "nan" is not a plain number
rail.elements_per_bay=21|elements_per_bay must be at least 1 and at most 20, not 21
sleeper.mass=0|mass must be greater than 0
sleeper.mass={number: [1, 92], value: [380, 0]}|mass must be greater than 0
sleeper.roll_inertia=0|roll_inertia must be greater than 0
sleeper.length=-2.6|length must be at least 0.1
sleeper.spacing=0|spacing must be at least 0.1
sleeper.centre=0.7|sleeper.centre: the left rail, 1.45 m beside the middle of sleeper -144, is beyond its end at 1.3 m
sleeper.centre={number: [40, 41, 42], value: [0, -1, 0]}|sleeper.centre: the right rail, 1.75 m beside the middle of sleeper 41
rail_spacing=2.7|sleeper.centre: the left rail, 1.35 m beside the middle of sleeper -144
ballast.edge=1.3|ballast.edge: sleeper -144 of length 2.6 m is too short
zone.1.sleepers=[[500, 520]]|zone.1.sleepers: \[500, 520\] is not within the track, sleepers -144 to 109
zone.3.sleepers=[[70, 110]]|zone.3.sleepers: \[70, 110\] is not within
zone.1.sleepers=[[-145, 20]]|zone.1.sleepers: \[-145, 20\] is not within
zone.1.sleepers=[]|zone.1.sleepers: no sleeper
zone.1.sleepers=[1, 20]|sleepers: a pair
zone.1.sleepers=[[1, 21]]|zone.2.sleepers: the left railpad of sleeper 21 is in two zones, switch and closure
zone.4.rail=both|zone.4.sleepers: the left railpad of sleeper 70 is in two zones, crossing and crossing-other-rail
zone.1.sleepers=[[1, 20], [15, 20]]|zone.1.sleepers: \[1, 20\] and \[15, 20\] have sleepers in common
zone.2.name=switch|zone.2.name: "switch" is the name of zone.1 already
zone.1.rail=middle|rail must be one of left, right, both
zone.1.railpad.stiffness=-1|stiffness must be greater than 0
zone.1.railpad.damping=-1|damping must be greater than 0
zone.5.railpad.stiffness=1e8|5 is not an item of a list of 4
zone.frog.railpad.stiffness=1e8|frog is not an item of a list of 4
sleeper.mass={number: [2, 1], value: [380, 380]}|mass: places must increase
sleeper.length={station: [5, 5], value: [2.6, 2.7]}|length: places must increase
sleeper.centre={number: [1, 2], value: [0]}|centre: 2 places but 1 values
sleeper.centre={number: [], value: []}|centre: 0 places
sleeper.mass={bay: [1, 2], value: [380, 380]}|mass: one number, or {station
check_rail.1.play={station: [44, 43], value: [0.01, 0.01]}|play: places must increase
check_rail.1.stiffness=-1|stiffness must be greater than 0
curve.1.from=60|curve.2.from: 50.592 must be beyond
curve.1.curvature=-2|curvature must be at least -1
rail.mass={station: [0, 1], value: [60, 0]}|mass must be greater than 0
rail.left.mass=-1|mass must be greater than 0
rail.left.pitch_inertia=0|pitch_inertia must be greater than 0
rail.right.rotary_inertia={station: [1, 0], value: [1, 1]}|rotary_inertia: places must increase
ballast.gap=-1e-3|gap must be at least 0
ballast.gap={number: [1, 2], value: [0, 2]}|gap must be at least 0 and at most 0.05 m, not 2
ballast.left.gap=-1|gap must be at least 0
ballast.middle.stiffness=-1|stiffness must be at least 0
ballast.right.damping=-1|damping must be at least 0
ballast.tension=maybe|tension
railpad.missing=[{sleepers: [[500, 501]]}]|railpad.missing.1.sleepers: \[500, 501\] is not within the track, sleepers -144 to 109
railpad.missing=[{sleepers: [[3, 3]]}, {sleepers: [[3, 2]]}]|railpad.missing.2.sleepers: \[3, 2\] must be two whole numbers
railpad.missing=[{sleepers: [[3, 3], [3, 4]]}]|--set .*: error: railpad.missing.1.sleepers: \[3, 3\] and \[3, 4\] have sleepers in common
ballast.gap={number: [1.5, 2], value: [0, 0]}|error: ballast.gap: 1.5 is no number of a sleeper
ballast.gap={number: [801, 802], value: [0, 0]}|error: ballast.gap: sleepers 801 to 802 are not on the track, whose sleepers are -144 to 109
rail.left.mass={station: [801, 802], value: [60, 61]}|error: rail.left.mass: stations 801 to 802 are not on the track
railpad.missing=[{sleepers: []}]|railpad.missing.1.sleepers: no sleeper
railpad.missing=[{sleepers: [[3, 3]], rail: middle}]|rail must be one of left, right, both
railpad.missing=[{rail: left}]|sleepers
railpad.missing=[{sleepers: [[-144, 108]], rail: right}]|railpad.missing: the right rail has 1 railpads left
length=-3|length must be greater than 0
length=152.5|length: 152.5 m is not a whole number, two or more, of sleeper spacings
EOF

# Nonsense in a spatial track: the same turnout with dofs: spatial.  KEY=VALUE | what the line must hold
while IFS='|' read -r set word; do
	refuses 1 "$word" "refused, spatial: $set" $bin/vxtrack --set dofs=spatial --set "$set" $turnout
done <<'EOF'
rail.lateral_bending_stiffness=0|lateral_bending_stiffness must be greater than 0
rail.left.lateral_bending_stiffness={station: [0, 1], value: [1e6, -1e6]}|lateral_bending_stiffness must be greater than 0
rail.yaw_inertia=-1|yaw_inertia must be greater than 0
rail.torsional_stiffness=0|torsional_stiffness must be greater than 0
rail.polar_inertia=0|polar_inertia must be greater than 0
rail.head_height=-0.1|head_height must be greater than 0
rail.foot_depth=2|foot_depth must be greater than 0 and at most 1
rail.lateral_shear_stiffness=0|lateral_shear_stiffness must be greater than 0
rail.lateral_rotary_inertia=0|lateral_rotary_inertia must be greater than 0
sleeper.yaw_inertia=0|yaw_inertia must be greater than 0
sleeper.seat_height=-0.1|seat_height must be at least 0
railpad.lateral_stiffness=-25e6|lateral_stiffness must be greater than 0
railpad.lateral_damping=-1|lateral_damping must be at least 0
railpad.width=0|width must be greater than 0
railpad.length=-0.1|length must be at least 0
ballast.lateral_stiffness=0|lateral_stiffness must be greater than 0
ballast.lateral_damping=-1|lateral_damping must be at least 0
ballast.longitudinal_stiffness=0|longitudinal_stiffness must be greater than 0
ballast.longitudinal_damping=-1|longitudinal_damping must be at least 0
zone.1.railpad.lateral_stiffness=-1|lateral_stiffness must be greater than 0
zone.1.railpad.lateral_damping=-1|lateral_damping must be greater than 0
check_rail.1.beam.to=43.2|check_rail.1.beam.to: 43.2 must be beyond the 43.2 of from
check_rail.1.beam.from=50|check_rail.1.beam.from: between 50 and 50.4 m stand fewer than two sleepers
check_rail.1.beam.side=3|check_rail.1.beam.side: 3.[0-9]* m beside the middle of sleeper
check_rail.1.beam.mass=0|mass must be greater than 0
check_rail.1.beam.stiffness=-1|stiffness must be greater than 0
check_rail.1.beam.lateral_damping=-1|lateral_damping must be greater than 0
model=moving_mass|dofs: spatial is not for model: moving_mass
dofs=lateral|dofs must be one of vertical, spatial
EOF

# What a spatial track needs, one key after the other taken away.
for key in lateral_bending_stiffness yaw_inertia torsional_stiffness polar_inertia head_height foot_depth lateral_stiffness lateral_damping \
	width longitudinal_stiffness longitudinal_damping; do
	sed "/^    $key:/d" $track >"$tmp/less.yaml"
	refuses 1 "$key: dofs: spatial needs it" "spatial without $key" $bin/vxtrack --set dofs=spatial "$tmp/less.yaml"
done
sed '/lateral_shear_stiffness/d' $track >"$tmp/less.yaml"
refuses 1 "rail.lateral_shear_stiffness: dofs: spatial needs it" "a spatial Timoshenko rail without lateral shear stiffness" \
	$bin/vxtrack --set dofs=spatial --set rail.beam=timoshenko "$tmp/less.yaml"

# The spatial turnout goes through receptance, modes, statics and stiffness; a vertical track does not move sideways.
$bin/vxtrack --set dofs=spatial -o "$tmp/s.trk" $turnout && $bin/vxinfo "$tmp/s.trk" >"$tmp/info" && grep -q 'A.p  *i64  *3617 ' "$tmp/info" &&
	grep -q 'check.node  *i64  *12 ' "$tmp/info" && grep -q '^DOFS= spatial' "$tmp/info"
ok $? "the spatial turnout builds, its check rail over twelve sleepers, with 3616 degrees of freedom"
$bin/vxfreq --static --load 1000 "$tmp/s.trk" | grep -q '^seat force' && $bin/vxfreq --stiffness --every 10 "$tmp/s.trk" >"$tmp/out" &&
	$bin/vxfreq --modes 4 --near 113 --text "$tmp/s.trk" | grep -q 'lateral'
ok $? "statics, stiffness and modes, which are named by kind"
$bin/vxtrack --set dofs=spatial -o "$tmp/s.trk" $track
peak() { $bin/vxfreq --receptance --excite left --peaks --direction lateral "$@" "$tmp/s.trk"; }
peak --to 200 | awk '/^peak/ { exit !($2 > 112.2 && $2 < 114.2 && $3 > 1.0e-7 && $3 < 1.04e-7) }'
ok $? "sideways a rail of the straight track peaks at 113 Hz with 1.02e-7 m/N"
peak --at midspan --from 380 --to 420 | awk '/^peak/ && $2 > 395 && $2 < 398 { good = 1 } END { exit !good }'
ok $? "and between sleepers at 396 Hz, pinned-pinned: sqrt(4 EI/(L I))/2 pi = 397 Hz"
$bin/vxfreq --receptance --direction lateral --motion-direction vertical --excite left "$tmp/s.trk" >"$tmp/out" &&
	$bin/vxinfo "$tmp/out" | grep -q '^FORCE_DIRECTION= lateral' && $bin/vxinfo "$tmp/out" | grep -q '^MOTION_DIRECTION= vertical'
ok $? "force and motion have a direction each"
refuses 2 "direction lateral: a vertical track does not move sideways" "a vertical track pushed sideways" $bin/vxfreq --receptance --direction lateral "$tmp/a.trk"
refuses 2 "direction does not go with --modes" "a direction of modes" $bin/vxfreq --modes 2 --direction lateral "$tmp/s.trk"

# The same in a file: the place of it too.  s/FROM/TO/ | what the line must hold after the name of the file, LINE the first that is edited
while IFS='|' read -r edit word; do
	sed "$edit" $turnout >"$tmp/bad.yaml"
	line=$(awk 'NR == FNR { a[FNR] = $0; next } $0 != a[FNR] { print FNR; exit }' $turnout "$tmp/bad.yaml")
	refuses 1 "bad.yaml:$(echo "$word" | sed "s/LINE/$line/")" "refused with its place: $edit" $bin/vxtrack "$tmp/bad.yaml"
done <<'EOF'
s/stiffness: 300e6/stiffness: -300e6/|LINE:16: error: stiffness must be greater than 0
s/damping: 120e3/damping: -120e3/|LINE:14: error: damping must be at least 0
s/380.0, 383.8/0, 383.8/|LINE:15: error: mass must be greater than 0
s/380.0, 383.8/380.0 383.8/|LINE:15: error: mass: "380.0 383.8" is not a plain number
s/0.0000, -0.0131/20, -0.0131/|LINE:15: error: centre must be at least -10 and at most 10 m, not 20
s/number: .1, 11, 21/number: [1, 21, 11/|LINE:23: error: mass: places must increase
s/rail: left/rail: frog/|LINE:52: error: rail must be one of left, right, both, not "frog"
s/closure, sleepers/closure, sleeper/|LINE:23: error: unknown key sleeper in zone, did you mean sleepers
s/..70, 90.., rail: left/[70, 90], rail: left/|LINE:35: error: sleepers: a pair
s/50.592,/-50.592,/|LINE:[0-9]*: error: curve.2.from: -50.592 must be beyond
s/.91, 100./[85, 100]/|[0-9]*:[0-9]*: error: zone.3.sleepers: the left railpad of sleeper 85 is in two zones, closure and crossing
s/.91, 100./[91, 1000]/|LINE:[0-9]*: error: zone.2.sleepers: .91, 1000. is not within the track
EOF

refuses 1 "sleeper 5: 1 of its railpads and ballast springs is there" "a sleeper on its middle alone" $bin/vxtrack \
	--set 'ballast.left.stiffness={number: [4, 5, 6], value: [1e8, 0, 1e8]}' \
	--set 'ballast.right.stiffness={number: [4, 5, 6], value: [1e8, 0, 1e8]}' --set 'railpad.missing=[{sleepers: [[5, 5]]}]' $turnout
refuses 1 "a moving mass has both" "a moving mass without a railpad" $bin/vxtrack --set 'railpad.missing=[{sleepers: [[1, 1]]}]' data/tracks/moving-mass.yaml
refuses 1 "no void beneath" "a moving mass over a void" $bin/vxtrack --set ballast.gap=1e-3 data/tracks/moving-mass.yaml
refuses 1 "a lumped rail needs it" "pitch inertia of one lumped rail alone" sh -c "sed '/pitch_inertia: 1.25/d' $track | $bin/vxtrack --set rail.left.pitch_inertia=1.25 -"

# A rail's mass and a void change what they should: kg on the node, m under a wheel.
$bin/vxtrack --set 'rail.left.mass={station: [0, 1.2], value: [60, 180]}' -o "$tmp/heavy.trk" $track
$bin/vxdump --csv "$tmp/heavy.trk" rail.mass | awk -F, 'NR == 2 { left = $26 } NR == 3 { right = $26 } END { exit !(left > 53.9999 && left < 54.0001 && right == 36) }'
ok $? "mass 60 to 180 kg/m over 1.2 m: 54 kg at 0.3 m, 36 kg beside it"
gap() { $bin/vxtrack --set "ballast.gap={number: [0, 1, 2], value: [0, $1, 0]}" $track | $bin/vxfreq --static --load 60000 --x 0.3 - | awk '/^deflection/ { print $2 }'; }
[ "$(gap 1e-9)" = 0.000298623 ] && [ "$(gap 0.05)" = "$($bin/vxtrack --set 'ballast.stiffness={number: [0, 1, 2], value: [280e6, 1e-9, 280e6]}' $track |
	$bin/vxfreq --static --load 60000 --x 0.3 - | awk '/^deflection/ { print $2 }')" ]
ok $? "a gap of nothing is linear ballast, one of 50 mm is none"
awk -v a="$(gap 0.0002)" 'BEGIN { exit !(a > 0.00037 && a < 0.000375) }'
ok $? "one of 0.2 mm closes under 60 kN a rail"

$bin/vxtrack --set railpad.stiffness=300 --set rail.elements_per_bay=2 $track 2>"$tmp/err" >"$tmp/out"
ok $? "numbers that are possible and hardly meant"
is=$(cat "$tmp/err")
echo "$is" | grep -q '^vxtrack: doubt: a railpad of sleeper -24 has 300 N/m$' && echo "$is" | grep -q '^vxtrack: doubt: rail.pitch_inertia: 1.25 ' &&
	[ "$(wc -l <"$tmp/err")" -eq 2 ]
ok $? "are doubted on standard error"
for input in data/tracks/*.yaml; do $bin/vxtrack "$input" 2>&1 >"$tmp/out" | grep doubt; done >"$tmp/err"
[ ! -s "$tmp/err" ]
ok $? "none of the tracks here"
refuses 1 "^vxtrack: /tmp: Is a directory" "a folder" $bin/vxtrack /tmp

sed 's/stiffness: 300e6/stiffness: 300 MN/' $track >"$tmp/unit.yaml"
refuses 1 "unit.yaml:[0-9]*:[0-9]*: error: " "a unit in a number, told with its place" $bin/vxtrack "$tmp/unit.yaml"
if [ -c /dev/full ]; then
	refuses 1 "No space" "a full disk" sh -c "$bin/vxtrack $track >/dev/full"
else
	ok 0 "a full disk # SKIP no /dev/full"
fi
echo "1..$n"
