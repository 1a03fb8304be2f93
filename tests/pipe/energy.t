#!/bin/sh
# The account of -v over the crossing of the diverging route: what is missing of the track's loss, and that it falls with the step.
. tests/tap.sh
. tests/passage.sh

turnout_tables && coach && vxtrack -o "$dir/t.trk" data/tracks/60E1-R760-1-15-diverging.yaml
ok $? "turnout, coach and track"
cat >"$dir/diverging.yaml" <<'END'
case:
  name: diverging
  track: t.trk
  vehicle: coach.veh
  contact_left: tl.ctab
  contact_right: tr.ctab
  speed_kmh: 80
  route: diverging
  channels: {bodies: false, pads: false, ballast: false, sleepers: false, rails: false}
END

# missing STEP SCHEME: of the loss.
missing()
{
    vxrun -v --set step=$1 --set scheme=$2 -o "$dir/d.run" "$dir/diverging.yaml" 2>&1 | sed -n 's/.* missing \([^ ]*\) of the loss$/\1/p'
}
one=$(missing 1e-4 explicit)
half=$(missing 5e-5 explicit)
between "$one" 0 1e-2 "explicit, 1e-4 s: missing of the loss"
between "$half" 0 "$(awk -v x="$one" 'BEGIN {print 0.5*x}')" "explicit, 5e-5 s: missing of the loss, less than half of that"
between "$(missing 1e-4 implicit)" 0 1e-8 "implicit, 1e-4 s: missing of the loss"
done_testing
