#!/bin/sh
# Every profile file of others is read the right way round, or refused for a reason: one line of the table each.  Lengths in mm, residuals
# in um.  The wheels whose files say Sh, Sd and qR are held against these, MiniProf files also turned round against themselves.
. tests/tap.sh

others=../shared/data/contact_profiles
[ -d $others ] || skip_all "$others is absent"

# FILE|OPTIONS|refused|REASON or FILE|OPTIONS|PART|MIRRORED y z, SHIFT, measures where there are: gauge face or flange Sh Sd qR, cant; extent
cat >"$dir/table" <<'END'
MBench_UIC60_v3.ban||rail|true false 0 face -43.03 cant 0.0250 y -43.70 30.60 z 0.00 38.51 residual 2.6
avg_low2.ban||rail|true true 0 face -25.53 cant 0.0261 y -25.52 53.95 z 0.00 11.50 residual 120.2
guard_rail_test.ban||refused|whether z points up or down cannot be seen
guard_rail_test.ban|--set mirror_y=true --set mirror_z=true|refused|dips 44.0 mm below both its ends: a groove, or two rails in one outline
left-roller-v1-pre-dry.ban||rail|false false 0 face -37.04 y -38.03 36.12 z 0.00 20.84 residual 34.2
right-roller-v1-pre-dry.ban||rail|false false 0 face -37.34 y -38.34 35.42 z 0.00 23.24 residual 61.3
rail_left_iter288.ban||rail|true true 0 face -29.94 cant 0.0769 y -29.94 36.43 z 0.00 27.60 residual 168.9
rail_left_iter795.ban||rail|true true 0 face -22.01 cant 0.0996 y -35.46 36.38 z 0.00 32.45 residual 40.4
avg_HR.BAN||rail|true true 0 face -44.88 y -46.59 11.73 z 0.00 25.21 residual 7.5
Car7216_0001r.whl||wheel|false false -70 flange 27.64 33.07 11.52 y -70.09 61.35 z -16.81 27.64 residual 183.4
Car7358_0001r.whl||wheel|false false -70 flange 26.85 31.76 9.31 y -70.18 61.92 z -7.40 26.85 residual 32.5
Car7422_0001r.whl||wheel|false false -70 flange 28.50 29.74 8.18 y -70.01 61.37 z -16.79 28.50 residual 140.9
Car7813_0001r.whl||wheel|false false -70 flange 27.55 29.52 7.58 y -70.04 61.41 z -15.74 27.55 residual 37.5
avg_wheel.whl||wheel|false false -70 flange 28.04 30.14 8.09 y -68.46 69.70 z -18.34 28.04 residual 22.7
left-wheel-v1-pre-dry.whl||wheel|false false -70 flange 27.90 36.17 9.12 y -69.86 73.28 z -12.32 27.90 residual 17.1
right-wheel-v1-pre-dry.whl||wheel|false false -70 flange 27.80 36.25 9.19 y -69.55 73.30 z -13.95 27.80 residual 9.1
whl_left_iter288.whl||wheel|false false -70 flange 28.36 36.37 5.44 y -70.13 75.07 z -21.15 28.36 residual 14.7
whl_left_iter795.whl||wheel|false false -70 flange 34.98 34.34 10.03 y -69.98 77.05 z -6.75 34.98 residual 27.6
SNX00500.mpt||refused|need --part
SNX00500.mpt|--part rail|refused|section: must be stated, the file holds 2
SNX00500.mpt|--part rail --set section=1|rail|true true 0 face -67.11 cant 0.0001 y -73.00 -27.17 z 0.00 37.66 residual 43.6
SNX00500.mpt|--part rail --set section=2|refused|which side of this rail is the gauge side cannot be seen: state mirror_y
SNX00500.mpt|--part rail --set section=2 --set mirror_y=true|rail|true true 0 face -35.22 cant -0.0039 y -35.21 37.23 z 0.00 33.52 residual 117.3
MBench_UIC60_v3.prr||rail|false false 0 face -43.03 cant 0.0250 y -43.70 30.60 z 0.00 38.51 residual 2.6
circ_r100.prr||rail|false false 0 face -51.03 cant 0.0000 y -99.90 99.90 z 0.00 95.53 residual 0.4
circ_r300.prr||rail|false false 0 face -90.58 cant 0.0000 y -212.10 212.10 z 0.00 87.83 residual 0.6
flat_ang200.prr||refused|only the field side reaches the gauge depth
flat_plane.prr||refused|the gauge side ends 0.00 mm below the top
groove_r1002.prr||refused|the surface is hollow where a rail has its top
groove_r1005.prr||refused|the surface is hollow where a rail has its top
groove_r1010.prr||refused|the surface is hollow where a rail has its top
groove_r1025.prr||refused|the surface is hollow where a rail has its top
meas_roller.prr||refused|the gauge side ends 0.70 mm below the top
r300_wide.prr||rail|false false 0 face -40.34 cant 0.0000 y -40.43 40.43 z 0.00 15.43 residual 2.9
site_b_hr.prr||rail|false false 0 face -31.16 cant 0.0891 y -36.89 36.51 z 0.00 35.55 residual 43.8
uic60_true.prr||rail|false false 0 face -40.34 cant 0.0000 y -40.43 40.43 z 0.00 15.43 residual 2.9
MBench_S1002_v3.prw||wheel|false false 0 flange 28.00 32.50 10.79 y -69.61 60.00 z -2.64 28.00 residual 2.7
circ_r10.prw||wheel|false false 0 y -9.92 9.92 z -8.59 0.00 residual 16.2
circ_r100.prw||wheel|false false 0 y -50.00 50.00 z -13.40 0.00 residual 2.2
circ_r50.prw||wheel|false false 0 y -49.90 49.90 z -46.84 0.00 residual 1.3
final_clean.prw||wheel|false false 0 y -0.00 15.96 z -0.01 0.00 residual 12.9
flat_ang200.prw||wheel|false false 0 y -50.00 50.00 z -10.14 10.14 residual 0.0
flat_plane.prw||wheel|false false 0 y -50.00 50.00 z 0.00 0.00 residual 0.0
worn_high_mileage.prw||refused|the flange tip lies at y = 20.6 mm, from a running circle it would be -68 to -38: state shift_y
worn_high_mileage.prw|--set shift_y=-0.070|wheel|false false -70 flange 35.36 30.89 7.87 y -66.07 73.45 z -3.02 35.36 residual 30.0
os_l.csv|--part rail --unit mm|refused|the gauge side ends 3.73 mm below the top
os_l.csv|--part rail --unit m|refused|wrong unit
os_l.csv|--part rail --unit mm --set gauge_depth=0.002|rail|false true 0 face -33.93 cant -0.0000 y -33.93 -11.62 z 0.00 1.42 residual 95.3
fr_ol.csv|--part wheel --unit mm|refused|no flange shows which side faces the track's centre: state mirror_y
fr_ol.csv|--part wheel --unit mm --set mirror_y=false|refused|does not reach its running circle y = 0: see shift_y
END

ls $others | grep -iE '[.](ban|bnd|whl|mpt|prr|prw|csv)$' | sort >"$dir/there"
is "$(cut -d'|' -f1 "$dir/table" | sort -u | comm -13 - "$dir/there")" "" "the table names every file of the folder"

# The measures of --check as the table has them.
measures()
{
    awk -F'\t' '
        {v[$1] = $2}
        $1 == "flange_said" {said = sprintf("%.2f %.2f %.2f", 1e3 * $2, 1e3 * $3, 1e3 * $4)}
        $1 == "0.000" {y = sprintf("y %.2f %.2f z %.2f %.2f", 1e3 * $4, 1e3 * $5, 1e3 * $6, 1e3 * $7)}
        END {
            printf "%s|%s %s %.0f ", v["part"], v["mirror_y"], v["mirror_z"], 1e3 * v["shift_y"]
            if ("gauge_face" in v) printf "face %.2f ", 1e3 * v["gauge_face"]
            if ("flange_height" in v) printf "flange %.2f %.2f %.2f ", 1e3 * v["flange_height"], 1e3 * v["flange_thickness"], 1e3 * v["flange_slope"]
            if ("cant_found" in v) printf "cant %.4f ", v["cant_found"]
            printf "%s residual %.1f\n", y, 1e6 * v["residual_worst"]
        }' "$1"
}

# Words alike, numbers within 0.011 (residuals 1 %).
alike()
{
    printf '%s\n%s\n' "$1" "$2" | awk '
        {gsub(/[|]/, " "); n[NR] = NF; for (i = 1; i <= NF; i++) w[NR, i] = $i}
        END {
            bad = n[1] != n[2]
            for (i = 1; i <= n[1]; i++) {
                d = w[1, i] - w[2, i]; d = d < 0 ? -d : d
                tolerance = w[1, i - 1] == "residual" ? 0.1 + 0.01 * w[1, i] : w[1, i - 1] == "cant" ? 0.0005 : 0.011
                if (w[1, i] ~ /^[-0-9]/ ? d > tolerance : w[1, i] != w[2, i]) bad = 1
            }
            exit bad
        }'
}

while IFS='|' read -r file options part facts; do
    vxprofile --check $options "$others/$file" >"$dir/out" 2>"$dir/err"
    status=$?
    if [ "$part" = refused ]; then
        [ $status -ne 0 ] && [ ! -s "$dir/out" ] && [ "$(wc -l <"$dir/err")" -eq 1 ] && grep -qF -- "$facts" "$dir/err"
        ok $? "$file $options: refused, $facts"
        sed 's/^/# /' "$dir/err"
    else
        got=$([ $status -eq 0 ] && measures "$dir/out")
        alike "$got" "$part|$facts"
        ok $? "$file $options: $part $facts"
        [ "$got" = "$part|$facts" ] || echo "# got $got" "$(cat "$dir/err")"
    fi
done <"$dir/table"

# What the files say of their flanges: measured by the instrument's program.
for file in left-wheel-v1-pre-dry right-wheel-v1-pre-dry whl_left_iter288 whl_left_iter795; do
    vxprofile --check "$others/$file.whl" | awk -F'\t' '
        /^flange_said/ {for (i = 2; i <= 4; i++) said[i - 1] = $i}
        /^flange_height/ {got[1] = $2} /^flange_thickness/ {got[2] = $2} /^flange_slope/ {got[3] = $2}
        END {
            for (i = 1; i <= 3; i++) {d = got[i] - said[i]; d = d < 0 ? -d : d; worst = d > worst ? d : worst}
            printf "%.3f\n", 1e3 * worst
        }' >"$dir/worst"
    between "$(cat "$dir/worst")" 0 0.2 "$file: Sh, Sd, qR from those of its header, mm"
done

# Turned round, a MiniProf file gives the same profile or is refused: never its mirror image.
for file in $(cd $others && ls *.ban *.BAN *.whl); do
    vxprofile --check "$others/$file" >"$dir/out" 2>"$dir/err" || continue
    want=$(measures "$dir/out" | cut -d' ' -f3-)
    for turn in "-1 1" "1 -1" "-1 -1"; do
        awk -v turn="$turn" 'BEGIN {split(turn, s, " "); CONVFMT = OFMT = "%.12g"} /^[ \t]*[-0-9.eE+]+[ \t]+[-0-9.eE+]+/ && !/Sd/ && !/=/ {$1 *= s[1]; $2 *= s[2]} 1' \
            "$others/$file" >"$dir/turned.${file##*.}"
        if vxprofile --check "$dir/turned.${file##*.}" >"$dir/out" 2>"$dir/err"; then
            got=$(measures "$dir/out" | cut -d' ' -f3-)
            alike "$want" "$got"
            ok $? "$file, columns times $turn: the same profile"
            [ "$want" = "$got" ] || printf '# %s\n# %s\n' "$want" "$got"
        else
            grep -q 'state mirror_[yz]' "$dir/err"
            ok $? "$file, columns times $turn: $(cut -d: -f3- "$dir/err")"
        fi
    done
done

# The same rail in two formats; some points of the one are put out, so the points written lie up to 1 um on along the curve.
vxprofile -o "$dir/ban.prof" $others/MBench_UIC60_v3.ban && vxprofile -o "$dir/prr.prof" $others/MBench_UIC60_v3.prr &&
    vxcmp --only y --only z --max 1e-6 "$dir/ban.prof" "$dir/prr.prof" >"$dir/differ"
ok $? "MBench_UIC60_v3 as MiniProf and as Simpack: the same points within 1 um"
sed 's/^/# /' "$dir/differ"
done_testing
