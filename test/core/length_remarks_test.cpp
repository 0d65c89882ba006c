#include "clouds.h"

#include <pcl/core/impl/length_remarks.h>

#include <gtest/gtest.h>

#include <limits>

namespace pcl::acmap {
namespace {

using test::Cloud;

PointView
viewOf(const Cloud& cloud)
{
  return PointView(cloud.data(), sizeof(PointXYZ), cloud.size());
}

/** A plane 0.4 m wide. */
Cloud
makePlane()
{
  test::SheetSampling sampling;
  sampling.spacing = 0.01;
  return test::makeJitteredPlane(sampling).cloud;
}

TEST(LengthRemarks, SaysNothingOfAnOrdinaryCloud)
{
  EXPECT_TRUE(lengthRemarks(viewOf(makePlane()), 0.01).empty());
}

TEST(LengthRemarks, NamesMillimetresBySpacingAndByExtent)
{
  const Cloud coarse = test::scaled(makePlane(), 1000);
  const auto by_spacing = lengthRemarks(viewOf(coarse), 10);
  ASSERT_EQ(by_spacing.size(), 1u);
  EXPECT_NE(by_spacing[0].find("--scale 0.001"), std::string::npos) << by_spacing[0];

  const Cloud wide = test::scaled(makePlane(), 10000);
  EXPECT_EQ(lengthRemarks(viewOf(wide), 0.1).size(), 1u);
}

TEST(LengthRemarks, NamesAFarPointButDoesNotTakeItForMillimetres)
{
  const Cloud cloud = test::withOutlier(makePlane(), 1e9F);
  const auto remarks = lengthRemarks(viewOf(cloud), 0.01);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].find("one point lies far away"), std::string::npos)
      << remarks[0];
}

TEST(LengthRemarks, NamesLengthsThatNoBuildingHas)
{
  const Cloud vast = test::scaled(makePlane(), 1e30F);
  const auto remarks = lengthRemarks(viewOf(vast), 1e28);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].find("cannot be metres"), std::string::npos) << remarks[0];
}

TEST(LengthRemarks, NamesPlacesThatFloatsAreTooCoarseFor)
{
  const auto at = [](double place) {
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    motion.translation().y() = place;
    return lengthRemarks(viewOf(test::moved(makePlane(), motion)), 0.01);
  };
  EXPECT_TRUE(at(8000).empty());
  const auto remarks = at(5e6);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].find("take an offset off"), std::string::npos) << remarks[0];
}

TEST(LengthRemarks, SurvivesCloudsWithoutExtent)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Cloud invalid;
  invalid.resize(5, PointXYZ(nan, nan, nan));
  EXPECT_TRUE(lengthRemarks(viewOf(invalid)).empty());
  EXPECT_TRUE(lengthRemarks(viewOf(Cloud())).empty());
  EXPECT_TRUE(lengthRemarks(viewOf(test::makeCoincident(100))).empty());
  EXPECT_EQ(cloudExtent(viewOf(invalid)).finite_points, 0u);
}

} // namespace
} // namespace pcl::acmap
