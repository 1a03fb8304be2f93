#!/bin/sh
# A batch of runs: the bytes of each are those of the same command alone, whether they run one after another or several at once; one that fails
# harms no other.
. tests/tap.sh
. tests/passage.sh

plain_tables && coach
ok $? "contact tables and coach"
for k in 60 300; do
    vxtrack --set from=-60 --set length=120 --set "zone=[{name: ahead, sleepers: [[50, 90]], railpad: {stiffness: ${k}e6}}]" -o "$dir/$k.trk" \
        data/tracks/thesis-straight.yaml || exit 1
done
cat >"$dir/c.yaml" <<'END'
case:
  name: batch
  track: 300.trk
  vehicle: coach.veh
  contact_left: l.ctab
  contact_right: r.ctab
  speed_kmh: 160
  start: -30
  end: 20
  sampling: 500
  channels: {bodies: false, rails: false}
END
case=$dir/c.yaml
vxrun --set end=-9 --save-state -10 -o "$dir/s.run" "$case"
ok $? "a state that variants go on from"

# the words of each variant but for its output
cat >"$dir/words" <<END
--set speed_kmh=200 --set end=0
--track $dir/60.trk
--start $dir/s.state
--start $dir/s.state --track $dir/60.trk --set end=19
--save-state 10 --set contact.law=linear
END
{
    echo "# five variants"
    echo
    awk -v dir="$dir" '{print "  -o " dir "/b" NR ".run " $0 "  # number " NR}' "$dir/words"
} >"$dir/batch"

n=0
while read -r words; do
    n=$((n + 1))
    # shellcheck disable=SC2086
    vxrun $words --set friction=0.2 -o "$dir/a$n.run" "$case" 2>>"$dir/err" || cat "$dir/err"
    # and with the words of the command before those of the line, as in a batch
    # shellcheck disable=SC2086
    vxrun --set friction=0.2 $words -o "$dir/o$n.run" "$case" 2>>"$dir/err" || cat "$dir/err"
    vxcmp "$dir/a$n.run" "$dir/o$n.run" >/dev/null || echo "# the order of the words matters"
done <"$dir/words"
is "$n" 5 "each alone"

for jobs in 1 2 5; do
    rm -f "$dir"/b?.*
    vxrun --batch "$dir/batch" --jobs $jobs --set friction=0.2 "$case" 2>"$dir/err"
    ok $? "as a batch, $jobs at once"
    for k in 1 2 3 4 5; do
        cmp "$dir/o$k.run" "$dir/b$k.run" || echo "variant $k"
    done >"$dir/differ"
    is "$(cat "$dir/differ")" "" "the same bytes"
    cmp "$dir/o5.state" "$dir/b5.state"
    ok $? "and the same state"
done
if cmp -s "$dir/b1.run" "$dir/b2.run" || cmp -s "$dir/b3.run" "$dir/b4.run"; then false; else true; fi
ok $? "and they are not alike"
vxrun --batch - --set friction=0.2 "$case" <"$dir/batch" 2>"$dir/err" && cmp "$dir/o2.run" "$dir/b2.run"
ok $? "lines from standard input"
vxrun --batch="$dir/batch" --jobs=2 --set friction=0.2 -- "$case" 2>"$dir/err"
is $? 0 "options with =, operands behind --"

cat >"$dir/bad" <<END
-o $dir/g1.run
-o $dir/g2.run --track $dir/none.trk
-o $dir/g3.run --set speed_kmh=0
-o $dir/g4.run --batch $dir/batch
-o $dir/g5.run --set end=-20
END
vxrun --batch "$dir/bad" --set end=-25 "$case" 2>"$dir/err"
is $? 1 "lines that fail make the batch fail"
is "$(grep -o 'line [0-9]: failed' "$dir/err" | tr '\n' ' ')" "line 2: failed line 3: failed line 4: failed " "each is told"
[ -s "$dir/g1.run" ] && [ -s "$dir/g5.run" ] && [ ! -e "$dir/g2.run" ] && [ ! -e "$dir/g3.run" ] && [ ! -e "$dir/g4.run" ]
ok $? "the others are done"
done_testing
