#!/bin/sh
# Modes of the shipped vehicles with the wheelsets held: names as an engineer gives them, frequencies as worked out by hand.
#
# Manchester coach: bounce of the carbody 1.074 Hz and pitch 1.299 Hz on secondary and primary in series, bogie bounce 7.47 Hz on both;
# longitudinal sqrt(4 x 160e3/32 000), yaw sqrt(4 x 160e3 (9.5^2 + 1)/1.97e6), bogie pitch sqrt(4 (1220e3 x 1.28^2 + 31 391e3 x 0.14^2)/1476), each
# of them alone, so some per cent off.  Quarter car: the coach's.  Wagon: bounce sqrt(k/(80 600 + 4000)) on 20.8 MN/m less what the bowls give.
. tests/tap.sh

# mode VEHICLE: "number Hz damping name" of all modes, in $dir/modes.
modes()
{
    vxvehicle -o "$dir/v.veh" "data/vehicles/$1.yaml" && vxfreq --modes "$2" --text "$dir/v.veh" >"$dir/modes"
    ok $? "modes of $1"
}

# has NAME LEAST MOST: the first mode of this name.
has()
{
    between "$(awk -v name="$1" '{n = $0; sub(/^ *[^ ]+ +[^ ]+ +[^ ]+ +/, "", n)} n == name {print $2; exit}' "$dir/modes")" "$2" "$3" "$1, Hz"
}

modes manchester-passenger 18
has "carbody bounce" 1.0686 1.0794
has "carbody pitch" 1.2925 1.3055
has "bogie bounce, in phase" 7.433 7.507
has "bogie bounce, antiphase" 7.433 7.507
has "carbody longitudinal" 0.69 0.72
has "carbody yaw" 0.84 0.88
has "bogie pitch, in phase" 11.2 12.5
is "$(awk '{print $4, $5}' "$dir/modes" | head -6 | sort | tr '\n' ';')" \
    "carbody bounce;carbody longitudinal;carbody lower;carbody pitch;carbody upper;carbody yaw;" "the six lowest are those of the carbody, each once"
is "$(awk '$4 == "bogie"' "$dir/modes" | sed 's/,.*//; s/.*bogie/bogie/' | sort | uniq -c | awk '{print $1, $3}' | tr '\n' ';')" \
    "2 bounce;2 longitudinal;2 lower;2 pitch;2 upper;2 yaw;" "the others are those of two bogies, in phase and antiphase"

modes passenger-19t 18
has "carbody bounce" 1.0686 1.0794

modes quarter-car 12
has "carbody bounce" 1.0686 1.0794
has "bogie bounce" 7.433 7.507

modes freight-y25-22t5-linear 18
has "wagon bounce" 2.2 2.3
has "bogie bounce, in phase" 25.2 26.2
done_testing
