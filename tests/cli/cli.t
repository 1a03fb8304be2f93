#!/bin/sh
# What every program does alike: -h, misuse, a missing file, a full disk.
. tests/tap.sh

# The SYNOPSIS of a page as one line of text.
synopsis()
{
    mandoc -T ascii -O width=500 "$1" | sed 's/.\x08//g' | sed -n '/^SYNOPSIS/,/^[A-RT-Z]/{/^ /p}' | tr -s ' \n' '  ' | sed 's/^ //; s/ $//'
}

for path in build/bin/vx*; do
    name=${path##*/}

    $name -h >"$dir/help" 2>"$dir/err"
    ok $? "$name -h succeeds"
    is "$(cat "$dir/err")" "" "$name -h prints nothing on stderr"
    is "$(sed '$d' "$dir/help" | tr -s ' \n' '  ' | sed 's/ $//')" "$(synopsis man/$name.1 2>/dev/null)" "$name -h is the SYNOPSIS of its page"
    like "$(tail -n 1 "$dir/help")" '^[A-Z].*\.$' "and one line of purpose, a sentence"
    while read -r word rest; do
        [ "$word" = "$name" ] || echo "$word $rest"
    done <"$dir/help" | sed '$d' >"$dir/forms"
    is "$(grep -v '^\[\|^-\|^(' "$dir/forms")" "" "each form begins with the name"

    fails 2 "$name refuses an unknown option" $name --no-such-option
    like "$(cat "$dir/err")" "no-such-option" "and names it"
    fails 2 "$name refuses an unknown letter" $name -Z

    for option in $(grep -o -e '--[a-z][a-z-]*' "$dir/help" | sort -u); do
        short=${option%?}
        [ ${#short} -ge 4 ] && ! grep -q -e "$short[] |=]" "$dir/help" && break
        option=
    done
    [ -z "$option" ] || fails 2 "$name refuses $short, an abbreviation of $option" $name $short

    # Some programs want more than one operand: misuse then comes first.
    $name "$dir/no/such/file" >"$dir/out" 2>"$dir/err" </dev/null
    status=$?
    [ $status -ne 0 ] && [ "$(wc -l <"$dir/err")" -eq 1 ] && [ ! -s "$dir/out" ]
    ok $? "$name with a file that does not exist fails with one line (status $status)"

    $name -h >/dev/full 2>"$dir/err"
    status=$?
    [ $status -ne 0 ] && [ "$(wc -l <"$dir/err")" -eq 1 ]
    ok $? "$name notices a full disk (status $status)"
done
done_testing
