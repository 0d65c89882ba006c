#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/point_cloud.h>

namespace pcl::acmap {

/** \brief Checks that all indices are those of points.
 * \throws InitFailedException naming the first one that is not \ingroup core */
inline void
requireIndices(const Indices& indices, std::size_t points)
{
  for (const index_t index : indices)
    if (index < 0 || static_cast<std::size_t>(index) >= points)
      throw acmap::InitFailed(
          "index ", index, " is outside of the input cloud of ", points, " points");
}

/** \brief Checks that the input of a class has a cloud that holds the pixels that it claims,
 * and that all indices are valid.
 * PCL's own classes do not check indices and read outside of the cloud.
 * \param[in] input the cloud that was set
 * \param[in] indices the indices that were set, nullptr for the whole cloud
 * \throws InitFailedException naming the fault \ingroup core */
template <typename PointT>
void
requireInput(const typename PointCloud<PointT>::ConstPtr& input, const Indices* indices)
{
  if (!input)
    throw acmap::InitFailed("no input cloud was set");
  if (std::size_t{input->width} * input->height > input->size())
    throw acmap::InitFailed("the cloud claims ",
                            input->width,
                            " x ",
                            input->height,
                            " points and has ",
                            input->size());
  if (indices)
    requireIndices(*indices, input->size());
}

} // namespace pcl::acmap
