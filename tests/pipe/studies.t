#!/bin/sh
# The sums of the studies of passages, on numbers made up: spectra, differences of passages, tables of extremes; the recipes of these studies.
. tests/tap.sh

# 1 N at 37 Hz and 2 N at 74 Hz, 50 m/s, on 3 N.
awk 'BEGIN {print "station (m),Q"; for (i = 0; i <= 4000; i++) {x = i/100; t = 8*atan2(1, 1)*x/50; print x "," 3 + sin(37*t) + 2*cos(74*t)}}' \
    >"$dir/q.csv"
awk -v from=0 -v to=40 -v v=50 -v name=one -f pipelines/spectrum.awk "$dir/q.csv" >"$dir/spectrum"
between "$(awk '$1 == 37 {print $2}' "$dir/spectrum")" 0.98 1.02 "amplitude at 37 Hz"
between "$(awk '$1 == 74 {print $2}' "$dir/spectrum")" 1.96 2.04 "amplitude at 74 Hz"
between "$(awk '$1 == 55 {print $2}' "$dir/spectrum")" 0 0.02 "nothing between"

# passage NAME FACTOR: two wheelsets 2 m apart, bodies 0 and 1; yaw of the second one x mrad times the factor, its Q left 1 kN times that at 5 m.
passage()
{
    awk -v f="$2" 'BEGIN {
        printf "station (m)"
        for (b = 1; b <= 2; b++)
            for (k = 1; k <= 6; k++)
                printf ",\"body.q[%d][%d] (m,rad)\"", b, k
        for (w = 1; w <= 2; w++)
            printf ",contact.wheel_y[%d][1][1] (m),contact.wheel_y[%d][2][1] (m),contact.rail_y[%d][1][1] (m),contact.rail_y[%d][2][1] (m)", w, w, w, w
        for (w = 1; w <= 2; w++)
            printf ",wheel.Q[%d][1] (N),wheel.Q[%d][2] (N),wheel.Y[%d][1] (N),wheel.Y[%d][2] (N)", w, w, w, w
        print ""
        for (s = 0; s <= 12; s++)
            print s ",0,0,0,0,0,0,0,0,0,0,0," (s - 2)*1e-3*f ",0,0,0,0,0,0,0,0,0,0,0,0," (s == 7 ? 1000*f : 0) ",0,0,0"
    }' >"$dir/$1-samples.csv"
}
passage one 1.5
passage two 1
awk -v between="0:4 4:8" -v bodies="0 1" -v x="0 -2" -f pipelines/passages.awk "$dir/one-samples.csv" "$dir/two-samples.csv" >"$dir/differences"
is "$(awk -F, 'NR > 1' "$dir/differences" | wc -l | tr -d ' ')" 40 "ten quantities of two wheelsets between two pairs of stations"
is "$(grep '^4,8,2,yaw' "$dir/differences")" "4,8,2,yaw,mrad,one,12,8,4,8.00,3.082,4" "yaw of the second wheelset by its own station"
is "$(grep '^4,8,2,Q_left' "$dir/differences")" "4,8,2,Q_left,kN,one,1.5,1,0.5,5.00,0.2236,1" "its Q"
is "$(grep '^0,4,1,yaw' "$dir/differences" | cut -d, -f7-9)" "0,0,0" "the first one does not turn"

mkdir "$dir/a" "$dir/b"
head=zone,name,seats,Q,at,Y,at,pad,at,d,at,ballast,at
printf '%s\n0,no zone,1,100,-1,0,0,50,-1,1,-1,20,-1\n1,switch,2,200,3,10,4,60,5,2,6,30,7\n' $head >"$dir/a/car-through-50.csv"
printf '%s\n0,no zone,1,101,-1,0,0,50,-1,1,-1,20,-1\n1,switch,2,190,3,10,4,60,6,2,6,30,7\n' $head >"$dir/b/car-through-50.csv"
awk -f pipelines/accuracy.awk "$dir/a/car-through-50.csv" "$dir/b/car-through-50.csv" >"$dir/table"
is "$(sed -n 1p "$dir/table" | cut -d, -f6,8)" "a,b" "settings are named by their folders"
is "$(grep 'switch,Q' "$dir/table")" "car,through,50,switch,Q,200,3,190,3,-5.000" "the second against the first"
is "$(grep 'no zone,Y' "$dir/table")" "car,through,50,no zone,Y,0,0,0,0," "nothing over nothing"

for study in moving accuracy; do
    env -u MAKEFLAGS -u MAKELEVEL make -Bn $study >"$dir/$study" 2>&1
    ok $? "make knows how to make $study"
done
is "$(grep -c 'vxrun .*--set name' "$dir/accuracy")" 48 "twelve passages by three settings and on another mesh"
is "$(grep 'vxrun .*contact.grid=50' "$dir/accuracy" | grep -c 'step=1e-5')" 12 "twelve by those of reference"
is "$(grep 'vxrun .*accuracy/.*passenger' "$dir/accuracy" | grep -c 'speed_kmh=200')" 12 "a coach at 200 km/h on the through route"
done_testing
