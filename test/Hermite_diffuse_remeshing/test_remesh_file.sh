#!/usr/bin/env bash
# Tests of the command line program: test_remesh_file.sh CASE REMESH_FILE MAKE_SHEET_METAL_CUP
set -u

test_case=$1
remesh_file=$(realpath "$2")
make_cup=$(realpath "$3")
data=$(realpath "$(dirname "$0")")/data

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1

fail()
{
  echo "FAILED: $*" >&2
  exit 1
}

make_input()
{
  "$make_cup" "$1" 600 > log || fail "make_sheet_metal_cup $1"
}

run()
{
  "$remesh_file" "$@" --approximation-error 0.05 --quiet > log 2> errors \
    || fail "remesh_file $*: $(cat errors)"
  [ ! -s log ] || fail "remesh_file $* --quiet printed: $(cat log)"
  [ ! -s errors ] || fail "remesh_file $* complained: $(cat errors)"
}

same()
{
  cmp -s "$1" "$2" || fail "$1 and $2 differ"
}

# refused ARGUMENTS...: exit status 2, one line on stderr, no file more or other than before
refused()
{
  local before after
  before=$(find . -type f ! -name log ! -name errors -exec cksum {} + | sort)
  "$remesh_file" "$@" > log 2> errors
  local status=$?
  after=$(find . -type f ! -name log ! -name errors -exec cksum {} + | sort)
  [ $status -eq 2 ] || fail "remesh_file $*: exit status $status"
  [ "$(wc -l < errors)" -eq 1 ] || fail "remesh_file $*: not one line: $(cat errors)"
  grep -q '^remesh_file: .' errors || fail "remesh_file $*: unclear: $(cat errors)"
  [ ! -s log ] || fail "remesh_file $*: printed $(cat log)"
  [ "$before" = "$after" ] || fail "remesh_file $*: changed the files"
}

# refused_with WORDS ARGUMENTS...: the same, and the sentence has the words
refused_with()
{
  local words=$1
  shift
  refused "$@"
  grep -q -e "$words" errors || fail "remesh_file $*: '$words' is not in: $(cat errors)"
}

case "$test_case" in

formats)
  # the same mesh from every format gives the same result
  for format in off obj ply; do
    make_input cup.$format
    run cup.$format from_$format.off
    same from_off.off from_$format.off
  done
  # and every digit survives in every format
  for format in off obj ply vtp; do
    run cup.off out.$format
    run out.$format again_$format.off
    same again_off.off again_$format.off
  done
  # STL has no vertices to keep in order, only faces; the extension may be in capitals
  run cup.off out.STL
  [ "$(grep -c 'facet normal' out.STL)" -eq "$(awk 'NR == 2 { print $2 }' from_off.off)" ] \
    || fail "the STL file lacks faces"
  run out.STL again_stl.off
  # VTK's ways of writing one octahedron
  for file in "$data"/octahedron_*.vtp; do
    run "$file" octahedron.off
    [ -f octahedron_first.off ] || cp octahedron.off octahedron_first.off
    same octahedron_first.off octahedron.off
  done
  ;;

bad_option)
  make_input cup.off
  refused
  refused cup.off
  refused cup.off out.off more.off
  refused_with no-such-option cup.off out.off --no-such-option
  refused_with gradation cup.off out.off --gradation
  refused_with gradation cup.off out.off --gradation steep
  refused_with gradation cup.off out.off --gradation 0.5
  refused_with gradation cup.off out.off --gradation nan
  refused_with approximation_error cup.off out.off --approximation-error -0.1
  refused_with elements cup.off out.off --elements-per-circle 1
  refused_with angle cup.off out.off --angle-per-element nan
  refused_with sagitta cup.off out.off --sagitta-over-length 0.6
  refused_with sagitta cup.off out.off --sagitta -1
  refused_with writes cup.off out.off --predict
  refused_with writes cup.off --predict --report out.json
  refused --predict
  refused_with maximum-number-of-faces cup.off out.off --maximum-number-of-faces many
  refused_with maximum_deviation cup.off out.off --maximum-deviation -1
  refused_with maximum_displacement cup.off out.off --maximum-displacement -1
  refused_with minimum_edge_length cup.off out.off --minimum-edge-length nan
  refused_with maximum_edge_length cup.off out.off --maximum-edge-length -2
  refused_with sharp_dihedral_angle cup.off out.off --sharp-angle -10
  refused_with corner_angle cup.off out.off --corner-angle nan
  refused_with iterations cup.off out.off --iterations -3
  refused_with out.xyz cup.off out.xyz
  refused_with fields.off cup.off out.off --fields fields.off
  refused_with out.off cup.off out.off --report out.off
  "$remesh_file" --help > log 2> errors || fail "--help"
  for option in approximation-error maximum-deviation minimum-edge-length maximum-edge-length \
                elements-per-circle angle-per-element sagitta-over-length sagitta \
                maximum-number-of-faces maximum-running-time predict gradation sharp-angle corner-angle noisy iterations report fields quiet; do
    grep -q -e "--$option" log || fail "--help does not name --$option"
  done
  ;;

unreadable_file)
  make_input cup.off
  refused_with missing.off missing.off out.off
  head -c 2000 cup.off > cut.off
  refused_with cut.off cut.off out.off
  echo 'no mesh at all' > words.obj
  cp words.obj words.ply
  cp words.obj words.vtp
  cp words.obj words.stl
  for format in obj ply vtp stl; do
    refused words.$format out.off
  done
  mkdir folder.off
  refused_with folder.off folder.off out.off
  refused_with words.txt words.txt out.off
  if [ -f "$data/compressed_octahedron.vtp" ]; then
    refused_with compressed "$data/compressed_octahedron.vtp" out.off
  fi
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n' > missing_point.off
  refused missing_point.off out.off
  ;;

unusable_mesh)
  printf 'OFF\n0 0 0\n' > empty.off
  refused empty.off out.off
  printf 'OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n4 0 1 2 3\n3 1 4 2\n' > quad.off
  refused_with triangle quad.off out.off --report out.json
  printf 'v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n' > nan.obj
  refused nan.obj out.off
  ;;

# three triangles at one edge: remeshed as a soup, which it says
non_manifold)
  printf 'OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n3 0 1 2\n3 1 0 3\n3 0 1 4\n' > fan.off
  refused_with manifold fan.off --predict
  "$remesh_file" fan.off out.off --maximum-edge-length 0.1 --fields fields.vtp --report out.json > log 2> errors \
    || fail "remesh_file: $(cat errors)"
  [ "$(wc -l < errors)" -eq 1 ] && grep -q 'as a soup' errors || fail "it does not say that it read a soup"
  [ "$(awk 'NR == 2 { print $2 }' out.off)" -gt 100 ] || fail "the soup was not refined"
  grep -q deviation fields.vtp || fail "no field"
  awk 'NR > 2 && NF == 4 { for(i = 2; i <= 4; ++i) { a = $i; b = $(i == 4 ? 2 : i + 1); ++n[a < b ? a " " b : b " " a] } }
       END { for(e in n) ++k[n[e]]; exit !(k[3] >= 8 && k[1] > 0 && k[4] == 0) }' out.off \
    || fail "the three sheets are not joined any more"
  ;;

prediction)
  make_input cup.off
  before=$(find . -type f | sort)
  "$remesh_file" cup.off --predict --approximation-error 0.02 > log 2> errors || fail "--predict: $(cat errors)"
  [ "$before" = "$(find . -type f ! -name errors | sort)" ] || fail "--predict wrote a file"
  predicted=$(cat log)
  "$remesh_file" cup.off out.off --approximation-error 0.02 --quiet || fail "remesh_file"
  faces=$(awk 'NR == 2 { print $2 }' out.off)
  [ $((5 * faces)) -ge $((4 * predicted)) ] && [ $((4 * faces)) -le $((5 * predicted)) ] \
    || fail "predicted $predicted faces, got $faces"
  "$remesh_file" cup.off out.off --approximation-error 0.02 --maximum-number-of-faces 1000 --quiet \
    || fail "remesh_file --maximum-number-of-faces"
  [ "$(awk 'NR == 2 { print $2 }' out.off)" -le 1000 ] || fail "more than 1000 faces"
  # elements as large as the fillets do not see them
  "$remesh_file" cup.off --predict --approximation-error 0.2 > all || fail "--predict"
  "$remesh_file" cup.off --predict --approximation-error 0.2 --noisy > without_noise || fail "--predict --noisy"
  [ "$(cat without_noise)" -lt "$(cat all)" ] || fail "--noisy does not lower the number of faces"
  ;;

failing_write)
  make_input cup.off
  refused_with nowhere cup.off nowhere/out.off
  refused_with nowhere cup.off out.off --report nowhere/out.json
  mkdir taken.off
  refused_with taken.off cup.off taken.off
  # the disk is full after 8 kB: what was there stays
  echo 'the old file' > out.off
  ( trap '' XFSZ; ulimit -f 8; refused_with out.off cup.off out.off --report out.json ) || exit 1
  ;;

json_report)
  make_input cup.off
  run cup.off out.off --report out.json
  for key in input_faces degenerate_input_faces folded_input_faces unrepaired_faces input_quality_min input_quality_mean faces vertices quality_min \
             quality_mean deviation_max deviation_mean deviation_max_point maximum_deviation \
             maximum_deviation_met faces_above_maximum_deviation deviation_obstacles quality_obstacles low_quality_faces size_conformity predicted_faces size_scale corners curves \
             feature_edges iterations stop_reason counts seconds stages; do
    [ "$(grep -c "\"$key\":" out.json)" -eq 1 ] || fail "the report has no key $key"
  done
  counts=$(sed -n 's/.*"vertices": \([0-9]*\).*/\1/p' out.json)' '$(
           sed -n 's/^  "faces": \([0-9]*\).*/\1/p' out.json)' 0'
  [ "$(sed -n 2p out.off)" = "$counts" ] || fail "the report counts $counts elements"
  grep -q '"maximum_deviation": null' out.json || fail "no bound must be null"
  if command -v python3 > /dev/null; then
    python3 -c 'import json; json.load(open("out.json"))' || fail "the report is not JSON"
  fi
  ;;

fields)
  make_input cup.off
  run cup.off out.vtp --fields fields.vtp --report out.json
  faces=$(sed -n 's/^  "faces": \([0-9]*\).*/\1/p' out.json)
  vertices=$(sed -n 's/.*"vertices": \([0-9]*\).*/\1/p' out.json)
  numbers_in()
  {
    sed -n "/Name=\"$1\"/,/<\/DataArray>/p" fields.vtp | grep -c -E '^-?[0-9]'
  }
  for array in k_min k_max mean_curvature gaussian_curvature size; do
    [ "$(numbers_in $array)" -eq "$vertices" ] || fail "array $array has not a number per vertex"
  done
  for array in quality deviation; do
    [ "$(numbers_in $array)" -eq "$faces" ] || fail "array $array has not a number per face"
  done
  # the fields are on the mesh that was written
  for file in out fields; do
    sed -n '/<Points>/,$p' $file.vtp > $file.mesh
  done
  same out.mesh fields.mesh
  ;;

determinism)
  make_input cup.off
  make_input cup_again.off
  same cup.off cup_again.off
  run cup.off first.off --fields first.vtp
  run cup.off second.off --fields second.vtp
  same first.off second.off
  same first.vtp second.vtp
  ;;

*)
  fail "there is no case $test_case"
  ;;

esac
echo "passed: $test_case"
