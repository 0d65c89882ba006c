#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/export.h>
#include <pcl/core/scratch_memory.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

namespace pcl {

namespace acmap {
struct PointShares;
} // namespace acmap

/** \brief The points of a cloud, with any fields, that are shared and never changed: those
 * of a PCLPointCloud2, or rows of the same layout in a LargeVector, which may be larger than
 * the memory. Copies share the points. \ingroup core */
class ACMAP_EXPORT CloudRows {
public:
  /** \brief No cloud. */
  CloudRows() = default;

  /** \brief The points of a cloud; of a null pointer, no cloud. */
  CloudRows(const PCLPointCloud2ConstPtr& cloud);

  CloudRows(const PCLPointCloud2Ptr& cloud)
  : CloudRows(PCLPointCloud2ConstPtr(cloud))
  {}

  /** \brief The points of a cloud that must outlive this object and its copies. */
  static CloudRows
  of(const PCLPointCloud2& cloud)
  {
    return CloudRows(PCLPointCloud2ConstPtr(PCLPointCloud2ConstPtr(), &cloud));
  }

  /** \brief Rows of points.
   * \param[in] layout fields and step of a point; width and height if these are those of
   * the rows, else the cloud is not organized; its data are not used
   * \param[in] rows a multiple of the step
   * \throws BadArgumentException if it is none */
  CloudRows(PCLPointCloud2 layout, LargeVector<std::uint8_t> rows);

  /** \brief Is there a cloud? */
  explicit operator bool() const
  {
    return layout_ != nullptr;
  }

  /** \brief Fields, step, width and height. Its data may be empty: see \ref data. */
  const PCLPointCloud2&
  layout() const
  {
    return *layout_;
  }

  const std::uint8_t*
  data() const
  {
    return data_;
  }

  std::size_t
  bytes() const
  {
    return bytes_;
  }

  /** \brief Number of points by width and height. */
  std::size_t
  size() const
  {
    return layout_ ? std::size_t{layout_->width} * layout_->height : 0;
  }

  /** \brief Parts of the rows that other processes have, too; null if there are none. */
  const std::shared_ptr<const acmap::PointShares>&
  shares() const
  {
    return shares_;
  }

  void
  setShares(std::shared_ptr<const acmap::PointShares> shares)
  {
    shares_ = std::move(shares);
  }

  /** \brief The points as a cloud of its own. */
  PCLPointCloud2
  copy() const;

private:
  PCLPointCloud2ConstPtr layout_;
  std::shared_ptr<const void> rows_;
  const std::uint8_t* data_ = nullptr;
  std::size_t bytes_ = 0;
  std::shared_ptr<const acmap::PointShares> shares_;
};

} // namespace pcl
