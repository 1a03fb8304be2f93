#!/bin/sh
# A run that goes on from a saved state: bit for bit; on other railpads beyond the state's reach as if run there from the start; refused where it
# does not fit.
. tests/tap.sh
. tests/passage.sh

plain_tables && coach
ok $? "contact tables and coach"
track() { vxtrack --set from=-60 --set length=150 "$@" data/tracks/thesis-straight.yaml; }
track -o "$dir/t.trk"
ok $? "track"
cat >"$dir/c.yaml" <<'END'
case:
  name: state
  track: t.trk
  vehicle: coach.veh
  contact_left: l.ctab
  contact_right: r.ctab
  speed_kmh: 120
  start: -30
  end: 60
  sampling: 2000
  dip: [{from: 5, length: 1, depth: 1e-3}, {from: 40, length: 1, depth: 1e-3}]
END
case=$dir/c.yaml

# from RUN: its records beyond 20 m, every channel.
from() { vxdump --csv "$1" $(vxinfo "$1" | awk '$1 == "series" {print $2}') | awk -F, 'NR == 1 || $2 > 20.0001'; }

vxtrack -o "$dir/m.trk" data/tracks/co-running.yaml
ok $? "a track that follows the train"
vxrun --track "$dir/m.trk" --save-state 20 -o "$dir/m.run" "$case"
vxrun --track "$dir/m.trk" --start "$dir/m.state" -o "$dir/n.run" "$case"
ok $? "goes on"
from "$dir/m.run" >"$dir/m.csv"
from "$dir/n.run" | cmp - "$dir/m.csv"
ok $? "to the digit"
vxtrack --set railpad.stiffness=60e6 -o "$dir/other.trk" data/tracks/co-running.yaml
vxrun --track "$dir/other.trk" --start "$dir/m.state" -o "$dir/n.run" "$case" 2>"$dir/err"
is $? 1 "but with no other railpad"

for scheme in explicit implicit; do
    vxrun --set scheme=$scheme --save-state 20 -o "$dir/a.run" "$case"
    ok $? "$scheme: a run that leaves its state at 20 m"
    vxrun --set scheme=$scheme --start "$dir/a.state" -o "$dir/b.run" "$case" 2>"$dir/err"
    ok $? "$scheme: a run that goes on from there"
    is "$(cat "$dir/err")" "" "and says nothing, since nothing differs"
    from "$dir/a.run" >"$dir/a.csv"
    from "$dir/b.run" >"$dir/b.csv"
    [ "$(wc -l <"$dir/a.csv")" -gt 2000 ] && cmp "$dir/a.csv" "$dir/b.csv"
    ok $? "$scheme: the same digits in every channel to the end"
done

# Soft pads from 50 m on: the front wheelset stands at 20 m, and what it moves ends well before.
vxinfo "$dir/a.state" | awk '$1 == "REACH_TO=" {exit !($2 > 20 && $2 < 35)}'
ok $? "the state reaches a few metres beyond the front wheelset"
soft='zone=[{name: soft, sleepers: [[84, 140]], railpad: {stiffness: 60e6}}]'
track --set "$soft" -o "$dir/soft.trk" 2>"$dir/err" || cat "$dir/err"
vxrun --set scheme=explicit --save-state 20 -o "$dir/a.run" "$case"
vxrun --track "$dir/soft.trk" --set scheme=explicit -o "$dir/whole.run" "$case"
vxrun --track "$dir/soft.trk" --set scheme=explicit --start "$dir/a.state" -o "$dir/warm.run" "$case" 2>"$dir/err"
ok $? "on soft railpads far ahead"
grep -q 'note\|pad.k of the track differs from 50.1' "$dir/err"
ok $? "which is told"
for run in whole warm; do vxdump --csv "$dir/$run.run" station wheel.Q | awk -F, 'NR > 1 && $1 > 20.0001' >"$dir/$run.csv"; done
paste -d, "$dir/whole.csv" "$dir/warm.csv" | awk -F, '
    {n = NF/2; for (i = 2; i <= n; i++) {d = $i - $(i + n); if (d < 0) d = -d; if (d > most) most = d}}
    END {printf "# Q differs by %.3g N at most from a run there from the start\n", most; exit !(NR > 2000 && most < 1)}'
ok $? "Q is within 1 N of that of a run from the start"

# What does not fit.
refuses()
{
    word=$1 what=$2
    shift 2
    rm -f "$dir/x.run"
    vxrun -o "$dir/x.run" "$@" 2>"$dir/err"
    is $? 1 "$what is refused"
    grep -q "$word" "$dir/err" || sed 's/^/# /' "$dir/err"
    grep -q "$word" "$dir/err"
    ok $? "... $word"
    [ ! -e "$dir/x.run" ]
    ok $? "... and leaves no file"
}
state="--set scheme=explicit --start $dir/a.state"
track --set railpad.stiffness=60e6 -o "$dir/other.trk"
refuses "pad.k of the track differs from .* but the state reaches from" "soft pads under the train" $state --track "$dir/other.trk" "$case"
track --set sleeper.spacing=0.5 -o "$dir/short.trk"
refuses "has another shape" "a track of other spacing" $state --track "$dir/short.trk" "$case"
refuses "its speed is 33.3333333 m/s" "another speed" $state --set speed_kmh=100 "$case"
refuses "its step is 0.0001 s" "another step" $state --set step=5e-5 "$case"
refuses "it is of the explicit scheme" "the other scheme" $state --set scheme=implicit "$case"
refuses "where the case ends or beyond" "an end before it" $state --set end=19 "$case"
vxvehicle --set body.1.mass=33000 -o "$dir/heavy.veh" data/vehicles/manchester-passenger.yaml
refuses "is of another vehicle" "another vehicle" $state --vehicle "$dir/heavy.veh" "$case"
refuses "a .run file where a .state file is wanted" "a run" --start "$dir/a.run" "$case"
head -c 20000 "$dir/a.state" >"$dir/cut.state"
refuses "cut.state: truncated" "a state cut short" --start "$dir/cut.state" "$case"
refuses "under wheelset 1 the left rail's irregularity is off that of the state by 1 mm" "a dip under the train" $state \
    --set 'dip=[{from: 19.5, length: 1, depth: 1e-3, rail: left}]' "$case"
vxrun $state --set 'dip=[{from: 30, length: 1, depth: 1e-3}]' -o "$dir/ahead.run" "$case" 2>"$dir/err"
ok $? "but one ahead of it is not"
grep -q "the case is not that of the state" "$dir/err"
ok $? "only told"
done_testing
