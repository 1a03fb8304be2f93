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
doubts "a carbody off the middle" body.1.y=0.05 "wheelset wheelset1: "
"$bin/vxvehicle" --check --set "coupling.5.stiffness=[160e3, 160e3, 0.43]" "$coach" >"$tmp/out" 2>"$tmp/err"
status=$?
n=$((n + 1)); [ $status -eq 1 ] && echo "ok $n - a spring that does not carry is refused" || echo "not ok $n - a spring that does not carry is refused"
says "with the doubt that may be why" "doubt      coupling secondary1-r: 0.43 N/m along z"

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
refused "an axlebox off its axle" 's/at: \[0, 1.0, 0.46\]/at: [0, 1.0, 0.5]/' "must sit on the axle of wheelset wheelset1"
refused "a stop that falls" 's/\[0.035, 1760\]/[0.035, 60]/' "stop bumpstop1: its table does not rise"

# A vehicle file cut anywhere is no vehicle.
size=$(wc -c <"$tmp/a.veh")
for part in 0 10 64 500 $((size / 2)) $((size - 1)); do
    head -c "$part" "$tmp/a.veh" >"$tmp/cut.veh"
    is 1 "cut to $part bytes" "$bin/vxinfo" "$tmp/cut.veh"
done
echo "1..$n"
