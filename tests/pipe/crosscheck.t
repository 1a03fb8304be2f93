#!/bin/sh
# The front wheel force on a smooth rail and over a dip against an implicit Newmark code in two dimensions with four elements a bay: lumped
# track by the explicit scheme, the same by the implicit one, and the reference's own mesh.
#
# The lumped track has one element a bay with the compliance of the loaded element beside it.  Without that compliance the
# force of passing the sleepers (1.3 kN between its extremes) is missed by 0.7 kN rms, so 0.05 kN tells the two apart.
. tests/tap.sh
. tests/passage.sh

reference=../shared/data/vertical_crosscheck
[ -r $reference/smooth_80kmh.csv ] || skip_all "$reference is not here"

plain_tables
ok $? "contact tables of both sides"
vxtrack --set from=-0.3 --set length=120.6 -o "$dir/c.trk" data/tracks/thesis-straight.yaml
ok $? "201 sleepers, the first at 0 m"
primary=[31391e3,3884e3,1200e3]
vxvehicle --set body.1.mass=63518 --set coupling.1.stiffness=$primary --set coupling.2.stiffness=$primary \
    --set coupling.3.stiffness=$primary --set coupling.4.stiffness=$primary -o "$dir/c.veh" data/vehicles/manchester-passenger.yaml
ok $? "the coach of 19 t axle load"

cat >"$dir/c.yaml" <<'END'
case:
  name: crosscheck
  track: c.trk
  vehicle: c.veh
  contact_left: l.ctab
  contact_right: r.ctab
  speed_kmh: 80
  start: 27.6
  end: 114
  contact: {law: linear, stiffness: 141e6, damping: 30e3, series: 1e15}
  sampling: 10e3
  channels: {bodies: false, pads: false, ballast: false, sleepers: false, rails: false}
END

# against REFERENCE.csv RUN: rms of half the front wheelset's Q less the reference from 60 to 105 m, kN.
against()
{
    vxdump --csv "$2" station wheel.Q | awk -F, '
        FNR == 1 {next}
        NR == FNR {x[++n] = $1; Q[n] = $2; next}
        {
            s = $1; q = ($2 + $3)/2e3
            for (; k < n && x[k + 1] <= s; k++)
                if (x[k + 1] >= s0) {
                    e = q0 + (q - q0)*(x[k + 1] - s0)/(s - s0) - Q[k + 1]
                    sum += e*e
                    m++
                }
            s0 = s; q0 = q
        }
        END {if (m != n) exit 1; printf "%.4f\n", sqrt(sum/m)}' "$1" -
}

# compare WHAT REFERENCE.csv MOST OPTION...
compare()
{
    what=$1 file=$reference/$2 most=$3
    shift 3
    vxrun "$@" -o "$dir/c.run" "$dir/c.yaml"
    ok $? "$what: runs"
    between "$(against $file "$dir/c.run")" 0 $most "$what: kN rms off the implicit code"
}

compare "smooth rail" smooth_80kmh.csv 0.05
dip='dip=[{from: 71.5, length: 1.0, depth: 1e-3}]'
compare "dip of 1 mm" dip_80kmh.csv 0.15 --set "$dip"
compare "smooth rail, implicit" smooth_80kmh.csv 0.05 --set scheme=implicit
compare "dip of 1 mm, implicit" dip_80kmh.csv 0.15 --set scheme=implicit --set "$dip"

vxtrack --set from=-0.3 --set length=120.6 --set rail.mass_model=consistent --set rail.elements_per_bay=4 -o "$dir/four.trk" \
    data/tracks/thesis-straight.yaml
ok $? "four elements of consistent mass a bay"
compare "smooth rail, four elements a bay" smooth_80kmh.csv 0.05 --track "$dir/four.trk"
compare "dip of 1 mm, four elements a bay" dip_80kmh.csv 0.1 --track "$dir/four.trk" --set "$dip"
done_testing
