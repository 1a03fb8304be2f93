#!/bin/sh
# vxvehicle: the shipped vehicles stand, files round-trip, and what is wrong is refused in one line, with nothing on standard output.
set -u
bin=$PWD/build/bin data=$PWD/data/vehicles
tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT
n=0

# is STATUS NAME COMMAND...: the exit status, and for a failure one line on stderr and none on stdout.
is() {
    want=$1 name=$2; shift 2
    n=$((n + 1))
    "$@" >"$tmp/out" 2>"$tmp/err"; got=$?
    if [ $got -eq "$want" ] && { [ "$want" -eq 0 ] || { [ ! -s "$tmp/out" ] && [ "$(wc -l <"$tmp/err")" -eq 1 ]; }; }; then
        echo "ok $n - $name"
    else
        echo "not ok $n - $name"
        echo "# exit $got, should be $want"; sed 's/^/# /' "$tmp/out" "$tmp/err" | head -5
    fi
}

# says NAME TEXT: the last command printed it.
says() {
    n=$((n + 1))
    if cat "$tmp/out" "$tmp/err" | grep -qF -- "$2"; then echo "ok $n - $1"; else echo "not ok $n - $1"; sed 's/^/# /' "$tmp/out" "$tmp/err"; fi
}

coach=$data/manchester-passenger.yaml
is 0 "the Manchester coach" "$bin/vxvehicle" --check "$coach"
says "weighs 44 482 kg" "mass       44482 kg"
says "and stands with 54.55 kN a wheel" "left 54546.1 N  right 54546.1 N"
is 0 "the coach of 19 t" "$bin/vxvehicle" --check "$data/passenger-19t.yaml"
says "stands with 93.2 kN a wheel" "left 93195.0 N  right 93195.0 N"
is 0 "the wagon of 22.5 t" "$bin/vxvehicle" --check "$data/freight-y25-22t5.yaml"
says "stands with 110.4 kN a wheel" "left 110362.5 N  right 110362.5 N"
is 0 "empty" "$bin/vxvehicle" --check "$data/freight-y25-tare.yaml"
says "24.5 kN" "left 24525.0 N  right 24525.0 N"
is 0 "a single wheelset" "$bin/vxvehicle" --check "$data/wheelset.yaml"
is 0 "the example of the man page" "$bin/vxvehicle" --check --set body.1.mass=40000 "$coach"
says "has its 52 482 kg" "mass       52482 kg"

is 0 "a check" "$bin/vxvehicle" --check "$coach"
says "tells what is held" "support    every body is held"
says "how far a spring is bent" "primary1-r       carries 45653.3 N  bent by 37.421 mm"
says "how a clearance is used" "bumpstop1        along y  clearance 25 mm  used at rest 0 mm"
says "and that nothing is doubtful" "doubts     0"
# doubts NAME KEY=VALUE TEXT: --check of the coach with this value says so.
doubts() {
    is 0 "doubtful: $1" "$bin/vxvehicle" --check --set "$2" "$coach"
    says "and says so" "doubt      $3"
}
doubts "a mass in t" body.1.mass=32 "body carbody: a mass of 32 kg; kg are wanted, not t"
doubts "a stiffness a million times too small" "coupling.7.rotation=[940e3, 0, 1.2]" "coupling antirollbar1: 1.2 N m/rad about z"
doubts "a damping of Ns/mm" "coupling.1.damping=[15, 2, 4]" "coupling primary1-r: 2 N s/m along y"
doubts "inertias of no body" "body.1.inertia=[4e6, 1.97e6, 1.97e6]" "body carbody: no body has these inertias, that about x is more than the other two"
doubts "a wrong coordinate" "coupling.5.at=[-1.28, 10, 0.8275]" "coupling secondary1-r: 8.62 m off body bogie1"
doubts "a carbody of a tall box" "body.1.inertia=[250e3, 1.97e6, 1.97e6]" "body carbody: a box of its inertias, "
doubts "a carbody off the middle" body.1.y=0.05 "wheelset wheelset1: "
"$bin/vxvehicle" --check --set "coupling.5.stiffness=[160e3, 160e3, 0.43]" "$coach" >"$tmp/out" 2>"$tmp/err"
status=$?
n=$((n + 1)); [ $status -eq 1 ] && echo "ok $n - a spring that does not carry is refused" || echo "not ok $n - a spring that does not carry is refused"
says "with the doubt that may be why" "doubt      coupling secondary1-r: 0.43 N/m along z"

cat >"$tmp/two.yaml" <<'END'
vehicle:
  name: two-axle-wagon
  body: [{name: body, mass: 18000, inertia: [30e3, 250e3, 255e3], x: -4, height: 1.6}]
  bogie:
    - at: [0, -8]
      wheelset: [{name: ws, mass: 1300, inertia: [700, 100, 700], x: 0, radius: 0.46}]
      coupling: [{name: guide, from: ws, to: body, at: [0, 1, 0.46], mirror: true, stiffness: [3e6, 0.8e6, 0], damping: [5e3, 5e3, 3e3]}]
      spring: [{name: leaf, from: ws, to: body, at: [0, 1, 0.46], mirror: true, table: [[0, 0], [0.03, 30e3], [0.06, 90e3]]}]
END
is 0 "springs of a table" "$bin/vxvehicle" --check "$tmp/two.yaml"
says "that is not doubtful" "doubts     0"
sed 's/name: leaf, from: ws, to: body/name: leaf, from: body, to: ws/' "$tmp/two.yaml" >"$tmp/doubt.yaml"
is 0 "the wrong way round" "$bin/vxvehicle" --check "$tmp/doubt.yaml"
says "lie before the table at rest" "doubt      coupling leaf1-r: at rest at -0.04414 m, beyond its table of 0 to 0.06 m"
sed 's/0.06, 90e3/0.06, 40e3/' "$tmp/two.yaml" >"$tmp/doubt.yaml"
is 0 "too heavy a load" "$bin/vxvehicle" --check "$tmp/doubt.yaml"
says "lies beyond the table" "doubt      coupling leaf2-l: at rest at 0.0"
sed 's/0.03, 30e3/30, 30e3/; s/0.06, 90e3/60, 90e3/' "$tmp/two.yaml" >"$tmp/doubt.yaml"
"$bin/vxvehicle" --check "$tmp/doubt.yaml" >"$tmp/out" 2>"$tmp/err"
says "a table in mm bends it by metres" "doubt      coupling leaf1-r: bent by 37.1 m at rest"

is 0 "a file" "$bin/vxvehicle" -o "$tmp/a.veh" "$coach"
is 0 "is a container" "$bin/vxinfo" "$tmp/a.veh"
says "with the stiffness of seven bodies" "K                        f64   42 x 42"
(cd "$tmp" && "$bin/vxvehicle" -o b.veh "$coach")
is 0 "the same command twice, the same bytes" cmp "$tmp/a.veh" "$tmp/b.veh"
is 0 "standard input gives the same vehicle" sh -c "'$bin/vxvehicle' - <'$coach' >'$tmp/c.veh'"
is 0 "to standard output" "$bin/vxinfo" "$tmp/c.veh"

is 0 "-h" "$bin/vxvehicle" -h
says "is the synopsis" "vxvehicle [--set KEY=VALUE]... [--check] [-o FILE] INPUT"
is 0 "--schema" "$bin/vxvehicle" --schema
says "names every key" "coupling.N.rotation_damping"
# The table of the page is the schema's, but for the parts of a bogie, which are those of the vehicle.
"$bin/vxvehicle" --schema | awk -F'\t' 'NR > 1 && $1 !~ /^bogie\.N\.[b-z]/ {
    words = $4; gsub(/[|]/, ", ", words); print ".It " $1 " Ta " $3 " Ta " $5 " Ta " $6 ($2 == "word" ? " (" words ")" : "")}' >"$tmp/schema"
sed -n '/^\.It Sy key/,/^\.El/{/^\.It Sy key/d; /^\.El/d; /^\.It bogie\.N\.body to /d; p}' man/vehicle-input.5 >"$tmp/page"
is 0 "vehicle-input(5) has the keys of --schema" cmp "$tmp/page" "$tmp/schema"
is 0 "--master" "$bin/vxvehicle" --master

is 2 "no input" "$bin/vxvehicle"
is 2 "an unknown option" "$bin/vxvehicle" --chek "$coach"
is 2 "--schema with an input" "$bin/vxvehicle" --schema "$coach"
is 2 "--check with -o" "$bin/vxvehicle" --check -o "$tmp/x.veh" "$coach"
is 1 "no such file" "$bin/vxvehicle" "$tmp/none.yaml"
is 1 "a binary file" "$bin/vxvehicle" "$tmp/a.veh"
is 1 "an override of no key" "$bin/vxvehicle" --set body.1.weight=1 "$coach"
is 1 "an override of no body" "$bin/vxvehicle" --set body.9.mass=1 "$coach"
is 1 "a full disk" sh -c "'$bin/vxvehicle' '$coach' >/dev/full"

# refused NAME SED TEXT: the coach after this change, with a message that holds TEXT.
refused() {
    sed "$2" "$coach" >"$tmp/bad.yaml"
    is 1 "refused: $1" "$bin/vxvehicle" "$tmp/bad.yaml"
    says "and says so" "$3"
}
refused "a unit in a number" 's/mass: 32000 /mass: 32 t /' "bad.yaml:"
refused "an unknown key" 's/      height: 1.8/      hight: 1.8/' "height"
refused "a missing inertia" '/inertia: \[56800/d' "inertia"
refused "zero inertia" 's/\[56800,/[0,/' "inertia"
refused "two inertias" 's/\[56800, 1.97e6,/[56800,/' "body carbody: inertia must be three numbers"
refused "a doubled name" 's/name: bogie2/name: bogie1/' "body bogie1: two bodies have this name"
refused "a missing body" 's/from: bogie1/from: boogie/' "there is no body or wheelset boogie"
refused "a body without support" 's/430e3\]/0]/' "body carbody: vertical springs do not carry its weight"
refused "a body that slides" 's/\[160e3, 160e3/[0, 160e3/' "body carbody: nothing holds it along x"
refused "an axlebox off its axle, with its line" 's/at: \[0, 1.0, 0.46\]/at: [0, 1.0, 0.5]/' \
    "bad.yaml:$(grep -n 'name: primary1' "$coach" | cut -d: -f1): error: coupling primary1-r: must sit on the axle"
refused "an axlebox off its axle" 's/at: \[0, 1.0, 0.46\]/at: [0, 1.0, 0.5]/' "must sit on the axle of wheelset wheelset1"
refused "a stop that falls" 's/\[0.035, 1760\]/[0.035, 60]/' "stop bumpstop1: its table does not rise"
refused "a missing body, with its line" 's/from: bogie1/from: boogie/' "bad.yaml:$(sed -n '/from: bogie1/{=;q;}' "$coach" | awk '{print $1 - 1}'): error:"

# The wagon after this change.
wagon=$data/freight-y25-22t5.yaml
refused_wagon() {
    sed "$2" "$wagon" >"$tmp/bad.yaml"
    is 1 "refused: $1" "$bin/vxvehicle" "$tmp/bad.yaml"
    says "and says so" "$3"
}
refused_wagon "friction of a spring that is none" 's/spring: nest-a/spring: nest-x/' "there is no coupling or spring nest-x"
refused_wagon "frictions that load each other" 's/spring: nest-a/spring: lenoir-b/' "error: friction lenoir-a1: there is no coupling or spring lenoir-b"
refused_wagon "a friction that loads itself" 's/spring: nest-a/spring: lenoir-a/' "error: friction lenoir-a1: there is no coupling or spring lenoir-a"
refused_wagon "friction without a stick stiffness" 's/\[0, 8e6, 8e6\]/[0, 0, 0]/' "needs a stick stiffness"
refused_wagon "a torque without its lever" 's/radius: 0.127 .*//' "a radius goes with a rotation"
refused_wagon "friction that gives energy" 's/coefficient: 0.3 /coefficient: -0.3 /' "coefficient must be at least 0"
refused_wagon "a spring that falls" 's/\[0.060, 104.8e3\]/[0.060, 10e3]/' "spring nest-a1-r: its table does not rise"
refused_wagon "springs that end before the weight does" 's/\[0.060, 104.8e3\]/[0.060, 32e3]/' "vertical springs do not carry its weight"
refused_wagon "a preload its table has not" 's/, \[0.0375, 20.6e3\], \[0.0385, 50.6e3\]/, [0.01, 10e3], [0.02, 10e3]/' "spring bearer1-r: its table does not reach its preload"
refused_wagon "two bogies at one place" 's/at: \[-0.9, -14.96\]/at: [-0.9, -0.9]/' "is not behind the wheelset before it"
refused_wagon "a bogie in a bogie" 's/^      stop:/      bogie:/' "unknown key bogie in bogie"

# rig MORE: a frame on a wheelset, and what else is on it.
rig() {
    cat <<END
vehicle:
  name: rig
  body:
    - {name: frame, mass: 10000, inertia: [9300, 9300, 9300], x: 0, height: 0.6}
  wheelset:
    - {name: wheelset, mass: 1800, inertia: [1100, 110, 1100], x: 0, radius: 0.46}
  coupling:
    - {name: primary, from: wheelset, to: frame, at: [0, 1, 0.46], mirror: true, stiffness: [3e6, 4e6, 1e6], rotation: [0, 1e7, 0]}
END
    printf '  %s\n' "$@"
}
rig >"$tmp/bad.yaml"
is 0 "a rig" "$bin/vxvehicle" --check "$tmp/bad.yaml"
tried() {
    rig "$2" >"$tmp/bad.yaml"
    is 1 "refused: $1" "$bin/vxvehicle" "$tmp/bad.yaml"
    says "and says so" "$3"
}
tried "a rod without length" "rod: [{name: r, from: wheelset, to: frame, at: [0, 0, 0.46], end: [0, 0, 0.46], stiffness: 1e6}]" "ends are 0 m apart"
tried "a rod off its axle" "rod: [{name: r, from: wheelset, to: frame, at: [0, 0, 0.5], end: [1, 0, 0.46], stiffness: 1e6}]" "must sit on the axle"
tried "a line without an end" "damper: [{name: d, from: wheelset, to: frame, at: [0, 0, 0.46], axis: line, table: [[0, 0], [1, 1e3]]}]" \
    "bad.yaml:9: error: damper d: axis line and an end go together"
tried "a damper that pushes" "damper: [{name: d, from: wheelset, to: frame, at: [0, 0, 0.46], axis: x, table: [[0, 10], [1, 1e3]]}]" "must start at 0 m/s"
tried "a damper that gives way" "damper: [{name: d, from: wheelset, to: frame, at: [0, 0, 0.46], axis: x, table: [[0, 0], [1, 1e3], [2, 1e3]]}]" \
    "does not rise"
tried "a spring across with a load" "spring: [{name: s, from: wheelset, to: frame, at: [0, 0, 0.46], axis: y, table: [[0, 10], [1, 1e3]]}]" "needs a row 0, 0"
tried "friction without a load" "friction: [{name: f, from: wheelset, to: frame, at: [0, 0, 0.46], coefficient: 1, stiffness: [1, 0, 0]}]" "needs a load or a spring"
tried "two couplings of one name" "stop: [{name: primary-r, from: wheelset, to: frame, at: [0, 0, 0.46], axis: y, table: [[0, 0], [1, 1]]}]" "bad.yaml:8: error: coupling primary-r: two are named primary-r"
tried "an anchor" "stop: &a []" "bad.yaml:9:"

# A ring of couplings is a vehicle: three rods from frame to wheelset close it many times.
rig "rod: [{name: a, from: wheelset, to: frame, at: [0, 1, 0.46], end: [1, 1, 0.46], stiffness: 1e6}," \
    "  {name: b, from: frame, to: wheelset, at: [1, -1, 0.46], end: [0, -1, 0.46], stiffness: 1e6}]" >"$tmp/ring.yaml"
is 0 "couplings in a ring" "$bin/vxvehicle" --check "$tmp/ring.yaml"

# Ten thousand bodies, one on the other.
{
    echo "vehicle:"; echo "  name: tower"; echo "  body:"
    awk 'BEGIN {for (i = 1; i <= 10000; i++) printf "    - {name: b%d, mass: 1, inertia: [1, 1, 1], x: 0, height: 1}\n", i}'
    echo "  wheelset: [{name: w, mass: 1, inertia: [1, 1, 1], x: 0, radius: 0.5}]"
} >"$tmp/bad.yaml"
is 1 "refused: ten thousand bodies" "$bin/vxvehicle" "$tmp/bad.yaml"
says "and says so" "10001 bodies and wheelsets are more than 500"

# A vehicle file cut anywhere is no vehicle.
size=$(wc -c <"$tmp/a.veh")
for part in 0 10 64 500 $((size / 2)) $((size - 1)); do
    head -c "$part" "$tmp/a.veh" >"$tmp/cut.veh"
    is 1 "cut to $part bytes" "$bin/vxinfo" "$tmp/cut.veh"
done
echo "1..$n"
