#!/bin/sh
# Every program has a page and a test, every kind of file a page; the pages are clean.
. tests/tap.sh

command -v mandoc >/dev/null || skip_all "mandoc is not here"

for f in tools/vx*.c; do
    name=$(basename "$f" .c)
    [ -f man/$name.1 ]
    ok $? "$name has a page"
    [ -f tests/cli/$name.t ]
    ok $? "$name has a test"
done

kinds=$(sed -n 's/.*vxf_out_begin(&*[a-z>.-]*, "\([a-z]*\)").*/\1/p' $(find formats tools -name '*.c') | sort -u)
[ -n "$kinds" ]
ok $? "kinds of files are found"
for kind in $kinds; do
    [ -f man/$kind.5 ]
    ok $? ".$kind has a page"
done

for page in man/*.[157]; do
    is "$(mandoc -T lint -W warning "$page" 2>&1)" "" "$page is clean"
done
for page in man/vx*.1; do
    for section in NAME SYNOPSIS DESCRIPTION OPTIONS 'INPUT AND OUTPUT' 'EXIT STATUS' EXAMPLES CAVEATS 'SEE ALSO'; do
        grep -q "^\.Sh $section\$" "$page" || echo "$section"
    done >"$dir/missing"
    is "$(cat "$dir/missing")" "" "$page has all sections"
done

for ref in $(sed -n 's/^\.Xr \([a-z0-9-]*\) \([157]\).*/\1.\2/p' man/*.[157] | sort -u); do
    case $ref in
    make.1) continue ;;
    esac
    [ -f "man/$ref" ]
    ok $? "the page $ref that others name is there"
done
for path in $(sed -n 's/.*](\([^)]*\)).*/\1/p' README.md); do
    [ -f "$path" ]
    ok $? "README's $path is there"
done
for path in $(grep -o '`\(man\|data\|tests\|tools\|formats\|pipelines\)/[^` ]*`' README.md | tr -d '`'); do
    [ -e "$path" ]
    ok $? "README's $path is there"
done
done_testing
