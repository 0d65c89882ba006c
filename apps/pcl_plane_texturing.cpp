#include "output_target.h"
#include "reading_options.h"
#include "texturing/texture_stage.h"

#include <pcl/core/map_file.h>
#include <pcl/core/output_folder.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/texture/compact_map_folder.h>

#include <CLI/CLI.hpp>

namespace {

using namespace pcl::acmap;

struct Options {
  std::string planes;
  std::string observations;
  std::string output;
  TextureOptions texture;
};

void
addOptions(Tool& tool, Options& options)
{
  CLI::App& app = tool.options();
  app.add_option(
         "planes",
         options.planes,
         "Planes and cylinders in the frame of the poses, of pcl_plane_extraction")
      ->type_name("PLANES.json")
      ->required();
  app.add_option("observations",
                 options.observations,
                 "Folder of observation PCDs with their poses, or one coloured cloud "
                 "(.pcd, .ply, .obj) in the frame of the planes")
      ->type_name("POSED_DIR")
      ->required();
  app.add_option("-o,--output", options.output, "Folder for the compact map")
      ->type_name("OUT_DIR")
      ->required();
  addTextureOptions(tool, options.texture);
  tool.addThreads();
  addScale(app, tool.reader());
}

void
checkOptions(const Tool& tool, const Options& options)
{
  const OutputFolder folder(options.output); // fails now rather than after the work
  if (folder.holds(options.planes) || folder.holds(options.observations))
    throw UsageError(options.output + ": holds an input, which the map could replace; "
                                      "name another folder");
  tool.requireReportWritable({options.planes});
}

pcl::PaintedMap
paint(const Options& options,
      const pcl::CompactMap& surfaces,
      const RunControls& controls)
{
  const pcl::MapPainting painting = paintingOf(options.texture, controls);
  const std::string ending = endingOf(options.observations);
  if (ending != ".pcd" && ending != ".ply" && ending != ".obj")
    return paintMap(
        surfaces,
        pcl::ObservationSequence(options.observations, controls.reader.getScale()),
        painting);
  const auto cloud = std::make_shared<const pcl::PointCloudFile>(
      controls.reader.read(options.observations));
  return paintMap(surfaces, sharedCloud(cloud), painting);
}

void
run(const Options& options, const RunControls& controls, StageLog& log)
{
  StepTimer timer(log.report);
  const pcl::CompactMap surfaces = pcl::loadMapFile(options.planes);
  if (surfaces.planes.empty() && surfaces.cylinders.empty())
    throw NothingFound(options.planes + ": holds no plane");
  timer.finish("read");
  pcl::PaintedMap painted = paint(options, surfaces, controls);
  log.warn(painted.remarks);
  tellTexture(painted.report, log);
  timer.finish("paint");
  stopIfInterrupted();
  for (const std::string& name :
       pcl::saveCompactMap(options.output, painted.map, options.texture.outputs))
    log.tell("file", options.output + "/" + name);
  timer.finish("write");
  log.details["planes"] = surfaces.planes.size();
  log.details["cylinders"] = surfaces.cylinders.size();
}

} // namespace

int
main(int argc, char** argv)
{
  Tool tool("pcl_plane_texturing",
            "Paints planes with what was seen of them: a compact map.");
  Options options;
  addOptions(tool, options);
  tool.setHelp({{{"pcl_plane_texturing planes.json clouds -o map",
                  "A textured map of planes and of the observations that saw them."}},
                {}});
  return tool.run(argc, argv, [&] {
    checkOptions(tool, options);
    run(options, tool.controls(), tool.log());
  });
}
