#!/usr/bin/env bash
# test_compilers.sh SOURCE PROGRAM OTHER_COMPILER OPTIONS... -- FILES...: builds SOURCE with the other compiler,
# and remeshes the files with both programs. The results must be the same bytes.
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
"$compiler" "${options[@]}" "$source" -o "$folder/other" -lgmp -lmpfr -lboost_program_options -pthread \
  || { echo "FAILED: $compiler does not build $source" >&2; exit 1; }
status=0
for file in "$@"; do
  "$program" "$file" "$folder/one.off" --approximation-error 0.02 --quiet || exit 1
  "$folder/other" "$file" "$folder/two.off" --approximation-error 0.02 --quiet || exit 1
  if cmp "$folder/one.off" "$folder/two.off"; then
    echo "same: $file"
  else
    echo "FAILED: the compilers differ on $file" >&2
    status=1
  fi
done
exit $status
