#include "compact_mapping/map_pictures.h"
#include "compact_mapping/merged_map.h"
#include "output_target.h"
#include "plane_extraction/extraction.h"
#include "plane_extraction/plane_outputs.h"
#include "plane_extraction/plane_reports.h"
#include "scaled_cloud.h"
#include "texturing/texture_stage.h"

#include <pcl/core/output_folder.h>
#include <pcl/visualization/display_connection.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>

namespace {

using namespace pcl::acmap;

struct Options {
  PlaneOptions planes; ///< its input is the tool's
  std::string output;
  bool no_pictures = false;
  TextureOptions texture;
};

void
addOptions(Tool& tool, Options& options)
{
  CLI::App& app = tool.options();
  app.add_option(
         "input",
         options.planes.input,
         "Folder of observation PCDs with their poses, or one cloud (.pcd, .ply, "
         ".obj, .xyz)")
      ->type_name("INPUT")
      ->required();
  app.add_option("-o,--output", options.output, "Folder for the compact map")
      ->type_name("OUT_DIR")
      ->required();
  addPlaneChoices(tool, options.planes);
  addTextureOptions(tool, options.texture);
  app.add_flag("--no-pictures",
               options.no_pictures,
               "Draw no pictures, which need an X server, as xvfb-run gives");
  tool.addThreads();
  tool.addScale();
}

bool
isCloudFile(const std::string& path)
{
  std::error_code error;
  return !std::filesystem::is_directory(path, error);
}

/** \brief An X server for the pictures; none, and a warning, where there is none. */
std::unique_ptr<DisplayConnection>
openDisplay(Tool& tool, const Options& options)
{
  if (options.no_pictures)
    return nullptr;
  try {
    return std::make_unique<DisplayConnection>();
  }
  catch (const pcl::InitFailedException&) {
    tool.warn("no pictures: no X server answers; run the tool under xvfb-run -a");
    return nullptr;
  }
}

/** \brief What the input became. */
struct Mapped {
  Extraction extraction;
  pcl::CompactMap map;
};

Mapped
mapFolder(Tool& tool, const Options& options, StepTimer& timer)
{
  const PosedFolder folder(options.planes.input, tool.scale());
  Mapped result;
  {
    const MergedMap merged =
        mergeObservations(tool, folder, options.texture.skip_broken);
    timer.finish("read");
    tool.details()["observations"] = merged.observations;
    tool.tell("read",
              std::to_string(merged.observations) + " observations, " +
                  std::to_string(merged.file.points().size()) + " points");
    result.extraction =
        extractFromCloud(tool, options.planes, timer, merged.file, merged.sensors());
  }
  requirePlanes(tool, options.planes, result.extraction);
  result.map =
      paintPlanes(tool, result.extraction.clusters.patches, folder, options.texture);
  return result;
}

Mapped
mapCloud(Tool& tool, const Options& options, StepTimer& timer)
{
  const pcl::PointCloudFile file = loadScaledCloud(options.planes.input, tool.scale());
  timer.finish("read");
  Mapped result;
  result.extraction = extractFromCloud(tool, options.planes, timer, file);
  requirePlanes(tool, options.planes, result.extraction);
  result.map =
      paintPlanes(tool, result.extraction.clusters.patches, file, options.texture);
  return result;
}

/** \brief A picture that cannot be drawn costs the pictures, not the map. */
void
drawPictures(Tool& tool, const OutputFolder& folder, const Mapped& mapped)
{
  try {
    savePictures(folder, mapped.extraction, mapped.map);
  }
  catch (const pcl::InitFailedException& error) {
    tool.warn("not all pictures could be drawn: " + std::string(error.what()));
  }
}

void
run(Tool& tool, const Options& options)
{
  checkChoices(options.planes);
  const std::unique_ptr<DisplayConnection> display = openDisplay(tool, options);
  OutputFolder folder(options.output);
  tool.requireReportWritable({options.planes.input});
  if (folder.holds(options.planes.input))
    throw UsageError(options.planes.input + ": lies in the folder that is to hold the "
                                            "map; name another one");
  StepTimer timer(tool.report());
  Mapped mapped = isCloudFile(options.planes.input) ? mapCloud(tool, options, timer)
                                                    : mapFolder(tool, options, timer);
  timer.finish("paint");
  tool.stopIfInterrupted();

  const std::string place = folder.path("");
  pcl::saveCompactMap(place, mapped.map, options.texture.outputs);
  saveNormals(folder.path("mesh.ply"),
              mapped.extraction.mesh,
              mapped.extraction.clusters.labels);
  timer.finish("write");
  if (display)
    drawPictures(tool, folder, mapped);
  timer.finish("pictures");
  tool.stopIfInterrupted();
  folder.commit();
  tellPlanes(tool,
             mapped.extraction.clusters.patches,
             mapped.extraction.input_labels,
             mapped.extraction.finite_points);
  tool.details()["planes"] = mapped.map.planes.size();
  tellCompactness(tool, mapped.extraction.finite_points, mapped.map, options.output);
  tool.tellSeconds();
  tool.tell("folder", options.output);
  tool.setReportPlace(options.output + "/report.json");
}

} // namespace

int
main(int argc, char** argv)
{
  Tool tool("pcl_compact_mapping",
            "Turns point clouds of a building into a few textured planes.");
  Options options;
  addOptions(tool, options);
  return tool.run(argc, argv, [&] { run(tool, options); });
}
