#include <pcl/core/exceptions.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/stereo/trinocular_rectification.h>

#include "matching/shot_check.h"
#include "rectification/common_view.h"
#include "rectification/remap_table.h"

#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/parallel.h>

#include <optional>

namespace pcl {

namespace {

void
requireFits(const CameraImage& image, const char* name, const RigCalibration& rig)
{
  const auto fail = [&](const std::string& fault) {
    throw acmap::BadArgument(std::string("the ") + name + " image " + fault);
  };
  if (image.width != rig.width || image.height != rig.height)
    fail("has " + acmap::sizeText(image) + " pixels, the calibration has " +
         acmap::sizeText(rig) + " pixels");
  if (image.channels != 1 && image.channels != 3)
    fail("has " + std::to_string(image.channels) + " channels; legal are 1 and 3");
  if (!isWhole(image))
    fail("has not all its values");
}

} // namespace

struct TrinocularRectification::State {
  Report run;
  RigCalibration calibration;
  acmap::CommonView view;
  std::array<std::optional<acmap::RemapTable>, 3> tables;
};

TrinocularRectification::TrinocularRectification() = default;
TrinocularRectification::~TrinocularRectification() = default;
TrinocularRectification::TrinocularRectification(TrinocularRectification&&) noexcept =
    default;
TrinocularRectification&
TrinocularRectification::operator=(TrinocularRectification&&) noexcept = default;

void
TrinocularRectification::setInputCalibration(const RigCalibration& calibration)
{
  auto state = std::make_unique<State>();
  acmap::StepTimer timer(state->run);
  state->calibration = calibration;
  state->view = acmap::commonViewOf(calibration);
  acmap::withThreads(threads_, [&] {
    for (std::size_t i = 0; i < state->tables.size(); ++i)
      if (calibration.cameras[i].is_there)
        state->tables[i].emplace(calibration, calibration.cameras[i], state->view);
  });
  timer.finish("tables");
  state_ = std::move(state);
}

void
TrinocularRectification::setNearestDepth(double depth)
{
  acmap::requireInRange("nearest depth", depth, 0.01, 1000.0, "m");
  nearest_depth_ = depth;
}

void
TrinocularRectification::setNumberOfThreads(unsigned threads)
{
  threads_ = acmap::requiredThreads(threads);
}

const TrinocularRectification::State&
TrinocularRectification::requireState() const
{
  if (!state_)
    throw acmap::InitFailed("TrinocularRectification has no calibration");
  return *state_;
}

const CameraCalibration&
TrinocularRectification::requireCamera(RigCamera camera) const
{
  const CameraCalibration& found = requireState().calibration.camera(camera);
  if (!found.is_there)
    throw acmap::BadArgument("the rig has no such camera");
  return found;
}

const TrinocularRig&
TrinocularRectification::getRig() const
{
  return requireState().view.rig;
}

Eigen::Matrix3d
TrinocularRectification::getRotation(RigCamera camera) const
{
  return requireState().view.rotationOf(requireCamera(camera));
}

TrinocularRectificationReport
TrinocularRectification::getReport() const
{
  const State& state = requireState();
  TrinocularRectificationReport report;
  report.seconds = state.run.seconds;
  for (std::size_t i = 0; i < report.turns.size(); ++i)
    if (state.tables[i])
      report.turns[i] =
          Eigen::AngleAxisd(state.view.rotationOf(state.calibration.cameras[i]))
              .angle() *
          180.0 / M_PI;
  report.column_offset = state.view.column_offset;
  report.column_residual =
      state.view.rig.focal_length * std::abs(state.view.column_offset) / nearest_depth_;
  if (report.column_residual > 0.5)
    report.remarks.push_back(
        "the baselines are not perpendicular: a point at " +
        std::to_string(nearest_depth_) + " m lies " +
        std::to_string(report.column_residual) +
        " px beside its column of the vertical camera, no rotation takes that off");
  return report;
}

Eigen::Vector2d
TrinocularRectification::rectifiedPixel(RigCamera camera,
                                        const Eigen::Vector2d& pixel) const
{
  const TrinocularRig& rig = getRig();
  const Eigen::Vector3d ray =
      getRotation(camera) * pixelRay(requireCamera(camera), pixel);
  return rig.focal_length * ray.hnormalized() +
         Eigen::Vector2d(rig.center_x, rig.center_y);
}

void
TrinocularRectification::rectify(const TrinocularFrame& frame,
                                 TrinocularFrame& rectified) const
{
  const State& state = requireState();
  for (std::size_t i = 0; i < frame.images.size(); ++i) {
    if (frame.images[i].empty())
      continue;
    if (!state.tables[i])
      throw acmap::BadArgument(std::string("there is a ") +
                               nameOf(static_cast<RigCamera>(i)) +
                               " image, but no such camera in the calibration");
    requireFits(frame.images[i], nameOf(static_cast<RigCamera>(i)), state.calibration);
  }
  std::array<CameraImage, 3> images;
  acmap::withThreads(threads_, [&] {
    for (std::size_t i = 0; i < frame.images.size(); ++i)
      if (!frame.images[i].empty())
        images[i] = state.tables[i]->apply(frame.images[i]);
  });
  rectified.number = frame.number;
  rectified.observation = frame.observation;
  rectified.pattern = frame.pattern;
  rectified.stamp = frame.stamp;
  rectified.images = std::move(images);
}

} // namespace pcl
