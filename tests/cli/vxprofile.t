#!/bin/sh
# vxprofile: shapes of every kind of input into .prof of either side, overrides, --check, misuse and wrong inputs.
bin=build/bin
tmp=$(mktemp -d) || exit 1
trap 'rm -rf "$tmp"' EXIT
n=0
# ok STATUS TEXT
ok() {
    n=$((n + 1))
    if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; fi
}
# fails STATUS PATTERN COMMAND...: exits so, with one line on stderr that matches and nothing on stdout
fails() {
    want=$1 pattern=$2
    shift 2
    "$@" >"$tmp/out" 2>"$tmp/err"
    got=$?
    [ $got -eq "$want" ] && [ ! -s "$tmp/out" ] && [ "$(wc -l <"$tmp/err")" -eq 1 ] && grep -q -- "$pattern" "$tmp/err"
    ok $? "exit $want: $pattern"
}
# value KEY COMMAND...: what --check says
value() {
    key=$1
    shift
    "$bin/vxprofile" --check "$@" | awk -F'\t' -v k="$key" '$1 == k {print $2}'
}

for p in profiles/S1002 profiles/60E1 turnouts/60E1-R760-1-15; do
    for s in l r; do
        $bin/vxprofile --side $s data/$p.yaml >"$tmp/$(basename $p).$s.prof"
        ok $? "data/$p.yaml, side $s"
    done
done
$bin/vxprofile --side r data/profiles/S1002.yaml -o "$tmp/again.prof" && cmp -s "$tmp/again.prof" "$tmp/S1002.r.prof"
ok $? "the same bytes with -o"
$bin/vxprofile - -o "$tmp/stdin.prof" <data/profiles/60E1.yaml && [ -s "$tmp/stdin.prof" ]
ok $? "an input on standard input"

[ "$(value position data/profiles/S1002.yaml)" = 0.750000 ] && [ "$(value position --side l data/profiles/S1002.yaml)" = -0.750000 ]
ok $? "wheels at 750 mm to either side"
[ "$(value position data/profiles/60E1.yaml)" = 0.753479 ]
ok $? "60E1 upright at 753.48 mm: its face is 35.98 mm from the centre 14 mm below the top"
[ "$(value position --set gauge=1.440 data/profiles/60E1.yaml)" = 0.755979 ]
ok $? "5 mm wider gauge moves the rail by half of it"
value residual_worst data/profiles/60E1.yaml | awk '{exit !($1 < 1e-5)}'
ok $? "the smoothed 60E1 departs less than 10 um from its arcs"
value residual_worst --set smoothing=0 data/profiles/60E1.yaml | awk '{exit !($1 < 1e-9)}'
ok $? "without smoothing it passes through them"
$bin/vxprofile --side l --check data/turnouts/60E1-R760-1-15.yaml | awk -F'\t' '
    $2 == "nose" && !nose {nose = $1} $2 == "switch and wing rail" {last = $1} $2 == "stock rail" && $1 + 0 == $1 {stock = $1}
    END {exit !(nose > 46.7 && nose < 46.9 && last > 47.9 && last < 48.1 && stock > 14 && stock < 16)}'
ok $? "turnout: stock rail to 15 m, nose from 46.8 m, wing rail to 48.0 m"
$bin/vxprofile --side r --set turnout.route=through --check data/turnouts/60E1-R760-1-15.yaml | grep -q 'nose'
ok $? "turnout, through route: the nose is on the right"
$bin/vxprofile --side l --set turnout.route=through --set turnout.hand=left --check data/turnouts/60E1-R300-1-9.yaml | grep -q 'nose'
ok $? "of the other hand on the left again"
$bin/vxprofile --side r --set turnout.check_rail.body=true --check data/turnouts/60E1-R300-1-9.yaml | grep -q 'check rail'
ok $? "the check rail is a body where told so"
$bin/vxprofile --side r --check data/turnouts/60E1-R300-1-9.yaml | grep -q 'check rail'
[ $? = 1 ]
ok $? "and else none"

# The same circle of 100 mm in metres, in millimetres, and as measured towards the track's centre with z up.
awk 'BEGIN {for (y = -0.05; y < 0.0501; y += 0.0005) printf "%.9f %.9f\n", y, 0.1 - sqrt(0.01 - y * y)}' >"$tmp/m.txt"
awk '{printf "%.6f %.6f\n", 1e3 * $1, 1e3 * $2}' "$tmp/m.txt" >"$tmp/mm.txt"
awk '{printf "%.9f %.9f\n", -$1, -$2}' "$tmp/m.txt" >"$tmp/turned.txt"
$bin/vxprofile --part rail --unit m --set gauge_depth=0.01 "$tmp/m.txt" -o "$tmp/m.prof" &&
    $bin/vxprofile --part rail --unit mm --set gauge_depth=0.01 "$tmp/mm.txt" -o "$tmp/mm.prof" &&
    $bin/vxprofile --part rail --unit m --set gauge_depth=0.01 --set mirror_y=true --set mirror_z=true "$tmp/turned.txt" -o "$tmp/turned.prof"
ok $? "plain points"
$bin/vxdump --csv "$tmp/m.prof" curvature | awk 'NR > 40 && NR < 1000 && ($1 < 9.9 || $1 > 10.1) {bad = 1} END {exit bad}'
ok $? "a circle of radius 100 mm has curvature 10 1/m"
for k in m mm turned; do $bin/vxdump --csv "$tmp/$k.prof" y z | awk 'NR > 1 {print $1, $2}' FS='[,\t]' >"$tmp/$k.csv"; done
# The texts are rounded to 1 nm.
for k in mm turned; do
    paste -d' ' "$tmp/m.csv" "$tmp/$k.csv" |
        awk '{d = ($1 - $3) ^ 2 + ($2 - $4) ^ 2; if (d > w) w = d} END {exit !(NR > 900 && NF == 4 && w < 1e-16)}' || echo "$k" >>"$tmp/differ"
done
[ ! -s "$tmp/differ" ]
ok $? "unit, mirror_y and mirror_z bring them to the same curve"
cat >"$tmp/in.yaml" <<E2
profile: {name: circle, part: rail, unit: m, file: m.txt, gauge_depth: 0.01}
E2
$bin/vxprofile --check "$tmp/in.yaml" | grep -q '^name	circle'
ok $? "a file named by an input lies beside it"

fails 2 'one input' $bin/vxprofile
fails 2 'unknown option' $bin/vxprofile --sides l data/profiles/60E1.yaml
fails 2 '--side must be one of' $bin/vxprofile --side x data/profiles/60E1.yaml
fails 2 '--part wheel|rail and --unit m|mm' $bin/vxprofile "$tmp/m.txt"
fails 2 'says its own' $bin/vxprofile --part rail --unit m data/profiles/60E1.yaml
fails 1 'No such file' $bin/vxprofile "$tmp/none.prr"
fails 1 'wing_rail: opens by' $bin/vxprofile --set turnout.wing_rail.opening=0.03 data/turnouts/60E1-R300-1-9.yaml
fails 1 'two pairs' $bin/vxprofile --set 'turnout.check_rail.flangeway=[[0, 0.04]]' data/turnouts/60E1-R300-1-9.yaml
fails 1 'wrong unit' $bin/vxprofile --part rail --unit m "$tmp/mm.txt"
fails 1 'gauge is measured' $bin/vxprofile --part rail --unit m --set gauge_depth=0.02 "$tmp/m.txt"
fails 1 'unit: must be stated' $bin/vxprofile --set unit=unstated data/profiles/60E1.yaml
fails 1 'one of file, zones and points' $bin/vxprofile --set file=x.prr data/profiles/60E1.yaml
fails 1 'zones must follow one another' $bin/vxprofile --set zones.2.to=20 data/profiles/60E1.yaml
fails 1 'either polynomial, or centre' $bin/vxprofile --set zones.1.radius=0 data/profiles/60E1.yaml
fails 1 'rails of a turnout stand upright' $bin/vxprofile --set cant=0.025 data/turnouts/60E1-R760-1-15.yaml
fails 1 'first numbers must increase' $bin/vxprofile --set 'turnout.nose.lowering=[[0.01, 0], [0.005, 0]]' data/turnouts/60E1-R760-1-15.yaml
fails 1 'stations' $bin/vxprofile --set turnout.stations.2.from=1 data/turnouts/60E1-R760-1-15.yaml
printf 'header.begin\n type = 1\nheader.end\nspline.begin\n units.len.f = 1000\n point.begin\n 0 0\n 10 1\n 20 3\n point.end\nspline.end\n' >"$tmp/w.prr"
fails 1 'holds a wheel, not a rail' $bin/vxprofile "$tmp/w.prr"
if [ -w /dev/full ]; then
    $bin/vxprofile data/profiles/60E1.yaml >/dev/full 2>"$tmp/err"
    [ $? -eq 1 ] && [ -s "$tmp/err" ]
    ok $? "a full disk is told"
fi
echo "1..$n"
