#include "pcl_planes.h"

#include "region_planes.h"

#include <pcl/ModelCoefficients.h>
#include <pcl/PointIndices.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <algorithm>
#include <memory>
#include <numeric>

namespace pcl::acmap::bench {
namespace {

SACSegmentation<PointXYZ>
makeSegmentation(const PlaneInput& input)
{
  constexpr int max_iterations = 1000; // PCL's 50 miss planes with less than a quarter
                                       // of the points
  SACSegmentation<PointXYZ> sac;
  sac.setModelType(SACMODEL_PLANE);
  sac.setMethodType(SAC_RANSAC);
  sac.setMaxIterations(max_iterations);
  sac.setDistanceThreshold(input.tolerance);
  sac.setOptimizeCoefficients(true);
  sac.setInputCloud(input.points);
  return sac;
}

void
takeAway(Indices& from, const std::vector<bool>& is_taken)
{
  const auto is_gone = [&](index_t i) { return is_taken[static_cast<std::size_t>(i)]; };
  from.erase(std::remove_if(from.begin(), from.end(), is_gone), from.end());
}

std::vector<Indices>
segmentIterated(const PlaneInput& input)
{
  std::vector<Indices> planes;
  SACSegmentation<PointXYZ> sac = makeSegmentation(input);
  const auto left = std::make_shared<Indices>(input.points->size());
  std::iota(left->begin(), left->end(), 0);
  std::vector<bool> is_taken(input.points->size());
  while (left->size() >= input.leastSupport()) {
    PointIndices inliers;
    ModelCoefficients coefficients;
    sac.setIndices(left);
    sac.segment(inliers, coefficients);
    if (inliers.indices.size() < input.leastSupport())
      break;
    for (const index_t i : inliers.indices)
      is_taken[static_cast<std::size_t>(i)] = true;
    takeAway(*left, is_taken);
    planes.push_back(std::move(inliers.indices));
  }
  return planes;
}

} // namespace

FoundPlanes
sacPlanes(const PlaneInput& input)
{
  return timedPlanes([&] { return planesOfRegions(input, segmentIterated(input)); });
}

} // namespace pcl::acmap::bench
