#pragma once

#include <pcl/core/build_config.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief Position of the sensor that saw a point: one position for all points, or that
 * of the observation given by the field `view` of the point, or unknown.
 *
 * It is used together with a PointView and has the same order of points. Positions
 * are in metres, in the frame of the points. It owns the positions but not the field.
 * \ingroup core */
class SensorView {
public:
  /** \brief The sensor positions are unknown. */
  SensorView() = default;

  /** \brief All points were seen by one sensor; it is unknown if its position is not finite.
   */
  explicit SensorView(const Eigen::Vector3f& origin)
  {
    if (origin.allFinite())
      origins_ = {origin};
  }

  /** \param[in] first address of the int32 `view` of the first point of the array
   * \param[in] stride bytes from one point to the next
   * \param[in] origins sensor position of each observation; those that are not finite are
   * unknown
   * \param[in] indices indices into the array, nullptr for all points in their order */
  SensorView(const void* first,
             std::size_t stride,
             std::vector<Eigen::Vector3f> origins,
             const std::int32_t* indices = nullptr)
  : first_(static_cast<const char*>(first))
  , stride_(stride)
  , indices_(indices)
  , origins_(std::move(origins))
  {}

  bool
  isKnown() const
  {
    return !origins_.empty();
  }

  /** \brief The one sensor that saw all points; nullptr if there is none, or several. */
  const Eigen::Vector3f*
  single() const
  {
    return first_ || origins_.empty() ? nullptr : origins_.data();
  }

  /** \brief Position of the sensor that saw point \a i of the view; nullptr if unknown.
   */
  const Eigen::Vector3f*
  operator[](std::size_t i) const
  {
    const std::int32_t view = observation(i);
    if (view < 0)
      return nullptr;
    const Eigen::Vector3f& origin = origins_[static_cast<std::size_t>(view)];
    return origin.allFinite() ? &origin : nullptr;
  }

  /** \brief Index of the observation that saw point \a i of the view; 0 if one sensor
   * saw all points, -1 if unknown. */
  std::int32_t
  observation(std::size_t i) const
  {
    if (!first_)
      return origins_.empty() ? -1 : 0;
    const std::size_t place = indices_ ? static_cast<std::size_t>(indices_[i]) : i;
    std::int32_t view;
    std::memcpy(&view, first_ + stride_ * place, sizeof view);
    return view >= 0 && static_cast<std::size_t>(view) < origins_.size() ? view : -1;
  }

private:
  const char* first_ = nullptr;
  std::size_t stride_ = 0;
  const std::int32_t* indices_ = nullptr;
  std::vector<Eigen::Vector3f> origins_;
};

} // namespace pcl::acmap
