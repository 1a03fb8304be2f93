#!/bin/sh
# Sections measured along the track: lists of every kind into sets of bodies, what is refused, and the public crossings.
. tests/tap.sh

# head FILE Y Z...: heads of 56 mm one beside the other, each at its y and z (mm), in metres, joined by a channel 40 mm deep.
head()
{
    file=$1
    shift
    echo "$@" | awk '
        {for (k = 1; k < NF; k += 2) {
            for (s = -28; s <= 28; s += 0.5) {
                d = (s < 0 ? -s : s) - 20
                printf "%.6f %.6f\n", 1e-3*($k + s), 1e-3*($(k + 1) + (d > 0 ? 8 - sqrt(64 - d*d*0.999999) : 0) + (d == 8 ? 15 : 0))
            }
            if (k + 2 < NF) printf "%.6f 0.04\n%.6f 0.04\n", 1e-3*($k + 29), 1e-3*($(k + 2) - 29)
        }}' >"$dir/$file"
}
# bodies FILE: name, first and last station, number of outlines
bodies()
{
    vxprofile --set spacing=0.001 --check "$@" | awk -F'\t' '/^# station/ {on = 1; next}
        on {n[$2]++; if (!($2 in from)) {from[$2] = $1; order[++bodies] = $2} to[$2] = $1}
        END {for (i = 1; i <= bodies; i++) {b = order[i]; printf "%s %.3f %.3f %d\n", b, from[b], to[b], n[b]}}'
}

for i in 1 2 3 4 5; do
    case $i in
    3 | 4) head s$i.txt 0 $((6 - i)) $((70 + 5 * i)) -1 ;;
    *) head s$i.txt $([ $i -lt 3 ] && echo $((70 + 5 * i)) || echo 0) 0 ;;
    esac
    echo " $i  $i.5" >>"$dir/index.txt"
done
{
    printf '%% a test\n 0.5 1000. U_OFFSET U_SCALE\n 5 NSLC\n 0 0 0\n 1 U_INTPOL\n'
    for i in 1 2 3 4 5; do echo "$i.0 's$i.txt'"; done
} >"$dir/t.slcs"
is "$(bodies --set sections.every=0.25 "$dir/t.slcs")" "rail 1.500 4.500 13
rail 2 3.500 5.500 9" "a .slcs: the first body ends at the fourth section, the second begins at the third"
cat >"$dir/t.yaml" <<'EOF'
profile:
  name: test
  part: sections
  sections:
    index: index.txt
    files: s*.txt
    every: 0.5
    at: 10
    names: [{name: wing rail}, {name: nose}]
    extra:
      - name: check rail
        list: [{station: 2, file: s1.txt}, {station: 4, file: s2.txt}]
EOF
is "$(bodies "$dir/t.yaml")" "wing rail 11.500 14.500 7
check rail 12.000 14.000 5
nose 13.500 15.500 5" "an index with another list: named, moved by at"
vxprofile -o "$dir/r.prof" "$dir/t.slcs" && vxprofile --side l -o "$dir/l.prof" "$dir/t.slcs" && vxinfo "$dir/l.prof" >/dev/null
ok $? "both sides are written"

cp "$dir/t.slcs" "$dir/t.slcw"
fails 1 "a wheel out of round" vxprofile "$dir/t.slcw"
like "$(cat "$dir/err")" "out of round" "and why"
sed 's/s3.txt/absent.txt/' "$dir/t.slcs" >"$dir/absent.slcs"
fails 1 "a section that is not there" vxprofile "$dir/absent.slcs"
like "$(cat "$dir/err")" "absent.txt" "is named"
fails 1 "a reference that is not there" vxprofile --set sections.reference=6 "$dir/t.slcs"
fails 1 "a wrong unit" vxprofile --set unit=mm "$dir/t.slcs"
fails 2 "--unit" vxprofile --unit m "$dir/t.slcs"
sed '/index:/d' "$dir/t.yaml" >"$dir/wrong.yaml"
fails 1 "files without an index" vxprofile "$dir/wrong.yaml"

public=../shared/data/contact_profiles
if [ -d $public ]; then
    is "$(bodies --set sections.every=0.1 --set sections.position=0.75 $public/uk_interrupt_v2.slcs)" "rail -0.085 0.179 20
rail 2 0.119 0.179 13" "features declared where the nose begins"
    for f in "cross+wing 2" "cross+wing_extd 2" "cross_nose 1" "wing_rail 1" "uk_interrupt_v1 2" "uk_crossing 2"; do
        is "$(bodies --set sections.every=1 --set sections.position=0.75 "$public/${f% *}.slcs" | wc -l)" "${f#* }" "${f% *}: bodies"
    done
    vxprofile --set sections.position=0.75 -o "$dir/n.prof" $public/cross_nose.slcs
    vxdump "$dir/n.prof" z slope fall | awk -F, 'NR > 1 && $2*$2 < 1 {d = $3 + 0.1; if (d*d > w) w = d*d} END {printf "%.6f\n", sqrt(w)}' >"$dir/nose"
    between "$(cat "$dir/nose")" 0 0.0005 "the nose that rises by 1:10 falls by -0.1 all over; greatest error"
    vxprofile --set sections.position=0.75 -o "$dir/w.prof" $public/wing_rail.slcs
    vxdump "$dir/w.prof" z slope fall | awk -F, 'NR > 1 && $2*$2 < 1 {d = $3 + 0.1*$2; if (d*d > w) w = d*d} END {printf "%.6f\n", sqrt(w)}' >"$dir/wing"
    between "$(cat "$dir/wing")" 0 0.0005 "the wing rail that leaves by 1:10 falls by -0.1 of its slope; greatest error"
else
    echo "# SKIP $public is absent"
fi
done_testing
