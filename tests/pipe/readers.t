#!/bin/sh
# The readers in the page of the container give what vxdump gives.
. tests/tap.sh

# The literal example of the page that begins with this line.
example()
{
    awk -v first="$1" '
        /^[.]Bd -literal/ {getline; on = $0 == first}
        /^[.]Ed/ {on = 0}
        on {gsub(/\\e/, "\\"); print}' man/vxf.5
}

command -v python3 >/dev/null || command -v octave >/dev/null || skip_all "neither python3 nor octave is here"
vxtrack -o "$dir/t.trk" data/tracks/thesis-straight.yaml
ok $? "a track to read"

if command -v python3 >/dev/null; then
    example 'import math, mmap' >"$dir/vxf.py"
    cat >"$dir/read.py" <<'EOF'
import sys
sys.path.insert(0, sys.argv[1])
from vxf import vxf
t = vxf(sys.argv[1] + '/t.trk')
print('rail.spacing (m)\n%.17g' % t['rail.spacing'][()], file=open(sys.argv[1] + '/scalar', 'w'))
with open(sys.argv[1] + '/columns', 'w') as out:
    print('sleeper.number (1),sleeper.x (m)', file=out)
    for n, x in zip(t['sleeper.number'], t['sleeper.x']):
        print('%d,%.17g' % (n, x), file=out)
with open(sys.argv[1] + '/matrix', 'w') as out:
    pads = t['pad.k']
    print(','.join('pad.k[%d] (N/m)' % (i + 1) for i in range(pads.shape[1])), file=out)
    for row in pads.tolist():
        print(','.join('%.17g' % x for x in row), file=out)
EOF
    python3 "$dir/read.py" "$dir"
    ok $? "the Python reader runs"
    vxdump "$dir/t.trk" rail.spacing | cmp -s - "$dir/scalar"
    ok $? "Python: a scalar"
    vxdump "$dir/t.trk" sleeper.number sleeper.x | cmp -s - "$dir/columns"
    ok $? "Python: columns"
    vxdump "$dir/t.trk" pad.k | cmp -s - "$dir/matrix"
    ok $? "Python: two dims"
fi

if command -v octave >/dev/null; then
    example 'function v = vxf(path)' >"$dir/vxf.m"
    vxdump --mat -o "$dir/t.mat" "$dir/t.trk"
    octave --no-gui --quiet --eval "cd('$dir'); a = vxf('t.trk'); b = load('t.mat'); for [x, k] = a, if ~isequal(x, b.(k)) && k(1) ~= 'z', exit(1), end, end" >/dev/null 2>&1
    ok $? "Octave: the reader and the MAT file agree"
fi
done_testing
