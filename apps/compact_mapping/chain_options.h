#pragma once

#include "active_stereo/stereo_options.h"
#include "entropy_rectification/rectification_options.h"
#include "plane_extraction/plane_options.h"
#include "starting_point.h"
#include "texturing/texture_stage.h"
#include "visual_egomotion/egomotion_options.h"

namespace pcl::acmap {

/** \brief What the user asks for: the options of all stages. */
struct ChainOptions {
  std::string input;
  std::string output;
  std::string truth; ///< simulated session to compare with; empty: none
  bool has_pictures = true;
  bool rectifies = true;
  std::size_t most_points = 50000000; ///< of the map, before it is consolidated
  StereoOptions stereo;
  EgomotionOptions egomotion;
  RectificationOptions rectification;
  PlaneOptions planes;
  TextureOptions texture;
};

/** \brief Titles of the options of the stages in the help. */
constexpr const char* stereo_group = "Stereo, for a raw session";
constexpr const char* egomotion_group = "Egomotion, for observations without poses";
constexpr const char* rectification_group =
    "Rectification, for more than one observation";
constexpr const char* map_group = "Map";

/** \brief Adds them to the command line. */
void
addOptions(Tool& tool, ChainOptions& options);

/** \brief Refuses options that do not go together, or of a stage that the way from the
 * input to the map does not lead through.
 * \throws UsageError naming them */
void
requireSense(Tool& tool, const ChainOptions& options, StartingPoint start);

/** \brief All options of a group with what the user gave, for \ref StageFolder. */
nlohmann::ordered_json
valuesIn(Tool& tool, const std::string& group);

} // namespace pcl::acmap
