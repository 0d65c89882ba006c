#include "simulated_runs.h"

#include <pcl/acquisition/trinocular_file_grabber.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {

std::vector<TrinocularFrame::ConstPtr>
framesOf(const std::string& session)
{
  TrinocularFileGrabber grabber(session, 1000.0f);
  std::vector<TrinocularFrame::ConstPtr> frames;
  const std::function<TrinocularGrabber::FrameCallback> take =
      [&](const TrinocularFrame::ConstPtr& frame) { frames.push_back(frame); };
  grabber.registerCallback(take);
  grabber.start();
  grabber.wait();
  EXPECT_FALSE(grabber.getError());
  return frames;
}

double
meanOf(const CameraImage& image)
{
  double sum = 0;
  for (const std::uint8_t value : image.values)
    sum += value;
  return sum / static_cast<double>(image.values.size());
}

} // namespace pcl::acmap::test
