#pragma once

#include "clouds/field_layout.h"

#include <pcl/core/impl/cloud_statement.h>
#include <pcl/core/point_cloud_file.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief Coordinates of some points of a file, for the middle of all of them. */
class CoordinateSample {
public:
  /** \brief Number of points that are sufficient. */
  static constexpr std::size_t enough = 4096;

  /** \brief Adds a point, unless it is not finite or (0, 0, 0), which some programs write
   * where nothing was measured. */
  void
  add(const Eigen::Vector3d& point);

  std::size_t
  size() const
  {
    return values_[0].size();
  }

  /** \brief The shift of the file in its own unit: what is stated, else the whole kilometres
   * of the median along the axes along which nine tenths of the points are beyond 10 km. */
  Eigen::Vector3d
  shift(const CloudStatement& stated) const;

private:
  std::array<std::vector<double>, 3> values_;
};

/** \brief Is a point at a place to a millimetre? (0, 0, 0) in steps of a millimetre and an offset
 * is rounded. */
template <typename Vector>
bool
isAt(const Vector& point, const Vector& place)
{
  return (point - place).cwiseAbs().maxCoeff() < 1e-3;
}

/** \brief Notes what was subtracted from the coordinates, with a remark if that is not 0. The
 * up direction of geocentric coordinates points away from the middle of the Earth, that of
 * grids is usually z.
 * \param[in] shift in the unit of the file, as \ref PointCloudFile::shift still is */
void
setShift(const Eigen::Vector3d& shift,
         const CloudStatement& stated,
         PointCloudFile& file);

/** \brief Remarks that float32 coordinates so far from the origin had lost digits before. */
void
remarkLostDigits(const Eigen::Vector3d& shift,
                 const CloudStatement& stated,
                 PointCloudFile& file);

/** \brief Notes the shift of a layout, if there is one, as \ref setShift does. */
void
noteShift(const FieldLayout& layout,
          const CloudStatement& stated,
          PointCloudFile& file);

} // namespace pcl::acmap
