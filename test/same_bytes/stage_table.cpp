#include "stage_table.h"

#include "rendered_boards.h"

namespace pcl::acmap::test {
namespace {

using Arguments = std::vector<std::string>;

Arguments
calibrationArguments()
{
  Arguments all = {"--square", "0.03", "-o", ">rig.yaml"};
  const char* const options[] = {"--reference", "--horizontal", "--vertical"};
  for (std::size_t camera = 0; camera < 3; ++camera) {
    all.emplace_back(options[camera]);
    for (std::size_t shot = 0; shot < board_shots; ++shot)
      all.push_back("<boards/" + shotNames(shot)[camera]);
  }
  return all;
}

/** Uses all images as shots of one place: the result is meaningless, but everything is
 * computed. The rig is the true one: another version of OpenCV calibrates another last bit. */
Arguments
rectifyingArguments()
{
  const auto images = shotNames(0);
  return {"--reference",
          "<boards/" + images[0],
          "--horizontal",
          "<boards/" + images[1],
          "--vertical",
          "<boards/" + images[2],
          "--rig",
          "<boards/rig.yaml",
          "--rectify",
          "--active",
          "--min-depth",
          "2",
          "-o",
          ">disparities"};
}

} // namespace

const std::vector<Stage>&
stageTable()
{
  static const Arguments planes = {"<rectification/map/map.pcd",
                                   ">planes.json",
                                   "--labels",
                                   ">labels.pcd",
                                   "--normals",
                                   ">normals.ply"};
  static const auto with = [](Arguments all, const Arguments& more) {
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  static const std::vector<Stage> table = {
      {"line_pattern",
       "pcl_line_pattern",
       {">patterns", "--patterns", "2", "--size", "320x240"},
       false},
      {"simulated_clouds",
       "pcl_simulated_rig",
       {"-o",
        ">session",
        "--scene",
        "<small_corridor.yaml",
        "--clouds",
        "--merged",
        ">merged.pcd"}},
      {"simulated_rig",
       "pcl_simulated_rig",
       {"-o", ">session", "--scene", "<small_corridor.yaml", "--patterns", "2"}},
      {"rig_calibration", "pcl_rig_calibration", calibrationArguments(), false},
      {"rectified_images", "pcl_active_stereo", rectifyingArguments()},
      {"active_stereo",
       "pcl_active_stereo",
       {"<simulated_rig/session",
        "-o",
        ">observations",
        "--min-depth",
        "1",
        "--disparity"}},
      {"digiclops_grabber",
       "pcl_digiclops_grabber",
       {"--device",
        "<simulated_rig/session",
        "--pcd",
        ">observations",
        "--min-depth",
        "1",
        "--method",
        "median"}},
      {"rgbd_import",
       "pcl_rgbd_import",
       {"<recording", "-o", ">observations", "--no-poses"},
       false},
      {"visual_egomotion",
       "pcl_visual_egomotion",
       {"<active_stereo/observations", "-o", ">posed", "--pictures"}},
      {"egomotion_6dof",
       "pcl_visual_egomotion",
       {"<active_stereo/observations", "-o", ">posed", "--6dof"}},
      {"rectification",
       "pcl_entropy_rectification",
       {"<visual_egomotion/posed", "-o", ">map", "--observations"}},
      {"rectification_by_votes",
       "pcl_entropy_rectification",
       {"<visual_egomotion/posed", "-o", ">map", "--mode", "paper"}},
      {"consolidated_surface",
       "pcl_dewall_surface",
       {"<rectification/map/map.pcd", ">mesh.ply", "--consolidate", "auto"}},
      {"dewall_surface",
       "pcl_dewall_surface",
       {"<rectification/map/map.pcd", ">mesh.ply", "--rule", "dense"}},
      {"plane_extraction", "pcl_plane_extraction", planes},
      {"plane_extraction_of_the_paper",
       "pcl_plane_extraction",
       with(planes, {"--paper"})},
      {"kinect_views",
       "pcl_simulated_rig",
       {"-o",
        ">session",
        "--scene",
        "office",
        "--clouds",
        "--observations",
        "1",
        "--sensor",
        "kinect"}},
      {"depth_planes",
       "pcl_plane_extraction",
       {"<kinect_views/session/observation_0000.pcd",
        ">planes.json",
        "--labels",
        ">labels.pcd"}},
      {"refined_surface",
       "pcl_dewall_surface",
       {"<kinect_views/session/observation_0000.pcd", ">mesh.ply", "--consolidate"}},
      {"plane_texturing",
       "pcl_plane_texturing",
       {"<plane_extraction/planes.json", "<rectification/map", "-o", ">map", "--ply"}},
      {"compact_mapping",
       "pcl_compact_mapping",
       {"<simulated_rig/session", "-o", ">map", "--min-depth", "1", "--no-pictures"}},
      {"compact_mapping_6dof",
       "pcl_compact_mapping",
       {"<simulated_rig/session",
        "-o",
        ">map",
        "--min-depth",
        "1",
        "--6dof",
        "--no-pictures"}},
      {"compact_mapping_of_the_paper",
       "pcl_compact_mapping",
       {"<simulated_rig/session",
        "-o",
        ">map",
        "--min-depth",
        "1",
        "--paper",
        "--no-pictures"}},
      {"replayed_map",
       "pcl_compact_mapping",
       {"<simulated_rig/session",
        "-o",
        ">map",
        "--min-depth",
        "1",
        "--as-recorded",
        "--no-pictures"}},
      {"grabbed_map",
       "pcl_digiclops_grabber",
       {"--device", "<simulated_rig/session", "--map", ">map", "--min-depth", "1"}},
      {"compact_viewer",
       "pcl_compact_viewer",
       {"<compact_mapping/map", "--screenshot", ">map.png", "--size", "320x240"},
       false,
       true},
  };
  return table;
}

} // namespace pcl::acmap::test
