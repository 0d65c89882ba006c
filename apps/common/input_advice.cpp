#include "input_advice.h"

#include <pcl/pipeline/input_kind.h>

#include <algorithm>
#include <map>
#include <vector>

namespace pcl::acmap {
namespace {

/** \brief The tools for an input. */
struct ToolsForInput {
  std::vector<std::string> doors; ///< arguments that accept it, as "tool argument"
  std::string advice;             ///< sentence with a command; a % is the input's path
};

const std::map<InputKind, ToolsForInput>&
toolsForInputs()
{
  static const std::map<InputKind, ToolsForInput> tools = {
      {InputKind::RgbdFolder,
       {{"pcl_compact_mapping input", "pcl_rgbd_import input"},
        "% is an RGB-D recording: run pcl_compact_mapping % -o map for a map, or first "
        "pcl_rgbd_import % -o observations"}},
      {InputKind::RawSession,
       {{"pcl_active_stereo session",
         "pcl_compact_mapping input",
         "acmap_paper_figures session"},
        "% is a raw session: run pcl_active_stereo % -o observations for point clouds, "
        "or pcl_compact_mapping % -o map for a map"}},
      {InputKind::CompactMap,
       {{"pcl_compact_viewer input", "acmap_paper_figures map"},
        "% is a compact map already: run pcl_compact_viewer % to see it; its planes "
        "are %/map.json"}},
      {InputKind::MergedMap,
       {{"pcl_compact_viewer input", "acmap_paper_figures map"}, // without its map.json
        "% holds poses and a merged map, no observations: run "
        "pcl_entropy_rectification with --observations to have those, or give "
        "%/map.pcd as one cloud"}},
      {InputKind::Observations,
       {{"pcl_compact_mapping input",
         "pcl_entropy_rectification posed",
         "pcl_plane_texturing observations",
         "pcl_visual_egomotion observations"},
        "% is a folder of point clouds: run pcl_compact_mapping % -o map for a map, or "
        "give one of its files"}},
      {InputKind::Images,
       {{},
        "% holds images: those of a stereo rig go to pcl_active_stereo --reference "
        "IMG.. --horizontal IMG.. --rig RIG.yaml -o observations"}},
      {InputKind::CarmenLog,
       {{},
        "% is a laser log of CARMEN: run pcl_entropy_rectification --carmen % -o "
        "straight"}},
      {InputKind::Bag,
       {{"pcl_compact_mapping input", "pcl_entropy_rectification posed"},
        "% is a bag of ROS: run pcl_compact_mapping % -o map for a map of its images "
        "or "
        "clouds, or pcl_entropy_rectification % -o straight for one of its laser "
        "scans"}},
      {InputKind::Planes,
       {{"pcl_compact_viewer input", "pcl_plane_texturing planes"},
        "% holds planes: run pcl_plane_texturing % POSED_DIR -o map to paint them, or "
        "pcl_compact_viewer % to see them"}},
      {InputKind::Cloud,
       {{"pcl_cloud_info input",
         "pcl_compact_mapping input",
         "pcl_compact_viewer input",
         "pcl_dewall_surface input",
         "pcl_plane_extraction input",
         "pcl_plane_texturing observations",
         "pcl_visual_egomotion observations"},
        "% is a point cloud or a mesh: run pcl_dewall_surface % mesh.ply for a mesh, "
        "or "
        "pcl_plane_extraction % planes.json for planes"}}};
  return tools;
}

} // namespace

std::string
toolForInput(const std::string& tool,
             const std::string& positional,
             const std::string& path)
{
  const auto tools = toolsForInputs().find(inputKindOf(path));
  if (tools == toolsForInputs().end())
    return {};
  const auto& [doors, advice] = tools->second;
  if (std::count(doors.begin(), doors.end(), tool + " " + positional) > 0)
    return {};
  std::string text;
  for (const char letter : advice)
    text += letter == '%' ? path : std::string(1, letter);
  return text;
}

} // namespace pcl::acmap
