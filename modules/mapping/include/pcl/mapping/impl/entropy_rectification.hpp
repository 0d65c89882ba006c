#pragma once

#include <pcl/common/transforms.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/point_fields.h>
#include <pcl/core/planar_pose.h>
#include <pcl/mapping/entropy_rectification.h>
#include <pcl/mapping/impl/map_entropy_kernel.h>
#include <pcl/mapping/impl/plane_adjustment_kernel.h>

namespace pcl {
namespace acmap {

template <typename PointT>
LevelledPoints
levelled(const PointCloud<PointT>& cloud,
         const Eigen::Isometry3d& T_map_camera,
         const std::vector<float>& weights)
{
  return levelledPoints(pointsOf(cloud), normalsOf(cloud), T_map_camera, weights);
}

} // namespace acmap

template <typename PointT>
std::size_t
EntropyRectification<PointT>::addPointCloud(const PointCloudConstPtr& cloud,
                                            const Eigen::Isometry3d& pose,
                                            const std::vector<float>& weights)
{
  if (!cloud)
    throw BadArgumentException("an observation needs a cloud");
  acmap::requireMapPose(pose);
  acmap::requirePointWeights(weights, cloud->size());
  clouds_.push_back(cloud);
  weights_.push_back(weights);
  given_.push_back(pose);
  poses_.push_back(pose);
  return poses_.size() - 1;
}

template <typename PointT>
void
EntropyRectification<PointT>::setPose(std::size_t number, const Eigen::Isometry3d& pose)
{
  acmap::requireObservation(number, poses_.size());
  acmap::requireMapPose(pose);
  given_[number] = pose;
  poses_[number] = pose;
}

template <typename PointT>
const Eigen::Isometry3d&
EntropyRectification<PointT>::getPose(std::size_t number) const
{
  acmap::requireObservation(number, poses_.size());
  return poses_[number];
}

template <typename PointT>
void
EntropyRectification<PointT>::clear()
{
  clouds_.clear();
  weights_.clear();
  given_.clear();
  poses_.clear();
}

template <typename PointT>
void
EntropyRectification<PointT>::setBinSize(double metres)
{
  acmap::requireInRange("bin size", metres, 0.001, 25, "m");
  settings_.bin_size = metres;
}

template <typename PointT>
void
EntropyRectification<PointT>::setEntropyWeight(double factor)
{
  acmap::requireInRange("entropy weight", factor, 1e-3, 1e3, "(no unit)");
  settings_.entropy_weight = factor;
}

template <typename PointT>
void
EntropyRectification<PointT>::setProjectionWeight(double mu)
{
  acmap::requireInRange("projection weight mu", mu, 0, 1000, "(no unit)");
  settings_.projection_weight = mu;
}

template <typename PointT>
void
EntropyRectification<PointT>::setSmoothing(double metres)
{
  acmap::requireInRange("smoothing sigma_XZ", metres, 0, 1000, "m");
  settings_.smoothing = metres;
}

template <typename PointT>
void
EntropyRectification<PointT>::setOdometryNoise(const OdometryNoise& noise)
{
  acmap::requireOdometryNoise(noise);
  settings_.odometry = noise;
  has_odometry_noise_ = true;
}

template <typename PointT>
void
EntropyRectification<PointT>::setUpDirection(const Eigen::Vector3d& up)
{
  up_ = acmap::requiredDirection(up);
}

template <typename PointT>
void
EntropyRectification<PointT>::compute()
{
  if (clouds_.empty())
    PCL_THROW_EXCEPTION(InitFailedException, "no point cloud was added");
  EntropyRectificationReport report;
  acmap::StepTimer timer(report);
  std::vector<acmap::LevelledPoints> observations(clouds_.size());
  std::vector<PlanarPose> poses;
  const Eigen::Quaterniond upright = acmap::uprightRotation(up_);
  std::vector<Eigen::Isometry3d> given;
  for (const Eigen::Isometry3d& pose : given_) {
    given.push_back(upright * pose);
    poses.push_back(planarPartOf(given.back()));
  }
  acmap::withThreads(threads_, [&] {
    oneapi::tbb::parallel_for(std::size_t{0}, clouds_.size(), [&](std::size_t i) {
      observations[i] = acmap::levelled(*clouds_[i], given[i], weights_[i]);
    });
    timer.finish("level");
    poses = acmap::rectify(
        observations, poses, settings_, acmap::Progress(progress_), report);
  });
  timer.finish("search");
  const bool is_new = report.outcome == RectificationOutcome::Rectified;
  for (std::size_t i = 0; i < given_.size(); ++i)
    poses_[i] =
        is_new ? upright.inverse() * isometryOf(poses[i]) * acmap::levelOf(given[i])
               : given_[i];
  report_ = std::move(report);
}

template <typename PointT>
Eigen::Affine3f
EntropyRectification<PointT>::getTransformation(std::size_t number) const
{
  return Eigen::Affine3f(getPose(number).template cast<float>().matrix());
}

template <typename PointT>
typename EntropyRectification<PointT>::PointCloudPtr
EntropyRectification<PointT>::getTransformedCloud(std::size_t number) const
{
  const Eigen::Affine3f pose = getTransformation(number);
  PointCloudPtr result(new PointCloud);
  if constexpr (acmap::has_normal<PointT>)
    transformPointCloudWithNormals(*clouds_[number], *result, pose);
  else
    transformPointCloud(*clouds_[number], *result, pose);
  return result;
}

template <typename PointT>
typename EntropyRectification<PointT>::PointCloudPtr
EntropyRectification<PointT>::getConcatenatedCloud() const
{
  PointCloudPtr result(new PointCloud);
  for (std::size_t i = 0; i < clouds_.size(); ++i)
    *result += *getTransformedCloud(i);
  return result;
}

} // namespace pcl

#define PCL_INSTANTIATE_EntropyRectification(T) \
  template class ACMAP_EXPORT pcl::EntropyRectification<T>;
