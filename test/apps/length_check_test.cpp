#include "length_check.h"

#include "clouds.h"
#include "exit_code.h"

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

TEST(LengthCheck, SaysNothingOfAnOrdinaryCloud)
{
  EXPECT_TRUE(lengthRemarks(viewOf(makePlane()), 0.01, 1).empty());
}

TEST(LengthCheck, NamesMillimetresBySpacingAndByExtent)
{
  const Cloud coarse = test::scaled(makePlane(), 1000);
  const auto by_spacing = lengthRemarks(viewOf(coarse), 10, 1);
  ASSERT_EQ(by_spacing.size(), 1u);
  EXPECT_NE(by_spacing[0].find("--scale 0.001 "), std::string::npos) << by_spacing[0];

  const Cloud wide = test::scaled(makePlane(), 10000);
  EXPECT_EQ(lengthRemarks(viewOf(wide), 0.1, 1).size(), 1u);
}

TEST(LengthCheck, AdviceBuildsOnTheScaleInUse)
{
  const auto remarks = lengthRemarks(viewOf(makePlane()), 10, 0.01);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].find("--scale 1e-05 "), std::string::npos) << remarks[0];
}

TEST(LengthCheck, NamesAFarPointButDoesNotTakeItForMillimetres)
{
  const Cloud cloud = test::withOutlier(makePlane(), 1e9F);
  const auto remarks = lengthRemarks(viewOf(cloud), 0.01, 1);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].find("one point lies far away"), std::string::npos)
      << remarks[0];
}

TEST(LengthCheck, NamesLengthsThatNoBuildingHas)
{
  const Cloud vast = test::scaled(makePlane(), 1e30F);
  const auto remarks = lengthRemarks(viewOf(vast), 1e28, 1);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].find("cannot be metres"), std::string::npos) << remarks[0];
}

TEST(LengthCheck, NamesPlacesThatFloatsAreTooCoarseFor)
{
  const auto at = [](double place) {
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    motion.translation().y() = place;
    return lengthRemarks(viewOf(test::moved(makePlane(), motion)), 0.01, 1);
  };
  EXPECT_TRUE(at(8000).empty());
  const auto remarks = at(5e6);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].find("take an offset off"), std::string::npos) << remarks[0];
}

/** The warnings about a voxel size; the message of the exception if it is refused. */
std::string
saidOf(double voxel, const Cloud& cloud)
{
  StageLog log;
  requireFineLength("--consolidate", voxel, viewOf(cloud), log);
  return log.report.remarks.empty() ? "" : log.report.remarks.front();
}

TEST(LengthCheck, RefusesLengthsBeyondTheCloudAndSuggestsMillimetres)
{
  const Cloud room = test::scaled(makePlane(), 10); // 4 m
  EXPECT_EQ(saidOf(0.03, room), "");
  EXPECT_EQ(saidOf(0, room), "") << "automatic";
  try {
    saidOf(30, room);
    FAIL() << "was not refused";
  }
  catch (const UsageError& e) {
    const std::string text = e.what();
    EXPECT_EQ(text.rfind("--consolidate 30:", 0), 0u) << text;
    EXPECT_NE(text.find("for 30 mm give 0.03"), std::string::npos) << text;
  }
}

TEST(LengthCheck, WarnsOfLengthsThatLeaveFewParts)
{
  const Cloud room = test::scaled(makePlane(), 10);
  EXPECT_NE(saidOf(2, room).find("for 2 mm give 0.002"), std::string::npos);
  EXPECT_EQ(saidOf(2, test::makeCoincident(100)), "") << "nothing to compare with";
  EXPECT_THROW(saidOf(2000, room), UsageError);
  EXPECT_NO_THROW(saidOf(2, test::withOutlier(room, 1e9F)));
}

TEST(LengthCheck, SurvivesCloudsWithoutExtent)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Cloud invalid;
  invalid.resize(5, PointXYZ(nan, nan, nan));
  EXPECT_TRUE(lengthRemarks(viewOf(invalid), 0, 1).empty());
  EXPECT_TRUE(lengthRemarks(viewOf(Cloud()), 0, 1).empty());
  EXPECT_TRUE(lengthRemarks(viewOf(test::makeCoincident(100)), 0, 1).empty());
  EXPECT_EQ(cloudExtent(viewOf(invalid)).finite_points, 0u);
}

} // namespace
} // namespace pcl::acmap
