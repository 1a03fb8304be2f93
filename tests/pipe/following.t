#!/bin/sh
# The track fixed in space against those that follow the train: a coach at 80 km/h on straight track, over a dip.
. tests/tap.sh
. tests/passage.sh

plain_tables && coach
ok $? "contact tables and coach"
vxtrack --set from=-90 --set length=120 -o "$dir/full.trk" data/tracks/thesis-straight.yaml
ok $? "the track"
vxtrack -o "$dir/mass.trk" data/tracks/moving-mass.yaml && vxtrack -o "$dir/co.trk" data/tracks/co-running.yaml
ok $? "a moving mass, a co-running track"
cat >"$dir/dip.yaml" <<'END'
case:
  name: dip
  vehicle: coach.veh
  contact_left: l.ctab
  contact_right: r.ctab
  speed_kmh: 80
  start: -40
  end: 10
  sampling: 10e3
  dip: [{from: 0, length: 1.0, depth: 1e-3}]
END
for t in full mass co; do
    vxrun --track "$dir/$t.trk" -o "$dir/$t.run" "$dir/dip.yaml"
    ok $? "$t runs"
    columns "$dir/$t.run" station wheel.Q >"$dir/$t.csv"
done

# passing FILE.csv: N, amplitude of Q at the wavelength of the sleepers, 37.04 Hz, over 40 of them, with Hann's window
passing()
{
    awk -F, '
        FNR > 1 && $1 > -25 && $1 <= -1 {x[++n] = $1; q[n] = $2; mean += $2}
        END {
            mean /= n
            for (i = 1; i <= n; i++) {
                a = 8*atan2(1, 1)*x[i]/0.6; w = 1 - cos(8*atan2(1, 1)*i/n)
                c += w*(q[i] - mean)*cos(a); s += w*(q[i] - mean)*sin(a); sum += w
            }
            print 2*sqrt(c*c + s*s)/sum
        }' "$1"
}
between "$(passing "$dir/full.csv")" 150 300 "sleeper passing on the full track, N"
between "$(passing "$dir/mass.csv")" 0 1e-3 "under a moving mass, N"
between "$(passing "$dir/co.csv")" 0 1e-3 "under a co-running track, N"

# range FILE.csv: N, largest less smallest Q within 4 m from the dip on
range() { awk -F, 'FNR > 1 && $1 > 0 && $1 < 4 {if (!n++) a = b = $2; if ($2 > a) a = $2; if ($2 < b) b = $2} END {print a - b}' "$1"; }
full=$(range "$dir/full.csv")
echo "# the dip changes Q by $full N on the full track"
between "$(range "$dir/mass.csv" | awk -v full="$full" '{print $1/full}')" 0.8 1.25 "under a moving mass, over the full track"
between "$(range "$dir/co.csv" | awk -v full="$full" '{print $1/full}')" 0.8 1.25 "under a co-running track, likewise"

vxdump --csv "$dir/mass.run" sleeper.x sleeper.number | sed 1d >"$dir/sleepers"
is "$(awk -F, '{printf "%g ", $2}' "$dir/sleepers")" "1 2 3 4 " "a sleeper for each wheelset, with its number"
is "$(awk -F, '{printf "%.2f ", $1}' "$dir/sleepers")" "$(vxdump --csv "$dir/mass.run" wheelset.x | sed 1d | awk '{printf "%.2f ", $1}')" "where it stands"

# In a curve the sum of Q is the weight and that of Y the centripetal force, as on the full track.
vxtrack --set 'curve=[{from: 0, curvature: 0.00131578947368}]' -o "$dir/curve.trk" data/tracks/moving-mass.yaml
vxrun --track "$dir/curve.trk" --set end=500 --set sampling=100 --set dip=[] -o "$dir/c.run" "$dir/dip.yaml"
ok $? "a moving mass in a curve of 760 m"
vxpost --balance --from 400 "$dir/c.run" >"$dir/balance"
mass=$(vxdump --csv "$dir/c.run" body.mass | sed 1d | awk '{sum += $1} END {print sum}')
between "$(awk -F, -v m="$mass" '$1 == "mean sum of Y" {print $2/(-m*(80/3.6)^2/760)}' "$dir/balance")" 0.999 1.001 "sum of Y over m v^2/R to the left"
between "$(awk -F, '$1 ~ /^largest vertical residual/ {print $2}' "$dir/balance")" 0 1e-12 "sum of Q against weight and accelerations"
done_testing
