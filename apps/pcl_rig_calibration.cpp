#include "output_target.h"
#include "rig_calibration/calibration_options.h"
#include "rig_calibration/calibration_results.h"

#include <pcl/acquisition/trinocular_file_grabber.h>
#include <pcl/core/rig_calibration.h>
#include <pcl/stereo/rig_calibrator.h>

#include <algorithm>
#include <optional>

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
