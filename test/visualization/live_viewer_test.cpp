#include "virtual_display.h"

#include <pcl/exceptions.h>
#include <pcl/visualization/live_viewer.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

TrinocularFrame
greyFrame()
{
  TrinocularFrame frame;
  for (CameraImage& image : frame.images)
    image = {4, 3, 1, std::vector<std::uint8_t>(12, 128)};
  return frame;
}

TEST(LiveViewer, ShowsCloudImagesAndPlanUntilTheServerEnds)
{
  VirtualDisplay display("1280x960x24");
  if (!display.exists())
    GTEST_SKIP() << "there is no X server, and Xvfb is not installed";
  std::mutex drawing;
  LiveViewer viewer(drawing, "test");
  PointCloud<PointXYZRGBSigma> cloud;
  cloud.resize(2); // one of them is unknown
  cloud[0].getVector3fMap() << 0, 0, 2;
  cloud[1].getVector3fMap().setConstant(std::numeric_limits<float>::quiet_NaN());
  viewer.show(greyFrame());
  viewer.show(cloud);
  viewer.update();
  viewer.showPlan({});
  viewer.showPlan({{{}, {}},
                   {{{0, 0}, {0, 9}, {2, 9}}, {200, 220, 240}, true},
                   {{{0, 0}, {0, 9}, {2, 9}}, {20, 30, 40}}});
  viewer.showStatus("12 observations, 31 m\u00b2, move slower");
  std::this_thread::sleep_for(std::chrono::milliseconds(150));
  viewer.update();
  EXPECT_FALSE(viewer.isClosed());
  display.stop();
  EXPECT_TRUE(viewer.isClosed());
  viewer.update();
}

TEST(LiveViewer, NeedsAnXServer)
{
  const char* const display = std::getenv("DISPLAY");
  const std::string before = display ? display : "";
  unsetenv("DISPLAY");
  std::mutex drawing;
  EXPECT_THROW(LiveViewer(drawing, "test"), InitFailedException);
  if (!before.empty())
    setenv("DISPLAY", before.c_str(), 1);
}

} // namespace
} // namespace pcl::acmap::test
