#include "camera_set.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/rig_cameras.h>

#include <algorithm>
#include <functional>
#include <sstream>

namespace pcl::acmap {

namespace {

using Clock = GrabbingThread::Clock;

/** Interval in which it is checked whether the stream is to be stopped. */
constexpr std::chrono::milliseconds look{20};

std::string
nameOfCamera(const CameraSet::Camera& camera)
{
  return std::string("the ") + nameOf(camera.place) + " camera, " + camera.device;
}

/** The four characters as OpenCV and V4L2 code them. */
double
codeOf(const std::string& format)
{
  std::uint32_t code = 0;
  for (std::size_t i = 0; i < format.size(); ++i)
    code |= static_cast<std::uint32_t>(static_cast<unsigned char>(format[i]))
            << (8 * i);
  return code;
}

/** The format is set first: the sizes and rates of a camera depend on it. */
void
request(VideoSource& source, const TrinocularRig& rig, const std::string& format)
{
  if (!format.empty())
    source.set(VideoSetting::PixelFormat, codeOf(format));
  source.set(VideoSetting::Width, rig.width);
  source.set(VideoSetting::Height, rig.height);
}

[[noreturn]] void
throwSilent(const CameraSet::Camera& camera, double timeout)
{
  std::ostringstream text;
  text << nameOfCamera(camera) << ": gave no image within " << timeout << " s";
  throw CameraException(CameraFault::Silent, text.str());
}

bool
isUniform(const CameraImage& image)
{
  return std::adjacent_find(image.values.begin(),
                            image.values.end(),
                            std::not_equal_to<>()) == image.values.end();
}

} // namespace

CameraSet::CameraSet(const TrinocularRig& rig,
                     const std::vector<std::string>& devices,
                     const VideoOpener& opener,
                     const std::string& pixel_format)
: width_(rig.width)
, height_(rig.height)
{
  std::size_t next = 0;
  for (const RigCamera place : rig_cameras)
    if (hasCamera(rig, place)) {
      const std::string& device = devices.at(next++);
      std::unique_ptr<VideoSource> source = opener(device);
      request(*source, rig, pixel_format);
      const bool is_recording = source->isRecording();
      are_recordings_ = are_recordings_ && is_recording;
      cameras_.push_back({device,
                          place,
                          is_recording,
                          std::make_unique<GrabbingThread>(std::move(source))});
    }
}

CameraSet::Outcome
CameraSet::grab(double timeout, const std::atomic<int>& stops)
{
  const Clock::time_point deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(
                         std::chrono::duration<double>(timeout));
  is_grabbing_ = true;
  for (const Camera& camera : cameras_)
    camera.thread->begin();
  const Camera* ended = nullptr;
  for (const Camera& camera : cameras_) {
    auto outcome = GrabbingThread::Outcome::Waiting;
    while (outcome == GrabbingThread::Outcome::Waiting) {
      if (stops > 0 && !are_recordings_)
        return Outcome::Stopped;
      if (Clock::now() >= deadline)
        throwSilent(camera, timeout);
      outcome = camera.thread->wait(std::min(deadline, Clock::now() + look));
    }
    if (outcome == GrabbingThread::Outcome::End)
      ended = &camera;
  }
  is_grabbing_ = false;
  if (ended && !are_recordings_)
    throw CameraException(CameraFault::Unplugged,
                          nameOfCamera(*ended) + ": gives no more images; was it "
                                                 "unplugged?");
  return ended ? Outcome::End : Outcome::Images;
}

CameraSet::Outcome
CameraSet::retrieve(ImageSet& images)
{
  for (const Camera& camera : cameras_) {
    CameraImage& image = images.images[static_cast<std::size_t>(camera.place)];
    if (!camera.thread->source().retrieve(image))
      return Outcome::Broken;
    if (image.width != width_ || image.height != height_)
      throw CameraException(CameraFault::Unsupported,
                            nameOfCamera(camera) + ": gives images of " +
                                sizeText(image) + " pixels, the rig has " +
                                sizeText(width_, height_) + " pixels");
  }
  images.stamp = cameras_.front().thread->source().stamp();
  return Outcome::Images;
}

void
requireDifferentImages(const CameraSet& set, const ImageSet& images)
{
  const auto imageOf = [&](const CameraSet::Camera& camera) -> const CameraImage& {
    return images.images[static_cast<std::size_t>(camera.place)];
  };
  for (const CameraSet::Camera& a : set.cameras())
    for (const CameraSet::Camera& b : set.cameras())
      if (a.place < b.place && imageOf(a) == imageOf(b) && !isUniform(imageOf(a)))
        throw acmap::BadArgument(nameOfCamera(a) + ", and " + nameOfCamera(b) +
                                 ", are refused: they give the same image, so they "
                                 "are one camera");
}

} // namespace pcl::acmap
