#include "command_line.h"
#include "output_target.h"
#include "tool.h"

#include <pcl/acquisition/trinocular_file_grabber.h>
#include <pcl/core/fields_json.h>
#include <pcl/core/rig_calibration.h>
#include <pcl/stereo/rig_calibrator.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <set>

namespace pcl::acmap {

namespace {

/** \brief Options of the user. */
struct CalibrationOptions {
  std::string session;                            ///< folder; empty: use the images
  std::array<std::vector<std::string>, 3> images; ///< paths by \ref RigCamera
  std::string board = std::to_string(CalibrationBoard().columns) + "x" +
                      std::to_string(CalibrationBoard().rows);
  double square = 0.0; ///< metres
  std::string output;
};

void
addOptions(Tool& tool, CalibrationOptions& options)
{
  CLI::App& app = tool.options();
  app.add_option("--session",
                 options.session,
                 "Raw session of which each frame is a shot of the board, in place of "
                 "images")
      ->type_name("SESSION_DIR");
  const auto images = [&](RigCamera camera, const char* name, const char* purpose) {
    return app
        .add_option(name, options.images[static_cast<std::size_t>(camera)], purpose)
        ->type_name("IMG..")
        ->default_str("")
        ->check(imageName());
  };
  images(RigCamera::Reference,
         "--reference",
         "Board images of the reference camera, PNG, JPEG, PGM or PPM, a shot each");
  images(RigCamera::Horizontal,
         "--horizontal",
         "Of its neighbour in the row: the same shots in the same order");
  images(RigCamera::Vertical, "--vertical", "Of its neighbour in the column, as above");
  app.add_option("--board",
                 options.board,
                 "Inner corners of the chessboard, one count even, the other odd")
      ->type_name("COLUMNSxROWS");
  app.add_option(
         "--square", options.square, "Side of a square of the board, metres, measured")
      ->type_name("M")
      ->required()
      ->default_str("");
  app.add_option("-o,--output", options.output, "Where the calibration goes")
      ->type_name("RIG.yaml")
      ->required();
}

/** \throws UsageError when the text of the board is malformed */
CalibrationBoard
boardOf(const CalibrationOptions& options)
{
  CalibrationBoard board;
  board.square = options.square;
  const auto corners = crossedNumbers(options.board);
  if (!corners || (*corners)[0] < 3 || (*corners)[1] < 3)
    throw UsageError("--board: '" + options.board.substr(0, 40) +
                     "' is none: two counts from 3 on are needed, as in 9x6");
  board.columns = (*corners)[0];
  board.rows = (*corners)[1];
  return board;
}

/** \throws UsageError when there is no neighbour, the lists differ in length, an image
 * occurs twice, or a session is named too */
void
requireShots(const CalibrationOptions& options)
{
  const auto& [reference, horizontal, vertical] = options.images;
  if (reference.empty() == options.session.empty())
    throw UsageError("either --session or --reference is needed");
  if (!options.session.empty()) {
    if (!horizontal.empty() || !vertical.empty())
      throw UsageError("--session has the images of all cameras");
    return;
  }
  if (horizontal.empty() && vertical.empty())
    throw UsageError("--horizontal or --vertical is needed, or both");
  std::set<std::string> paths;
  for (const std::vector<std::string>& list : options.images) {
    if (!list.empty() && list.size() != reference.size())
      throw UsageError("the cameras have " + std::to_string(reference.size()) + ", " +
                       std::to_string(horizontal.size()) + " and " +
                       std::to_string(vertical.size()) +
                       " images: all need one of each shot");
    for (const std::string& path : list)
      if (!paths.insert(path).second)
        throw UsageError(path + ": stands twice among the images");
  }
}

/** \brief Adds the board images with their errors, or the reasons why they were left
 * out, to the report, and reports those that were left out. */
void
tellImages(const RigCalibratorReport& calibrated, StageLog& log)
{
  auto images = nlohmann::ordered_json::array();
  for (const BoardImage& image : calibrated.images) {
    const bool is_used = image.reason.empty();
    images.push_back(fieldsOf(image, {{is_used ? "left_out" : "reprojection"}}));
    if (!is_used)
      log.warn("left out: " + image.name + ": " + image.reason);
  }
  log.details["images"] = std::move(images);
}

/** \brief Writes summary, report and warnings of a successful calibration. */
void
tellCalibration(const RigCalibratorReport& calibrated,
                const TrinocularRig& rig,
                StageLog& log)
{
  nlohmann::ordered_json& details = log.details;
  for (std::size_t i = 0; i < calibrated.boards.size(); ++i) {
    if (calibrated.boards[i] == 0)
      continue;
    details["cameras"][nameOf(static_cast<RigCamera>(i))] = {
        {"boards", calibrated.boards[i]}, {"reprojection", calibrated.reprojection[i]}};
    log.tell(nameOf(static_cast<RigCamera>(i)),
             std::to_string(calibrated.boards[i]) + " boards, reprojection " +
                 shortNumber(calibrated.reprojection[i]) + " px");
  }
  details.update(fieldsOf(calibrated, {{"images"}, {"boards"}, {"reprojection"}}));
  details["rig"] = {{"width", rig.width},
                    {"height", rig.height},
                    {"focal_length", rig.focal_length},
                    {"baseline_horizontal", rig.baseline_horizontal},
                    {"baseline_vertical", rig.baseline_vertical}};
  if (calibrated.boards[1] > 0)
    log.tell("rows", shortNumber(calibrated.row_residual) + " px off");
  if (calibrated.boards[2] > 0)
    log.tell("columns", shortNumber(calibrated.column_residual) + " px off");
  log.tell("coverage", shortNumber(100 * calibrated.coverage) + " % of the image");
  log.tell("focal length", shortNumber(rig.focal_length) + " px");
  log.tell("baselines",
           shortNumber(rig.baseline_horizontal) + " m, " +
               shortNumber(rig.baseline_vertical) + " m");
  log.warn(calibrated.remarks);
}

std::vector<std::string>
allImages(const CalibrationOptions& options)
{
  std::vector<std::string> all;
  for (const std::vector<std::string>& list : options.images)
    all.insert(all.end(), list.begin(), list.end());
  return all;
}

void
addShot(const CalibrationOptions& options, std::size_t shot, RigCalibrator& calibrator)
{
  TrinocularFrame frame;
  std::array<std::string, 3> names;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (options.images[i].empty())
      continue;
    names[i] = options.images[i][shot];
    frame.images[i] = loadCameraImage(names[i]);
  }
  calibrator.addShot(frame, names);
}

void
addFrame(const TrinocularFileGrabber& session,
         std::size_t index,
         RigCalibrator& calibrator)
{
  const TrinocularFrame::ConstPtr frame = session.frame(index);
  std::array<std::string, 3> names;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!frame->images[i].empty())
      names[i] = "frame " + std::to_string(frame->number) + ", " +
                 nameOf(static_cast<RigCamera>(i));
  calibrator.addShot(*frame, names);
}

void
addShots(const CalibrationOptions& options,
         const ProgressCallback& progress,
         RigCalibrator& calibrator)
{
  std::optional<TrinocularFileGrabber> session;
  if (!options.session.empty())
    session.emplace(options.session);
  const std::size_t shots = session ? session->frames() : options.images.front().size();
  const Progress told(progress);
  for (std::size_t shot = 0; shot < shots; ++shot) {
    told.tell(static_cast<double>(shot) / static_cast<double>(shots),
              "looking for boards");
    if (session)
      addFrame(*session, shot, calibrator);
    else
      addShot(options, shot, calibrator);
  }
}

void
calibrate(const CalibrationOptions& options,
          const RunControls& controls,
          RigCalibrator& calibrator,
          StageLog& log)
{
  StepTimer timer(log.report);
  addShots(options, controls.progress, calibrator);
  timer.finish("boards");

  RigCalibration cameras;
  TrinocularRig rig;
  try {
    calibrator.calibrate(cameras, rig);
  }
  catch (const PCLException&) {
    const std::vector<BoardImage>& images = calibrator.getReport().images;
    const bool none =
        std::all_of(images.begin(), images.end(), [](const BoardImage& image) {
          return !image.reason.empty();
        });
    tellImages(calibrator.getReport(), log);
    log.failWithNothing(
        failureOf(std::current_exception()).line +
        (none ? "; --board counts inner corners, a square less each way" : ""));
  }
  timer.finish("calibrate");
  stopIfInterrupted();
  saveRigCalibration(options.output, rig, cameras);
  timer.finish("write");
  log.details["output"] = options.output;
  tellImages(calibrator.getReport(), log);
  tellCalibration(calibrator.getReport(), rig, log);
  log.tell("file", options.output);
}

} // namespace

} // namespace pcl::acmap

int
main(int argc, char** argv)
{
  using namespace pcl::acmap;
  Tool tool("pcl_rig_calibration",
            "Calibrates a trinocular rig from images of a chessboard.");
  CalibrationOptions options;
  addOptions(tool, options);
  tool.setHelp({{{"pcl_rig_calibration --board 9x6 --square 0.024 --reference r*.png "
                  "--horizontal h*.png --vertical v*.png -o rig.yaml",
                  "A rig of three cameras."}},
                {}});
  return tool.run(argc, argv, [&] {
    const std::vector<std::string> images = allImages(options);
    requireShots(options);
    pcl::RigCalibrator calibrator;
    calibrator.setBoard(boardOf(options));
    requireWritable(options.output, {".yaml", ".yml"}, images);
    tool.requireReportWritable(images);
    calibrate(options, tool.controls(), calibrator, tool.log());
  });
}
