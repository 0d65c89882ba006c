#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/point_cloud.h>

#include <cstddef>

/** \file
 * The checks of inputs that all classes have in common, one for each kind of fault. The
 * exception is InitFailed where a run checks, BadArgument where a setter does. */
namespace pcl::acmap {

/** \brief Checks that there is an input.
 * \param[in] input any pointer or CloudRows
 * \throws Exception otherwise \ingroup core */
template <typename Exception = InitFailed, typename Input>
void
requireGiven(const Input& input)
{
  if (!input)
    throw Exception("no input cloud was set");
}

/** \brief Checks that a cloud has as many points as it claims; 0 x 0 claims nothing, as
 * clouds have it whose points were appended one by one.
 * \throws Exception otherwise \ingroup core */
template <typename Exception = InitFailed>
void
requireShape(std::size_t width, std::size_t height, std::size_t points)
{
  if (width * height != points && (width != 0 || height != 0))
    throw Exception(
        "the cloud claims ", width, " x ", height, " points and has ", points);
}

/** \brief Checks that there is a cloud, with as many points as it claims.
 * \throws Exception otherwise \ingroup core */
template <typename Exception = InitFailed, typename CloudPtr>
void
requireCloud(const CloudPtr& cloud)
{
  requireGiven<Exception>(cloud);
  requireShape<Exception>(cloud->width, cloud->height, cloud->size());
}

/** \brief Checks that an index is that of a point.
 * \throws Exception otherwise \ingroup core */
template <typename Exception = InitFailed>
void
requireIndex(index_t index, std::size_t points)
{
  if (index < 0 || static_cast<std::size_t>(index) >= points)
    throw Exception(
        "index ", index, " is outside of the input cloud of ", points, " points");
}

/** \brief The same for all indices. PCL's own classes read outside of the cloud.
 * \throws InitFailedException naming the first one that is not \ingroup core */
inline void
requireIndices(const Indices& indices, std::size_t points)
{
  for (const index_t index : indices)
    requireIndex(index, points);
}

/** \brief Checks the input of a class.
 * \param[in] input the cloud that was set
 * \param[in] indices the indices that were set, nullptr for the whole cloud
 * \throws InitFailedException naming the fault \ingroup core */
template <typename PointT>
void
requireInput(const typename PointCloud<PointT>::ConstPtr& input, const Indices* indices)
{
  requireCloud(input);
  if (indices)
    requireIndices(*indices, input->size());
}

/** \brief Rejects a cloud that is no picture.
 * \throws UnorganizedPointCloudException always \ingroup core */
[[noreturn]] inline void
refuseUnorganized()
{
  throw Unorganized("the cloud is not organized: give a view as rows of pixels");
}

} // namespace pcl::acmap
