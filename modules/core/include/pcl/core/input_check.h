#pragma once

#include <pcl/exceptions.h>
#include <pcl/point_cloud.h>

namespace pcl::acmap {

/** \brief Lets a class's input pass when there is a cloud and all indices lie inside of
 * it. PCL's own classes read what lies outside.
 * \param[in] input the cloud that was set
 * \param[in] indices that the user set, nullptr for the whole cloud
 * \throws InitFailedException naming the fault \ingroup core */
template <typename PointT>
void
requireInput(const typename PointCloud<PointT>::ConstPtr& input, const Indices* indices)
{
  if (!input)
    PCL_THROW_EXCEPTION(InitFailedException, "no input cloud was set");
  if (!indices)
    return;
  for (const index_t index : *indices)
    if (index < 0 || static_cast<std::size_t>(index) >= input->size())
      PCL_THROW_EXCEPTION(InitFailedException,
                          "index " << index << " is outside of the input cloud of "
                                   << input->size() << " points");
}

} // namespace pcl::acmap
