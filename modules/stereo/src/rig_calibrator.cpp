#include <pcl/core/exceptions.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/stereo/rig_calibrator.h>

#include "calibration/board_views.h"

#include <pcl/core/impl/arguments.h>
#include <pcl/stereo/trinocular_rectification.h>

#include <cmath>
#include <set>

namespace pcl {

namespace {

using acmap::BoardView;
using Views = std::array<std::vector<BoardView>, 3>;

void
requireBoardImage(const CameraImage& image, const std::string& name)
{
  constexpr std::int32_t longest = 32768;
  if (!isWhole(image) || image.width > longest || image.height > longest)
    throw acmap::BadArgument(name + ": the image has not all its values");
}

bool
isSeen(const std::vector<BoardView>& views, std::size_t shot)
{
  for (const BoardView& view : views)
    if (view.shot == shot)
      return true;
  return false;
}

/** \brief Excludes the images of a neighbour if the reference has no good image of the
 * same board. */
void
requireReference(const std::vector<BoardView>& reference,
                 std::vector<BoardView>& views,
                 RigCalibratorReport& report)
{
  std::vector<BoardView> kept;
  for (BoardView& view : views)
    if (isSeen(reference, view.shot))
      kept.push_back(std::move(view));
    else
      report.images[view.image].reason =
          "the reference has no good image of this board";
  views = std::move(kept);
}

/** \brief RMS difference over all corners that a neighbour and the reference share, px.
 * \param[in] coordinate 0: columns, 1: rows */
double
residualOf(const TrinocularRectification& rectification,
           const Views& views,
           RigCamera camera,
           int coordinate)
{
  double sum = 0;
  std::size_t count = 0;
  const auto rectified = [&](RigCamera of, const cv::Point2f& corner) {
    return rectification.rectifiedPixel(of, {corner.x, corner.y})[coordinate];
  };
  for (const BoardView& view : views[static_cast<std::size_t>(camera)])
    for (const BoardView& reference : views.front()) {
      if (reference.shot != view.shot)
        continue;
      for (std::size_t i = 0; i < view.corners.size(); ++i) {
        const double error = rectified(camera, view.corners[i]) -
                             rectified(RigCamera::Reference, reference.corners[i]);
        sum += error * error;
        ++count;
      }
    }
  return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0;
}

/** \brief Share of the cells of the image that contain a corner. */
double
coverageOf(const std::vector<BoardView>& views, const cv::Size& size)
{
  constexpr int columns = 8;
  constexpr int rows = 6;
  std::set<int> cells;
  for (const BoardView& view : views)
    for (const cv::Point2f& corner : view.corners)
      cells.insert(static_cast<int>(corner.y) * rows / size.height * columns +
                   static_cast<int>(corner.x) * columns / size.width);
  return static_cast<double>(cells.size()) / (columns * rows);
}

void
setErrors(std::size_t camera,
          const std::vector<BoardView>& views,
          const std::vector<double>& errors,
          RigCalibratorReport& report)
{
  double sum = 0;
  for (std::size_t i = 0; i < views.size(); ++i) {
    report.images[views[i].image].reprojection = errors[i];
    sum += errors[i] * errors[i];
  }
  report.reprojection[camera] = std::sqrt(sum / static_cast<double>(views.size()));
}

} // namespace

void
RigCalibrator::setBoard(const CalibrationBoard& board)
{
  acmap::requireInRange("columns of the board", board.columns, 3, 100, "corners");
  acmap::requireInRange("rows of the board", board.rows, 3, 100, "corners");
  acmap::requireInRange("square of the board", board.square, 1e-4, 10.0, "m");
  if ((board.columns + board.rows) % 2 == 0)
    throw acmap::BadArgument(
        "a board of " + acmap::sizeText(board.columns, board.rows) +
        " corners looks the same upside down: one count must be even, the other odd");
  *this = RigCalibrator();
  board_ = board;
}

void
RigCalibrator::addShot(const TrinocularFrame& frame,
                       const std::array<std::string, 3>& names)
{
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!frame.images[i].empty())
      requireBoardImage(frame.images[i], names[i]);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const CameraImage& image = frame.images[i];
    if (image.empty())
      continue;
    if (width_ == 0) {
      width_ = image.width;
      height_ = image.height;
    }
    acmap::BoardCorners found;
    if (image.width == width_ && image.height == height_)
      found = acmap::findBoard(image, board_);
    else
      found.reason = "has " + acmap::sizeText(image) + " pixels, the first image has " +
                     acmap::sizeText(width_, height_);
    report_.images.push_back(
        {names[i], static_cast<RigCamera>(i), shots_, found.reason, 0.0});
    corners_.push_back(std::move(found.corners));
    detection_.push_back(std::move(found.reason));
  }
  ++shots_;
}

namespace {

/** \brief What weakens a calibration: residuals beyond what the matcher allows, few boards, and
 * a part of the image without any. */
std::vector<std::string>
weaknessesOf(const RigCalibratorReport& calibrated)
{
  // limits for the matcher, and for a good session of boards; see doc/tutorials
  constexpr double max_residual = 0.3; // px
  constexpr std::size_t few_boards = 10;
  constexpr double small_coverage = 0.4;
  using acmap::shortNumber;
  std::vector<std::string> remarks;
  const auto residual = [&](const char* lines, double value) {
    if (value > max_residual)
      remarks.push_back(std::string(lines) + " are off by " + shortNumber(value) +
                        " px; disparities need " + shortNumber(max_residual) +
                        " or less: is the board flat, and were the shots sharp and "
                        "taken at once?");
  };
  residual("rows", calibrated.row_residual);
  residual("columns", calibrated.column_residual);
  for (std::size_t i = 0; i < calibrated.boards.size(); ++i)
    if (calibrated.boards[i] > 0 && calibrated.boards[i] < few_boards)
      remarks.push_back(std::string("the ") + nameOf(static_cast<RigCamera>(i)) +
                        " camera has only " + std::to_string(calibrated.boards[i]) +
                        " good boards; 15 are advised");
  if (calibrated.coverage < small_coverage)
    remarks.push_back("the boards cover only " +
                      shortNumber(100 * calibrated.coverage) +
                      " % of the reference's image: lens and focal length are guessed "
                      "there");
  return remarks;
}

} // namespace

/** \brief Intermediate data of a calibration. */
struct RigCalibrator::Fit {
  Views views;
  std::array<bool, 3> is_there{};
  cv::Size size;
  RigCalibration found;
  acmap::LeaveOut leave_out;
};

/** \brief Starts from all boards that were found, including those that a previous fit
 * excluded. */
RigCalibrator::Fit
RigCalibrator::beginFit()
{
  Fit fit;
  fit.size = {width_, height_};
  fit.found.width = width_;
  fit.found.height = height_;
  fit.leave_out = [this](const BoardView& view, const std::string& reason) {
    report_.images[view.image].reason = reason;
  };
  RigCalibratorReport report;
  report.images = std::move(report_.images);
  report_ = std::move(report);
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    BoardImage& image = report_.images[i];
    const auto camera = static_cast<std::size_t>(image.camera);
    fit.is_there[camera] = true;
    image.reason = detection_[i];
    image.reprojection = 0.0;
    if (!image.reason.empty())
      continue;
    BoardView view;
    view.image = i;
    view.shot = image.shot;
    for (const Eigen::Vector2f& corner : corners_[i])
      view.corners.emplace_back(corner.x(), corner.y());
    fit.views[camera].push_back(std::move(view));
  }
  if (!fit.is_there[1] && !fit.is_there[2])
    throw acmap::InitFailed("there are no images of a neighbour of the reference");
  return fit;
}

void
RigCalibrator::fitCameras(Fit& fit)
{
  for (std::size_t i = 0; i < fit.views.size(); ++i) {
    if (i > 0 && !fit.is_there[i])
      continue;
    if (i > 0)
      requireReference(fit.views[0], fit.views[i], report_);
    std::vector<double> errors;
    fit.found.cameras[i] = acmap::fitCamera(board_,
                                            fit.size,
                                            nameOf(static_cast<RigCamera>(i)),
                                            fit.views[i],
                                            errors,
                                            fit.leave_out);
    setErrors(i, fit.views[i], errors, report_);
  }
}

void
RigCalibrator::fitPlaces(Fit& fit)
{
  for (std::size_t i = 1; i < fit.views.size(); ++i)
    if (fit.is_there[i])
      acmap::fitPlace(board_,
                      fit.size,
                      nameOf(static_cast<RigCamera>(i)),
                      fit.found.cameras[0],
                      fit.views[0],
                      fit.found.cameras[i],
                      fit.views[i],
                      fit.leave_out);
  for (std::size_t i = 0; i < fit.views.size(); ++i)
    report_.boards[i] = fit.views[i].size();
}

void
RigCalibrator::calibrate(RigCalibration& calibration, TrinocularRig& rig)
{
  Fit fit = beginFit();
  acmap::StepTimer timer(report_);
  fitCameras(fit);
  timer.finish("cameras");
  fitPlaces(fit);
  timer.finish("places");

  TrinocularRectification rectification;
  rectification.setInputCalibration(fit.found);
  report_.row_residual = residualOf(rectification, fit.views, RigCamera::Horizontal, 1);
  report_.column_residual =
      residualOf(rectification, fit.views, RigCamera::Vertical, 0);
  report_.coverage = coverageOf(fit.views[0], fit.size);
  report_.remarks = weaknessesOf(report_);
  const std::vector<std::string>& more = rectification.getReport().remarks;
  report_.remarks.insert(report_.remarks.end(), more.begin(), more.end());
  timer.finish("residuals");
  calibration = fit.found;
  rig = rectification.getRig();
}

const std::vector<Eigen::Vector2f>&
RigCalibrator::getCorners(std::size_t image) const
{
  if (image >= corners_.size())
    throw acmap::BadArgument("image = " + std::to_string(image) +
                             " is refused: the report has " +
                             std::to_string(corners_.size()) + " images");
  return corners_[image];
}

} // namespace pcl
