# Passages of one train by samples at the same stations, RUN-samples.csv by vxdump --csv, against the last of them: of each wheelset the largest
# magnitude and the largest difference of yaw, lateral displacement, place of the most loaded contact on wheel and rail, Q and Y, the station of
# the wheelset there, the root mean square of the difference, and the range of the reference.  bodies: the body of each wheelset, from 0; x: their
# stations, from the front one.  between: pairs FROM:TO of stations of the wheelset, compared one by one.
BEGIN {
    FS = ","
    wheelsets = split(bodies, body, " ")
    split(x, behind, " ")
    parts = split(between, part, " ")
    n = split("yaw lateral wheel_left wheel_right rail_left rail_right Q_left Q_right Y_left Y_right", name, " ")
    split("mrad mm mm mm mm mm kN kN kN kN", unit, " ")
    for (i = 1; i <= n; i++)
        scale[i] = unit[i] == "kN" ? 1e-3 : 1e3
    print "from (m),to (m),wheelset,quantity,unit,run,largest,of reference,largest difference,at station (m),rms of difference,range of reference"
}

# The column of each quantity of each wheelset.
FNR == 1 {
    delete at
    gsub(/ \([^)]*\)|"/, "")            # units, one of which has a comma
    for (i = 1; i <= NF; i++)
        at[$i] = i
    for (w = 1; w <= wheelsets; w++) {
        column[w, 1] = at["body.q[" body[w] + 1 "][6]"]
        column[w, 2] = at["body.q[" body[w] + 1 "][2]"]
        for (side = 1; side <= 2; side++) {
            column[w, 2 + side] = at["contact.wheel_y[" w "][" side "][1]"]
            column[w, 4 + side] = at["contact.rail_y[" w "][" side "][1]"]
            column[w, 6 + side] = at["wheel.Q[" w "][" side "]"]
            column[w, 8 + side] = at["wheel.Y[" w "][" side "]"]
        }
    }
    file[++files] = FILENAME
    next
}

{
    rows = FNR - 1
    station[rows] = $at["station"]
    for (w = 1; w <= wheelsets; w++)
        for (i = 1; i <= n; i++)
            value[files, rows, w, i] = $column[w, i] * scale[i]
}

function magnitude(a) {
    return a < 0 ? -a : a
}

# Quantity i of wheelset w in file f against that of the last file, while the wheelset is between two stations.
function compare(f, w, i, from, to,    r, d, v, s, most, where, sum, count, lo, hi, top) {
    for (r = 1; r <= rows; r++) {
        s = station[r] + behind[w]
        if (s < from || s > to)
            continue
        v = value[files, r, w, i]
        d = value[f, r, w, i] - v
        if (!count++)
            lo = hi = v
        lo = v < lo ? v : lo
        hi = v > hi ? v : hi
        top = magnitude(v + d) > top ? magnitude(v + d) : top
        sum += d * d
        if (magnitude(d) >= magnitude(most)) {
            most = d
            where = s
        }
    }
    if (count)
        printf "%g,%g,%d,%s,%s,%s,%.4g,%.4g,%.4g,%.2f,%.4g,%.4g\n", from, to, w, name[i], unit[i], run, top, (-lo > hi ? -lo : hi), \
            most, where, sqrt(sum / count), hi - lo
}

END {
    for (p = 1; p <= parts; p++)
        for (f = 1; f < files; f++) {
            run = file[f]
            gsub(/.*\/|-samples\.csv$/, "", run)
            split(part[p], ends, ":")
            for (w = 1; w <= wheelsets; w++)
                for (i = 1; i <= n; i++)
                    compare(f, w, i, ends[1] + 0, ends[2] + 0)
        }
}
