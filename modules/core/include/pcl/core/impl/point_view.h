#pragma once

#include <pcl/core/build_config.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace pcl::acmap {

struct PointShares;

/** \brief Zero-copy view of the x y z floats of an array of any point type, of all
 * points or of a subset given by indices.
 *
 * Kernels access points with it, so that they do not depend on the point type. The
 * three floats of a point are adjacent; the distance between points is \a stride bytes.
 * Units and frame are those of the caller. The view does not own the memory.
 * \ingroup core */
class PointView {
public:
  PointView() = default;

  /** \param[in] first address of the x of the first point
   * \param[in] stride bytes from one point to the next
   * \param[in] size number of points, or of indices if these are given
   * \param[in] indices indices into the array, nullptr for all points in their order */
  PointView(const void* first,
            std::size_t stride,
            std::size_t size,
            const std::int32_t* indices = nullptr)
  : first_(static_cast<const char*>(first))
  , stride_(stride)
  , size_(size)
  , indices_(indices)
  {}

  /** \brief All points of an array, parts of which other processes have, too. */
  PointView(const void* first,
            std::size_t stride,
            std::size_t size,
            const PointShares* shares)
  : PointView(first, stride, size)
  {
    shares_ = shares;
  }

  std::size_t
  size() const
  {
    return size_;
  }

  /** \brief The parts of the array that other processes have, or nullptr. */
  const PointShares*
  shares() const
  {
    return shares_;
  }

  /** \brief Index in the underlying array of point \a i of the view. */
  std::int32_t
  index(std::size_t i) const
  {
    return indices_ ? indices_[i] : static_cast<std::int32_t>(i);
  }

  Eigen::Vector3f
  operator[](std::size_t i) const
  {
    Eigen::Vector3f p;
    std::memcpy(p.data(),
                first_ + stride_ * static_cast<std::size_t>(index(i)),
                sizeof(float) * 3);
    return p;
  }

private:
  const char* first_ = nullptr;
  std::size_t stride_ = 0;
  std::size_t size_ = 0;
  const std::int32_t* indices_ = nullptr;
  const PointShares* shares_ = nullptr;
};

} // namespace pcl::acmap
