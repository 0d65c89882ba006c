#pragma once

#include <pcl/core/disparity_image.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace pcl::acmap::test {

/** \brief A surface defined by what the reference of a rectified rig sees: positions
 * are pixels (x, y) of the reference, including fractions. */
struct SyntheticSheet {
  /** \brief px along \ref disparityBaseline; may change by less than one from pixel to
   * pixel. */
  std::function<double(double x, double y)> disparity;

  /** \brief Grey level of a position in a shot. */
  std::function<double(int shot, double x, double y)> level;

  /** \brief Does the sheet cover a position? Empty: everywhere. */
  std::function<bool(double x, double y)> covers = {};
};

struct SyntheticScene {
  TrinocularRig rig;
  std::vector<SyntheticSheet> sheets; ///< nearest first; the last one is everywhere
};

/** \brief 120 x 90 pixels. \param[in] horizontal, vertical baselines, metres */
TrinocularRig
syntheticRig(double horizontal, double vertical);

/** \brief Smooth random grey levels about 128, different in each shot: noise with a
 * knot every two pixels. */
double
noiseLevel(int shot, double x, double y);

/** \brief One sheet with \ref noiseLevel at a constant disparity, px. */
SyntheticScene
flatScene(const TrinocularRig& rig, double disparity);

/** \brief Grey shots of all cameras of the rig with patterns 0, 1, ... */
std::vector<TrinocularFrame::Ptr>
shotsOf(const SyntheticScene& scene, int shots);

/** \brief Is the position of a reference pixel inside the image of a neighbour, and not
 * occluded there? */
bool
isSeenBy(RigCamera neighbour, const SyntheticScene& scene, int column, int row);

/** \brief True disparities where a predicate (column, row) is true, NaN elsewhere. */
DisparityImage
trueDisparities(const SyntheticScene& scene,
                const std::function<bool(int column, int row)>& asked);

/** \brief As above for the pixels that are visible in all neighbours of the rig. */
DisparityImage
trueDisparities(const SyntheticScene& scene);

} // namespace pcl::acmap::test
