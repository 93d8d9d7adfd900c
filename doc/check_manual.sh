#!/usr/bin/env bash
# Checks the manual that Doxygen has written: check_manual.sh HTML_FOLDER INCLUDE_FOLDER
#   - every link inside of it leads to a file and, where it names one, to an anchor there;
#   - every name that the public headers declare, and every named parameter, has a place in it.
# What Doxygen warns of is not looked for again.
set -euo pipefail

html=$(realpath "$1")
include=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$html"

# file, and file#anchor for every anchor
{
  find . -type f -printf '%P\n'
  grep -oE ' (id|name)="[^"]+"' -- *.html | sed -E 's/^([^:]*): (id|name)="([^"]*)"$/\1#\3/'
} | sort -u > "$work/places"

# links of the pages and of the menu, absolute in the folder, and where they are used
{
  grep -oE '(href|src)="[^"]*"' -- *.html | sed -E 's/^([^:]*):[a-z]+="([^"]*)"$/\1 \2/'
  grep -oE 'url:"[^"]*"' menudata.js | sed -E 's/^url:"(.*)"$/index.html \1/'
} | awk '$2 ~ /^(https?:|file:|mailto:|javascript:)/ || $2 == "#" || $2 == "" { next }
         { if($2 ~ /^#/) $2 = $1 $2; print $2, $1 }' | sed 's/&amp;/\&/g' | sort -u > "$work/links"
awk 'NR == FNR { known[$0] = 1; next } !($1 in known) { print "dead link " $1 " in " $2 }' \
    "$work/places" "$work/links" > "$work/errors"

# names of classes, functions, enumerations and their values outside of internal namespaces
find "$include" -name '*.h' -not -path '*/internal/*' | sort | while read -r header; do
  awk '/^namespace internal(_np)?( |$)/ { hidden = 1 }
       /^} \/\/ namespace internal(_np)?/ { hidden = 0 }
       hidden || /^ *(\/\/|\*|\/\*)/ { next }
       /^(class|struct|enum) [A-Za-z_]+/ { sub(/;.*/, ""); print $2 }
       /^[A-Za-z].*[A-Za-z_]+\(/ && !/^(template|#|class|struct|enum)/ { sub(/\(.*/, ""); sub(/.*[ *&]/, ""); print }' \
      "$header" | sed "s|\$| ${header#"$include"/}|"
done | grep -vE '^(static_assert|CGAL_|operator)' | sort -u > "$work/names"
sed -nE 's|^ *<name>(.*)</name>.*|\1|p' names.tag | sed -E 's/.*:://; s/ *<.*//; s/&lt;.*//' | sort -u > "$work/documented"
awk 'NR == FNR { known[$1] = 1; next } !($1 in known) { print $1 " of " $2 " has no place in the manual" }' \
    "$work/documented" "$work/names" >> "$work/errors"


# named parameters, which functions and classes describe in their tables
tr -d '\\\n' < "$include/CGAL/Hermite_diffuse_remeshing/named_parameters.h" \
  | grep -oE 'ADD\([A-Za-z_]+, *[A-Za-z_]+, *[A-Za-z_]+\)' | sed -E 's/.*[ ,]([A-Za-z_]+)\)/\1/' | sort -u > "$work/parameters"
grep -hE '^<td><code>[A-Za-z_]+</code></td><td><ul>' -- *.html | sed -E 's|^<td><code>([A-Za-z_]+)<.*|\1|' | sort -u > "$work/described"
comm -23 "$work/parameters" "$work/described" | sed 's/$/: a named parameter that no page describes/' >> "$work/errors"

if [ -s "$work/errors" ]; then
  cat "$work/errors"
  exit 1
fi
echo "$(wc -l < "$work/links") links and $(wc -l < "$work/names") names of the public headers are good,"
echo "and $(wc -l < "$work/parameters") named parameters are described"
