#pragma once

#include "rectification_worlds.h"

#include <pcl/mapping/entropy_rectification.h>

#include <gtest/gtest.h>

#include <cstring>

namespace pcl::acmap::test {

using Rectification = EntropyRectification<PointNormal>;

inline Rectification
rectificationOf(const PosedClouds& map, const std::vector<PlanarPose>& poses)
{
  Rectification rectification;
  for (std::size_t i = 0; i < map.clouds.size(); ++i)
    rectification.addPointCloud(map.clouds[i], isometryOf(poses[i]));
  return rectification;
}

inline std::vector<PlanarPose>
planarPosesOf(const Rectification& rectification)
{
  std::vector<PlanarPose> poses;
  for (std::size_t i = 0; i < rectification.getNumberOfPointClouds(); ++i)
    poses.push_back(planarPartOf(rectification.getPose(i)));
  return poses;
}

/** \brief Compares bytes, not values. */
inline bool
haveSamePoses(const Rectification& a, const Rectification& b)
{
  if (a.getNumberOfPointClouds() != b.getNumberOfPointClouds())
    return false;
  for (std::size_t i = 0; i < a.getNumberOfPointClouds(); ++i)
    if (std::memcmp(a.getPose(i).data(), b.getPose(i).data(), 16 * sizeof(double)) != 0)
      return false;
  return true;
}

/** \brief Are the poses equal to the given ones, byte by byte? */
inline bool
isUntouched(const Rectification& rectification, const std::vector<PlanarPose>& given)
{
  for (std::size_t i = 0; i < given.size(); ++i)
    if (rectification.getPose(i).matrix() != isometryOf(given[i]).matrix())
      return false;
  return true;
}

inline double
largestOf(const std::vector<double>& values)
{
  double largest = 0;
  for (const double value : values)
    largest = std::max(largest, value);
  return largest;
}

/** \brief Checks that the report is complete for any outcome of a run. */
inline void
expectWholeReport(const Rectification& rectification)
{
  const EntropyRectificationReport& report = rectification.getReport();
  const std::size_t size = rectification.getNumberOfPointClouds();
  EXPECT_FALSE(report.reason.empty());
  EXPECT_EQ(report.reason.find('\n'), std::string::npos);
  EXPECT_EQ(report.observations, size);
  EXPECT_EQ(report.moved.size(), size);
  EXPECT_EQ(report.turned.size(), size);
  EXPECT_FALSE(report.seconds.empty());
  for (const MapEvidence& evidence : {report.before, report.after})
    for (const double share : {evidence.near_contradictions,
                               evidence.far_contradictions,
                               evidence.near_rays}) {
      EXPECT_GE(share, 0);
      EXPECT_LE(share, 2);
    }
  if (report.outcome != RectificationOutcome::Rectified) {
    EXPECT_EQ(largestOf(report.moved), 0);
    EXPECT_EQ(largestOf(report.turned), 0);
  }
}

} // namespace pcl::acmap::test
