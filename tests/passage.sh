# A coach on plain straight track, for tests of passages: sourced after tap.sh, files in $dir.

# profiles: wheel and rail of each side, $dir/wl.prof, rl.prof, wr.prof, rr.prof.
profiles()
{
    for side in l r; do
        vxprofile --side $side -o "$dir/w$side.prof" data/profiles/S1002.yaml &&
            vxprofile --side $side -o "$dir/r$side.prof" data/profiles/60E1.yaml || return 1
    done
}

# plain_tables: S1002 on upright 60E1, $dir/l.ctab and r.ctab.
plain_tables()
{
    profiles &&
        for side in l r; do
            vxcontact --wheel "$dir/w$side.prof" --rail "$dir/r$side.prof" --yaw exact -o "$dir/$side.ctab" || return 1
        done
}

# turnout_tables: S1002 on the diverging route, $dir/tl.ctab and tr.ctab.
turnout_tables()
{
    profiles &&
        for side in l r; do
            vxprofile --side $side -o "$dir/t$side.prof" data/turnouts/60E1-R760-1-15.yaml &&
                vxcontact --wheel "$dir/w$side.prof" --rail "$dir/t$side.prof" --yaw exact -o "$dir/t$side.ctab" || return 1
        done
}

coach()
{
    vxvehicle -o "$dir/coach.veh" data/vehicles/manchester-passenger.yaml
}

# columns FILE.run NAME...: CSV whose header names are easy to match in awk: wheel.Q[1][2] (N) becomes wheel.Q:1:2.
columns()
{
    vxdump --csv "$@" | sed '1{s/ ([^)]*)//g; s/"//g; s/\[/:/g; s/\]//g}'
}
