# Tables of vxpost --table, .../SETTING/TRAIN-ROUTE-BALLAST.csv, first those of all passages by one setting, then those by the other in the same
# order: each largest value of each zone by both, and what the second differs by over the first.
BEGIN {
    FS = OFS = ","
    split("4 6 8 10 12", column, " ")
}

FNR == 1 {
    n = split(FILENAME, part, "/")
    passage = part[n]
    sub(/\.csv$/, "", passage)
    second = passage in seen
    if (!second)
        order[++passages] = passage
    seen[passage] = 1
    setting[second] = part[n - 1]
    for (q = 1; q <= 5; q++)
        quantity[q] = $column[q]
    next
}

{
    zone[passage, FNR - 1] = $2
    zones = FNR - 1
    for (q = 1; q <= 5; q++) {
        value[second, passage, FNR - 1, q] = $column[q]
        sleeper[second, passage, FNR - 1, q] = $(column[q] + 1)
    }
}

END {
    print "train", "route", "ballast (MN/m)", "zone", "quantity", setting[0], "at sleeper", setting[1], "at sleeper", "difference (%)"
    for (p = 1; p <= passages; p++)
        for (z = 1; z <= zones; z++)
            for (q = 1; q <= 5; q++) {
                a = value[0, order[p], z, q]
                b = value[1, order[p], z, q]
                split(order[p], w, "-")
                off = a ? sprintf("%.3f", (b / a - 1) * 100) : ""
                print w[1], w[2], w[3], zone[order[p], z], quantity[q], a, sleeper[0, order[p], z, q], b, sleeper[1, order[p], z, q], off
            }
}
