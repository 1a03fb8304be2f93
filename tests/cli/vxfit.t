#!/bin/sh
# vxfit: railpads and ballast found again from a receptance made with known ones, through the files a user has.  Run from the project root.
. tests/tap.sh
straight=data/tracks/thesis-straight.yaml

vxtrack -o "$dir/t.trk" $straight
vxtrack --set railpad.stiffness=120e6 --set railpad.damping=30e3 --set ballast.stiffness=200e6 --set ballast.damping=150e3 -o "$dir/real.trk" $straight
vxfreq --receptance --excite left --at 0.2 --motion left --motion-at 0.2 --quantity accelerance --from 30 --to 1200 --step 10 \
    -o "$dir/real.frf" "$dir/real.trk"
vxdump --csv "$dir/real.frf" frequency accelerance >"$dir/measured.csv"

place="--excite left --at 0.2 --quantity accelerance"
vxfit --measured "$dir/measured.csv" $place -o "$dir/fitted.trk" "$dir/t.trk" >"$dir/fit"
ok $? "a fit"
row() { awk -v p="$1" -v c="$2" '$1 == p { print $c }' "$dir/fit"; }
is "$(row railpad_stiffness 4) $(row railpad_damping 4) $(row ballast_stiffness 4) $(row ballast_damping 4)" "1.2e+08 30000 2e+08 1.5e+05" \
    "railpads and ballast of the track that was measured"
is "$(row railpad_stiffness 3) $(row railpad_stiffness 6)" "3e+08 0.40000" "from where it began, and the factor"
vxfreq --receptance --excite left --at 0.2 --quantity accelerance --from 30 --to 1200 --step 10 -o "$dir/fitted.frf" "$dir/fitted.trk"
vxcmp --rel 1e-5 "$dir/real.frf" "$dir/fitted.frf" >/dev/null
ok $? "the fitted track has the receptance measured"

# Noise of some 5 % by a fixed sequence: the fit lies within three of its uncertainties.
awk -F, 'function draw() { s = s * 16807 % 2147483647; return s / 2147483647 - 0.5 }      # Lehmer 1951, Park and Miller 1988
    BEGIN { s = 12345 }
    NR == 1 { print; next }
    { a = 1 + 0.17 * draw(); b = 0.17 * draw(); printf "%s,%.10g,%.10g\n", $1, $2 * a - $3 * b, $3 * a + $2 * b }' "$dir/measured.csv" >"$dir/noisy.csv"
vxfit --measured "$dir/noisy.csv" $place "$dir/t.trk" >"$dir/fit"
for p in "railpad_stiffness 120e6" "railpad_damping 30e3" "ballast_stiffness 200e6" "ballast_damping 150e3"; do
    set -- $p
    awk -v p=$1 -v true=$2 '$1 == p { e = ($4 - true) / $5; good = e * e < 9 && $5 > 0 && $5 < 0.1 * $4; print "# " $0 } END { exit !good }' "$dir/fit"
    ok $? "$1 from a noisy receptance within three of its uncertainties, which are below 10 %"
done

vxfit --measured "$dir/measured.csv" $place --fix railpad_damping --bounds 0.5,2 "$dir/t.trk" >"$dir/fit" 2>"$dir/said"
is "$(row railpad_damping 7) $(row railpad_stiffness 7) $(row railpad_stiffness 5)" "fixed lower -" "what is fixed, and what meets its bound, without uncertainty"

like "$(cat "$dir/said")" '^vxfit: railpad_stiffness ends at its lower bound' "which is said"

fails 2 "no measurement" vxfit "$dir/t.trk"
fails 2 "a parameter that is none" vxfit --measured "$dir/measured.csv" --fix rail "$dir/t.trk"
fails 2 "bounds that do not hold 1" vxfit --measured "$dir/measured.csv" --bounds 2,3 "$dir/t.trk"
fails 1 "two frequencies" vxfit --measured "$dir/measured.csv" --to 35 "$dir/t.trk"
echo 'station value' >"$dir/other"
fails 1 "another table" vxfit --measured "$dir/other" "$dir/t.trk"
refuses() { fails 1 "$1" vxfit --measured "$dir/bad.csv" -o "$dir/none.trk" "$dir/t.trk"; like "$(cat "$dir/err")" "$2" "  $2"; }
awk -F, 'NR == 5 { print $1 ",0,0"; next } 1' "$dir/measured.csv" >"$dir/bad.csv"
refuses "a zero" 'bad.csv:5: error: 0 +0i at 60 Hz'
[ ! -e "$dir/none.trk" ]
ok $? "and nothing is written"
awk -F, 'NR == 5 { print 45 "," $2 "," $3; next } 1' "$dir/measured.csv" >"$dir/bad.csv"
refuses "a frequency that falls back" 'bad.csv:5: error: the frequency must be above 50 Hz.*not 45'
sed 1d "$dir/measured.csv" >"$dir/bad.csv"
refuses "no header" 'line 1: a header must name the columns'
sed '4s/,[^,]*$//' "$dir/measured.csv" >"$dir/bad.csv"
refuses "a number too few" 'line 4: column 3, [a-z.]*, is missing'
done_testing
