#pragma once

#include <pcl/core/disparity_image.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace pcl::acmap::test {

/** \brief What the cameras of a rectified rig see is told by what the reference sees:
 * places are its pixels (x, y), also between them. */
struct SyntheticSheet {
  /** \brief px along \ref disparityBaseline; may change by less than one from pixel to
   * pixel. */
  std::function<double(double x, double y)> disparity;

  /** \brief Grey level of a place in a shot. */
  std::function<double(int shot, double x, double y)> level;

  /** \brief Where the sheet is; none: everywhere. */
  std::function<bool(double x, double y)> covers = {};
};

struct SyntheticScene {
  TrinocularRig rig;
  std::vector<SyntheticSheet> sheets; ///< the nearest first; the last is everywhere
};

/** \brief 120 x 90 pixels. \param[in] horizontal, vertical baselines, metres */
TrinocularRig
syntheticRig(double horizontal, double vertical);

/** \brief Smooth random grey levels about 128, another picture in each shot: noise with a
 * knot every two pixels. */
double
noiseLevel(int shot, double x, double y);

/** \brief One sheet under \ref noiseLevel at one disparity, px. */
SyntheticScene
flatScene(const TrinocularRig& rig, double disparity);

/** \brief Shots with patterns 0, 1, ..., grey, of all cameras of the rig. */
std::vector<TrinocularFrame::Ptr>
shotsOf(const SyntheticScene& scene, int shots);

/** \brief Whether a neighbour has the place of a reference's pixel in its image, and
 * nothing stands before it. */
bool
isSeenBy(RigCamera neighbour, const SyntheticScene& scene, int column, int row);

/** \brief True disparities where a predicate (column, row) holds, NaN elsewhere. */
DisparityImage
trueDisparities(const SyntheticScene& scene,
                const std::function<bool(int column, int row)>& asked);

/** \brief Those of the pixels that all neighbours of the rig see. */
DisparityImage
trueDisparities(const SyntheticScene& scene);

} // namespace pcl::acmap::test
