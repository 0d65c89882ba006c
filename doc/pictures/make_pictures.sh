#!/bin/sh
# Makes the pictures of the simulated corridor and of its rig anew, beside this script.
# usage: sh make_pictures.sh BIN_FOLDER    where tools and tests' programs are:
#        cmake --preset bench && cmake --build build/bench    makes them, in build/bench/bin
set -eu

bin=$(CDPATH='' cd -- "${1:?usage: sh make_pictures.sh BIN_FOLDER}" && pwd)
pictures=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# in_map X Y Z: from the corridor's axes (x right, y down, z ahead) to the first camera's,
# which looks 30 degrees to the right.
in_map() {
  awk -v x="$1" -v y="$2" -v z="$3" 'BEGIN {
    c = cos (atan2 (0, -1) / 6); s = 0.5
    printf "%.3f %.3f %.3f", c * x - s * z, y, s * x + c * z }'
}

# picture MESH NAME SIZE EYE... LOOK... [OPTION...]: places in the corridor's axes.
picture() {
  mesh=$scratch/$1.ply name=$2 size=$3
  from=$(in_map "$4" "$5" "$6") look=$(in_map "$7" "$8" "$9")
  shift 9
  xvfb-run -a -s "-screen 0 1280x960x24" "$bin/pcl_compact_viewer" "$mesh" --quiet "$@" \
    --screenshot "$pictures/$name.png" --size "$size" --from $from --look $look --up 0,-1,0
}

# mesh CLOUD NAME [OPTION...]
mesh() {
  cloud=$scratch/$1.pcd name=$2
  shift 2
  echo "== $name $*"
  "$bin/pcl_dewall_surface" "$cloud" "$scratch/$name.ply" "$@"
}

"$bin/pcl_line_pattern" "$pictures/line_pattern.png"
"$bin/draw_rig_calibration" "$scratch"
cp "$scratch/rig_calibration.png" "$pictures/"

"$bin/pcl_simulated_rig" -o "$scratch/few" --observations 4 --clouds \
  --merged "$scratch/few/map.pcd"
"$bin/pcl_simulated_rig" -o "$scratch/many" --observations 24 --clouds \
  --merged "$scratch/many/map.pcd"

mesh few/observation_0000 view_raw
mesh few/observation_0000 view --consolidate
mesh few/observation_0000 view_small --consolidate 0.02
mesh few/observation_0000 view_large --consolidate 0.2
mesh few/map few_raw
mesh few/map few --consolidate
mesh many/map many --consolidate

# noise does not compress: pairs that show some are small
door="-0.9 -0.1 0.2 1.2 0.05 3.2"
picture view_raw corridor_view_raw 432x288 $door --grey
picture view corridor_view 432x288 $door --grey
picture view_small corridor_voxel_small 432x288 $door --grey
picture view_large corridor_voxel_large 432x288 $door --grey
ahead="0 -0.1 0.4 0 0.15 6"
picture few_raw corridor_raw 432x288 $ahead
picture few corridor_consolidated 432x288 $ahead
picture many corridor_inside 900x600 0 -0.1 1 0 0.15 8
picture many corridor_door 900x600 -0.4 -0.1 1.9 1.2 0.25 3.1

xvfb-run -a "$bin/pcl_compact_mapping" "$scratch/many" -o "$scratch/map"
cp "$scratch/map/inside.png" "$pictures/map_inside.png"

"$bin/pcl_simulated_rig" -o "$scratch/office" --scene office --clouds
"$bin/pcl_compact_mapping" "$scratch/office" -o "$scratch/office_map"
cp "$scratch/office_map/pictures/floor_plan.png" "$pictures/map_plan.png"

"$bin/pcl_simulated_rig" -o "$scratch/room" --scene room --clouds
"$bin/pcl_compact_mapping" "$scratch/room" -o "$scratch/room_map" --no-pictures
xvfb-run -a -s "-screen 0 1280x960x24" "$bin/pcl_compact_viewer" "$scratch/room_map" --quiet \
  --hide-backs --layers texture --size 900x600 --screenshot "$pictures/room_primitives.png"

"$bin/pcl_simulated_rig" -o "$scratch/drive" --scene l_corridor_drive
"$bin/pcl_active_stereo" "$scratch/drive" -o "$scratch/seen"
"$bin/pcl_visual_egomotion" "$scratch/seen" -o "$scratch/way" --truth "$scratch/drive/trajectory.txt"
cp "$scratch/way/plan.png" "$pictures/egomotion_plan.png"
"$bin/pcl_visual_egomotion" "$scratch/seen" -o "$scratch/posed" --pictures --keypoints 300
cp "$scratch/posed/matches_0006.png" "$pictures/egomotion_matches.png"

"$bin/pcl_simulated_rig" -o "$scratch/survey" --scene corridor_survey
xvfb-run -a "$bin/pcl_compact_mapping" "$scratch/survey" -o "$scratch/survey_map" --no-pictures
xvfb-run -a "$bin/acmap_paper_figures" "$scratch/survey" "$scratch/survey_map" -o "$scratch/figures"
cp "$scratch/figures/"fig*.png "$pictures/paper_figures/"
# The first page: a view that is real, and what was filmed. Needs Chromium, Node and the cloud
# office1.pcd of https://github.com/PointCloudLibrary/data.
office=${ACMAP_TEST_DATA:-$pictures/../../../shared/data}/E_meshing/office1.pcd
shown() {
  xvfb-run -a -s "-screen 0 1280x960x24" "$bin/pcl_compact_viewer" "$1" --quiet --size 960x640 \
    --screenshot "$scratch/$2.png"
}
"$bin/pcl_dewall_surface" "$office" "$scratch/office.ply" --consolidate
shown "$office" real_points
shown "$scratch/office.ply" real_mesh
"$bin/pcl_compact_mapping" "$office" -o "$scratch/real" --no-pictures
node "$pictures/first_page.mjs" /usr/bin/chromium "$scratch" "$scratch/real/map.html" \
  "$scratch/survey_map/map.html"
/usr/bin/python3 "$pictures/overview.py" "$scratch" "$pictures/paper_figures" "$pictures"
