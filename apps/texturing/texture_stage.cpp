#include "texture_stage.h"

#include "setter_option.h"
#include "stage_reports.h"

#include <pcl/core/impl/size_text.h>
#include <pcl/core/process_memory.h>
#include <pcl/pipeline/cost_callback.h>
#include <pcl/pipeline/map_sizes.h>
#include <pcl/point_types.h>
#include <pcl/texture/plane_texturing.h>

#include <CLI/CLI.hpp>

namespace pcl::acmap {

using Texturing = PlaneTexturing<PointXYZRGB>;

void
tellTexture(const TexturingReport& report, StageLog& log)
{
  log.warn(report.remarks);
  log.details["texture"] = jsonOf(report);
  log.tell("painted",
           std::to_string(report.charts) + " charts, " + std::to_string(report.texels) +
               " texels of " + shortNumber(1000 * report.texel_size) + " mm, " +
               percent(report.seen, report.texels) + " seen, " +
               percent(report.filled, report.texels) + " filled");
}

void
addTextureOptions(Tool& tool, TextureOptions& options)
{
  CLI::App& app = tool.options();
  Texturing& stage = options.stage;
  addSetter(
      app,
      "--texel",
      stage,
      &Texturing::setTexelSize,
      &Texturing::getTexelSize,
      "Edge of a texel, metres [default: a pixel of the first observation on what is "
      "near, 0.003 to 0.03; half the spacing of points that are not in an image]",
      "M")
      ->default_str("");
  addSetter(app,
            "--max-distance",
            stage,
            &Texturing::setMaximumDistance,
            &Texturing::getMaximumDistance,
            "How far a point may be from the plane it colours, metres",
            "M");
  addSetter(
      app,
      "--max-texture",
      stage,
      &Texturing::setMaximumTextureSize,
      &Texturing::getMaximumTextureSize,
      "Texels a side; larger polygons get several textures, larger cylinders larger "
      "texels",
      "N");
  addSetter(
      app,
      "--fill",
      stage,
      &Texturing::setFillDistance,
      &Texturing::getFillDistance,
      "How far holes are filled from their rims, texels [default: 0.1 m, at least 5]",
      "N")
      ->default_str("");
  addSwitch(app,
            "--keep-exposure",
            stage,
            &Texturing::setCorrectExposure,
            false,
            "Take the colours as they are, without a gain for each view");
  app.add_flag(
      "--jpeg", options.outputs.jpeg_images, "Write the images as JPEG instead of PNG");
  app.add_option("--quality", options.outputs.jpeg_quality, "Of JPEG images, 1 to 100")
      ->type_name("N")
      ->check(CLI::Range(1, 100).description(""));
  app.add_flag("--ply",
               options.outputs.vertex_ply,
               "Write map.ply too, with a coloured vertex for each texel");
  app.add_flag("--skip-broken",
               options.skip_broken,
               "Leave observations out that cannot be read, instead of stopping");
}

MapPainting
paintingOf(const TextureOptions& options, const RunControls& controls)
{
  MapPainting painting;
  painting.texturing = options.stage;
  painting.skip_broken = options.skip_broken;
  painting.threads = controls.threads;
  painting.progress = controls.progress;
  painting.cost = memoryCheck();
  return painting;
}

void
tellCompactness(std::size_t points,
                const CompactMap& map,
                const std::string& folder,
                StageLog& log)
{
  const MapSizes sizes = measureMap(map, points, folder);
  const auto ratio = [&](std::size_t bytes) { return ratioText(sizes.ratioTo(bytes)); };
  log.tell("compactness",
           ratio(sizes.textured()) + " with texture, " + ratio(sizes.glb) +
               " with details, " + ratio(sizes.geometry) + " geometry alone, " +
               ratio(sizes.json) + " map.json");
  log.details["bytes"] = {{"raw", sizes.raw},
                          {"geometry", sizes.geometry},
                          {"details", sizes.details},
                          {"map.glb", sizes.glb},
                          {"map.json", sizes.json},
                          {"textured", sizes.textured()}};
}

} // namespace pcl::acmap
