#!/bin/sh
# The coach on 760 m to the right at 80 km/h with the cant at which tan(angle) = v^2/(R g): on the bodies nothing acts sideways, so no
# sum of Y, and wheel loads equal but for where the wheels stand on the rails and for the spinning wheelsets.
. tests/tap.sh
. tests/passage.sh

plain_tables && coach
ok $? "contact tables and coach"
cant=$(awk 'BEGIN {v = 80/3.6; R = 760; a = atan2(v*v/R, 9.81); printf "%.7f", 1.5*sin(a)}')
curve='curve=[{from: 20, curvature: 0.00032894736842}, {from: 40, curvature: 0.00065789473684},
  {from: 60, curvature: 0.00098684210526}, {from: 80, curvature: 0.00131578947368}]'
vxtrack --set from=-90 --set length=426 --set "$curve" --set "cant={station: [10, 90], value: [0, $cant]}" -o "$dir/c.trk" data/tracks/thesis-straight.yaml
ok $? "a curve of 760 m with $cant m of cant"
cat >"$dir/case.yaml" <<'END'
case: {name: cant, speed_kmh: 80, end: 320, sampling: 100, channels: {pads: false, ballast: false, sleepers: false, rails: false}}
END
vxrun --track "$dir/c.trk" --vehicle "$dir/coach.veh" --contact-left "$dir/l.ctab" --contact-right "$dir/r.ctab" -o "$dir/c.run" "$dir/case.yaml"
ok $? "runs"
vxpost --balance --from 250 --to 320 "$dir/c.run" >"$dir/balance"
value()
{
    awk -F, -v what="$1" '$1 == what {print $2}' "$dir/balance"
}
weight=$(value weight)
between "$(awk -v Y="$(value 'mean sum of Y')" -v W="$weight" 'BEGIN {print Y/W}')" -1e-4 1e-4 "sum of Y over the weight"
between "$(awk -v l="$(value 'mean sum of Q left')" -v r="$(value 'mean sum of Q right')" -v W="$weight" -v c="$cant" \
    'BEGIN {s = c/1.5; print (l + r)/W*sqrt(1 - s*s)}')" 0.9999 1.0001 "sum of Q over the weight by the cosine"

# What is left: the coach runs some millimetres outside the middle of the track, and spinning wheelsets turn with it.
moved=$(value "mean load moved to the left")
between "$(awk -v m="$moved" -v W="$weight" 'BEGIN {print m/W}')" 0 0.01 "load moved to the left over the weight, against 0.095 uncanted"
expected=$(value "the same from the moments of the bodies")
between "$(awk -v a="$moved" -v b="$expected" 'BEGIN {print a/b}')" 0.9999 1.0001 "load moved over that from the moments of the bodies"

# The same coach put there: nothing settles any more.
run()
{
    vxrun --track "$dir/c.trk" --vehicle "$dir/coach.veh" --contact-left "$dir/l.ctab" --contact-right "$dir/r.ctab" --set sampling=1000 "$@" "$dir/case.yaml"
}
run --set start=270 --set end=275 -o "$dir/s.run" 2>"$dir/err"
ok $? "starts in the curve on cant"
columns "$dir/s.run" station wheel.Y body.q >"$dir/s.csv"
columns "$dir/c.run" station wheel.Y body.q >"$dir/c.csv"
# Lateral places of wheelsets and carbody: the largest change from the start of the one, and the difference from the other's mean over 270 to 320 m.
awk -F, 'FNR == 1 {file++; next}
    file == 1 && $1 > 270 {n++; for (i = 10; i <= NF; i += 6) mean[i] += $(i + 1)}
    file == 2 && FNR == 2 {for (i = 10; i <= NF; i += 6) first[i] = $(i + 1)}
    file == 2 {for (i = 10; i <= NF; i += 6) {
        d = $(i + 1) - first[i]; if (d*d > moved*moved) moved = d
        d = $(i + 1) - mean[i]/n; if (d*d > off*off) off = d}}
    END {printf "%.6f\n%.6f\n", 1e3*moved, 1e3*off}' "$dir/c.csv" "$dir/s.csv" >"$dir/moves"
between "$(sed -n 1p "$dir/moves")" -0.01 0.01 "largest lateral move of a body after the start, mm"
between "$(sed -n 2p "$dir/moves")" -0.01 0.01 "and difference from the coach that ran in, mm"
done_testing
