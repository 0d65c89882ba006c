#include <pcl/common/io.h>
#include <pcl/core/exceptions.h>
#include <pcl/stereo/active_stereo_grabber.h>

#include "grabber/observation_stream.h"

#include <utility>

namespace pcl {

namespace {

template <typename Callback>
using Signal = boost::signals2::signal<Callback>;

shared_ptr<TrinocularGrabber>
requireGrabber(shared_ptr<TrinocularGrabber> frames)
{
  if (!frames)
    throw acmap::BadArgument("ActiveStereoGrabber needs a grabber of frames");
  return frames;
}

template <typename PointT>
using CloudSignal = Signal<ActiveStereoGrabber::PointCloudCallback<PointT>>;

/** Calls the callbacks for clouds of a point type, if there are any. */
template <typename PointT>
void
giveAs(const CloudSignal<PointT>& signal, const PointCloud<PointXYZRGBSigma>& cloud)
{
  if (signal.empty())
    return;
  const auto converted = pcl::make_shared<PointCloud<PointT>>();
  copyPointCloud(cloud, *converted);
  signal(converted);
}

/** The signals, which belong to the grabber. */
struct StereoSignals {
  const CloudSignal<PointXYZRGBSigma>& clouds;
  const Signal<ActiveStereoGrabber::ObservationCallback>& observations;
  const CloudSignal<PointXYZ>& points;
  const CloudSignal<PointXYZRGB>& rgb;
  const CloudSignal<PointXYZRGBA>& rgba;

  void
  give(const ActiveStereoObservation& observation) const
  {
    clouds(observation.cloud);
    observations(observation);
    giveAs<PointXYZ>(points, *observation.cloud);
    giveAs<PointXYZRGB>(rgb, *observation.cloud);
    giveAs<PointXYZRGBA>(rgba, *observation.cloud);
  }
};

} // namespace

struct ActiveStereoGrabber::State {
  State(shared_ptr<TrinocularGrabber> frames, const StereoSignals& signals)
  : stream(requireGrabber(std::move(frames)),
           [signals](const ActiveStereoObservation& observation) {
             signals.give(observation);
           })
  {}

  acmap::ObservationMaker&
  settings()
  {
    if (stream.isRunning())
      throw acmap::InitFailed("ActiveStereoGrabber streams: nothing can be set now");
    return stream.maker();
  }

  acmap::ObservationStream stream;
};

ActiveStereoGrabber::ActiveStereoGrabber(shared_ptr<TrinocularGrabber> frames)
: state_(std::make_unique<State>(
      std::move(frames),
      StereoSignals{*createSignal<CloudCallback>(),
                    *createSignal<ObservationCallback>(),
                    *createSignal<PointCloudCallback<PointXYZ>>(),
                    *createSignal<PointCloudCallback<PointXYZRGB>>(),
                    *createSignal<PointCloudCallback<PointXYZRGBA>>()}))
{}

ActiveStereoGrabber::~ActiveStereoGrabber() noexcept = default;

DisparityFusion&
ActiveStereoGrabber::fusion()
{
  return state_->settings().fusion();
}

DisparityBackProjection&
ActiveStereoGrabber::backProjection()
{
  return state_->settings().backProjection();
}

void
ActiveStereoGrabber::start()
{
  state_->stream.start();
}

void
ActiveStereoGrabber::stop()
{
  state_->stream.stop();
}

bool
ActiveStereoGrabber::isRunning() const
{
  return state_->stream.isRunning();
}

void
ActiveStereoGrabber::wait()
{
  state_->stream.wait();
}

std::exception_ptr
ActiveStereoGrabber::getError() const
{
  return state_->stream.error();
}

std::string
ActiveStereoGrabber::getName() const
{
  return "ActiveStereoGrabber";
}

float
ActiveStereoGrabber::getFramesPerSecond() const
{
  return 0.0F;
}

TrinocularRig
ActiveStereoGrabber::getRig() const
{
  return state_->stream.frames().getRig();
}

ActiveStereoGrabberReport
ActiveStereoGrabber::getReport() const
{
  return state_->stream.maker().report();
}

} // namespace pcl
