#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/length_remarks.h>
#include <pcl/core/planar_pose.h>
#include <pcl/mapping/entropy_rectification.h>
#include <pcl/mapping/impl/levelled_clouds.h>
#include <pcl/mapping/impl/plane_adjustment_kernel.h>

namespace pcl {
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
  settings_.is_odometry_stated = true;
}

template <typename PointT>
void
EntropyRectification<PointT>::setUpDirection(const Eigen::Vector3d& up)
{
  up_ = acmap::requiredDirection(up);
}

template <typename PointT>
std::vector<acmap::ObservedSurface>
EntropyRectification<PointT>::surfaces() const
{
  std::vector<acmap::ObservedSurface> surfaces;
  if (up_)
    return surfaces;
  surfaces.resize(this->given_.size());
  acmap::withThreads(this->threads_, [&] {
    oneapi::tbb::parallel_for(std::size_t{0}, surfaces.size(), [&](std::size_t i) {
      const auto cloud = this->loaders_[i]();
      surfaces[i] = acmap::observedSurface(
          acmap::pointsOf(*cloud), acmap::normalsOf(*cloud), this->weights_[i]);
    });
  });
  return surfaces;
}

template <typename PointT>
void
EntropyRectification<PointT>::compute()
{
  if (this->poses_.empty())
    throw acmap::InitFailed("no point cloud was added");
  EntropyRectificationReport report;
  acmap::StepTimer timer(report);
  acmap::addRemarks(report,
                    acmap::lengthRemarks(acmap::pointsOf(*this->loaders_.front()())));
  const Eigen::Quaterniond upright =
      uprightRotation(acmap::verticalOf(surfaces(), this->given_, up_, report));
  acmap::LevelledClouds level;
  std::vector<PlanarPose> poses;
  acmap::withThreads(this->threads_, [&] {
    level =
        acmap::levelledClouds(this->loaders_, this->weights_, this->given_, upright);
    timer.finish("level");
    poses = acmap::rectify(level.observations,
                           level.poses,
                           settings_,
                           acmap::Progress(this->progress_),
                           report);
  });
  timer.finish("search");
  const bool is_new = report.outcome == RectificationOutcome::Rectified;
  for (std::size_t i = 0; i < this->given_.size(); ++i)
    this->poses_[i] = is_new ? upright.inverse() * isometryOf(poses[i]) *
                                   acmap::levelOf(level.given[i])
                             : this->given_[i];
  this->report_ = std::move(report);
}

} // namespace pcl

#define PCL_INSTANTIATE_EntropyRectification(T)                       \
  PCL_INSTANTIATE_RegisteringFilter(                                  \
      T, pcl::EntropyRectificationReport) template class ACMAP_EXPORT \
      pcl::EntropyRectification<T>;
