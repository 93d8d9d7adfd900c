# Functions that draw meshes with f3d, which has no reader of OFF: to be sourced.

off_to_obj()
{
  awk '/^[ \t\r]*(#|$)/ { next }
       /^OFF/           { next }
       !counts          { counts = 1; points = $1; next }
       points-- > 0     { print "v", $1, $2, $3; next }
                        { print "f", $2 + 1, $3 + 1, $4 + 1 }' "$1"
}

# draw FILE PICTURE OPTIONS...: the mesh from the side that the options of f3d say; fails if there is no picture
draw()
{
  local file=$1 picture=$2
  shift 2
  if [[ $file == *.off ]]; then
    off_to_obj "$file" > "$picture.obj"
    file=$picture.obj
  fi
  rm -f "$picture"
  xvfb-run --auto-servernum f3d "$file" --output "$picture" --quiet --bg-color=1,1,1 "$@" \
    < /dev/null > /dev/null 2>&1 || true
  rm -f "$picture.obj"
  [ -s "$picture" ]
}

# beside PICTURE WIDTH INPUTS...: the pictures in one row
beside()
{
  local picture=$1 width=$2 trimmed=() input
  shift 2
  for input in "$@"; do
    trimmed+=(\( "$input" -trim \))
  done
  convert "${trimmed[@]}" -bordercolor white -border 30x10 -gravity center +append +repage -resize "${width}x" "$picture"
}
