#!/bin/sh
# vxpost: its tables, and what it refuses.
. tests/tap.sh
. tests/passage.sh

plain_tables && coach
ok $? "contact tables and coach"
vxtrack --set from=-60 --set length=120 --set 'zone=[{name: soft, sleepers: [[1, 20]], railpad: {stiffness: 30e6}}]' --set first_sleeper=0 \
    -o "$dir/t.trk" data/tracks/thesis-straight.yaml
ok $? "track"
cat >"$dir/plain.yaml" <<'END'
case:
  name: plain
  track: t.trk
  vehicle: coach.veh
  contact_left: l.ctab
  contact_right: r.ctab
  speed_kmh: 80
  start: -30
  end: 20
END
vxrun -o "$dir/a.run" "$dir/plain.yaml"
ok $? "runs"
run=$dir/a.run

# Every line of a table has as many fields as its header.
even() { awk -F, 'NR == 1 {n = NF} NF != n {exit 1}' "$1"; }
rows() { wc -l <"$1" | tr -d ' '; }

vxpost "$run" >"$dir/zones.csv" && vxpost --table "$run" | cmp -s - "$dir/zones.csv"
ok $? "--table is the default"
like "$(head -n 1 "$dir/zones.csv")" '^zone,name,seats,Q (N),Q at sleeper,Y (N),' "a header with units"
even "$dir/zones.csv"
ok $? "even rows"
is "$(rows "$dir/zones.csv")" 3 "a row for what is in no zone, and one for the zone"
is "$(awk -F, 'NR == 3 {print $2 "," $3}' "$dir/zones.csv")" "soft,40" "its name and its seats on both rails"
awk -F, 'NR == 2 {rigid = $10} NR == 3 {exit !($10 > 3*rigid)}' "$dir/zones.csv"
ok $? "soft pads are pressed more"
awk -F, 'NR == 3 {exit !($11 >= 1 && $11 <= 20)}' "$dir/zones.csv"
ok $? "at a sleeper of the zone"

vxpost --sleepers "$run" >"$dir/sleepers.csv"
ok $? "--sleepers"
even "$dir/sleepers.csv"
ok $? "even rows"
is "$(rows "$dir/sleepers.csv")" 201 "200 sleepers"
is "$(awk -F, 'NR == 102 {print $1 "," $2}' "$dir/sleepers.csv")" "1,0.3" "sleeper 1 at 0.3 m"
# What the zone's row says is the largest of its sleepers.
awk -F, 'NR == FNR {if (FNR > 1 && $1 >= 1 && $1 <= 20) {for (i = 5; i <= 6; i++) if ($i > pad) pad = $i}; next}
    FNR == 3 {exit !($8 == pad)}' "$dir/sleepers.csv" "$dir/zones.csv"
ok $? "a zone's pad force is the largest of its sleepers'"

vxpost --wheels "$run" >"$dir/wheels.csv"
ok $? "--wheels"
even "$dir/wheels.csv"
ok $? "even rows"
is "$(awk -F, 'NR > 1 {print $1 $2}' "$dir/wheels.csv" | tr '\n' ' ')" "1l 1r 2l 2r 3l 3r 4l 4r " "wheels from the front, left and right"
awk -F, 'NR > 1 && !($6 <= $3 && $3 <= $4) {exit 1}' "$dir/wheels.csv"
ok $? "static Q lies between smallest and largest"
awk -F, 'NR == FNR {if (FNR > 1) for (i = 3; i <= 4; i++) if ($i > Q) Q = $i; next} FNR > 1 && $4 > most {most = $4} END {exit !(most == Q)}' \
    "$dir/sleepers.csv" "$dir/wheels.csv"
ok $? "the largest Q of all wheels is the largest of all sleepers"

vxpost --balance "$run" >"$dir/balance.csv"
ok $? "--balance"
is "$(rows "$dir/balance.csv")" 11 "ten numbers"
balance() { sed -n "s/^$1,\([^,]*\),.*/\1/p" "$2"; }
is "$(balance weight "$dir/balance.csv")" 436368.42 "44 482 kg times 9.81 m/s2"
between "$(balance 'mean sum of Q left' "$dir/balance.csv")" 218100 218260 "half of it on the left"
is "$(balance samples "$dir/balance.csv")" 2251 "all samples"
vxpost --balance --from -10 --to 0 "$run" >"$dir/part.csv"
is "$(balance samples "$dir/part.csv")" 451 "or those of a stretch"
vxpost --balance -o "$dir/o.csv" "$run" && cmp -s "$dir/o.csv" "$dir/balance.csv"
ok $? "-o writes the same"

fails 2 "no run" vxpost
fails 2 "two runs" vxpost "$run" "$run"
fails 2 "two tables" vxpost --wheels --sleepers "$run"
fails 2 "--from without --balance" vxpost --from 0 "$run"
fails 2 "--to that is no number" vxpost --balance --to 10m "$run"
fails 1 "a run that is not there" vxpost "$dir/none.run"
fails 1 "the wrong kind" vxpost "$dir/t.trk"
like "$(cat "$dir/err")" "a .trk file where a .run file is wanted" "says which"
fails 1 "no sample in the stretch" vxpost --balance --from 100 --to 200 "$run"
like "$(cat "$dir/err")" "no sample with the front wheelset from 100 to 200 m" "says so"
vxrun --set channels.wheels=false --set end=-29 -o "$dir/bare.run" "$dir/plain.yaml"
fails 1 "no wheels to balance" vxpost --balance "$dir/bare.run"
like "$(cat "$dir/err")" "not recorded" "says so"
fails 1 "a full disk" vxpost -o /dev/full "$run"
fails 1 "a folder that is not there" vxpost -o "$dir/no/x.csv" "$run"

# A complete run cut short is damaged.  One that says no size, as a .part or on a pipe, holds what whole blocks it has.
size=$(wc -c <"$run")
head -c $((size / 2)) "$run" >"$dir/cut.run"
fails 1 "half of a complete run" vxpost --wheels "$dir/cut.run"
like "$(cat "$dir/err")" "truncated" "says so"
vxrun "$dir/plain.yaml" | head -c $((size / 2)) >"$dir/half.run"
fails 1 "half of a stream has no extremes" vxpost --wheels "$dir/half.run"
like "$(cat "$dir/err")" "not complete" "says so"
vxpost --balance "$dir/half.run" >"$dir/half.csv"
ok $? "but balances"
between "$(balance samples "$dir/half.csv")" 256 2250 "samples in it"
head -c 3000 "$run" >"$dir/cut.run"
fails 1 "a header cut short" vxpost --balance "$dir/cut.run"
done_testing
