#pragma once

#include "plane_raster.h"

#include <pcl/simulation/simulated_scene.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief A true plane with the part of it that the cameras saw. Several of a scene that
 * lie in one plane, such as the tops of two tables, are one face. */
struct VisibleFace {
  std::string name;
  Eigen::Vector4d coefficients = Eigen::Vector4d::Zero();
  PlaneFrame frame;
  CellSet all;  ///< its rectangles
  CellSet seen; ///< of these, the cells whose centres a camera saw
};

/** \brief A centimetre of the common line of two faces, beside which both were seen. */
struct CreaseSample {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  std::array<std::size_t, 2> faces{};
};

/** \brief What the cameras of a scene saw of its planes, in the scene's frame: the
 * reference for outlines. A point is seen if it is in the image of a view, within the
 * sensor's reach, and nothing is in front of it. Curved surfaces only occlude. */
struct VisibleTruth {
  std::vector<VisibleFace> faces;
  std::vector<std::size_t> face_of_plane; ///< for each true plane of the scene

  /** \brief Creases, in steps of \ref raster_cell: both faces exist beside the line and
   * were seen at 2.5 and 3.5 cm from it, on one side or both. */
  std::vector<CreaseSample> creases;

  /** \brief Corners of the faces' boundaries, without duplicates; the surface was seen
   * on all sides at 2.5 cm where it exists. */
  std::vector<Eigen::Vector3d> corners;

  double
  seenArea() const;
};

VisibleTruth
findVisibleTruth(const SimulatedScene& scene);

} // namespace pcl::acmap::bench
