#include "digiclops/camera_stream.h"
#include "register_bus.h"

#include <pcl/acquisition/iidc_camera.h>

#include <algorithm>
#include <cmath>

using namespace pcl::acmap;

namespace {

/** \brief Calls a function that the camera may reject.
 * \return true if it was not rejected */
template <typename Work>
bool
accepts(const Work& work)
{
  try {
    work();
    return true;
  }
  catch (const pcl::CameraException& refusal) {
    test::require(refusal.fault() != pcl::CameraFault::None && *refusal.what());
  }
  catch (const pcl::BadArgumentException&) { // outside the range that the camera
                                             // reports
  }
  return false;
}

void
requireSense(const pcl::IidcMode& mode)
{
  test::require((mode.format >= 0 && mode.format <= 2) || mode.format == 7);
  test::require(mode.mode >= 0 && mode.mode <= 7);
  test::require(mode.width > 0 && mode.width <= 32768);
  test::require(mode.height > 0 && mode.height <= 32768);
  test::require(mode.color <= pcl::IidcColor::Raw16 && mode.bytes() > 0);
  test::require(mode.rates.empty() == (mode.format == 7));
  test::require(std::is_sorted(mode.rates.begin(), mode.rates.end()));
}

void
useFeature(pcl::IidcCamera& camera, pcl::IidcFeature feature)
{
  accepts([&] {
    const auto physical = camera.feature(feature).physical;
    test::require(!physical || (std::isfinite(physical->value) &&
                                physical->minimum <= physical->maximum));
  });
  accepts([&] { camera.setValue(feature, 100); });
  accepts([&] { camera.setPhysical(feature, 0.01F); });
  accepts([&] { camera.setAutomatic(feature); });
}

void
takeFrames(CameraStream& stream, CameraStream::Way way, const pcl::IidcMode& mode)
{
  constexpr int max_frames = 30;
  WholeFrame frame;
  for (int i = 0; i < max_frames && stream.next(way, frame); ++i) {
    test::require(frame.data.bytes.size() >= mode.bytes() && frame.lost < 1000000);
    const std::size_t bytes = frame.data.bytes.size();
    counterOf(frame.data);
    for (const int rows : {1, 2})
      coverCounter(frame.data, mode, rows);
    test::require(frame.data.bytes.size() == bytes);
  }
}

void
film(pcl::IidcCamera& camera, const pcl::IidcMode& mode)
{
  float rate = 0;
  if (!accepts([&] { rate = camera.setMode(mode, 14); }))
    return;
  test::require(std::isfinite(rate) && rate > 0);
  CameraStream stream(camera);
  stream.setUp(mode, rate, 0.1);
  for (const auto way : {CameraStream::Way::Free, CameraStream::Way::Single}) {
    accepts([&] { takeFrames(stream, way, mode); });
    stream.end();
  }
}

} // namespace

/** For any registers and stream, the camera is rejected with a reason, or works. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  test::HostileCamera hostile(test::FuzzedBytes(data, size));
  pcl::IidcCamera camera([&] { return std::make_unique<test::RegisterBus>(hostile); });
  const bool is_open = accepts([&] { camera.open(); });
  test::require(camera.isOpen() == is_open);
  if (!is_open)
    return 0;
  for (const auto feature : {pcl::IidcFeature::WhiteBalance,
                             pcl::IidcFeature::Shutter,
                             pcl::IidcFeature::FrameRate})
    useFeature(camera, feature);
  accepts([&] { camera.colorFilter(); });
  const std::vector<pcl::IidcMode> modes = camera.modes();
  for (const pcl::IidcMode& mode : modes)
    requireSense(mode);
  if (!modes.empty()) // the first one has a fixed format, the last one is scalable, if
                      // they exist
    for (const pcl::IidcMode& mode : {modes.back(), modes.front()})
      film(camera, mode);
  return 0;
}
