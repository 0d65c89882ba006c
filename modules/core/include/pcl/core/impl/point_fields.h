#pragma once

#include <pcl/core/impl/point_view.h>
#include <pcl/core/impl/voxel_moments.h>
#include <pcl/core/point_types.h>
#include <pcl/core/sensor_view.h>
#include <pcl/point_cloud.h>
#include <pcl/type_traits.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Has the point type a packed colour `rgb` or `rgba`? */
template <typename PointT>
inline constexpr bool has_color = traits::has_field<PointT, fields::rgb>::value ||
                                  traits::has_field<PointT, fields::rgba>::value;

template <typename PointT>
inline constexpr bool has_normal = traits::has_field<PointT, fields::normal_x>::value;

template <typename PointT>
inline constexpr bool has_curvature =
    traits::has_field<PointT, fields::curvature>::value;

/** \brief Has the point type a field `view` with the observation that saw it? */
template <typename PointT>
inline constexpr bool has_view = traits::has_field<PointT, fields::view>::value;

/** \brief View of the coordinates of a cloud, valid as long as the cloud is unchanged.
 * \param[in] chosen indices of points, nullptr for all */
template <typename PointT>
PointView
pointsOf(const PointCloud<PointT>& cloud,
         const std::vector<std::int32_t>* chosen = nullptr)
{
  return {cloud.empty() ? nullptr : &cloud.front().x,
          sizeof(PointT),
          chosen ? chosen->size() : cloud.size(),
          chosen ? chosen->data() : nullptr};
}

/** \brief View of the normals of a cloud; empty if PointT has none. */
template <typename PointT>
PointView
normalsOf(const PointCloud<PointT>& cloud)
{
  if constexpr (has_normal<PointT>)
    if (!cloud.empty())
      return {&cloud.front().normal_x, sizeof(PointT), cloud.size()};
  return {};
}

/** \brief Returns the colours of a cloud; empty if PointT has none. */
template <typename PointT>
ColorView
colorsOf(const PointCloud<PointT>& cloud)
{
  if constexpr (has_color<PointT>) {
    if (!cloud.empty())
      return {&cloud.front().rgba, sizeof(PointT)};
  }
  return {};
}

/** \brief Returns the sensor positions of the points of a cloud: the viewpoint given by
 * their field `view`, or the sensor of the cloud if PointT has no such field. */
template <typename PointT>
SensorView
sensorsOf(const PointCloud<PointT>& cloud,
          const Indices& indices,
          const std::vector<Eigen::Vector3f>& viewpoints)
{
  if constexpr (has_view<PointT>)
    return SensorView(cloud.empty() ? nullptr : &cloud.front().view,
                      sizeof(PointT),
                      viewpoints,
                      indices.data());
  else
    return SensorView(Eigen::Vector3f(cloud.sensor_origin_.template head<3>()));
}

/** \brief As above, for a whole cloud. */
template <typename PointT>
SensorView
sensorsOf(const PointCloud<PointT>& cloud,
          const std::vector<Eigen::Vector3f>& viewpoints)
{
  if constexpr (has_view<PointT>)
    return SensorView(
        cloud.empty() ? nullptr : &cloud.front().view, sizeof(PointT), viewpoints);
  else
    return SensorView(Eigen::Vector3f(cloud.sensor_origin_.template head<3>()));
}

/** \brief As \ref sensorsOf for a whole cloud, but unknown if PointT has no field
 * `view` or no viewpoints are given: the faces of a mesh with a consistent orientation
 * should not be turned towards a sensor that was not specified. */
template <typename PointT>
SensorView
namedSensorsOf(const PointCloud<PointT>& cloud,
               const std::vector<Eigen::Vector3f>& viewpoints)
{
  if constexpr (has_view<PointT>)
    if (!cloud.empty() && !viewpoints.empty())
      return SensorView(&cloud.front().view, sizeof(PointT), viewpoints);
  return {};
}

template <typename PointT>
void
setNormal(PointT& point, const Eigen::Vector3f& normal, float curvature)
{
  if constexpr (has_normal<PointT>)
    point.getNormalVector3fMap() = normal;
  if constexpr (has_curvature<PointT>)
    point.curvature = curvature;
}

/** \param[in] color red, green, blue */
template <typename PointT>
void
setColor(PointT& point, const std::array<std::uint8_t, 3>& color)
{
  if constexpr (has_color<PointT>) {
    point.r = color[0];
    point.g = color[1];
    point.b = color[2];
  }
}

} // namespace pcl::acmap
