#include "output_target.h"
#include "rig_calibration/calibration_options.h"

#include <pcl/acquisition/trinocular_file_grabber.h>
#include <pcl/core/rig_calibration.h>
#include <pcl/stereo/rig_calibrator.h>

#include <algorithm>
#include <optional>

namespace pcl::acmap {

namespace {

// Limits for the matcher, and for a good session of boards; see doc/tutorials.
constexpr double max_residual = 0.3; // px
constexpr std::size_t few_boards = 10;
constexpr double small_coverage = 0.4;

void
warnOfWeakness(Tool& tool, const RigCalibratorReport& calibrated)
{
  const auto residual = [&](const char* lines, double value) {
    if (value > max_residual)
      tool.warn(std::string(lines) + " are off by " + shortNumber(value) +
                " px; disparities need " + shortNumber(max_residual) +
                " or less: is the board flat, and were the shots sharp and taken at "
                "once?");
  };
  residual("rows", calibrated.row_residual);
  residual("columns", calibrated.column_residual);
  for (std::size_t i = 0; i < calibrated.boards.size(); ++i)
    if (calibrated.boards[i] > 0 && calibrated.boards[i] < few_boards)
      tool.warn(std::string("the ") + nameOf(static_cast<RigCamera>(i)) +
                " camera has only " + std::to_string(calibrated.boards[i]) +
                " good boards; 15 are advised");
  if (calibrated.coverage < small_coverage)
    tool.warn("the boards cover only " + shortNumber(100 * calibrated.coverage) +
              " % of the reference's image: lens and focal length are guessed there");
  for (const std::string& remark : calibrated.remarks)
    tool.warn(remark);
}

/** \brief Adds the board images with their errors, or the reasons why they were left
 * out, to the report, and reports those that were left out. */
void
tellImages(Tool& tool, const RigCalibratorReport& calibrated)
{
  auto images = nlohmann::ordered_json::array();
  for (const BoardImage& image : calibrated.images) {
    nlohmann::ordered_json entry = {
        {"name", image.name}, {"camera", nameOf(image.camera)}, {"shot", image.shot}};
    if (image.reason.empty())
      entry["reprojection"] = image.reprojection;
    else {
      entry["left_out"] = image.reason;
      tool.warn("left out: " + image.name + ": " + image.reason);
    }
    images.push_back(std::move(entry));
  }
  tool.details()["images"] = std::move(images);
}

/** \brief Writes summary, report and warnings of a successful calibration. */
void
tellCalibration(Tool& tool,
                const RigCalibratorReport& calibrated,
                const TrinocularRig& rig)
{
  nlohmann::ordered_json& details = tool.details();
  for (std::size_t i = 0; i < calibrated.boards.size(); ++i) {
    if (calibrated.boards[i] == 0)
      continue;
    details["cameras"][nameOf(static_cast<RigCamera>(i))] = {
        {"boards", calibrated.boards[i]}, {"reprojection", calibrated.reprojection[i]}};
    tool.tell(nameOf(static_cast<RigCamera>(i)),
              std::to_string(calibrated.boards[i]) + " boards, reprojection " +
                  shortNumber(calibrated.reprojection[i]) + " px");
  }
  details["row_residual"] = calibrated.row_residual;
  details["column_residual"] = calibrated.column_residual;
  details["coverage"] = calibrated.coverage;
  details["rig"] = {{"width", rig.width},
                    {"height", rig.height},
                    {"focal_length", rig.focal_length},
                    {"baseline_horizontal", rig.baseline_horizontal},
                    {"baseline_vertical", rig.baseline_vertical}};
  if (calibrated.boards[1] > 0)
    tool.tell("rows", shortNumber(calibrated.row_residual) + " px off");
  if (calibrated.boards[2] > 0)
    tool.tell("columns", shortNumber(calibrated.column_residual) + " px off");
  tool.tell("coverage", shortNumber(100 * calibrated.coverage) + " % of the image");
  tool.tell("focal length", shortNumber(rig.focal_length) + " px");
  tool.tell("baselines",
            shortNumber(rig.baseline_horizontal) + " m, " +
                shortNumber(rig.baseline_vertical) + " m");
  warnOfWeakness(tool, calibrated);
}

} // namespace

} // namespace pcl::acmap

namespace {

using namespace pcl::acmap;

std::vector<std::string>
allImages(const CalibrationOptions& options)
{
  std::vector<std::string> all;
  for (const std::vector<std::string>& list : options.images)
    all.insert(all.end(), list.begin(), list.end());
  return all;
}

void
addShot(const CalibrationOptions& options,
        std::size_t shot,
        pcl::RigCalibrator& calibrator)
{
  pcl::TrinocularFrame frame;
  std::array<std::string, 3> names;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (options.images[i].empty())
      continue;
    names[i] = options.images[i][shot];
    frame.images[i] = pcl::loadCameraImage(names[i]);
  }
  calibrator.addShot(frame, names);
}

void
addFrame(const pcl::TrinocularFileGrabber& session,
         std::size_t index,
         pcl::RigCalibrator& calibrator)
{
  const pcl::TrinocularFrame::ConstPtr frame = session.frame(index);
  std::array<std::string, 3> names;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!frame->images[i].empty())
      names[i] = "frame " + std::to_string(frame->number) + ", " +
                 nameOf(static_cast<pcl::RigCamera>(i));
  calibrator.addShot(*frame, names);
}

void
addShots(Tool& tool, const CalibrationOptions& options, pcl::RigCalibrator& calibrator)
{
  std::optional<pcl::TrinocularFileGrabber> session;
  if (!options.session.empty())
    session.emplace(options.session);
  const std::size_t shots = session ? session->frames() : options.images.front().size();
  tool.withProgress([&](const pcl::ProgressCallback& progress) {
    const Progress told(progress);
    for (std::size_t shot = 0; shot < shots; ++shot) {
      told.tell(static_cast<double>(shot) / static_cast<double>(shots),
                "looking for boards");
      if (session)
        addFrame(*session, shot, calibrator);
      else
        addShot(options, shot, calibrator);
    }
  });
}

void
calibrate(Tool& tool, const CalibrationOptions& options)
{
  const std::vector<std::string> images = allImages(options);
  requireShots(options);
  pcl::RigCalibrator calibrator;
  calibrator.setBoard(boardOf(options));
  requireWritable(options.output, {".yaml", ".yml"}, images);
  tool.requireReportWritable(images);
  StepTimer timer(tool.report());
  addShots(tool, options, calibrator);
  timer.finish("boards");

  pcl::RigCalibration cameras;
  pcl::TrinocularRig rig;
  try {
    calibrator.calibrate(cameras, rig);
  }
  catch (const pcl::PCLException&) {
    const std::vector<pcl::BoardImage>& images = calibrator.getReport().images;
    const bool none =
        std::all_of(images.begin(), images.end(), [](const pcl::BoardImage& image) {
          return !image.reason.empty();
        });
    tellImages(tool, calibrator.getReport());
    tool.failWithNothing(
        failureOf(std::current_exception()).line +
        (none ? "; --board counts inner corners, a square less each way" : ""));
  }
  timer.finish("calibrate");
  tool.stopIfInterrupted();
  pcl::saveRigCalibration(options.output, rig, cameras);
  timer.finish("write");
  tool.details()["output"] = options.output;
  tellImages(tool, calibrator.getReport());
  tellCalibration(tool, calibrator.getReport(), rig);
  tool.tell("file", options.output);
}

} // namespace

int
main(int argc, char** argv)
{
  Tool tool("pcl_rig_calibration",
            "Calibrates a trinocular rig from images of a chessboard.");
  CalibrationOptions options;
  addOptions(tool, options);
  return tool.run(argc, argv, [&] { calibrate(tool, options); });
}
