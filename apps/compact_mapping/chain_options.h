#pragma once

#include "active_stereo/stereo_options.h"
#include "entropy_rectification/rectification_options.h"
#include "plane_extraction/extraction.h"
#include "rgbd_import/rgbd_options.h"
#include "texturing/texture_stage.h"
#include "visual_egomotion/egomotion_options.h"

#include <pcl/pipeline/detail_mesh.h>
#include <pcl/pipeline/map_input.h>
#include <pcl/pipeline/pose_convention_check.h>
#include <pcl/pipeline/ranks.h>

#include <memory>

namespace pcl::acmap {

/** \brief All formats of a map beside map.json, map.glb and map.obj; without html if acmap was
 * built without the page (hasMapPage). */
std::vector<std::string>
formatsByDefault();

/** \brief Options of the user: those of all stages. */
struct ChainOptions {
  ChainOptions()
  {
    planes.primitives_by_default = true;
  }

  std::string input;
  std::string output;
  std::string earlier; ///< folder of a map that is extended; empty: none
  std::string truth;   ///< simulated session to compare with; empty: none
  bool has_pictures = true;
  bool verbose = false; ///< all lines of all stages are told
  /** \brief Endings of those of map.html, map.ifc and the floor plans that are written. */
  std::vector<std::string> formats = formatsByDefault();
  bool rectifies = true;
  BagSettings bag;              ///< how a bag is read, and which frames of it
  bool as_recorded = false;     ///< replay a session at its pace, and map it meanwhile
  bool live = false;            ///< show the map of the replay so far
  std::shared_ptr<Ranks> ranks; ///< processes that make the map; null: this one alone
  /** \brief Maximum for the merged cloud, before it is consolidated. */
  std::size_t max_points = 2000000000;
  StereoOptions stereo;
  RgbdOptions rgbd;
  PoseConventionCheck poses; ///< of recorded poses
  EgomotionOptions egomotion;
  RectificationOptions rectification;
  std::size_t max_detail_bytes = default_detail_bytes;
  PlaneOptions planes;
  TextureOptions texture;
};

/** \brief Titles of the option groups of the stages in the help. */
constexpr const char* stereo_group = "Stereo, for a raw session";
constexpr const char* recording_group = "Bag of ROS, or RGB-D folder";
constexpr const char* bag_group = "Bag of ROS";
constexpr const char* rgbd_group = "RGB-D folder";
constexpr const char* poses_group = "Recorded poses, of a folder";
constexpr const char* egomotion_group = "Egomotion, for observations without poses";
constexpr const char* motion_group = "Motion, for more than one observation";
constexpr const char* rectification_group =
    "Rectification, for more than one observation";
constexpr const char* map_group = "Map";

/** \brief Adds the options to the command line. */
void
addOptions(Tool& tool, ChainOptions& options);

/** \brief With --paper, sets all stages to the paper's way.
 * \throws UsageError for options that depart from it */
void
takePaperWay(Tool& tool, ChainOptions& options);

/** \brief Refuses options that exclude each other, or that belong to a stage that is
 * not used for this input.
 * \throws UsageError naming them */
void
requireSense(Tool& tool, const ChainOptions& options, StartingPoint start);

/** \brief All options of a group with the values of the user, for \ref StageFolder. */
nlohmann::ordered_json
valuesIn(Tool& tool, const std::string& group);

} // namespace pcl::acmap
