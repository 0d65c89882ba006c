#pragma once

#include <pcl/core/arguments.h>
#include <pcl/core/point_fields.h>
#include <pcl/texture/plane_texturing.h>
#include <pcl/texture/texturing_kernel.h>

namespace pcl {

template <typename PointT>
void
PlaneTexturing<PointT>::addObservation(const PointCloudConstPtr& cloud,
                                       const Eigen::Isometry3d& T_map_camera)
{
  if (!cloud)
    throw BadArgumentException("an observation needs a cloud");
  constexpr double rounding = 1e-4;
  if (!T_map_camera.matrix().allFinite() ||
      !T_map_camera.linear().isUnitary(rounding) ||
      T_map_camera.linear().determinant() < 0)
    throw BadArgumentException("the pose of an observation is no rigid motion");
  // poses multiplied in float are not orthonormal to the precision that the files
  // require
  Eigen::Isometry3d pose = T_map_camera;
  pose.linear() =
      Eigen::Quaterniond(T_map_camera.linear()).normalized().toRotationMatrix();
  observations_.push_back({cloud, pose});
}

template <typename PointT>
void
PlaneTexturing<PointT>::setTexelSize(double metres)
{
  acmap::requireInRange("texel size", metres, 1e-4, 10, "m");
  texel_size_ = metres;
}

template <typename PointT>
void
PlaneTexturing<PointT>::setMaximumDistance(double metres)
{
  acmap::requireInRange("maximum distance", metres, 1e-6, 1e3, "m");
  maximum_distance_ = metres;
}

template <typename PointT>
void
PlaneTexturing<PointT>::setMaximumTextureSize(int texels)
{
  acmap::requireInRange("maximum texture size", texels, 16, 65500, "texels");
  maximum_texture_size_ = texels;
}

template <typename PointT>
void
PlaneTexturing<PointT>::setFillDistance(int texels)
{
  acmap::requireInRange("fill distance", texels, 0, 1000, "texels");
  fill_distance_ = texels;
}

template <typename PointT>
void
PlaneTexturing<PointT>::texture(CompactMap& map)
{
  if (!has_planes_)
    PCL_THROW_EXCEPTION(InitFailedException, "no planes were set");
  acmap::TexturingSettings settings;
  settings.texel_size = texel_size_;
  settings.maximum_distance = maximum_distance_;
  settings.maximum_texture_size = maximum_texture_size_;
  settings.fill_distance = fill_distance_;
  settings.correct_exposure = correct_exposure_;
  settings.threads = threads_;
  const acmap::Progress progress(progress_);
  acmap::TextureBuilder builder(planes_, settings);
  for (std::size_t i = 0; i < observations_.size(); ++i) {
    progress.tell(0.9 * static_cast<double>(i) /
                      static_cast<double>(observations_.size()),
                  "views");
    const PointCloud<PointT>& cloud = *observations_[i].cloud;
    acmap::ColoredView view;
    view.points = acmap::PointView(
        cloud.empty() ? nullptr : &cloud.front().x, sizeof(PointT), cloud.size());
    view.colors = acmap::colorsOf(cloud);
    view.width = cloud.height > 1 ? static_cast<int>(cloud.width) : 0;
    view.has_eye = cloud.height > 1;
    view.T_map_camera = observations_[i].T_map_camera;
    builder.add(view);
  }
  TexturingReport report;
  CompactMap result =
      builder.finish(acmap::Progress([&](double share, const std::string& step) {
                       progress.tell(0.9 + 0.1 * share, step);
                       return true;
                     }),
                     report);
  for (std::size_t i = 0; i < observations_.size(); ++i) {
    result.trajectory.stamps.push_back(static_cast<double>(i));
    result.trajectory.poses.push_back(observations_[i].T_map_camera);
  }
  map = std::move(result);
  report_ = std::move(report);
}

} // namespace pcl

#define PCL_INSTANTIATE_PlaneTexturing(T) \
  template class ACMAP_EXPORT pcl::PlaneTexturing<T>;
