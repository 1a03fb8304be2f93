#!/bin/sh
# All 300 modes of the track of Table 1, as vxfreq tells them: three bands of modes in which the rails move alike, three in which they
# move against each other.  The bands are those of an independent dense calculation, the single modes those of Lau and Hoff 2018.
# Run from the project root.
. tests/tap.sh
track=$dir/t.trk

vxtrack -o "$track" data/tracks/thesis-straight.yaml

# Lines "name number lowest highest" of n modes around a frequency, names without blanks.
band() { # n Hz
	vxfreq --modes "$1" --near "$2" --text "$track" | sed 's/in phase/in-phase/' |
		awk '{ n[$4]++; if (n[$4] == 1) lo[$4] = $2; hi[$4] = $2 } END { for (k in n) print k, n[k], lo[k], hi[k] }'
}

# Number and limits of a band within 0.1 %.
holds() { # WHAT NUMBER LO HI
	awk -v what="$1" -v n="$2" -v lo="$3" -v hi="$4" '
		function same(a, b) { return a > 0.999 * b && a < 1.001 * b }
		$1 == what { good = $2 == n && same($3, lo) && same($4, hi); print "# " $0 }
		END { exit !good }' "$dir/band"
	ok $? "$2 modes $1 from $3 to $4 Hz"
}

band 100 0 >"$dir/band"
holds in-phase 50 124.40 225.97
holds antiphase 50 145.84 268.26
band 102 723.2 >"$dir/band"
holds in-phase 51 474.14 906.18
holds antiphase 51 490.45 906.21
band 98 1351.7 >"$dir/band"
holds in-phase 49 1085.8 1573.4
holds antiphase 49 1087.2 1573.4

# A mode in phase lies within 0.1 % of a frequency.  The third of the article, 830.48 Hz, is none of a track with free ends: those
# next to it are 825.39 and 843.26 Hz.
nearest() { # Hz
	vxfreq --modes 8 --near "$1" --text "$track" |
		awk -v f="$1" '/in phase/ && $2 > 0.999 * f && $2 < 1.001 * f { good = 1 } END { exit !good }'
	ok $? "one in phase at $1 Hz"
}
for f in 129.0 505.1 826 129.10 505.08; do
	nearest $f
done
done_testing
