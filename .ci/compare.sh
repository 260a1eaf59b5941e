#!/usr/bin/env bash
# bash .ci/compare.sh OLD NEW: checks that two builds give the same digits and pixels. OLD and NEW
# are build folders. Both commands compute the same scenes (points, pick, project, matrices, map,
# code, doctor, landmarks), and both windows take pictures of their views. Prints the differences,
# those in numbers and those in words apart (differences.py); returns 1 if there are any.
# A change of the structure must have none. A change that is meant to alter digits shows them.
set -eu
old=$(cd -- "$1" && pwd) new=$(cd -- "$2" && pwd)
folder=$(cd -- "$(dirname -- "$0")" && pwd)
for build in "$old" "$new"; do
    [ -x "$build/core/cli/unproject" ] || { echo "There is no $build/core/cli/unproject" >&2; exit 2; }
    [ -x "$build/gui/unprojector" ] || echo "There is no $build/gui/unprojector: no pictures are compared"
done
work=$(mktemp -d)
failed=
trap 'rm -rf "$work"' EXIT
mkdir "$work/scenes" "$work/old" "$work/new"

# scene NAME PROJECTION [MORE [RATIO]]: a scene file.
scene() {
    cat >"$work/scenes/$1.json" <<JSON
{"unprojector": 1, "window": {"width": 640, "height": 480, "devicePixelRatio": ${4:-1}}, "projection": $2,
 "view": {"eye": [3.1, 2.3, 7.7], "center": [0.1, 0.2, 0], "up": [0, 1, 0]}${3:-},
 "objects": [{"name": "pot", "bundled": "Teapot", "transform": [{"translate": [0.5, 0.25, -1]},
                                                               {"rotate": [30, 1, 2, 3]}]},
             {"name": "ball", "bundled": "Torus", "transform": [{"scale": [1.5, 1, 0.75]}]}]}
JSON
}
scene perspective '{"type": "perspective", "fovy": 45, "near": 0.5, "far": 50}'
scene frustum '{"type": "frustum", "left": -0.3, "right": 0.5, "bottom": -0.2, "top": 0.35, "near": 0.5, "far": 80}'
scene ortho '{"type": "ortho", "left": -5, "right": 4, "bottom": -3, "top": 3.5, "near": 1, "far": 30}'
scene oblique '{"type": "oblique", "left": -5, "right": 5, "bottom": -4, "top": 4, "near": 1, "far": 30, "theta": 70, "phi": 80}'
scene reversed '{"type": "perspective", "fovy": 50, "near": 0.1, "far": 1000}' ', "depthRange": [1, 0]'
scene part '{"type": "perspective", "fovy": 50, "aspect": 1.5, "near": 0.1, "far": 100}' \
    ', "viewport": {"x": 20, "y": 30, "width": 500, "height": 400}, "depthRange": [0.25, 0.75]'
scene ratio '{"type": "perspective", "fovy": 45, "near": 0.5, "far": 50}' '' 1.5
scene planes '{"type": "perspective", "fovy": 45, "near": 0.5, "far": 50}' ', "clipPlanes": [[0, 1, 0.5, 0.2]]'
scene matrix '{"type": "matrix", "matrix": [1.5, 0, 0, 0, 0, 2, 0, 0, 0.1, 0.05, -1.01, -1, 0, 0, -0.201, 0], "ndcDepth": [0, 1]}'

printf 'name,x,y,z\nnose,1.25,2.5,3.125\nchin,0.1,0.2,0.3\nlost,,,\n' >"$work/points.csv"
for ((j = 0; j < 480; j += 37)); do
    for ((i = 0; i < 640; i += 41)); do echo "$i.5,$j.5,0.$((i * 7919 % 997 + 1))"; done
done | sed '1i px,py,depth' >"$work/pixels.csv"

# keep FILE PROGRAM …: a program's output, with its exit code: 2 is a scene of ours that it rejects.
keep() {
    local file=$1 rc=0
    shift
    "$@" >"$file" 2>&1 || rc=$?
    echo "exit code $rc" >>"$file"
    [ "$rc" -lt 2 ] || { echo "${file#"$work"/}: $(head -n 1 "$file")"; failed=1; }
}

# All mistakes that the old build knows: it lists them when it gets an unknown one.
mistakes=$("$old/core/cli/unproject" map --what displacement --convention ? -o "$work/none.pfm" "$work/scenes/ortho.json" 2>&1 |
    sed -n 's/.* is not one of //p' | tr -d ',')
[ -n "$mistakes" ] || { echo "The old build lists no mistakes" >&2; exit 2; }

# computed COMMAND OUT: the output of a build's command for all scenes.
computed() {
    local command=$1/core/cli/unproject out=$2 name form
    for file in "$work"/scenes/*.json; do
        name=$out/$(basename -- "$file" .json)
        keep "$name.points" "$command" points --method all "$file" "$work/pixels.csv"
        keep "$name.object" "$command" points --space object:pot "$file" "$work/pixels.csv"
        cut -d, -f1,2 "$work/pixels.csv" | keep "$name.pick" "$command" pick "$file" -
        for snap in edge face vertex; do
            cut -d, -f1,2 "$work/pixels.csv" | keep "$name.$snap" "$command" pick --snap $snap "$file" -
        done
        sed 's/px,py,depth/x,y,z/' "$work/pixels.csv" | keep "$name.project" "$command" project "$file" -
        for form in text json numpy latex; do keep "$name.$form" "$command" matrices --format $form "$file"; done
        keep "$name.vulkan" "$command" matrices --conventions vulkan "$file"
        for form in glm glu qt three; do keep "$name.code.$form" "$command" code --for $form "$file"; done
        for what in formula-matrix formula-ray uncertainty; do
            keep "$name.$what" "$command" map --json --size 160x120 --what $what -o "$name.$what.pfm" "$file"
        done
        for mistake in $mistakes; do
            keep "$name.$mistake" "$command" map --json --size 80x60 --what displacement --convention $mistake \
                -o "$name.$mistake.pfm" "$file"
        done
        keep "$name.doctor" "$command" doctor --json --pixel 310.5,200.5 --got 0.1234,0.5678,-0.9012 "$file"
        keep "$name.info" "$command" info "$file"
    done
    for form in csv pp mrk.json fcsv pts tps nts; do
        keep "$out/landmarks.$form" "$command" landmarks --to $form "$work/points.csv" -
    done
}

# picture NAME PROGRAM …: keeps the program's output, and checks that NAME.png exists.
picture() {
    local name=$1
    shift
    keep "$name.clicks" "$@"
    [ -s "$name.png" ] || { echo "${name#"$work"/}.png was not made"; failed=1; }
}

# pictures BUILD OUT: the scenes in a build's window, at the start and after two clicks.
pictures() {
    local window=$1/gui/unprojector out=$2 name
    for file in "$work"/scenes/*.json; do
        name=$out/$(basename -- "$file" .json)
        for clicks in "" "--click 320,240 --click 200,260"; do
            # shellcheck disable=SC2086
            picture "$name${clicks:+-clicked}" sh "$folder/../tests/launch.sh" --display -- "$window" --no-panels \
                --view-size 640x480 $clicks --screenshot "$name${clicks:+-clicked}.png" "$file"
        done
    done
    for place in click pipeline points doctor; do
        picture "$out/bundled-$place" sh "$folder/../tests/launch.sh" --display -- "$window" --view-size 640x480 \
            --no-panels --place $place --screenshot "$out/bundled-$place.png"
    done
}

for which in old new; do
    computed "${!which}" "$work/$which"
    [ ! -x "$old/gui/unprojector" ] || [ ! -x "$new/gui/unprojector" ] || pictures "${!which}" "$work/$which"
done
echo "$(find "$work/old" -type f | wc -l) outputs of the old build, $(find "$work/old" -name '*.png' | wc -l) of them pictures"
if python3 "$folder/differences.py" "$work/old" "$work/new" && [ -z "$failed" ]; then
    echo "The same."
else
    exit 1
fi
