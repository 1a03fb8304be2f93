# Sweeps of vxcontact --sweep, out/yaw/PLACE-YAW.txt, against their columns "exact": where the flange touches (the contact plane at 45 degrees
# or more), and over |u| of 1 to 8 mm the root mean square difference of place on the wheel, place ahead, height, angle and rolling radius.
BEGIN {
    split("wheel_y x height angle radius", what)
    printf "%-8s %9s %-7s %14s", "place", "yaw[mrad]", "method", "u_flange[mm]"
    for (i = 1; i <= 5; i++)
        printf " %13s", what[i] "[" (what[i] == "angle" ? "mrad" : "mm") "]"
    print ""
}

function report(    m, i) {
    for (m = 1; m <= methods; m++) {
        printf "%-8s %9s %-7s %14.2f", place, yaw, method[m], flange[m] * 1e3
        for (i = 1; i <= 5; i++)
            printf " %13.4f", rows ? sqrt(sum[m, what[i]] / rows) * 1e3 : 0
        print ""
    }
}

FNR == 1 {
    if (NR > 1)
        report()
    n = split(FILENAME, part, "/")
    split(part[n], word, /[-.]/)
    place = word[1]
    yaw = word[2]
    delete column
    delete sum
    delete flange
    rows = methods = 0
    for (i = 1; i <= NF; i++) {
        name = $i
        sub(/\[.*/, "", name)
        column[name] = i
        if (sub(/^height_/, "", name))
            method[++methods] = name
    }
    next
}

{
    u = $1 < 0 ? -$1 : $1
    for (m = 1; m <= methods; m++) {
        angle = $column["angle_" method[m]]
        if ((angle < 0 ? -angle : angle) > 0.785398 && (!(m in flange) || u < flange[m]))
            flange[m] = u
    }
}

($1 < 0) == (place == "switch") && u > 0.9995e-3 && u < 8.0005e-3 {
    rows++
    for (m = 1; m <= methods; m++)
        for (i = 1; i <= 5; i++) {
            d = $column[what[i] "_" method[m]] - $column[what[i] "_exact"]
            sum[m, what[i]] += d * d
        }
}

END {
    report()
}
