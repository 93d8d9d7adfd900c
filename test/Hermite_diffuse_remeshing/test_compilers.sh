#!/usr/bin/env bash
# test_compilers.sh SOURCE PROGRAM OTHER_COMPILER OPTIONS... -- FILES...: builds SOURCE with the other compiler,
# and remeshes the files with both programs, which write remeshed.off. The results must be the same bytes.
set -u

source=$1
program=$(realpath "$2")
compiler=$3
shift 3
options=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do
  options+=("$1")
  shift
done
shift

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$compiler" "${options[@]}" "$source" -o "$folder/other" -lgmp -lmpfr \
  || { echo "FAILED: $compiler does not build $source" >&2; exit 1; }
status=0
mkdir "$folder/one" "$folder/two"
for file in "$@"; do
  (cd "$folder/one" && "$program" "$file" > /dev/null) || exit 1
  (cd "$folder/two" && "$folder/other" "$file" > /dev/null) || exit 1
  if cmp "$folder/one/remeshed.off" "$folder/two/remeshed.off"; then
    echo "same: $file"
  else
    echo "FAILED: the compilers differ on $file" >&2
    status=1
  fi
done
exit $status
