#pragma once

#include <pcl/PCLPointField.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/core/impl/point_fields.h>
#include <pcl/texture/impl/texturing_kernel.h>
#include <pcl/texture/plane_texturing.h>

namespace pcl {

namespace acmap {

template <typename PointT>
ColoredView
viewOfCloud(const PointCloud<PointT>& cloud, const Eigen::Isometry3d& T_map_camera)
{
  ColoredView view;
  view.points = pointsOf(cloud);
  view.colors = colorsOf(cloud);
  if constexpr (traits::has_field<PointT, fields::intensity>::value)
    if (!cloud.empty())
      view.intensities = {
          &cloud.front().intensity, sizeof(PointT), PCLPointField::FLOAT32};
  view.width = cloud.height > 1 ? static_cast<int>(cloud.width) : 0;
  view.has_eye = cloud.height > 1;
  view.T_map_camera = T_map_camera;
  return view;
}

} // namespace acmap

template <typename PointT>
void
PlaneTexturing<PointT>::addObservation(const PointCloudConstPtr& cloud,
                                       const acmap::RigidMotion& T_map_camera)
{
  acmap::requireCloud<acmap::BadArgument>(cloud);
  observations_.push_back({cloud, acmap::requirePlace(T_map_camera), {}, {}});
}

template <typename PointT>
void
PlaneTexturing<PointT>::addObservationLoader(TexturedObservationLoader load)
{
  if (!load)
    throw acmap::BadArgument("an observation needs a loader");
  observations_.push_back(
      {nullptr, Eigen::Isometry3d::Identity(), std::move(load), {}});
}

template <typename PointT>
void
PlaneTexturing<PointT>::addPaintedObservations(acmap::PaintedObservations next)
{
  if (!next)
    throw acmap::BadArgument("painted observations need a source");
  observations_.push_back(
      {nullptr, Eigen::Isometry3d::Identity(), {}, std::move(next)});
}

template <typename PointT>
void
PlaneTexturing<PointT>::setTexelSize(double metres)
{
  if (metres != 0)
    acmap::requireInRange("texel size", metres, 1e-4, 10, "m, or 0 (automatic)");
  settings_.texel_size = metres;
}

template <typename PointT>
void
PlaneTexturing<PointT>::setMaximumDistance(double metres)
{
  acmap::requireInRange("maximum distance", metres, 1e-6, 1e3, "m");
  settings_.maximum_distance = metres;
}

template <typename PointT>
void
PlaneTexturing<PointT>::setMaximumTextureSize(int texels)
{
  acmap::requireInRange("maximum texture size", texels, 16, 65500, "texels");
  settings_.maximum_texture_size = texels;
}

template <typename PointT>
void
PlaneTexturing<PointT>::setFillDistance(int texels)
{
  acmap::requireInRange("fill distance", texels, -1, 1000, "texels, -1: automatic");
  settings_.fill_distance = texels;
}

template <typename PointT>
acmap::TexturingSettings
PlaneTexturing<PointT>::settings() const
{
  acmap::TexturingSettings settings = settings_;
  settings.threads = threads_;
  return settings;
}

template <typename PointT>
double
PlaneTexturing<PointT>::estimateMemory() const
{
  return acmap::texturingMemory(planes_, cylinders_, settings());
}

template <typename PointT>
void
PlaneTexturing<PointT>::texture(CompactMap& map)
{
  if (!has_planes_)
    throw acmap::InitFailed("no planes were set");
  const acmap::Progress progress(progress_);
  acmap::TextureBuilder builder(planes_, cylinders_, settings());
  Trajectory trajectory;
  bool has_poses = true;
  for (std::size_t i = 0; i < observations_.size(); ++i) {
    progress.tell(0.9 * static_cast<double>(i) /
                      static_cast<double>(observations_.size()),
                  "painting");
    const Observation& observation = observations_[i];
    if (observation.painted) {
      while (std::optional<acmap::ByteParcel> parcel = observation.painted())
        builder.join(*parcel, trajectory);
    }
    else if (!observation.load) {
      builder.add(acmap::viewOfCloud(*observation.cloud, observation.T_map_camera));
      trajectory.stamps.push_back(static_cast<double>(i));
      trajectory.poses.push_back(observation.T_map_camera);
    }
    else if (std::optional<TexturedObservation> loaded = observation.load()) {
      loaded->T_map_camera = acmap::RigidMotion(loaded->T_map_camera);
      builder.add(acmap::viewOfObservation(*loaded));
      has_poses = has_poses && loaded->has_sensor;
      trajectory.stamps.push_back(loaded->stamp);
      trajectory.poses.push_back(loaded->T_map_camera);
    }
  }
  TexturingReport report;
  CompactMap result =
      builder.finish(acmap::Progress([&](double share, const std::string& step) {
                       progress.tell(0.9 + 0.1 * share, step);
                       return true;
                     }),
                     report);
  if (has_poses)
    result.trajectory = std::move(trajectory);
  else
    for (std::vector<std::int32_t>& seen : result.observations)
      seen.clear(); // they number poses, and there are none
  map = std::move(result);
  report_ = std::move(report);
}

} // namespace pcl

#define PCL_INSTANTIATE_PlaneTexturing(T) \
  template class ACMAP_EXPORT pcl::PlaneTexturing<T>;
