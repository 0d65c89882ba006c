#pragma once

#include <pcl/core/cloud_rows.h>
#include <pcl/core/export.h>
#include <pcl/core/impl/byte_parcel.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/pipeline/cost_callback.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl::acmap {

/** \brief Builds the cloud of a whole map, observation by observation. Fields: `x y z`,
 * `rgb` if some observation has colours, and `view`, the number of the observation. */
class ACMAP_EXPORT MapRows {
public:
  /** \param[in] points expected minimum number of points, 0 if unknown
   * \param[in] cost called before memory is allocated for more points than that */
  MapRows(std::size_t points, bool colored, CostCallback cost = {});

  /** \brief Sets the maximum number of points. Whenever it is exceeded, every second
   * point is dropped. */
  void
  setMaximum(std::size_t points)
  {
    maximum_ = points;
  }

  /** \brief Step between the finite points that are kept: every n-th. */
  std::size_t
  every() const
  {
    return every_;
  }

  /** \brief Number of points that are kept so far. */
  std::size_t
  size() const
  {
    return rows_.size() / layout_.point_step;
  }

  /** \brief Reserves memory for this number of points, or for the maximum. */
  void
  reserve(std::size_t points);

  /** \brief Appends the finite points of an observation, black without colours. Runs in
   * parallel. */
  void
  append(const PointCloudFile& observation,
         const Eigen::Isometry3d& T_map_camera,
         std::int32_t view);

  /** \brief Appends points that another object has made in the same way.
   * \param[in] rows of its points, which are finite
   * \param[in] first_view is added to the numbers of their observations */
  void
  appendRows(const std::vector<std::uint8_t>& rows, std::int32_t first_view);

  /** \brief Returns all appended points. Nothing can be appended afterwards. */
  CloudRows
  finish();

private:
  void
  announce(std::size_t bytes) const;

  void
  grow(std::size_t points);

  void
  dropAboveMaximum();

  PCLPointCloud2 layout_;
  LargeVector<std::uint8_t> rows_;
  bool colored_;
  CostCallback cost_;
  std::size_t announced_; ///< bytes
  std::size_t maximum_ = std::numeric_limits<std::size_t>::max();
  std::size_t every_ = 1;
  std::size_t seen_ = 0; ///< finite points so far
};

/** \brief Puts points of any cloud in the layout of MapRows, those that are not finite, too:
 * black without colours, of observation 0 without a field `view`.
 * \param[in] begin, end numbers of the points */
ACMAP_EXPORT void
putMapRows(const CloudRows& cloud,
           std::size_t begin,
           std::size_t end,
           ByteParcel& parcel);

/** \brief The same rows in another frame, with their normals, if they have any; rows of
 * normals alone are turned. */
ACMAP_EXPORT CloudRows
movedRows(const Eigen::Isometry3d& T_to_from, const CloudRows& rows);

/** \brief The first row and every n-th after it, as an unorganized cloud. */
ACMAP_EXPORT PCLPointCloud2
everyNth(const CloudRows& cloud, std::size_t n);

} // namespace pcl::acmap
