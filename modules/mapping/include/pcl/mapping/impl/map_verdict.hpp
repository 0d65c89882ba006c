#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/planar_pose.h>
#include <pcl/mapping/impl/levelled_clouds.h>
#include <pcl/mapping/impl/plane_adjustment_kernel.h>
#include <pcl/mapping/map_verdict.h>

namespace pcl {

template <typename PointT>
void
MapVerdict<PointT>::setJudgedPoses(const std::vector<Eigen::Isometry3d>& poses)
{
  for (const Eigen::Isometry3d& pose : poses)
    acmap::checkedPose(pose);
  judged_ = poses;
}

template <typename PointT>
void
MapVerdict<PointT>::setOdometryNoise(const OdometryNoise& noise)
{
  acmap::requireOdometryNoise(noise);
  odometry_ = noise;
}

template <typename PointT>
void
MapVerdict<PointT>::setUpDirection(const Eigen::Vector3d& up)
{
  up_ = acmap::requiredDirection(up);
}

template <typename PointT>
void
MapVerdict<PointT>::compute()
{
  if (this->given_.empty())
    throw acmap::InitFailed("no point cloud was added");
  if (!judged_.empty() && judged_.size() != this->given_.size())
    throw acmap::BadArgument("each observation needs one pose to be judged");
  MapVerdictReport report;
  acmap::StepTimer timer(report);
  acmap::withThreads(this->threads_, [&] {
    const acmap::LevelledClouds level = acmap::levelledClouds(
        this->loaders_, this->weights_, this->given_, uprightRotation(up_));
    std::vector<PlanarPose> judged = level.poses;
    for (std::size_t i = 0; i < judged_.size(); ++i)
      judged[i] = planarPartOf(uprightRotation(up_) * judged_[i]);
    timer.finish("level");
    acmap::judgeMap(level.observations,
                    level.poses,
                    judged,
                    odometry_,
                    seed_,
                    acmap::Progress(this->progress_),
                    report);
  });
  timer.finish("judge");
  this->report_ = std::move(report);
}

} // namespace pcl

#define PCL_INSTANTIATE_MapVerdict(T) \
  PCL_INSTANTIATE_RegisteredClouds(   \
      T, pcl::MapVerdictReport) template class ACMAP_EXPORT pcl::MapVerdict<T>;
