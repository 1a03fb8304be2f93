#!/bin/sh
# S1002 over the cast crossing 56E1-R245-1:9.25, 148 measured sections: the wheel's path from the contact tables against the path computed
# section by section, its smoothness, where it goes from wing rail to nose, how far ahead of the axle it touches.
#
# The reference puts the sections' origin at 753 mm (gauge face 35.5 mm inside it).
. tests/tap.sh

data=../shared/data
[ -e $data/uk_crossing_path.csv ] || skip_all "$data is absent"
ok $(vxprofile --set sections.position=0.753 $data/contact_profiles/uk_crossing.slcs -o "$dir/r.prof" &&
    vxprofile data/profiles/S1002.yaml -o "$dir/w.prof" &&
    vxcontact --wheel "$dir/w.prof" --rail "$dir/r.prof" --u-max 0.005 --yaw none -o "$dir/none.ctab" &&
    vxcontact --wheel "$dir/w.prof" --rail "$dir/r.prof" --u-max 0.005 --yaw exact --yaw-max 0.004 --yaws 3 -o "$dir/exact.ctab"; echo $?) "tables"

# path TABLE U: station, height, rail_y, x in mm, every millimetre
path()
{
    vxcontact --path u="$2"e-3,from=-0.9,to=2.1,step=0.001 "$1" | awk 'NR > 1 {print 1000*$1, 1000*$3, 1000*$4, 1000*$6}'
}
# worst COLUMN FROM TO: largest difference (mm) from column COLUMN of the reference between these stations (m)
worst()
{
    awk -v k="$1" -v from="$2" -v to="$3" -F'[, ]' 'NR == FNR {s[NR] = $1/1000; z[NR] = $2; n = NR; next}
        FNR > 1 && $1 >= from && $1 <= to {while (i < n - 1 && s[i + 2] < $1) i++
            e = z[i + 1] + (z[i + 2] - z[i + 1])*($1 - s[i + 1])/(s[i + 2] - s[i + 1]) - $k; if (e < 0) e = -e; if (e > w) w = e; seen++}
        END {if (seen) printf "%.4f\n", w; else print "nothing compared"}' "$dir/path" $data/uk_crossing_path.csv
}
rough()
{
    awk '{z[NR] = $2} END {for (i = 3; i < NR - 1; i++) {e = (z[i+1] - z[i]) - 0.5*((z[i] - z[i-1]) + (z[i+2] - z[i+1])); if (e < 0) e = -e; if (e > w) w = e}
        if (NR > 3) printf "%.4f\n", w; else print "no path"}' "$dir/path"
}

k=2
for u in -4 -2 0 2 4; do
    path "$dir/none.ctab" $u >"$dir/path"
    between "$(worst $k -0.85 2.05)" 0 0.02 "u = $u mm, plane sections: mm from the reference, at all sections"
    path "$dir/exact.ctab" $u >"$dir/path"
    between "$(worst $k -0.6 1.85)" 0 0.05 "u = $u mm, falling rails: mm from the reference between the ramps"
    between "$(worst $k -0.85 2.05)" 0 0.2 "u = $u mm, falling rails: over the ramps, which the wheel feels a contact's length before"
    k=$((k + 2))
done
for u in -4 -3 -2 -1 0 1 2 3 4; do
    path "$dir/exact.ctab" $u >"$dir/path"
    between "$(rough)" 0 0.03 "u = $u mm: mm an increment of the path over 1 mm differs from its neighbours' mean"
done
path "$dir/exact.ctab" 0 >"$dir/path"
between "$(awk '$1 > 0 && $3 < 0 {print $1; exit}' "$dir/path")" 220 280 "from the wing rail to the nose, mm"
between "$(awk '$1 > 282 && $1 < 310 {s += $4; n++} END {print s/n}' "$dir/path")" 4.5 5.5 "mm ahead on the nose's ramp"
between "$(awk '$1 > 180 && $1 < 240 {s += $4; n++} END {print s/n}' "$dir/path")" -3.8 -2.8 "mm behind on the wing rail"
vxcontact --path u=0,from=0.18,to=0.24,step=0.002 "$dir/exact.ctab" >"$dir/wing"
between "$(awk 'NR > 1 {d = $8 + 0.0666667; if (d < 0) d = -d; if (d > w) w = d} END {print 1e3*w}' "$dir/wing")" 0 1 \
    "on the wing rail's edge the contact plane is that of the tread's cone, mrad"

# A yawed wheelset: its right wheel's centre stands 750 mm sin(yaw) behind.
vxcontact --query u=0,yaw=0.002,s=0.2 "$dir/exact.ctab" >"$dir/yawed"
vxcontact --query u=0,yaw=0,s=0.1985 "$dir/exact.ctab" >"$dir/straight"
between "$(awk 'FNR == 2 {z[++n] = $2} END {print 1e3*(z[1] - z[2])}' "$dir/yawed" "$dir/straight")" -0.002 0.002 "yawed by 2 mrad the wheel feels the rail 1.5 mm behind, mm"
done_testing
