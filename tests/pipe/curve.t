#!/bin/sh
# A coach settled in a curve of 760 m to the right, uncanted, at 80 km/h: the load moved to the left rail and the sum of Y against
# statics worked out here from masses, heights, radius, recorded displacements and contact points.
. tests/tap.sh
. tests/passage.sh

plain_tables && coach
ok $? "contact tables and coach"
vxtrack --set from=-90 --set length=606 --set 'curve=[{from: 0, curvature: 0.00131578947368}]' -o "$dir/c.trk" data/tracks/thesis-straight.yaml
ok $? "a curve of 760 m from station 0"
cat >"$dir/curve.yaml" <<'END'
case:
  name: curve
  track: c.trk
  vehicle: coach.veh
  contact_left: l.ctab
  contact_right: r.ctab
  speed_kmh: 80
  end: 500
  sampling: 100
  channels: {pads: false, ballast: false, sleepers: false, rails: false}
END
vxrun -o "$dir/c.run" "$dir/curve.yaml"
ok $? "runs"

# Body by body: mass, x, y, z of its centre of gravity at rest.
vxdump --csv "$dir/c.run" body.mass body.cg | sed 1d >"$dir/bodies"
rail=$(vxinfo "$dir/r.ctab" | sed -n 's/^RAIL_POSITION= //p')
columns "$dir/c.run" station wheel.Q wheel.Y contact.N contact.angle contact.rail_y body.q >"$dir/run.csv"

# Means over 400 to 500 m.  Moments about the tangent, at rail level, to the track under the carbody, body 1 here; another frame d metres
# ahead of it lies d^2/2R to its right.  A body at y, z with the centripetal acceleration v^2/R to the right asks for
#   sum of y Q = y m g + z m v^2/R;
# a wheelset of pitch inertia J spinning at -v/r0 and yawing at v/R for -J v^2/(r0 R) more.  Q acts at the mean place of its contacts, weighted
# with N cos(angle); Y acts at rail level.
awk -F, -v rail="$rail" '
    BEGIN {R = 760; v = 80/3.6; g = 9.81; J = 112; r0 = 0.46; wheelsets = 4}
    function ahead(x) {return x - x_body[1]}
    NR == FNR {m[++n] = $1; x_body[n] = $2; y_body[n] = $3; z_body[n] = $4; next}
    FNR == 1 {for (i = 1; i <= NF; i++) at[$i] = i; next}
    $1 < 400 {next}
    {
        samples++
        for (i = 1; i <= n; i++) {
            y = ahead(x_body[i])^2/(2*R) + y_body[i] + $at["body.q:" i ":2"]
            z = z_body[i] + $at["body.q:" i ":3"]
            moment += y*m[i]*g + z*m[i]*v*v/R
        }
        for (w = 1; w <= wheelsets; w++) {
            moment -= J*v*v/(r0*R)
            for (s = 1; s <= 2; s++) {
                Q = $at["wheel.Q:" w ":" s]
                Y += $at["wheel.Y:" w ":" s]
                sum = place = 0
                for (c = 1; c <= 3; c++) {
                    i = ":" w ":" s ":" c
                    share = $at["contact.N" i]*cos($at["contact.angle" i])
                    sum += share
                    place += share*$at["contact.rail_y" i]
                }
                load[s] += Q
                lever[s] += Q*(place/sum + (s == 1 ? -rail : rail) + ahead(x_body[n - wheelsets + w])^2/(2*R))
            }
        }
    }
    END {
        for (i = 1; i <= n; i++) mass += m[i]
        # Ql + Qr = W and yl Ql + yr Qr = moment
        yl = lever[1]/load[1]; yr = lever[2]/load[2]; W = mass*g
        moved = 0.5*W - (moment/samples - yl*W)/(yr - yl)
        printf "%.5f\n", 0.5*(load[1] - load[2])/samples/moved
        printf "%.5f\n", Y/samples/(-mass*v*v/R)
        printf "# load moved to the left by statics %.1f N, sum of Y %.1f N\n", moved, -mass*v*v/R
    }' "$dir/bodies" "$dir/run.csv" >"$dir/ratios"
sed -n 3p "$dir/ratios"
between "$(sed -n 1p "$dir/ratios")" 0.99 1.01 "load moved to the left over that of statics"
between "$(sed -n 2p "$dir/ratios")" 0.9999 1.0001 "sum of Y over m v^2/R to the left"

# A model of the coach alone with exact positions and rotations in space, wheelsets where the run has them: the carbody stands 50.04 mm
# outside the chord of its pivots, 9.5^2/2R inside its own frame, and rolls by 11.998 mrad; the first bogie by 3.892.
awk -F, 'FNR == 1 {for (i = 1; i <= NF; i++) at[$i] = i; next}
    $at["station"] > 400 {
        n++
        y += $at["body.q:1:2"]
        roll += $at["body.q:1:4"]
        bogie += $at["body.q:2:4"]
    }
    END {printf "%.3f\n%.3f\n%.3f\n", 1e3*(y/n - 9.5^2/(2*760)), 1e3*roll/n, 1e3*bogie/n}' "$dir/run.csv" >"$dir/sway"
between "$(sed -n 1p "$dir/sway")" -50.54 -49.54 "carbody outside the chord of its pivots, mm"
between "$(sed -n 2p "$dir/sway")" -12.12 -11.88 "roll of the carbody, mrad"
between "$(sed -n 3p "$dir/sway")" -3.93 -3.85 "roll of the first bogie, mrad"

# Started in the curve, it has at once what it settled to: every Q and Y of the first 10 ms against the means over 400 to 500 m.
vxrun -v --set start=400 --set end=410 --set sampling=1000 -o "$dir/s.run" "$dir/curve.yaml" 2>"$dir/err"
ok $? "starts in the curve"
grep 'at the start' "$dir/err" | sed 's/^/# /'
columns "$dir/s.run" station wheel.Q wheel.Y | awk -F, 'NR == 2' >"$dir/first"
columns "$dir/c.run" station wheel.Q wheel.Y | awk -F, 'NR == FNR {for (i = 2; i <= 17; i++) first[i] = $i; next}
    $1 > 400 {n++; for (i = 2; i <= 17; i++) mean[i] += $i}
    END {
        for (i = 2; i <= 17; i++) {
            off = first[i]/(mean[i]/n) - 1
            if (off < 0) off = -off
            if (off > most) most = off
        }
        printf "%.5f\n", most
    }' "$dir/first" FS=, - >"$dir/off"
between "$(cat "$dir/off")" 0 0.005 "largest difference of a wheel's Q or Y at the start from that it settles to"
done_testing
