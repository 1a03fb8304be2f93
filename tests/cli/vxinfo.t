#!/bin/sh
# vxinfo: what is printed, and every damage refused quietly.
. tests/tap.sh

input=data/tracks/thesis-straight.yaml
vxtrack -o "$dir/t.trk" $input
ok $? "a track to look at"
size=$(wc -c <"$dir/t.trk")

vxinfo "$dir/t.trk" >"$dir/text"
ok $? "vxinfo of a file"
is "$(head -n 1 "$dir/text")" "$dir/t.trk: .trk, $size bytes" "kind and size"
like "$(cat "$dir/text")" "^CMD= vxtrack $input\$" "the command that made it, without -o"
like "$(cat "$dir/text")" '^array    pad.k  *f64   2 x 50  \[N/m\]$' "an array with type, dims and unit"
is "$(vxinfo --history "$dir/t.trk")" "vxtrack $input" "the history alone"
is "$(vxinfo <"$dir/t.trk" | tail -n +2)" "$(tail -n +2 "$dir/text")" "standard input gives the same"
is "$(cat "$dir/t.trk" | vxinfo - | tail -n +2)" "$(tail -n +2 "$dir/text")" "a pipe too"

vxtrack --set name=thesis-table-1 $input >"$dir/same.trk"
vxtrack --set railpad.stiffness=1e6 -o "$dir/other.trk" $input
is "$(vxinfo --content - <"$dir/same.trk" | cut -c 1-16)" "$(vxinfo --content "$dir/t.trk" | cut -c 1-16)" "one content, two histories"
[ "$(vxinfo --content "$dir/other.trk" | cut -c 1-16)" != "$(vxinfo --content "$dir/t.trk" | cut -c 1-16)" ]
ok $? "another stiffness is another content"
is "$(vxinfo --content "$dir/t.trk" "$dir/other.trk" | wc -l | tr -d ' ')" 2 "two files, two lines"
vxtrack --set 'name=a b' -o "$dir/quoted.trk" $input
is "$(vxinfo --history "$dir/quoted.trk")" "vxtrack --set 'name=a b' $input" "a word with a blank is quoted in the history"
vxtrack $input | cmp -s - "$dir/t.trk"
ok $? "the same command gives the same bytes, by -o or by a pipe"

fails 2 "--content and --history exclude each other" vxinfo --content --history "$dir/t.trk"
fails 1 "a file that is not there" vxinfo "$dir/none"
like "$(cat "$dir/err")" 'none: No such file or directory$' "says so"
fails 1 "a folder" vxinfo "$dir"
: >"$dir/empty"
fails 1 "an empty file" vxinfo "$dir/empty"
fails 1 "a text" vxinfo $input
like "$(cat "$dir/err")" 'not a Veksel file' "says so"
fails 1 "endless input that is no container" vxinfo /dev/zero
sed 's/$/\r/' "$dir/t.trk" >"$dir/text.trk"
fails 1 "a transfer as text" vxinfo "$dir/text.trk"
fails 1 "the second of two files is missing: nothing of the first is printed" vxinfo "$dir/t.trk" "$dir/none"

cut=0
for n in 1 7 8 63 64 65 100 1000 2000 5000 10000 50000 $((size - 64)) $((size - 1)); do
    head -c $n "$dir/t.trk" >"$dir/cut.trk"
    vxinfo "$dir/cut.trk" >"$dir/out" 2>"$dir/err" && cut=$((cut + 1))
    [ -s "$dir/out" ] && cut=$((cut + 1))
    [ "$(wc -l <"$dir/err")" -eq 1 ] || cut=$((cut + 1))
    head -c $n "$dir/t.trk" | vxinfo >/dev/null 2>&1 && cut=$((cut + 1))
done
is $cut 0 "cut at any length it is refused with one line, from a file and from a pipe"

{ cat "$dir/t.trk"; echo; } >"$dir/long.trk"
fails 1 "a byte too many" vxinfo "$dir/long.trk"

# A byte in the middle of each array.
flipped=0
for at in 24 40 70 700 4000 9000 20000 40000 60000 $((size - 3)); do
    cp "$dir/t.trk" "$dir/bad.trk"
    printf '\125' | dd of="$dir/bad.trk" bs=1 seek=$at conv=notrunc 2>/dev/null
    cmp -s "$dir/t.trk" "$dir/bad.trk" && continue
    vxinfo "$dir/bad.trk" >/dev/null 2>&1 && flipped=$((flipped + 1))
done
is $flipped 0 "a byte changed anywhere is refused"

vxinfo "$dir/t.trk" >/dev/full 2>"$dir/err"
is "$? $(wc -l <"$dir/err" | tr -d ' ')" "1 1" "a full disk is exit 1 and one line"
done_testing
