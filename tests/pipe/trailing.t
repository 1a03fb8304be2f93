#!/bin/sh
# Direction trailing: what is the same the other way round, what is not, and where it is told.
. tests/tap.sh
. tests/passage.sh

plain_tables && coach
ok $? "contact tables and coach"
cat >"$dir/case.yaml" <<'END'
case: {name: trailing, speed_kmh: 80, start: -8, end: 8, sampling: 1000, channels: {pads: true, ballast: false, sleepers: true, rails: false}}
END
passage="vxrun --vehicle $dir/coach.veh --contact-left $dir/l.ctab --contact-right $dir/r.ctab"
run()
{
    $passage "$@" "$dir/case.yaml"
}

# apart A B SIGN: the largest difference of wheel forces between two CSV of columns, as a share of the largest Q; B has sides exchanged
# and stations and Y of the opposite sign where SIGN is -1.
apart()
{
    paste -d, "$1" "$2" | awk -F, -v sign="$3" '
        NR == 1 {for (i = 1; i <= NF; i++) if (i <= NF/2) a[$i] = i; else b[$i] = i; next}
        {
            if (($a["station"] - sign*$b["station"])^2 > 1e-18) wrong = 1
            for (w = 1; w <= 4; w++) for (s = 1; s <= 2; s++) {
                other = sign < 0 ? 3 - s : s
                q = $a["wheel.Q:" w ":" s]; d = q - $b["wheel.Q:" w ":" other]
                y = $a["wheel.Y:" w ":" s] - sign*$b["wheel.Y:" w ":" other]
                if (q > most) most = q
                if (d*d > worst*worst) worst = d
                if (y*y > worst*worst) worst = y
            }
        }
        END {print wrong || NR < 3 ? "stations differ" : sqrt(worst*worst)/most}'
}
forces()
{
    columns "$1" station wheel.Q wheel.Y
}

# Sleepers and dip lie symmetrically about station 0, so there and back are the same.
vxtrack --set from=-45 --set length=90 -o "$dir/d.trk" data/tracks/thesis-straight.yaml
dip='dip=[{from: -0.5, length: 1.0, depth: 1e-3}]'
run --track "$dir/d.trk" --set "$dip" -o "$dir/f.run" && run --track "$dir/d.trk" --set "$dip" --set direction=trailing --set start=8 --set end=-8 -o "$dir/b.run"
ok $? "there and back over a dip"
forces "$dir/f.run" >"$dir/f.csv"
forces "$dir/b.run" >"$dir/b.csv"
between "$(apart "$dir/f.csv" "$dir/b.csv" -1)" 0 1e-9 "difference of Q and Y over the largest Q, sides exchanged"
like "$(vxinfo "$dir/b.run")" '^DIRECTION= trailing' "the run says so"

# A dip of the left rail stays on the left.
left='dip=[{from: -0.5, length: 1.0, depth: 1e-3, rail: left}]'
run --track "$dir/d.trk" --set "$left" -o "$dir/f.run" && run --track "$dir/d.trk" --set "$left" --set direction=trailing --set start=8 --set end=-8 -o "$dir/b.run"
largest()
{
    vxpost --wheels "$1" | awk -F, -v side="$2" '$1 == 1 && $2 == side {print $4}'
}
is "$(largest "$dir/b.run" l)" "$(largest "$dir/f.run" l)" "a dip of the left rail: the same largest Q on the left"
is "$(largest "$dir/b.run" r)" "$(largest "$dir/f.run" r)" "and on the right"

# A canted curve with pads, sleepers and ballast of their own on one side, and the same track described from its other end.
side='rail.left.bending_stiffness={station: [-60, 60], value: [6.11e6, 8e6]}'
other='rail.right.bending_stiffness={station: [-60, 60], value: [8e6, 6.11e6]}'
vxtrack --set from=-45 --set length=90 --set "$side" --set 'curve=[{from: -4, curvature: 0.002}]' \
    --set 'cant={station: [-6, 4], value: [0, 0.05]}' --set 'ballast.left.stiffness=120e6' -o "$dir/a.trk" data/tracks/thesis-straight.yaml
ok $? "a track"
vxtrack --set from=-45 --set length=90 --set "$other" --set 'curve=[{from: -90, curvature: -0.002}, {from: 4, curvature: 0}]' \
    --set 'cant={station: [-4, 6], value: [-0.05, 0]}' --set 'ballast.right.stiffness=120e6' -o "$dir/z.trk" data/tracks/thesis-straight.yaml
ok $? "the same from its other end"
run --track "$dir/a.trk" -o "$dir/a.run" && run --track "$dir/z.trk" --set direction=trailing --set start=8 --set end=-8 -o "$dir/z.run"
ok $? "facing on the one, trailing on the other"
forces "$dir/a.run" >"$dir/a.csv"
forces "$dir/z.run" >"$dir/z.csv"
between "$(apart "$dir/a.csv" "$dir/z.csv" -1)" 0 1e-6 "difference of Q and Y over the largest Q"
columns "$dir/a.run" station body.q pad.F sleeper.roll >"$dir/a.csv"
columns "$dir/z.run" station body.q pad.F sleeper.roll >"$dir/z.csv"
# Body 1: x y z roll pitch yaw; 150 sleepers: the last of the right rail is the first of the left one.
paste -d, "$dir/a.csv" "$dir/z.csv" | awk -F, '
    NR == 1 {for (i = 1; i <= NF; i++) if (i <= NF/2) a[$i] = i; else b[$i] = i; next}
    {
        sum += $a["body.q:1:2"]^2 + $a["body.q:1:6"]^2
        off += ($a["body.q:1:2"] + $b["body.q:1:2"])^2 + ($a["body.q:1:3"] - $b["body.q:1:3"])^2 + ($a["body.q:1:6"] - $b["body.q:1:6"])^2
        for (i = 60; i < 90; i++) {
            force += $a["pad.F:1:" i]^2
            wrong += ($a["pad.F:1:" i] - $b["pad.F:2:" 151 - i])^2
            roll += $a["sleeper.roll:" i]^2
            turned += ($a["sleeper.roll:" i] + $b["sleeper.roll:" 151 - i])^2
        }
    }
    END {printf "%g\n%g\n%g\n", sqrt(off/sum), sqrt(wrong/force), sqrt(turned/roll)}' >"$dir/apart"
between "$(sed -n 1p "$dir/apart")" 0 1e-5 "carbody sideways, down and in yaw"
between "$(sed -n 2p "$dir/apart")" 0 1e-5 "forces of railpads"
between "$(sed -n 3p "$dir/apart")" 0 1e-5 "roll of sleepers"

# Going on from a state, to the bit.
back="--track $dir/z.trk --set direction=trailing --set start=8 --set end=-8"
run $back --save-state 2 -o "$dir/s.run" && run $back --start "$dir/s.state" -o "$dir/t.run"
ok $? "goes on from a state at 2 m"
forces "$dir/t.run" >"$dir/t.csv"
forces "$dir/s.run" | awk -F, -v first="$(sed -n '2s/,.*//p' "$dir/t.csv")" 'NR == 1 || $1 + 0 <= first + 0' | cmp -s - "$dir/t.csv"
ok $? "to the bit"
fails 1 "a state of the other direction" $passage --track "$dir/z.trk" --start "$dir/s.state" --set start=1 -o "$dir/x.run" "$dir/case.yaml"
fails 1 "an end beyond the start" $passage --track "$dir/z.trk" --set direction=trailing -o "$dir/x.run" "$dir/case.yaml"
like "$(cat "$dir/err")" "must lie before start" "says why"

# The coach through the diverging route, from the rear end of the turnout: nose to wing at the crossing, where it comes down harder.
turnout_tables
ok $? "tables of the turnout"
vxtrack --set length=180 -o "$dir/t.trk" data/tracks/60E1-R760-1-15-diverging.yaml
through="vxrun --track $dir/t.trk --vehicle $dir/coach.veh --contact-left $dir/tl.ctab --contact-right $dir/tr.ctab --set route=diverging"
$through --set start=20 --set end=60 -o "$dir/f.run" "$dir/case.yaml" && $through --set direction=trailing --set start=60 --set end=20 -o "$dir/b.run" "$dir/case.yaml"
ok $? "through the crossing both ways"
for run in f b; do
    vxpost --wheels "$dir/$run.run" | awk -F, '$1 == 1 && $2 == "l" {print $4, $5}' >"$dir/$run.most"
    echo "# largest Q of the front left wheel: $(cat "$dir/$run.most")"
done
read -r Q at <"$dir/b.most"
between "$Q" 80e3 160e3 "trailing"
between "$at" 46.5 47.5 "its station, in the crossing"
done_testing
