#include "consolidation_runs.h"

#include <gtest/gtest.h>

#ifdef ACMAP_FEW_POINT_TYPES
#include <pcl/filters/impl/voxel_consolidation.hpp>
#endif

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {
namespace {

/** A thin wall seen from both sides, a floor and a few isolated points. */
NoisyCloud
makeThinWallScene()
{
  NoisyCloud cloud;
  cloud.viewpoints = {{0.31F, -0.22F, 5.0F}, {0.33F, -0.24F, -4.0F}};
  Random random(61);
  Patch front = squarePatch(1, 0.3);
  Patch back = {front.corner, front.v, front.u};
  front.corner += 0.06 * front.normal();
  back.corner += 0.06 * back.normal();
  cloud.addPatch(front, 8000, 0.01, random, 0);
  cloud.addPatch(back, 8000, 0.01, random, 1);
  cloud.addPatch({{-1, -1, 2.6}, {2, 0, 0}, {0, 2, 0}}, 2000, 0.01, random, 0);
  cloud.points.emplace_back(0, 0, 4);
  cloud.points.emplace_back(NAN, 0, 4);
  cloud.view.resize(cloud.points.size(), 1);
  return cloud;
}

class Sources : public testing::TestWithParam<double> {
protected:
  const NoisyCloud cloud_ = makeThinWallScene();
  const Consolidated found_ = consolidate(cloud_, GetParam());
};

TEST_P(Sources, everyFinitePointIsInOneList)
{
  const auto& [offsets, indices] = found_.sources;
  ASSERT_EQ(offsets.size(), found_.cloud.size() + 1);
  EXPECT_EQ(offsets.front(), 0U);
  EXPECT_EQ(offsets.back(), indices.size());
  ASSERT_EQ(found_.voxel_of_point.size(), cloud_.points.size());
  std::vector<int> lists(cloud_.points.size());
  for (std::size_t i = 0; i < found_.cloud.size(); ++i) {
    ASSERT_LT(offsets[i], offsets[i + 1]) << "a point without a source";
    for (std::size_t k = offsets[i]; k < offsets[i + 1]; ++k) {
      ASSERT_TRUE(k == offsets[i] || indices[k - 1] < indices[k]);
      ++lists[static_cast<std::size_t>(indices[k])];
      ASSERT_EQ(found_.voxel_of_point[static_cast<std::size_t>(indices[k])],
                static_cast<index_t>(i));
    }
  }
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const bool is_finite = cloud_.points[i].allFinite();
    ASSERT_EQ(lists[i], is_finite ? 1 : 0);
    ASSERT_EQ(found_.voxel_of_point[i] >= 0, is_finite);
  }
}

TEST_P(Sources, areNearTheirRepresentativeAndOnItsSide)
{
  std::size_t astray = 0;
  for (std::size_t i = 0; i < cloud_.points.size(); ++i) {
    const index_t of = found_.voxel_of_point[i];
    if (of < 0)
      continue;
    const MapPoint& point = found_.cloud[static_cast<std::size_t>(of)];
    astray += (point.getVector3fMap() - cloud_.points[i]).norm() > 2.5 * GetParam() ||
              point.getNormalVector3fMap().dot(
                  cloud_.viewpoints[static_cast<std::size_t>(cloud_.view[i])] -
                  cloud_.points[i]) < 0;
  }
  EXPECT_LT(static_cast<double>(astray),
            0.01 * static_cast<double>(cloud_.points.size()));
}

TEST_P(Sources, haveARepresentativeNearby)
{
  std::size_t bare = 0;
  for (std::size_t i = 0; i < cloud_.points.size(); i += 7) {
    if (!cloud_.points[i].allFinite())
      continue;
    const auto near = [&](const MapPoint& point) {
      return (point.getVector3fMap() - cloud_.points[i]).norm() < 1.5 * GetParam();
    };
    bare += std::none_of(found_.cloud.begin(), found_.cloud.end(), near);
  }
  EXPECT_EQ(bare, 0U);
}

TEST_P(Sources, giveColorAndView)
{
  const MapCloud::Ptr input = toMapCloud(cloud_);
  const auto& [offsets, indices] = found_.sources;
  std::size_t other_color = 0;
  for (std::size_t i = 0; i < found_.cloud.size(); ++i) {
    Eigen::Vector3d color = Eigen::Vector3d::Zero();
    bool has_view = false;
    for (std::size_t k = offsets[i]; k < offsets[i + 1]; ++k) {
      const MapPoint& source = (*input)[static_cast<std::size_t>(indices[k])];
      color += Eigen::Vector3d(source.r, source.g, source.b);
      has_view |= source.view == found_.cloud[i].view;
    }
    color /= static_cast<double>(offsets[i + 1] - offsets[i]);
    const Eigen::Vector3d own(found_.cloud[i].r, found_.cloud[i].g, found_.cloud[i].b);
    other_color += (color - own).cwiseAbs().maxCoeff() > 0.51;
    EXPECT_TRUE(has_view) << "point " << i;
  }
  EXPECT_EQ(other_color, 0U) << "of " << found_.cloud.size();
}

TEST_P(Sources, pointsOfOneSideKeepTheirDistance)
{
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < found_.cloud.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const MapPoint& a = found_.cloud[i];
      const MapPoint& b = found_.cloud[k];
      pairs += (a.getVector3fMap() - b.getVector3fMap()).norm() < 0.699 * GetParam() &&
               !(a.getNormalVector3fMap().dot(b.getNormalVector3fMap()) < -0.5);
    }
  EXPECT_EQ(pairs, 0U) << "of " << found_.cloud.size() << " points";
}

TEST_P(Sources, areCountedInTheReport)
{
  const ConsolidationReport& report = found_.report;
  EXPECT_EQ(report.points, cloud_.points.size());
  EXPECT_EQ(report.invalid_points, 1U);
  EXPECT_EQ(report.distant_points, 0U);
  EXPECT_EQ(report.representatives, found_.cloud.size());
  EXPECT_EQ(report.voxel_size, GetParam());
  EXPECT_EQ(static_cast<std::size_t>(std::count_if(
                found_.cloud.begin(),
                found_.cloud.end(),
                [](const MapPoint& point) { return std::isnan(point.normal_x); })),
            report.without_normal);
  EXPECT_GE(report.voxels + report.two_sided_voxels, report.representatives);
  EXPECT_NEAR(report.sigma, 0.01, 0.003);
}

INSTANTIATE_TEST_SUITE_P(Consolidation, Sources, testing::Values(0.05, 0.08, 0.15));

TEST(Witness, givesAllOtherFields)
{
  const NoisyCloud cloud = makeThinWallScene();
  PointCloud<PointXYZI>::Ptr input(new PointCloud<PointXYZI>);
  for (const Eigen::Vector3f& place : cloud.points) {
    PointXYZI point;
    point.getVector3fMap() = place;
    point.intensity = static_cast<float>(input->size());
    input->push_back(point);
  }
  input->sensor_origin_ = Eigen::Vector4f(0.3F, -0.2F, 5, 1);
  VoxelConsolidation<PointXYZI> consolidation;
  consolidation.setInputCloud(input);
  consolidation.setVoxelSize(0.08);
  consolidation.setKeepSources(true);
  PointCloud<PointXYZI> output;
  consolidation.filter(output);
  ASSERT_GT(output.size(), 200U);
  const auto& [offsets, indices] = consolidation.getSourceIndices();
  for (std::size_t i = 0; i < output.size(); ++i) {
    const auto begin = indices.begin() + static_cast<std::ptrdiff_t>(offsets[i]);
    const auto end = indices.begin() + static_cast<std::ptrdiff_t>(offsets[i + 1]);
    EXPECT_TRUE(
        std::binary_search(begin, end, static_cast<index_t>(output[i].intensity)));
  }
}

TEST(Indices, referToTheWholeCloud)
{
  const NoisyCloud all = makeThinWallScene();
  NoisyCloud part;
  part.viewpoints = all.viewpoints;
  const auto indices = std::make_shared<Indices>();
  for (std::size_t i = 0; i < all.points.size(); ++i)
    if (i % 3 != 1) {
      indices->push_back(static_cast<index_t>(i));
      part.points.push_back(all.points[i]);
      part.view.push_back(all.view[i]);
    }
  MapConsolidation consolidation;
  consolidation.setInputCloud(toMapCloud(all));
  consolidation.setIndices(indices);
  consolidation.setViewpoints(all.viewpoints);
  consolidation.setVoxelSize(0.08);
  consolidation.setKeepSources(true);
  MapCloud output;
  consolidation.filter(output);
  const Consolidated wanted = consolidate(part, 0.08);
  ASSERT_EQ(output.size(), wanted.cloud.size());
  for (std::size_t i = 0; i < output.size(); ++i) {
    EXPECT_EQ(output[i].getVector3fMap(), wanted.cloud[i].getVector3fMap());
    EXPECT_EQ(output[i].view, wanted.cloud[i].view);
  }
  const Indices& of = consolidation.getVoxelOfPoint();
  ASSERT_EQ(of.size(), all.points.size());
  for (std::size_t i = 0; i < of.size(); ++i)
    EXPECT_TRUE(i % 3 != 1 || of[i] == -1);
  for (std::size_t k = 0; k < indices->size(); ++k)
    EXPECT_EQ(of[static_cast<std::size_t>((*indices)[k])], wanted.voxel_of_point[k]);
  EXPECT_EQ(consolidation.getReport().points, indices->size());
}

} // namespace
} // namespace pcl::acmap::test
