#pragma once

#include <pcl/core/export.h>

#include <Eigen/Geometry>

namespace pcl::acmap {

/** \brief The rotation that aligns points with others in the least-squares sense
 * (Kabsch, Umeyama); never a reflection.
 *
 * Points that coincide do not determine a rotation, and points on a line in space
 * determine it up to a turn about the line: then it is the smallest one.
 * \param[in] cross sum of target * source^T over the pairs of points, both relative to
 * their centroids
 * \param[in] undetermined singular values up to this one are regarded as 0
 * \return R, for which R * source is closest to target \ingroup core */
template <int Dimension>
Eigen::Matrix<double, Dimension, Dimension>
alignmentRotation(const Eigen::Matrix<double, Dimension, Dimension>& cross,
                  double undetermined = 0);

/** \brief The smallest rotation that turns one direction into another.
 *
 * Eigen's own takes seconds of compilation in each source that calls it, and GCC 13 warns of
 * it at -O3. Of opposite directions, the axis is any one across them.
 * \param[in] from, to need not be unit vectors \ingroup core */
ACMAP_EXPORT Eigen::Quaterniond
smallestRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

} // namespace pcl::acmap
