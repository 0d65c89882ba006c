#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/mapping/impl/posed_clouds.h>
#include <pcl/mapping/map_entropy.h>

#include <algorithm>
#include <iterator>
#include <string>

namespace pcl {

template <typename PointT>
std::size_t
MapEntropy<PointT>::addPointCloud(const PointCloudConstPtr& cloud,
                                  const PlanarPose& pose,
                                  const std::vector<float>& weights)
{
  const std::size_t number = Base::addPointCloud(cloud, pose, weights);
  evaluator_.reset();
  return number;
}

template <typename PointT>
void
MapEntropy<PointT>::clear()
{
  Base::clear();
  cells_.clear();
  evaluator_.reset();
}

template <typename PointT>
void
MapEntropy<PointT>::setBinSize(double metres)
{
  acmap::requireInRange("bin size", metres, 0.001, 100, "m");
  if (metres != settings_.bin_size)
    cells_.clear();
  settings_.bin_size = metres;
  evaluator_.reset();
}

template <typename PointT>
void
MapEntropy<PointT>::setSmoothing(double metres)
{
  acmap::requireInRange("smoothing sigma_XZ", metres, 0, 1000, "m");
  settings_.smoothing = metres;
  evaluator_.reset();
}

template <typename PointT>
void
MapEntropy<PointT>::setProjectionWeight(double mu)
{
  acmap::requireInRange("projection weight mu", mu, 0, 1000, "(no unit)");
  settings_.projection_weight = mu;
  evaluator_.reset();
}

template <typename PointT>
void
MapEntropy<PointT>::setDirectionAware(bool aware)
{
  if (aware != settings_.direction_aware)
    cells_.clear();
  settings_.direction_aware = aware;
  evaluator_.reset();
}

template <typename PointT>
acmap::PosedPoints
MapEntropy<PointT>::viewOf(std::size_t number) const
{
  const PointCloud<PointT>& cloud = *this->loaders_[number]();
  acmap::PosedPoints view;
  view.pose = this->poses_[number];
  if (cloud.empty())
    return view;
  view.points = acmap::pointsOf(cloud);
  view.normals = acmap::normalsOf(cloud);
  if (!this->weights_[number].empty())
    view.weights = this->weights_[number].data();
  return view;
}

template <typename PointT>
void
MapEntropy<PointT>::tellEmpty(MapEntropyReport& report) const
{
  for (std::size_t i = 0; i < this->loaders_.size(); ++i)
    if (this->loaders_[i]()->empty())
      report.remarks.push_back("observation " + std::to_string(i) + " has no points");
}

template <typename PointT>
void
MapEntropy<PointT>::makeCells(const acmap::Progress& progress)
{
  constexpr std::size_t batch = 16; // between two calls of the progress
  while (cells_.size() < this->poses_.size()) {
    progress.tell(0.9 * static_cast<double>(cells_.size()) /
                      static_cast<double>(this->poses_.size()),
                  "cells");
    const std::size_t first = cells_.size();
    std::vector<acmap::EntropyCells> more(std::min(batch, this->poses_.size() - first));
    acmap::withThreads(this->threads_, [&] {
      oneapi::tbb::parallel_for(std::size_t{0}, more.size(), [&](std::size_t i) {
        const acmap::PosedPoints view = viewOf(first + i);
        more[i] =
            acmap::aggregateCells(view.points, view.normals, settings_, view.weights);
      });
    });
    std::move(more.begin(), more.end(), std::back_inserter(cells_));
  }
}

template <typename PointT>
MapEntropyTerms
MapEntropy<PointT>::evaluate(std::vector<Eigen::Vector3d>* gradient)
{
  if (this->poses_.empty())
    throw acmap::InitFailed("no point cloud was added");
  const acmap::Progress progress(this->progress_);
  MapEntropyReport report;
  tellEmpty(report);
  acmap::StepTimer timer(report);
  makeCells(progress);
  if (!evaluator_)
    evaluator_.emplace(cells_, settings_);
  timer.finish("cells");
  progress.tell(0.9, "entropy");
  MapEntropyTerms terms;
  acmap::withThreads(this->threads_, [&] {
    terms = evaluator_->evaluate(this->poses_, report, gradient);
  });
  timer.finish("entropy");
  this->report_ = std::move(report);
  return terms;
}

template <typename PointT>
MapEntropyTerms
MapEntropy<PointT>::compute()
{
  return evaluate(nullptr);
}

template <typename PointT>
MapEntropyTerms
MapEntropy<PointT>::computeGradient(std::vector<Eigen::Vector3d>& gradient)
{
  std::vector<Eigen::Vector3d> result;
  const MapEntropyTerms terms = evaluate(&result);
  gradient = std::move(result);
  return terms;
}

template <typename PointT>
MapEntropyTerms
MapEntropy<PointT>::computeExact()
{
  if (this->poses_.empty())
    throw acmap::InitFailed("no point cloud was added");
  MapEntropyReport report;
  tellEmpty(report);
  acmap::StepTimer timer(report);
  std::vector<acmap::PosedPoints> views;
  for (std::size_t i = 0; i < this->poses_.size(); ++i)
    views.push_back(viewOf(i));
  MapEntropyTerms terms;
  acmap::withThreads(this->threads_, [&] {
    terms = acmap::exactMapEntropy(
        views, settings_, acmap::Progress(this->progress_), report);
  });
  timer.finish("entropy");
  this->report_ = std::move(report);
  return terms;
}

} // namespace pcl

#define PCL_INSTANTIATE_MapEntropy(T) \
  PCL_INSTANTIATE_PosedClouds(        \
      T,                              \
      pcl::PlanarPose,                \
      pcl::MapEntropyReport) template class ACMAP_EXPORT pcl::MapEntropy<T>;
