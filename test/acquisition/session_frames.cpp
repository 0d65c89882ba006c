#include "session_frames.h"

#include "temporary_folder.h"

#include <pcl/acquisition/trinocular_recorder.h>
#include <pcl/core/random.h>
#include <pcl/core/rig_cameras.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace pcl::acmap::test {

TrinocularRig
rigOf(int width, int height)
{
  TrinocularRig rig;
  rig.width = width;
  rig.height = height;
  return rig;
}

CameraImage
noisyImage(int width, int height, int channels, std::uint64_t seed)
{
  Random random(seed);
  CameraImage image{width, height, channels, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width * channels; ++x)
      image.values.push_back(static_cast<std::uint8_t>(
          std::clamp(80.0 + x % 64 + y + 2 * random.normal(), 0.0, 254.0)));
  return image;
}

TrinocularFrame
frameOf(const TrinocularRig& rig,
        std::uint64_t number,
        std::int32_t observation,
        std::int32_t pattern,
        int channels)
{
  TrinocularFrame frame;
  frame.number = number;
  frame.observation = observation;
  frame.pattern = pattern;
  frame.stamp = 1'700'000'000'000'000 + number;
  for (std::size_t camera = 0; camera < frame.images.size(); ++camera)
    if (hasCamera(rig, rig_cameras[camera]))
      frame.images[camera] =
          noisyImage(rig.width, rig.height, channels, 3 * number + camera);
  return frame;
}

void
expectEqual(const TrinocularFrame& a, const TrinocularFrame& b)
{
  EXPECT_EQ(a.number, b.number);
  EXPECT_EQ(a.observation, b.observation);
  EXPECT_EQ(a.pattern, b.pattern);
  EXPECT_EQ(a.stamp, b.stamp);
  EXPECT_TRUE(a.images == b.images);
}

TrinocularFrame
recordedFrame(const TrinocularRig& rig, std::uint64_t number)
{
  const auto shot = static_cast<std::int32_t>(number);
  return frameOf(rig, number, shot / patterns_recorded, shot % patterns_recorded - 1);
}

void
recordSession(const std::string& folder, const TrinocularRig& rig, std::uint64_t frames)
{
  TrinocularRecorder recorder(folder, rig);
  for (std::uint64_t number = 0; number < frames; ++number)
    recorder.record(recordedFrame(rig, number));
  recorder.finish();
}

void
damage(const std::string& path, std::ptrdiff_t place)
{
  std::string bytes = contentOf(path);
  const auto size = static_cast<std::ptrdiff_t>(bytes.size());
  char& byte = bytes.at(static_cast<std::size_t>(place < 0 ? size + place : place));
  byte = static_cast<char>(~byte);
  std::ofstream(path, std::ios::binary) << bytes;
}

} // namespace pcl::acmap::test
