#pragma once

#include <pcl/acquisition/trinocular_file_grabber.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace pcl::acmap::test {

/** \brief A rig of three cameras with this many pixels. */
TrinocularRig
rigOf(int width, int height);

/** \brief An image with gradients and noise, the same for the same seed. */
CameraImage
noisyImage(int width, int height, int channels, std::uint64_t seed);

/** \brief A frame of such images, which differ, of the rig's cameras; its stamp tells its
 * number too. */
TrinocularFrame
frameOf(const TrinocularRig& rig,
        std::uint64_t number,
        std::int32_t observation,
        std::int32_t pattern,
        int channels = 1);

void
expectEqual(const TrinocularFrame& a, const TrinocularFrame& b);

/** \brief Patterns of each observation that \ref recordSession makes: none, 0, 1. */
constexpr std::int32_t patterns_recorded = 3;

/** \brief The frame that \ref recordSession gives a number. */
TrinocularFrame
recordedFrame(const TrinocularRig& rig, std::uint64_t number);

/** \brief Records a session of that many frames and finishes it. */
void
recordSession(const std::string& folder,
              const TrinocularRig& rig,
              std::uint64_t frames);

/** \brief Inverts a byte of a file, counted from its end when negative. */
void
damage(const std::string& path, std::ptrdiff_t place);

/** \brief What a piece of work threw, empty when it threw nothing of this kind. */
template <typename Exception, typename Work>
std::string
faultOfRunning(const Work& work)
{
  try {
    work();
  }
  catch (const Exception& exception) {
    // PCL puts ": " before every message.
    const std::string what = exception.what();
    return what.substr(what.find_first_not_of(": "));
  }
  return "";
}

} // namespace pcl::acmap::test
