#!/bin/sh
# Two softly guided wheelsets with treads coned 1:10 in a curve of 760 m.  Where nothing but creep guides it a wheelset rolls without slip:
# its wheels' radii differ as the rails' lengths, so at rail level it stands at
#   y = -r0 b/(lambda R) = -0.46 x 0.75/(0.1 x 760) = -4.539 mm,
# outwards.  The rails' heads are arcs of 50 mm about a point 1:10 aslant, which keeps the contact where it is.
. tests/tap.sh

cat >"$dir/cone.yaml" <<'END'
profile:
  name: cone
  part: wheel
  unit: mm
  radius: 0.46
  zones:
    - {from: -70, to: -60, polynomial: [30]}
    - {from: -60, to: -50, polynomial: [-120, -2.5]}
    - {from: -50, to: 60, polynomial: [0, -0.1]}
END
# The gauge puts the point of the head at slope 1:10 at 0.75 m.
cat >"$dir/head.yaml" <<'END'
profile:
  name: head
  part: rail
  unit: mm
  gauge: 1.440553
  zones:
    - {from: -36.5, to: -36, polynomial: [-2800, -79]}
    - {from: -36, to: 36, centre: [4.97519, 49.75186], radius: 50}
END
cat >"$dir/wagon.yaml" <<'END'
vehicle:
  name: steering
  body:
    - {name: frame, mass: 18615, inertia: [18615, 670e3, 670e3], x: -10, height: 0.6}
  wheelset:
    - {name: lead, mass: 1813, inertia: [1120, 112, 1120], x: 0, radius: 0.46}
    - {name: trail, mass: 1813, inertia: [1120, 112, 1120], x: -20, radius: 0.46}
  coupling:
    - {name: a, from: lead, to: frame, at: [0, 1.0, 0.46], mirror: true, stiffness: [1e3, 1e6, 1220e3], damping: [500e3, 50e3, 4e3]}
    - {name: b, from: trail, to: frame, at: [-20, 1.0, 0.46], mirror: true, stiffness: [1e3, 1e6, 1220e3], damping: [500e3, 50e3, 4e3]}
END
for s in l r; do
    vxprofile --side $s -o "$dir/w$s.prof" "$dir/cone.yaml" && vxprofile --side $s -o "$dir/r$s.prof" "$dir/head.yaml" &&
        vxcontact --wheel "$dir/w$s.prof" --rail "$dir/r$s.prof" --yaw exact --u-max 0.012 -o "$dir/$s.ctab" || break
done
ok $? "contact tables"
between "$(vxcontact --conicity 0.003 --no-roll "$dir/l.ctab" "$dir/r.ctab" | awk 'NR == 2 {print $2}')" 0.0999 0.1001 "conicity without roll"
vxvehicle -o "$dir/w.veh" "$dir/wagon.yaml"
ok $? "the vehicle"

# run NAME SIGN END: a curve to the right (1) or to the left (-1), entered over 16 m.
run()
{
    curve=$(awk -v sign="$2" 'BEGIN {for (k = 1; k <= 4; k++) printf "%s{from: %d, curvature: %.14f}", (k > 1 ? ", " : ""), 4*k, sign*k/4/760}')
    vxtrack --set from=-45 --set length=180 --set "curve=[$curve]" -o "$dir/$1.trk" data/tracks/thesis-straight.yaml &&
        printf 'case: {name: steering, speed_kmh: 20, start: -10, end: %s, sampling: 50, %s}\n' "$3" \
            'channels: {pads: false, ballast: false, sleepers: false, rails: false}' >"$dir/case.yaml" &&
        vxrun --track "$dir/$1.trk" --vehicle "$dir/w.veh" --contact-left "$dir/l.ctab" --contact-right "$dir/r.ctab" -o "$dir/$1.run" "$dir/case.yaml" &&
        vxdump --csv "$dir/$1.run" station body.q | sed 1d >"$dir/$1.csv"
}
run right 1 129
ok $? "runs to the right"
# Columns: station, then x y z roll pitch yaw of frame, lead and trail.  Both weave about their place; five and more waves of 11.7 m.
mean()
{
    awk -F, -v y="$1" -v roll="$2" '$1 > 58 {n++; sum += $y - 0.46*$roll} END {printf "%.4f\n", 1e3*sum/n}' "$dir/right.csv"
}
between "$(mean 9 11)" -4.630 -4.448 "place of the leading wheelset, mm"
between "$(mean 15 17)" -4.630 -4.448 "place of the trailing one, mm"

# To the left everything is mirrored: y, roll and yaw change sign, x, z and pitch do not.
run left -1 25
ok $? "runs to the left"
head -n "$(wc -l <"$dir/left.csv")" "$dir/right.csv" | paste -d, - "$dir/left.csv" | awk -F, '{
        for (b = 0; b < 3; b++)
            for (k = 0; k < 6; k++) {
                d = $(2 + 6*b + k) - (k % 2 ? -1 : 1)*$(21 + 6*b + k)
                if (d*d > worst*worst) worst = d
            }
    } END {printf "%.3g\n", worst}' >"$dir/worst"
between "$(cat "$dir/worst")" -1e-9 1e-9 "largest difference from the mirror image, m or rad"
done_testing
