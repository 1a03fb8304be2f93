#!/bin/sh
# vxplot: every figure from what the other tools make, the same bytes twice, and what it refuses.  Run from the project root.
. tests/tap.sh

# draws WHAT WIDTHxHEIGHT COMMAND...: a PNG of this size on standard output, of 8 kB or more: not a blank one.
draws()
{
    what=$1 want=$2
    shift 2
    "$@" >"$dir/picture" 2>"$dir/err"
    status=$?
    size=$(od -An -tu1 -j16 -N8 "$dir/picture" | awk '{print $3 * 256 + $4 "x" $7 * 256 + $8}')
    [ $status -eq 0 ] && [ "$size" = "$want" ] && [ "$(wc -c <"$dir/picture")" -gt 8000 ]
    ok $? "$what"
    sed 's/^/# /' "$dir/err"
}

for s in l r; do
    vxprofile --side $s -o "$dir/w$s.prof" data/profiles/S1002.yaml
    vxprofile --side $s -o "$dir/r$s.prof" data/profiles/60E1.yaml
    vxcontact --wheel "$dir/w$s.prof" --rail "$dir/r$s.prof" --yaw exact --yaws 3 -o "$dir/$s.ctab"
done
vxprofile --side l -o "$dir/turnout.prof" data/turnouts/60E1-R760-1-15.yaml
vxtrack -o "$dir/track.trk" data/tracks/thesis-straight.yaml
vxfreq --receptance --at sleeper --from 20 --to 1500 --step 5 -o "$dir/sleeper.frf" "$dir/track.trk"
vxfreq --receptance --at midspan --from 20 --to 1500 --step 5 -o "$dir/midspan.frf" "$dir/track.trk"
vxfreq --modes 3 --near 129 -o "$dir/track.mod" "$dir/track.trk"
vxcontact --rolling-radius "$dir/l.ctab" "$dir/r.ctab" >"$dir/radius.txt"
vxvehicle -o "$dir/wheelset.veh" data/vehicles/wheelset.yaml
vxvehicle -o "$dir/coach.veh" data/vehicles/manchester-passenger.yaml
vxfreq --modes 12 -o "$dir/coach.mod" "$dir/coach.veh"
printf 'case: {name: one wheelset, speed_kmh: 80, start: -6, end: 6}\n' >"$dir/case.yaml"
vxrun --track "$dir/track.trk" --vehicle "$dir/wheelset.veh" --contact-left "$dir/l.ctab" --contact-right "$dir/r.ctab" \
    -o "$dir/a.run" "$dir/case.yaml"
cd "$dir" || exit 1

draws "receptances of two files" 1600x900 vxplot sleeper.frf midspan.frf
draws "static stiffness along the track" 1600x900 sh -c 'vxfreq --stiffness track.trk | vxplot --figure stiffness -'
draws "the bowl under axles" 1600x900 sh -c 'vxfreq --static --load 9e4 --axles -1,1 track.trk | vxplot --figure bowl -'
draws "a receptance through a pipe" 800x450 sh -c 'vxplot --size 800x450 - <sleeper.frf'
vxdump --csv sleeper.frf frequency receptance >measured.csv
draws "a measurement and receptances" 1600x900 vxplot --figure fit measured.csv sleeper.frf midspan.frf
vxplot --figure fit --label one --label two measured.csv sleeper.frf midspan.frf >curves.png
ok $? "labels of the curves of a fit alone"
# The end of the file holds pixels; the command that it keeps stands before them.
pixels() { vxplot "$@" measured.csv sleeper.frf midspan.frf | tail -c 20000 | cksum; }
is "$(pixels --figure fit --label one --label two)" "$(pixels --figure fit --label measured --label one --label two)" \
    "are those after the one of the measurement"
fails 2 "a label too many" vxplot --label one --label two sleeper.frf
draws "modes of the track" 800x450 vxplot --size 800x450 track.mod track.trk
draws "a vehicle in three views" 1600x900 vxplot wheelset.veh
draws "a window of a coach" 800x450 vxplot --size 800x450 --figure vehicle --from -4 --to 2 coach.veh
draws "modes of a vehicle" 800x450 vxplot --size 800x450 coach.mod coach.veh
draws "one mode of each file" 800x450 vxplot --size 800x450 track.trk track.mod track.mod
draws "sections of a turnout, a window of them" 800x450 vxplot --size 800x450 --from 46 --to 48 turnout.prof
draws "a single section" 800x450 vxplot --size 800x450 wl.prof
draws "a contact at u and yaw" 800x450 vxplot --size 800x450 --u 0.0066 --yaw 0.01 wr.prof rr.prof r.ctab
draws "contact pairs" 800x450 vxplot --size 800x450 --figure pairs wl.prof rl.prof l.ctab
vxcontact --wheel wl.prof --rail turnout.prof --yaw none -o turnout.ctab
draws "a wheel through the crossing, a sheet" 800x450 \
    vxplot --size 800x450 --figure sequence --from 46.8 --to 47.3 --stations 6 wl.prof turnout.prof turnout.ctab
for u in -2 2; do
    vxcontact --path u=${u}e-3,from=46,to=48,step=0.002 turnout.ctab >path$u.txt
done
draws "its path at two displacements" 800x450 vxplot --size 800x450 --figure path --label one --label two path-2.txt path2.txt
draws "a window of it, through a pipe" 800x450 sh -c 'vxplot --size 800x450 --figure path --from 46.7 --to 47.3 - <path2.txt'
vxplot --size 800x450 --figure sequence --from 46.8 --to 47.3 --stations 3 --each -o frame.png wl.prof turnout.prof turnout.ctab
is "$(echo frame*.png)" "frame-01.png frame-02.png frame-03.png" "the same in numbered frames"
cmp -s frame-01.png frame-02.png
is $? 1 "which differ"
draws "conicity over amplitude" 800x450 \
    sh -c 'vxcontact --conicity 0.001,0.002,0.003 l.ctab r.ctab | vxplot --size 800x450 --figure conicity -'
draws "rolling radii of two tables" 800x450 vxplot --size 800x450 l.ctab r.ctab
draws "rolling radii from text" 800x450 vxplot --size 800x450 radius.txt
draws "any table from standard input" 800x450 sh -c 'vxplot --size 800x450 --figure table - <radius.txt'
for figure in vertical lateral wheelset max-pads max-ballast; do
    draws "$figure of a run" 800x450 vxplot --size 800x450 --figure $figure a.run
done
for figure in pads ballast; do
    draws "$figure of two runs at two sleepers" 800x450 \
        vxplot --size 800x450 --figure $figure --sleeper 24 --sleeper 25 --label one --label two a.run a.run
done
draws "another size, a window, marks" 1000x700 vxplot --size 1000x700 --from -2 --to 3 --mark 0=switch --mark 1.5=nose a.run

vxplot -o a.png sleeper.frf && vxplot sleeper.frf >b.png && cmp -s a.png b.png
ok $? "the same bytes twice, by -o and on standard output"
grep -aq 'vxplot sleeper.frf' a.png
ok $? "the picture says how it was made, without its -o"
is "$(vxplot --list | awk '{print $1}' | uniq | sort | uniq -d)" "" "a name of a figure stands for one figure"

fails 2 "no operand" vxplot
fails 2 "an unknown figure" vxplot --figure nothing a.run
fails 2 "an odd size" vxplot --size 1600 a.run
fails 2 "a size too small" vxplot --size 100x100 a.run
fails 2 "a size too large" vxplot --size 5000x900 a.run
fails 2 "a mark without words" vxplot --mark 3 a.run
fails 2 "a sleeper that is no number" vxplot --figure pads --sleeper two a.run
fails 2 "frames of another figure" vxplot --each -o frame.png --figure path path2.txt
fails 2 "frames on standard output" vxplot --each --figure sequence wl.prof turnout.prof turnout.ctab
fails 2 "an abbreviated option" vxplot --fig vertical a.run
fails 1 "a sleeper that is not there" vxplot --figure pads --sleeper 999 a.run
fails 1 "a wheelset that is not there" vxplot --wheelset 2 a.run
fails 1 "the motion of a wheelset that is not there" vxplot --figure wheelset --wheelset 2 a.run
fails 1 "modes of another vehicle" vxplot coach.mod wheelset.veh
fails 1 "no body in the window" vxplot --from 30 --to 40 coach.veh
fails 1 "two kinds that fit no figure" vxplot a.run sleeper.frf
fails 1 "a figure of another kind" vxplot --figure sections a.run
fails 1 "rail and wheel swapped" vxplot rr.prof wr.prof r.ctab
fails 1 "profiles of another side than the table" vxplot wl.prof rl.prof r.ctab
fails 1 "tables swapped" vxplot r.ctab l.ctab
fails 1 "a window with nothing in it" vxplot --from 3 --to 2 a.run
fails 1 "no station in the window" vxplot --figure sequence --from 1000 --to 2000 wl.prof turnout.prof turnout.ctab
fails 1 "a table that is no path" vxplot --figure path radius.txt
fails 1 "a table without conicities" vxplot --figure conicity radius.txt
fails 1 "no section in the window" vxplot --from 1000 --to 2000 turnout.prof
fails 1 "a file that is not there" vxplot none.run
head -c 2000 sleeper.frf >cut.frf
fails 1 "a file cut off" vxplot cut.frf
printf 'a[m] b[m]\n1 2\n3 x\n' >bad.txt
fails 1 "a table with a word for a number" vxplot bad.txt
like "$(cat err)" 'line 3: column 2' "and the refusal says where"
printf 'a[m] b[m]\n1 2 3\n' >bad.txt
fails 1 "a table with a number too many" vxplot bad.txt
echo untouched >kept.png
vxplot -o kept.png cut.frf 2>/dev/null
is "$(cat kept.png)" untouched "a failure leaves the old picture"
vxplot sleeper.frf >/dev/full 2>err
is "$? $(wc -l <err)" "1 1" "a full disk is told"

done_testing
