#include "calibration_results.h"

#include <algorithm>

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

} // namespace

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

} // namespace pcl::acmap
