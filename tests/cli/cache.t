#!/bin/sh
# The cache of contact tables: the same bytes with and without, every option in the key, damage found and mended, many writers at once.
. tests/tap.sh

cache=$dir/cache
mkdir "$cache"
for s in l r; do
    vxprofile --side $s data/profiles/S1002.yaml -o "$dir/w$s.prof" && vxprofile --side $s data/profiles/60E1.yaml -o "$dir/r$s.prof" || exit 1
done

# table OPTION...: the small table of these tests, on standard output or as the options say.
table()
{
    vxcontact --wheel "$dir/wr.prof" --rail "$dir/rr.prof" --yaw exact --u-max 0.004 --yaws 5 "$@"
}

# cached OPTION...: the same with the cache.
cached()
{
    VX_CACHE=$cache table "$@"
}

count()
{
    find "$cache" -name '*.ctab' | wc -l
}

# ---- hits and misses ----

table -o "$dir/fresh.ctab"
ok $? "a table without a cache"
cached -o "$dir/miss.ctab" && cmp -s "$dir/fresh.ctab" "$dir/miss.ctab"
ok $? "made with a cache it has the same bytes"
is "$(count)" 1 "and is kept"
entry=$(echo "$cache"/*.ctab)

touch -d 2001-02-03T04:05:06 "$entry" "$dir/miss.ctab"
before=$(ls -i "$entry")
cached -o "$dir/miss.ctab" && cmp -s "$dir/fresh.ctab" "$dir/miss.ctab"
ok $? "copied from the cache it has the same bytes"
is "$(ls -i "$entry")" "$before" "the entry was not made anew"
[ "$dir/miss.ctab" -nt "$dir/wr.prof" ]
ok $? "the copy has a new time"
[ "$entry" -nt "$dir/wr.prof" ]
ok $? "the entry has the time of its use"
cached | cmp -s - "$dir/fresh.ctab"
ok $? "the same bytes on standard output"

# The same content by another way: another history.
mkdir "$dir/else"
cp data/profiles/S1002.yaml "$dir/else/"
vxprofile --side r "$dir/else/S1002.yaml" -o "$dir/else/w.prof"
vxcontact --wheel "$dir/else/w.prof" --rail "$dir/rr.prof" --yaw exact --yaws 5 --u-max 4e-3 -o "$dir/else/fresh.ctab"
n=$(count)
VX_CACHE=$cache vxcontact --wheel "$dir/else/w.prof" --rail "$dir/rr.prof" --yaw exact --yaws 5 --u-max 4e-3 -o "$dir/else/hit.ctab" &&
    cmp -s "$dir/else/fresh.ctab" "$dir/else/hit.ctab"
ok $? "a copy has the history of the command that asked"
is "$(count)" "$n" "profiles count by content, numbers by value, not as they are spelled"
cmp -s "$dir/else/fresh.ctab" "$dir/fresh.ctab"
is $? 1 "histories differ"

# Each of these is another table.  Options of the page that change a table and are not here would not be tested: they must be.
n=$(count)
tried=0
options=$(vxcontact -h | awk '/^vxcontact --wheel FILE/ {on = 1; print; next} /^vxcontact/ {on = 0} on' | grep -o -e '--[a-z-]*' | sort -u)
for option in $options; do
    case $option in
    --wheel) set -- --wheel "$dir/else/wheel.prof"
        vxprofile --side r --set radius=0.45 data/profiles/S1002.yaml -o "$dir/else/wheel.prof" 2>/dev/null || continue ;;
    --rail) set -- --rail "$dir/else/rail.prof"
        vxprofile --side r --set cant=0.025 data/profiles/60E1.yaml -o "$dir/else/rail.prof" ;;
    --yaw) set -- --yaw none ;;
    --u-max) set -- --u-max 0.0041 ;;
    --u-step) set -- --u-step 2e-4 ;;
    --yaw-max) set -- --yaw-max 0.020000000000000004 ;;
    --yaws) set -- --yaws 6 ;;
    --shear-modulus) set -- --shear-modulus 80e9 ;;
    --poisson) set -- --poisson 0.3 ;;
    --normal) set -- --normal strip ;;
    --load) set -- --load 90e3 ;;
    *) ok 1 "$option is in the key: this test does not know it"; continue ;;
    esac
    tried=$((tried + 1))
    cached "$@" -o "$dir/a.ctab" && cached "$@" -o "$dir/b.ctab" && cmp -s "$dir/a.ctab" "$dir/b.ctab" &&
        [ "$(count)" -eq $((n + tried)) ]
    ok $? "another $option is another entry"
done
[ $tried -ge 8 ]
ok $? "$tried options were tried"

# ---- faults ----

whole=$dir/whole
cp "$entry" "$whole"
size=$(wc -c <"$whole")

# mended WHAT LINES: the entry as it lies is told in so many lines, the table is right, and the entry whole afterwards.
mended()
{
    cached -o "$dir/a.ctab" 2>"$dir/err" && cmp -s "$dir/a.ctab" "$dir/fresh.ctab" && [ "$(wc -l <"$dir/err")" -eq "$2" ] &&
        cmp -s "$entry" "$whole"
    ok $? "$1: $(sed "s|.*\.ctab: ||" "$dir/err")"
}

for n in 0 1 63 64 700 2048 $((size / 2)) $((size - 64)) $((size - 1)); do
    head -c "$n" "$whole" >"$entry"
    mended "cut to $n bytes" 1
done
for n in 9 24 33 41 60 70 1500 $((size / 3)) $((size / 2 + 1)) $((size - 100)); do
    perl -e 'local $/; open F, "<", $ARGV[0]; $_ = <F>; substr($_, $ARGV[1], 1) ^= chr(1 << $ARGV[1] % 8); print' "$whole" "$n" >"$entry"
    mended "a bit of byte $n flipped" 1
done
{ cat "$whole"; echo; } >"$entry"
mended "a byte more" 1
cp "$dir/wr.prof" "$entry"
mended "a profile" 1
cp "$dir/fresh.ctab" "$entry"
mended "a table that says no key" 1
for other in "$cache"/*.ctab; do [ "$other" = "$entry" ] || break; done
cp "$other" "$entry"
mended "another entry" 1
rm "$entry"; ln -s "${entry##*/}" "$entry"
mended "a link to itself" 1
rm "$entry"; ln -s nowhere "$entry"
mended "a link to nowhere" 0
rm "$entry"; mkfifo "$entry"
mended "a named pipe" 1

rm "$entry"; mkdir "$entry"
cached -o "$dir/a.ctab" 2>"$dir/err" && cmp -s "$dir/a.ctab" "$dir/fresh.ctab" && [ "$(wc -l <"$dir/err")" -eq 2 ]
ok $? "a folder in its place cannot be mended, and the table is written"
VX_CACHE=$cache vxcontact --cache-verify >"$dir/out" 2>"$dir/err"
is $? 1 "--cache-verify fails"
like "$(cat "$dir/out")" "${entry##*/}: not a regular file" "and names the entry"
is "$(wc -l <"$dir/err")" 1 "in one line on stderr"
rmdir "$entry"
cached >/dev/null
VX_CACHE=$cache vxcontact --cache-verify >"$dir/out"
ok $? "mended, it passes: $(cat "$dir/out")"

# ---- the folder ----

export VX_CACHE
VX_CACHE=$dir/none
fails 1 "VX_CACHE is not there" vxcontact --wheel "$dir/wr.prof" --rail "$dir/rr.prof" --yaw none -o "$dir/x.ctab"
VX_CACHE=$whole
fails 1 "VX_CACHE is a file" vxcontact --wheel "$dir/wr.prof" --rail "$dir/rr.prof" --yaw none -o "$dir/x.ctab"
unset VX_CACHE
[ ! -e "$dir/x.ctab" ]
ok $? "and nothing is written"
VX_CACHE='' table | cmp -s - "$dir/fresh.ctab"
ok $? "an empty VX_CACHE is none"
if [ -d /proc/self ]; then
    VX_CACHE=/proc table -o "$dir/a.ctab" 2>"$dir/err" && cmp -s "$dir/a.ctab" "$dir/fresh.ctab" && [ "$(wc -l <"$dir/err")" -eq 1 ]
    ok $? "a folder that cannot be written: one line, and the table"
fi
rm "$entry"
# Beyond the limit a write fails as on a full disk; the pipe has none.
(trap '' XFSZ; ulimit -f 20; cached 2>"$dir/err") | cmp -s - "$dir/fresh.ctab"
ok $? "a full disk: the table is written all the same"
like "$(cat "$dir/err")" "not kept" "and it is told"
[ ! -e "$entry" ] && [ -z "$(find "$cache" -name '*.ctab.*')" ]
ok $? "nothing half stays"

# ---- list, prune ----

cached >/dev/null
n=$(count)
VX_CACHE=$cache vxcontact --cache-list >"$dir/list"
is "$(wc -l <"$dir/list")" $((n + 1)) "--cache-list has a line for each entry and one of names"
touch -d 2001-02-03T04:05:06Z "$entry"
is "$(VX_CACHE=$cache vxcontact --cache-list | awk 'NR == 2 {print $1, $2, $3, $4, $5, $6, $7, $8, $9, $10, $11, $12}')" \
    "${entry##*/} $size 2001-02-03T04:05:06Z r exact 1 5 -0.004 0.004 S1002 on 60E1" "the longest unused first"
touch "$cache/notes.ctab" "$cache/00000000000000000000000000000000.ctab.abcdef" "$cache/00000000000000000000000000000000.ctab.ABCDEF"
touch -d 2001-02-03T04:05:06Z "$cache/notes.ctab" "$cache/00000000000000000000000000000000.ctab.abcdef"
VX_CACHE=$cache vxcontact --cache-prune days=30 >"$dir/out"
ok $? "--cache-prune: $(tail -n 1 "$dir/out")"
[ ! -e "$entry" ] && [ ! -e "$cache/00000000000000000000000000000000.ctab.abcdef" ]
ok $? "an entry not used for long and a temporary an hour old go"
[ -e "$cache/notes.ctab" ] && [ -e "$cache/00000000000000000000000000000000.ctab.ABCDEF" ]
ok $? "what is not the cache's and a writer at work stay"
rm "$cache/notes.ctab" "$cache/00000000000000000000000000000000.ctab.ABCDEF"
is "$(wc -l <"$dir/out")" 3 "both are named"
touch -d 2001-02-03T04:05:06Z "$cache"/*.ctab
cached >/dev/null
VX_CACHE=$cache vxcontact --cache-prune "size=$(awk "BEGIN {print 1.1e-9 * $size}")" >/dev/null
[ "$(count)" -eq 1 ] && [ -e "$entry" ]
ok $? "by size: the last used stays"

fails 1 "no cache to list" vxcontact --cache-list
fails 2 "two forms" vxcontact --cache-list --cache-verify
fails 2 "an operand" vxcontact --cache-list "$entry"
export VX_CACHE="$cache"
for what in '' days days=-1 days=x age=3 days=1,days=2; do
    fails 2 "--cache-prune '$what'" vxcontact --cache-prune "$what"
done
unset VX_CACHE

# ---- many at once ----

# Four tables, each by two programs, three times over; then some are killed while they write; somebody looks all the time.
for k in 1 2 3 4; do
    table --u-step ${k}e-5 -o "$dir/want$k.ctab"
done
: >"$dir/run"
while [ -e "$dir/run" ]; do
    VX_CACHE=$cache vxcontact --cache-verify >>"$dir/looks" 2>&1 || echo failed >>"$dir/looks"
done &
looker=$!
wrong=0 left=0
for round in 1 2 3; do
    rm -f "$cache"/*.ctab
    pids=
    for k in 1 2 3 4; do
        for twin in a b; do
            VX_CACHE=$cache vxcontact --wheel "$dir/wr.prof" --rail "$dir/rr.prof" --yaw exact --u-max 0.004 --yaws 5 --u-step ${k}e-5 \
                -o "$dir/got$k$twin.ctab" 2>>"$dir/noise" &
            pids="$pids $!"
        done
    done
    wait $pids
    for k in 1 2 3 4; do
        cmp -s "$dir/want$k.ctab" "$dir/got${k}a.ctab" && cmp -s "$dir/want$k.ctab" "$dir/got${k}b.ctab" || wrong=$((wrong + 1))
    done
done
is $wrong 0 "eight programs at once: every table is right"
is "$(cat "$dir/noise")" "" "and nobody complains"
for kill in 1 2 3 4 5 6 7 8; do
    rm -f "$cache"/*.ctab "$cache"/*.ctab.*
    VX_CACHE=$cache vxcontact --wheel "$dir/wr.prof" --rail "$dir/rr.prof" --yaw exact --u-max 0.004 --yaws 5 --u-step 1e-5 >/dev/null &
    victim=$!
    set -- "$cache"/*.ctab.*
    while [ ! -e "$1" ] && kill -0 $victim 2>/dev/null; do
        set -- "$cache"/*.ctab.*
    done
    [ $kill -gt 4 ] && sleep 0.001
    kill -9 $victim 2>/dev/null
    wait $victim 2>/dev/null
    left=$((left + $(find "$cache" -name '*.ctab.*' | wc -l)))
    cached --u-step 1e-5 2>>"$dir/noise" | cmp -s - "$dir/want1.ctab" || wrong=$((wrong + 1))
done 2>/dev/null
is $wrong 0 "programs killed while they write: every table is right"
is "$(cat "$dir/noise")" "" "and no entry was damaged"
rm "$dir/run"
wait $looker
echo "# $(wc -l <"$dir/looks") looks, $left temporaries left by 8 killed writers"
is "$(grep -v ' entries, 0 damaged' "$dir/looks")" "" "no half or wrong entry was ever seen"
done_testing
