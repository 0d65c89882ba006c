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

/** \brief An image with gradients and noise, determined by the seed. */
CameraImage
noisyImage(int width, int height, int channels, std::uint64_t seed);

/** \brief A frame of such images, all different, with the cameras of the rig; its stamp
 * depends on its number. */
TrinocularFrame
frameOf(const TrinocularRig& rig,
        std::uint64_t number,
        std::int32_t observation,
        std::int32_t pattern,
        int channels = 1);

void
expectEqual(const TrinocularFrame& a, const TrinocularFrame& b);

/** \brief Patterns per observation of \ref recordSession (none, 0, 1). */
constexpr std::int32_t patterns_recorded = 3;

/** \brief The frame with a given number in \ref recordSession. */
TrinocularFrame
recordedFrame(const TrinocularRig& rig, std::uint64_t number);

/** \brief Records a session with this number of frames and finishes it. */
void
recordSession(const std::string& folder,
              const TrinocularRig& rig,
              std::uint64_t frames);

/** \brief Inverts a byte of a file; negative positions count from the end. */
void
damage(const std::string& path, std::ptrdiff_t place);

/** \brief Message of the exception that a function throws; empty if it does not
 * throw. */
template <typename Exception, typename Work>
std::string
faultOfRunning(const Work& work)
{
  try {
    work();
  }
  catch (const Exception& exception) {
    // PCL puts ": " before every message
    const std::string what = exception.what();
    return what.substr(what.find_first_not_of(": "));
  }
  return "";
}

} // namespace pcl::acmap::test
