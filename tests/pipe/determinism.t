#!/bin/sh
# The same command gives the same bytes, to a file as to standard output; a run killed on its way leaves what it had done.
. tests/tap.sh
. tests/passage.sh

plain_tables && coach
ok $? "contact tables and coach"
vxtrack --set from=-60 --set length=120 -o "$dir/t.trk" data/tracks/thesis-straight.yaml
ok $? "track"
cat >"$dir/plain.yaml" <<'END'
case:
  name: plain
  track: t.trk
  vehicle: coach.veh
  contact_left: l.ctab
  contact_right: r.ctab
  speed_kmh: 200
  start: -30
  end: 50
END

vxrun -o "$dir/a.run" "$dir/plain.yaml"
ok $? "runs"
[ ! -e "$dir/a.run.part" ]
ok $? "and leaves no .part"
vxrun -o "$dir/b.run" "$dir/plain.yaml"
cmp -s "$dir/a.run" "$dir/b.run"
ok $? "again the same bytes"
vxrun "$dir/plain.yaml" >"$dir/c.run"
vxcmp "$dir/a.run" "$dir/c.run" >/dev/null
ok $? "on standard output the same numbers"
# On a pipe the size of the file is not known: 8 bytes of the preamble.
is "$(cmp -l "$dir/a.run" "$dir/c.run" | wc -l | awk '{print ($1 <= 8)}')" 1 "and the same bytes but for the size of the file"
vxpost --wheels - <"$dir/c.run" >"$dir/c.csv" && vxpost --wheels "$dir/a.run" | cmp -s - "$dir/c.csv"
ok $? "so it goes through a pipe"

# Killed when at least one block is there: 256 records of all channels take 5 MB.
vxrun --set step=1e-5 --set sampling=1e4 --set end=54 -o "$dir/k.run" "$dir/plain.yaml" &
pid=$!
tries=0
while [ $tries -lt 200 ] && ! { [ -e "$dir/k.run.part" ] && [ "$(wc -c <"$dir/k.run.part")" -gt 6000000 ]; }; do
    tries=$((tries + 1))
    sleep 0.05
done
kill -9 $pid 2>/dev/null
ok $? "killed on its way"
wait $pid 2>/dev/null
[ ! -e "$dir/k.run" ]
ok $? "it leaves no .run"
vxinfo "$dir/k.run.part" >"$dir/info"
ok $? "vxinfo reads its .part"
like "$(head -n 1 "$dir/info")" 'NOT COMPLETE' "and says that it is not complete"
vxpost --balance "$dir/k.run.part" >"$dir/balance"
ok $? "vxpost --balance reads it"
between "$(sed -n 's/^samples,\([0-9]*\),.*/\1/p' "$dir/balance")" 256 1e6 "samples in it"
between "$(sed -n 's/^largest vertical residual over weight,\([^,]*\),.*/\1/p' "$dir/balance")" 0 1e-6 "and they balance"
fails 1 "extremes are missing" vxpost --table "$dir/k.run.part"
like "$(cat "$dir/err")" 'not complete' "and that is told"

# What stood there before stays until the new one is complete.
cp "$dir/a.run" "$dir/k.run"
vxrun --set start=-1e3 -o "$dir/k.run" "$dir/plain.yaml" 2>/dev/null
cmp -s "$dir/a.run" "$dir/k.run"
ok $? "a run that cannot start leaves the one before"
done_testing
