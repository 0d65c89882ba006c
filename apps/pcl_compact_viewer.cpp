#include "cloud_labels.h"
#include "compact_viewer/viewer_input.h"
#include "compact_viewer/viewer_options.h"
#include "memory.h"
#include "output_target.h"
#include "tool.h"

#include <cstdio>

namespace {

using namespace pcl::acmap;

void
checkPlaces(const Tool& tool, const ViewerOptions& options)
{
  if (!options.screenshot.empty())
    requireWritable(options.screenshot, {".png"}, {options.input});
  tool.requireReportWritable({options.input, options.screenshot});
}

void
summarize(Tool& tool, const ViewerOptions& options, const ViewerInput& input)
{
  const pcl::LayeredScene& scene = input.scene;
  const std::size_t points = pointsIn(scene);
  const std::size_t triangles = scene.mesh.triangles.size();
  tool.details() = {{"input", options.input},
                    {"output", options.screenshot},
                    {"report",
                     {{"points", points},
                      {"triangles", triangles},
                      {"planes", scene.map.planes.size()},
                      {"poses", scene.map.trajectory.poses.size()}}}};
  for (const std::string& remark : input.remarks)
    tool.warn(remark);
  tool.tell("points", std::to_string(points));
  tool.tell("triangles", std::to_string(triangles));
  tool.tell("planes", std::to_string(scene.map.planes.size()));
  if (!options.screenshot.empty())
    tool.tell("file", options.screenshot);
}

void
colorByLabel(pcl::LayeredScene& scene)
{
  if (scene.points.width != 0)
    scene.points = coloredByLabel(std::move(scene.points));
  if (scene.vertices.width != 0 || scene.points.width == 0)
    scene.vertices = coloredByLabel(std::move(scene.vertices));
}

/** \brief Chooses the plan for a cloud with poses: from outside, only its ceilings
 * would be visible. */
void
choosePlace(const ViewerOptions& options,
            const pcl::LayeredScene& scene,
            pcl::LayeredView& view)
{
  const bool is_chosen = !options.place.empty() || view.from || view.at_pose;
  if (!is_chosen && scene.map.planes.empty() && scene.mesh.triangles.empty() &&
      !scene.map.trajectory.poses.empty())
    view.place = pcl::MapView::Place::Plan;
}

void
tellUser(const std::string& text)
{
  std::fputs(text.c_str(), stdout);
  std::fflush(stdout);
}

void
show(Tool& tool, const ViewerOptions& options)
{
  checkPlaces(tool, options);
  pcl::LayeredView view = viewOf(options);
  StepTimer timer(tool.report());
  ViewerInput input = loadViewerInput(options.input, tool.scale());
  timer.finish("read");
  if (options.labels)
    colorByLabel(input.scene);
  view.sensor_origin = input.sensor_origin;
  view.sensor_orientation = input.sensor_orientation;
  if (!view.up)
    view.up = input.up;
  choosePlace(options, input.scene, view);
  tool.stopIfInterrupted();

  const UnlimitedMemory while_drawing;
  if (options.screenshot.empty()) {
    obeyInterruptions();
    pcl::showScene(options.input, input.scene, view, tellUser);
  }
  else
    pcl::saveSnapshot(options.screenshot, input.scene, view);
  timer.finish("draw");
  summarize(tool, options, input);
}

} // namespace

int
main(int argc, char** argv)
{
  Tool tool(
      "pcl_compact_viewer",
      "Shows a map, a triangle mesh or a point cloud, in a window or as a picture.");
  ViewerOptions options;
  addOptions(tool, options);
  return tool.run(argc, argv, [&] { show(tool, options); });
}
