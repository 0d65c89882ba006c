#include "length_check.h"

#include "clouds.h"
#include "exit_code.h"

#include <gtest/gtest.h>

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

} // namespace
} // namespace pcl::acmap
