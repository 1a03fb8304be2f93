#!/bin/sh
# Are the sections of the nominal turnout dense enough?  The forces that the demo's coach puts on it, the leading bogie at the crossing and
# the other one at the switch, against those over sections at a quarter of the distance.
. tests/tap.sh
. tests/passage.sh

turnout_tables && coach
ok $? "contact tables and coach"
vxtrack -o "$dir/t.trk" data/tracks/60E1-R760-1-15-diverging.yaml
ok $? "track"
vxprofile --side l --set turnout.stations.2.step=0.0625 --set turnout.stations.7.step=0.0125 \
    -o "$dir/dense.prof" data/turnouts/60E1-R760-1-15.yaml &&
    vxprofile --side l -o "$dir/w.prof" data/profiles/S1002.yaml &&
    vxcontact --wheel "$dir/w.prof" --rail "$dir/dense.prof" --yaw exact -o "$dir/dense.ctab"
ok $? "four times as many sections where the wheel changes rails"
for table in tl dense; do
    vxrun --track "$dir/t.trk" --vehicle "$dir/coach.veh" --contact-left "$dir/$table.ctab" --contact-right "$dir/tr.ctab" \
        --set channels.rails=false --set channels.ballast=false data/cases/diverging-80.yaml | vxpost --wheels - >"$dir/$table.csv"
done
for set in 1 2 3 4; do
    ratio=$(awk -F, -v set=$set '$1 == set && $2 == "l" {q[FILENAME] = $4; last = FILENAME} FNR == 1 {n++; name[n] = FILENAME}
        END {printf "%.4f", q[name[1]]/q[name[2]]}' "$dir/tl.csv" "$dir/dense.csv")
    between "$ratio" 0.97 1.03 "largest Q of left wheel $set, over that of the denser sections"
done
done_testing
