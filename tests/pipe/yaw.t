#!/bin/sh
# Three treatments of yaw compared, S1002 on 60E1 1:40: where the flange touches, and how far they are from the silhouette; the sums that
# make yaw prints; the recipes of make yaw.
. tests/tap.sh

vxprofile --side r -o "$dir/w.prof" data/profiles/S1002.yaml && vxprofile --side r --set cant=0.025 -o "$dir/r.prof" data/profiles/60E1.yaml
ok $? "profiles"
# table NAME OPTION...
table()
{
    name=$1
    shift
    vxcontact --wheel "$dir/w.prof" --rail "$dir/r.prof" --u-step 2e-5 -o "$dir/$name.ctab" "$@"
    ok $? "table $name"
}
table none --yaw none
table own --yaw thesis
table thesis --yaw thesis --yaw-max 0.024
table five --yaw thesis --yaw-max 0.024 --yaws 5
table exact --yaw exact --yaw-max 0.024 --yaws 25

is "$(vxdump --csv "$dir/own.ctab" yaw | awk 'NR > 1 {n++; s += $1} END {print n, s + 0}')" "3 0" "three yaws, even about 0"
between "$(vxdump --csv "$dir/own.ctab" yaw | awk 'END {print $1 * 1.8/2 * 1e3}')" 6.6 6.64 "clearance on its own range, mm"

for yaw in 0 5 12 24; do
    own=thesis
    [ $yaw -le 5 ] && own=own
    vxcontact --sweep yaw=${yaw}e-3 "$dir/none.ctab" "$dir/$own.ctab" "$dir/exact.ctab" >"$dir/plain-$yaw.txt"
    ok $? "sweep at $yaw mrad"
done
vxcontact --sweep yaw=12e-3 "$dir/none.ctab" "$dir/five.ctab" "$dir/exact.ctab" >"$dir/five-12.txt"
awk -f pipelines/yaw.awk "$dir/plain-0.txt" "$dir/plain-5.txt" "$dir/plain-12.txt" "$dir/plain-24.txt" "$dir/five-12.txt" >"$dir/errors"
sed 's/^/# /' "$dir/errors"
# at PLACE YAW METHOD COLUMN
at()
{
    awk -v p="$1" -v y="$2" -v m="$3" -v c="$4" 'NR == 1 {for (i = 1; i <= NF; i++) {sub(/\[.*/, "", $i); n[$i] = i}} $1 == p && $2 == y && $3 == m {print $n[c]}' \
        "$dir/errors"
}
minus()
{
    awk -v a="$1" -v b="$2" 'BEGIN {printf "%.3f", a - b}'
}

is "$(awk '$2 == 0 {for (i = 5; i <= 9; i++) s += $i; n++} END {print n ? s + 0 : "no rows"}' "$dir/errors")" 0 "at yaw 0 all three are the same"
is "$(awk 'NR > 1 {d = $4 - was; if (NR > 2 && d < -3e-3) printf "%s%.1f", n++ ? " " : "", $1 * 1e3; was = $4}' "$dir/plain-0.txt")" "0.2 5.2 6.6" \
    "without yaw the contact leaps at 0.2, 5.2 and 6.6 mm"

none=$(at plain 24 none u_flange) exact=$(at plain 24 exact u_flange)
between "$(minus "$none" "$exact")" 0.2 0.3 "at 24 mrad the flange of the silhouette touches sooner, mm"
between "$(minus "$(at plain 12 none u_flange)" "$(at plain 12 exact u_flange)")" 0.04 0.08 "at 12 mrad by a quarter of that, mm"
# By construction: the section removed is as long as this asks for (thesis.c).
between "$(minus "$(at plain 24 thesis u_flange)" "$exact")" -0.05 0.05 "at 24 mrad the thesis' flange touches where the silhouette's does, mm"
between "$(minus "$(at plain 12 thesis u_flange)" "$(at plain 24 thesis u_flange)")" -0.03 0.03 \
    "between its three profiles it begins where that of the largest yaw does, mm"
between "$(minus "$(at five 12 thesis u_flange)" "$(at plain 12 exact u_flange)")" -0.05 0.05 "with a profile at 12 mrad where the silhouette's does, mm"
for column in height angle radius; do
    is "$(awk -v t="$(at plain 24 thesis $column)" -v n="$(at plain 24 none $column)" 'BEGIN {print (t < n/2)}')" 1 \
        "at 24 mrad the thesis' $column is less than half as far off as without yaw"
done

# On the flange at u = 7 mm the silhouette touches ahead of the axle by r tan(angle) tan(yaw); a profile touches below it.
ahead=$(awk '$1 > 6.99e-3 && $1 < 7.01e-3 {printf "%.2f", ($20 - $13) * 1e3}' "$dir/plain-24.txt")
between "$ahead" 30.5 32.5 "at 24 mrad and u = 7 mm the silhouette's contact lies ahead of the thesis' by 0.474 tan(70) tan(0.024), mm"
awk 'NR > 1 {d = $13 + (0.75 + $11) * sin(0.024); if (d * d > 1e-12) bad++} END {exit bad > 0 || NR < 2}' "$dir/plain-24.txt"
ok $? "which counts only the axle's turn"

vxprofile --side l -o "$dir/wl.prof" data/profiles/S1002.yaml && vxprofile --side l --set cant=0.025 -o "$dir/rl.prof" data/profiles/60E1.yaml &&
    vxcontact --wheel "$dir/wl.prof" --rail "$dir/rl.prof" --u-step 2e-5 --yaw thesis --yaw-max 0.024 -o "$dir/left.ctab"
ok $? "table of the left side"
vxcontact --query u=0.0064,yaw=0.017 "$dir/thesis.ctab" | awk 'NR == 2 {print $2, +$3, +$6, +$7, $5, $8}' >"$dir/right"
vxcontact --query u=-0.0064,yaw=-0.017 "$dir/left.ctab" | awk 'NR == 2 {print $2, -$3, -$6, -$7, $5, $8}' >"$dir/left"
[ -s "$dir/right" ] && cmp -s "$dir/left" "$dir/right"
ok $? "left mirrors right"

vxplot --size 800x800 --figure yaw --from 0.004 --to 0.008 -o "$dir/one.png" "$dir/plain-24.txt" &&
    vxplot --size 800x800 --figure yaw --label a --label b -o "$dir/two.png" "$dir/plain-0.txt" "$dir/plain-24.txt" &&
    [ "$(wc -c <"$dir/one.png")" -gt 20000 ] && ! cmp -s "$dir/one.png" "$dir/two.png"
ok $? "pictures of one sweep and of two"
vxcontact --query u=0.0064 "$dir/thesis.ctab" >"$dir/query.txt"
fails 1 "a table that is no sweep" vxplot --figure yaw "$dir/query.txt"
fails 1 "yaw beyond a table" vxcontact --sweep yaw=0.03 "$dir/none.ctab" "$dir/thesis.ctab"
fails 2 "a sweep of nothing" vxcontact --sweep yaw=0
fails 2 "a sweep without yaw" vxcontact --sweep s=0 "$dir/none.ctab"
fails 1 "sides mixed" vxcontact --sweep yaw=0 "$dir/thesis.ctab" "$dir/left.ctab"
fails 1 "a yaw for which the flange's root is too short" vxcontact --wheel "$dir/w.prof" --rail "$dir/r.prof" --yaw thesis --yaw-max 0.09
fails 1 "no flange touches within the range" vxcontact --wheel "$dir/w.prof" --rail "$dir/r.prof" --u-max 0.004 --yaw thesis
like "$(cat "$dir/err")" "no flange touches" "which is told"

env -u MAKEFLAGS -u MAKELEVEL make -n yaw >"$dir/recipes" 2>&1
ok $? "make knows how to make the whole comparison"
is "$(env -u MAKEFLAGS -u MAKELEVEL make -Bn yaw | grep -c 'vxcontact --sweep')" 8 "from two places at four yaws"
done_testing
