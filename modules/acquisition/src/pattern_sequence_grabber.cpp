#include "pattern/image_fit.h"
#include "sequence/sequence_stream.h"

#include <pcl/acquisition/pattern_sequence_grabber.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/size_text.h>

#include <utility>

namespace pcl {

namespace {

using Seconds = acmap::SequenceStream::Seconds;

void
requireWholePatterns(const std::vector<RgbImage>& patterns)
{
  for (std::size_t i = 0; i < patterns.size(); ++i) {
    const RgbImage& image = patterns[i];
    if (!acmap::isWhole(image))
      throw acmap::BadArgument("pattern " + std::to_string(i) + " of " +
                               acmap::sizeText(image) + " pixels has " +
                               std::to_string(image.values.size()) + " values");
  }
}

} // namespace

PatternSequenceGrabber::PatternSequenceGrabber(shared_ptr<TrinocularGrabber> camera,
                                               shared_ptr<PatternProjector> projector,
                                               std::vector<RgbImage> patterns)
: StreamedGrabber("PatternSequenceGrabber")
{
  requireWholePatterns(patterns);
  stream_ = std::make_unique<acmap::SequenceStream>(std::move(camera),
                                                    std::move(projector),
                                                    std::move(patterns),
                                                    *createSignal<FrameCallback>());
}

PatternSequenceGrabber::~PatternSequenceGrabber() noexcept = default;

acmap::StreamThread&
PatternSequenceGrabber::stream() const
{
  return stream_->thread();
}

void
PatternSequenceGrabber::setSettleTime(double seconds)
{
  acmap::requireInRange("settle time", seconds, 0.0, 10.0, "s");
  stream_->setSettings(
      [seconds](auto& settings) { settings.settle_time = Seconds(seconds); });
}

double
PatternSequenceGrabber::getSettleTime() const
{
  return stream_->settings().settle_time.count();
}

void
PatternSequenceGrabber::setShotTimeout(double seconds)
{
  acmap::requireInRange("shot timeout", seconds, 0.01, 600.0, "s");
  stream_->setSettings(
      [seconds](auto& settings) { settings.shot_timeout = Seconds(seconds); });
}

double
PatternSequenceGrabber::getShotTimeout() const
{
  return stream_->settings().shot_timeout.count();
}

void
PatternSequenceGrabber::setWantMore(WantMore want_more)
{
  stream_->setSettings(
      [&want_more](auto& settings) { settings.want_more = std::move(want_more); });
}

void
PatternSequenceGrabber::start()
{
  stream_->addObservationsWithoutEnd();
}

void
PatternSequenceGrabber::observe()
{
  stream_->addObservation();
}

void
PatternSequenceGrabber::stop()
{
  stream_->stop();
}

void
PatternSequenceGrabber::trigger()
{
  stream_->addShot();
}

void
PatternSequenceGrabber::rewind()
{
  stream_->progress().rewind();
}

float
PatternSequenceGrabber::getFramesPerSecond() const
{
  return 0.0F;
}

TrinocularRig
PatternSequenceGrabber::getRig() const
{
  return stream_->camera().getRig();
}

PatternSequenceGrabberReport
PatternSequenceGrabber::getReport() const
{
  return stream_->progress().report();
}

} // namespace pcl
