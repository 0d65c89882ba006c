#include "calibration_options.h"

#include "command_line.h"

#include <CLI/CLI.hpp>

#include <set>

namespace pcl::acmap {

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

} // namespace pcl::acmap
