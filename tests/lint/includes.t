#!/bin/sh
# Dependencies point one way: what each folder may include.
. tests/tap.sh

formats='formats'
profile="$formats tools/profile"
contact="$profile tools/contact"
creep="$contact tools/creep"
track="$formats tools/track"
receptance="$track tools/receptance"
vehicle="$formats tools/vehicle"
integrate="$creep $track $vehicle tools/integrate"
post="$formats tools/post"
draw="$formats tools/draw"
optimise="$formats tools/optimise"
cli="$formats tools/cli"

for folder in formats $(find tools -mindepth 1 -maxdepth 1 -type d | sort); do
    subject=${folder#tools/}
    eval "allowed=\$$subject"
    [ -n "$allowed" ]
    ok $? "$folder has a place among the arrows"
    grep -n '^#[[:space:]]*include "' $folder/*.[ch] | while IFS=: read -r file line text; do
        path=${text#*\"}
        case " $allowed " in
        *" ${path%/*} "*) ;;
        *) echo "$file:$line: $text" ;;
        esac
    done >"$dir/wrong"
    is "$(cat "$dir/wrong")" "" "$folder includes only $allowed"
done

is "$(grep -n '^#[[:space:]]*include "' tools/vx*.c tests/kernel/*.[ch] | grep -vE '"(formats|tools/[a-z]+|tests/[a-z]+)/[a-z0-9_]+\.h"')" "" \
    "programs and tests include by qualified names"
is "$(grep -ln 'include "tools/cli/' $(find formats tools tests -name '*.[ch]') | grep -v -e '^tools/cli/' -e '^tools/vx[a-z]*\.c$')" "" \
    "only programs are Unix programs"
is "$(grep -ln 'cli_private.h' $(find formats tools tests -name '*.[ch]') | grep -v '^tools/cli/')" "" "what is between the parts of cli stays there"
is "$(grep -ln 'vxf_disk.h' $(find formats tools -name '*.[ch]') | grep -v '^formats/vxf')" "" "what is on disk is known to vxf alone"
is "$(grep -ln 'yaml_tree.h\|<yaml.h>' $(find formats tools -name '*.[ch]') | grep -v '^formats/yaml')" "" "libyaml is known to yaml alone"
is "$(grep -lE '<(GL/osmesa|hdf5|png|ft2build|fontconfig/fontconfig)\.h>' $(find formats tools -name '*.[ch]') |
    grep -v -e '^tools/draw/' -e '^formats/export_hdf5\.c$')" "" "libraries of pictures and HDF5 are known where they are used alone"
for f in formats/*.h $(find tools -mindepth 2 -name '*.h'); do
    guard=VX_$(echo "${f#tools/}" | tr a-z/. A-Z__)
    grep -q "^#ifndef $guard\$" "$f" || echo "$f: $guard"
done >"$dir/guards"
is "$(cat "$dir/guards")" "" "the guard of a header is its path"
done_testing
