#!/bin/sh
# The diverging route at 80 km/h: wheel forces balance weight and accelerations, plain track before the turnout carries the static loads,
# half the step gives the same peaks, and the wheel on the curved switch rail is handed over from rail to rail.
. tests/tap.sh
. tests/passage.sh

turnout_tables
ok $? "contact tables of the turnout"
coach && vxtrack -o "$dir/t.trk" data/tracks/60E1-R760-1-15-diverging.yaml
ok $? "coach and track"
cat >"$dir/diverging.yaml" <<'END'
case:
  name: diverging
  track: t.trk
  vehicle: coach.veh
  contact_left: tl.ctab
  contact_right: tr.ctab
  speed_kmh: 80
  route: diverging
  channels: {pads: false, ballast: false, sleepers: false, rails: false}
END
vxrun -o "$dir/d.run" "$dir/diverging.yaml" && vxrun --set step=5e-5 -o "$dir/h.run" "$dir/diverging.yaml"
ok $? "runs, and with half the step"

residual() { vxpost --balance "$dir/d.run" | sed -n "s/^largest $1 residual over weight,\([^,]*\),.*/\1/p"; }
between "$(residual vertical)" 0 1e-12 "sum of Q against weight and accelerations, over weight"
between "$(residual lateral)" 0 1e-12 "sum of Y against accelerations, over weight"
between "$(residual roll)" 0 1e-11 "moments about the track, m times weight"

# Ten bays of plain straight track under the whole train: front wheelset from -6.5 to -0.5 m.
columns "$dir/d.run" station wheel.Q >"$dir/Q.csv"
vxpost --wheels "$dir/d.run" | awk -F, 'NR > 1 {print $3}' >"$dir/static"
awk -F, 'FNR == NR {static[NR] = $1; next}
    $1 > -6.5 && $1 < -0.5 {n++; for (k = 1; k <= 8; k++) sum[k] += $(k + 1)}
    END {for (k = 1; k <= 8; k++) {e = sum[k]/n/static[k] - 1; most = e*e > most*most ? e : most} printf "%.2e\n", most}' \
    "$dir/static" "$dir/Q.csv" >"$dir/off"
between "$(cat "$dir/off")" -1e-3 1e-3 "mean Q over ten bays against the static load, worst of eight wheels"

# Largest Q of each wheel, and the largest change by half the step.
for run in d h; do
    vxpost --wheels "$dir/$run.run" | awk -F, 'NR > 1 {print $4}' >"$dir/$run.peaks"
done
paste "$dir/d.peaks" "$dir/h.peaks" | awk '{e = $2/$1 - 1; most = e*e > most*most ? e : most} END {printf "%.2e\n", most}' >"$dir/change"
between "$(cat "$dir/change")" -0.01 0.01 "change of the largest Q by half the step, worst of eight wheels"

# Bodies: 0 stock rail, 1 switch rail and what it becomes, the wing rail, 2 nose.  Where the left wheel in front stands first on the next, and
# last on the one before.
columns "$dir/d.run" station contact.N contact.body >"$dir/contact.csv"
handover()
{
    awk -F, -v from="$1" -v to="$2" '
        NR == 1 {for (i = 1; i <= NF; i++) at[$i] = i; next}
        {
            for (c = 1; c <= 3; c++)
                if ($at["contact.N:1:1:" c] > 0) {
                    body = $at["contact.body:1:1:" c]
                    if (body == to && first == "") first = $1
                    if (body == from) last = $1
                }
        }
        END {printf "%.2f %.2f\n", first, last}' "$dir/contact.csv"
}
set -- $(handover 0 1)
between "$1" 2 5 "first on the switch rail, m"
between "$2" 4 8 "last on the stock rail, m"
set -- $(handover 1 2)
between "$1" 46.5 47.5 "first on the nose, m"
between "$2" 46.5 47.5 "last on the wing rail, m"

# The check rail stands inside the right rail from 43.2 to 50.4 m: the backs of the right flanges push it to the left.
columns "$dir/d.run" station wheel.check | awk -F, 'NR > 1 {
        if ($3 < least) least = $3
        if ($2 != 0 || $3 > 0 || ($3 != 0 && ($1 < 43.2 || $1 > 50.4))) wrong++
    } END {exit !(wrong == 0 && least < 0)}'
ok $? "the check rail is pushed to the left, by right wheels only, and only where it stands"
done_testing
