#!/bin/sh
# Two coaches 20 m apart behave each as one alone, over a dip and started in a curve on cant; joined by a coupler they still stand.
. tests/tap.sh
. tests/passage.sh

plain_tables && coach
ok $? "contact tables and coach"
gap=20
vxvehicle --join $gap -o "$dir/two.veh" "$dir/coach.veh" "$dir/coach.veh"
ok $? "two coaches"
behind=$(vxdump --csv "$dir/coach.veh" body.cg | awk -F, -v gap=$gap 'NR > 1 && $1 < least {least = $1} END {print least - gap}')
echo "# the second one stands ${behind} m ahead of the first"
is "$(vxinfo "$dir/two.veh" | grep -c '2[ ]*x[ ]*84\|84 x 84')" 3 "matrices of fourteen bodies"
like "$(vxfreq --modes 2 --text "$dir/two.veh" | head -n 3)" '\.2' "names say which"

cat >"$dir/case.yaml" <<'END'
case: {name: train, speed_kmh: 80, start: -8, end: 2, sampling: 1000, channels: {pads: false, ballast: false, sleepers: false, rails: false}}
END
run()
{
    vxrun --contact-left "$dir/l.ctab" --contact-right "$dir/r.ctab" --track "$dir/t.trk" "$@" "$dir/case.yaml"
}

# apart SKIP ALONE.run: largest difference of Q and Y of four wheelsets of the train, from column SKIP on, over the largest Q.
apart()
{
    columns "$dir/two.run" wheel.Q >"$dir/q2" && columns "$dir/two.run" wheel.Y >"$dir/y2" && columns "$2" wheel.Q >"$dir/q1" && columns "$2" wheel.Y >"$dir/y1"
    paste -d, "$dir/q2" "$dir/y2" "$dir/q1" "$dir/y1" | awk -F, -v skip="$1" 'NR > 1 {
        for (i = 1; i <= 8; i++) {
            d = $(skip + i) - $(32 + i); y = $(16 + skip + i) - $(40 + i)
            if (d*d > worst) worst = d*d
            if (y*y > worst) worst = y*y
            if ($(32 + i) > most) most = $(32 + i)
        }}
        END {print NR < 100 || NF != 48 ? "other columns" : sqrt(worst)/most}'
}
both()
{
    run --vehicle "$dir/two.veh" "$@" -o "$dir/two.run" && run --vehicle "$dir/coach.veh" "$@" -o "$dir/front.run" &&
        run --vehicle "$dir/coach.veh" "$@" --set start="$(awk -v b="$behind" 'BEGIN {print -8 + b}')" --set end="$(awk -v b="$behind" 'BEGIN {print 2 + b}')" -o "$dir/rear.run"
}
vxtrack --set from=-90 --set length=120 -o "$dir/t.trk" data/tracks/thesis-straight.yaml
both --set 'dip=[{from: -6, length: 1, depth: 1e-3}, {from: -45, length: 1, depth: 1e-3}]'
ok $? "over dips"
between "$(apart 0 "$dir/front.run")" 0 1e-4 "the first coach against one alone, over the largest Q"
between "$(apart 8 "$dir/rear.run")" 0 1e-4 "the second one"
vxtrack --set from=-90 --set length=120 --set 'curve=[{from: -200, curvature: 0.00131578947368}]' --set 'cant={station: [-200], value: [0.05]}' \
    -o "$dir/t.trk" data/tracks/thesis-straight.yaml
both
ok $? "in a curve on cant"
# Couplings act in one frame about the middle of the train, turned against a coach's own by 20.8/760: in small angles their forces have that
# share of another direction, 27 mrad of some kN.
between "$(apart 0 "$dir/front.run")" 0 2e-3 "the first coach against one alone, over the largest Q"
between "$(apart 8 "$dir/rear.run")" 0 2e-3 "the second one"

# A coupler between bodies at their places carries nothing on straight track; in the curve it stays small against the weight.
vxvehicle --join $gap --coupler 10e6 --coupler-damping 50e3 -o "$dir/two.veh" "$dir/coach.veh" "$dir/coach.veh"
ok $? "with a coupler"
run --vehicle "$dir/two.veh" -o "$dir/two.run"
ok $? "runs in the curve"
between "$(apart 0 "$dir/front.run")" 0 0.05 "the first coach against one alone, over the largest Q"

fails 2 "one vehicle is no train" vxvehicle --join 5 "$dir/coach.veh"
fails 2 "two inputs without --join" vxvehicle "$dir/coach.veh" "$dir/coach.veh"
fails 2 "a coupler without a train" vxvehicle --coupler 1e6 "$dir/coach.veh"
done_testing
