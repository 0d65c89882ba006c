#pragma once

#include "tool.h"

#include <pcl/acquisition/trinocular_file_grabber.h>

#include <optional>
#include <string>

namespace pcl::acmap {

/** \brief What the user asks for. */
struct StereoOptions {
  std::string session; ///< folder; empty where it is none
  TrinocularImageLists images;
  std::string rig;      ///< of the lists
  std::string color;    ///< image of the reference view; empty: of the shots
  bool rectify = false; ///< the lists
  bool active = false;  ///< one image per camera was taken under a pattern
  std::string output;
  std::string method = "spacetime";
  bool has_method = false;           ///< whether the method was given
  double nearest = 0.5;              ///< metres
  double farthest = 10;              ///< metres
  std::optional<double> correlation; ///< least ZNCC
  std::optional<double> texture;     ///< grey levels, one standard deviation
  std::string poses;                 ///< path; empty: none
  bool disparity = false;
  bool goes_on = false; ///< takes what an interrupted run left in the output

  bool
  hasLists() const
  {
    return !images.reference.empty();
  }

  /** \brief Whether there is only one image per camera: nothing to fuse. */
  bool
  hasOneShot() const
  {
    return images.reference.size() == 1;
  }

  /** \brief Whether the images are matched as passive stereo. */
  bool
  isPassive() const
  {
    return hasOneShot() && !active;
  }

  /** \brief Where the rig stands. */
  std::string
  rigPath() const;

  /** \brief All images that were named. */
  std::vector<std::string>
  allImages() const;
};

/** \brief Adds them to the command line. */
void
addOptions(Tool& tool, StereoOptions& options);

/** \brief Adds only those that say how disparities and points are found. */
void
addStereoChoices(CLI::App& app, StereoOptions& options);

/** \brief Refuses options that do not go together.
 * \throws UsageError naming them */
void
requireSense(const StereoOptions& options);

/** \brief Refuses depths of which the nearest is not below the farthest.
 * \throws UsageError naming them */
void
requireDepthOrder(const StereoOptions& options);

} // namespace pcl::acmap
