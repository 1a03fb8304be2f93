# Spectra of columns of FILES..., CSV of vxdump --csv with station and one wheel force each, all at the same stations: amplitude over frequency
# by a window of Hann between the stations from and to (m), at v (m/s), from 5 Hz to 100 Hz by 0.25 Hz.  name: of the columns.
BEGIN {
    FS = ","
    pi = 4 * atan2(1, 1)
    columns = split(name, title, " ")
}

FNR == 1 {
    files++
    n = 0
}

FNR > 1 && $1 >= from && $1 <= to {
    x[++n] = $1
    force[files, n] = $2
    mean[files] += $2
}

END {
    printf "frequency[Hz]"
    for (f = 1; f <= columns; f++)
        printf " %s[N]", title[f]
    print ""
    for (i = 1; i <= n; i++) {
        window[i] = 1 - cos(2 * pi * i / n)
        sum += window[i]
        for (f = 1; f <= files; f++)
            force[f, i] = (force[f, i] - mean[f] / n) * window[i]
    }
    for (hz = 5; hz <= 100; hz += 0.25) {
        for (f = 1; f <= files; f++)
            a[f] = b[f] = 0
        for (i = 1; i <= n; i++) {
            phase = 2 * pi * hz * x[i] / v
            c = cos(phase)
            s = sin(phase)
            for (f = 1; f <= files; f++) {
                a[f] += force[f, i] * c
                b[f] += force[f, i] * s
            }
        }
        printf "%.2f", hz
        for (f = 1; f <= files; f++)
            printf " %.6g", 2 * sqrt(a[f] * a[f] + b[f] * b[f]) / sum
        print ""
    }
}
