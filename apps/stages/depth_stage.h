#pragma once

#include "tool.h"

#include <pcl/core/depth_planes.h>
#include <pcl/core/point_cloud_file.h>

#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief What measured a cloud: decides whether its planes and surfaces are looked for in
 * the picture, where the noise of cameras that triangulate is even, or in space. */
enum class DepthSensor {
  Automatic, ///< in the picture where the depth is quantised
  Quantised, ///< structured light, such as a Kinect
  Stereo,
  TimeOfFlight,
  Laser
};

/** \brief Adds `--sensor`. */
void
addSensor(Tool& tool, DepthSensor& sensor);

/** \brief One view with the noise of its depth. */
struct MeasuredView {
  DepthView view;
  NoiseScale::InverseDepth noise;
  std::optional<PictureOrder> order; ///< where the file's points are not organized
};

/** \brief The picture in which a file's cloud is to be worked on; nothing where it is to be
 * in space.
 * \throws UsageError when the sensor that the user named needs a picture and the cloud is
 * not an organized view in its sensor's frame */
std::optional<MeasuredView>
viewOfFile(const PointCloudFile& file, DepthSensor sensor);

/** \brief Tells the noise of a view in the summary and the report. */
void
tellDepthNoise(Tool& tool, const MeasuredView& measured);

/** \brief Takes the steps out of a view as DepthRefinement does, as a step of a tool: moves
 * the points, sets their normals.
 * \param[in] known planes of the view; nullptr: they are searched for */
void
refineInput(Tool& tool,
            const MeasuredView& measured,
            const DepthPlanes* known,
            PointCloudFile& file);

/** \brief Moves the points of a view likewise where its depth is quantised, without a word
 * and without normals; those that are withdrawn become NaN. \return whether it was
 * \param[in] width pixels of a row */
bool
refineIfQuantised(std::vector<Eigen::Vector3f>& points,
                  std::size_t width,
                  DepthSensor sensor,
                  unsigned threads);

/** \brief The same of an observation. */
bool
refineIfQuantised(PointCloudFile& file, DepthSensor sensor, unsigned threads);

} // namespace pcl::acmap
