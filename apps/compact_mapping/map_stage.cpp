#include "map_stage.h"

#include "length_check.h"
#include "map_pictures.h"
#include "merged_map.h"
#include "plane_extraction/plane_outputs.h"
#include "plane_extraction/plane_reports.h"

#include <pcl/core/map_up.h>
#include <pcl/core/point_cloud_writer.h>
#include <pcl/core/scaled_cloud.h>
#include <pcl/pipeline/observation_files.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

/** \brief What the input became. */
struct Mapped {
  Extraction extraction;
  CompactMap map;
};

Mapped
mapSequence(Tool& tool,
            const ChainOptions& options,
            const ObservationSequence& posed,
            const OutputFolder& folder,
            StepTimer& timer)
{
  Mapped result;
  {
    const MergedMap merged = mergeObservations(
        tool,
        posed,
        options.planes.isInSpace() ? DepthSensor::Laser : options.planes.sensor,
        options.texture.skip_broken,
        options.most_points);
    timer.finish("read");
    warnOfLengths(tool, merged.file);
    tool.details()["observations"] = merged.observations;
    tool.tell("read",
              std::to_string(merged.observations) + " observations, " +
                  std::to_string(merged.file.points().size()) + " points");
    if (merged.refined > 0)
      tool.tell("refined",
                "the quantised depth of " + std::to_string(merged.refined) +
                    " observations");
    result.extraction =
        extractFromCloud(tool, options.planes, timer, merged.file, merged.sensors());
    savePointCloud(folder.path("map.pcd"), thinned(merged.file.cloud));
    timer.finish("write");
  }
  requirePlanes(tool, options.input, result.extraction);
  result.map =
      paintPlanes(tool, result.extraction.clusters.patches, posed, options.texture);
  saveTrajectory(folder.path(trajectory_name), result.map.trajectory);
  return result;
}

Mapped
mapCloud(Tool& tool, const ChainOptions& options, StepTimer& timer)
{
  const PointCloudFile file = loadScaledCloud(options.input, tool.scale());
  timer.finish("read");
  warnOfLengths(tool, file);
  Mapped result;
  result.extraction = extractFromCloud(tool, options.planes, timer, file);
  requirePlanes(tool, options.input, result.extraction);
  result.map =
      paintPlanes(tool, result.extraction.clusters.patches, file, options.texture);
  return result;
}

/** \brief What shows the rectification goes with the map that it straightened. */
void
takeAlong(const Chain& chain, const OutputFolder& folder)
{
  for (const char* name : {"trajectory_before.txt", "plan.png", "energy.png"}) {
    const fs::path from = fs::path(chain.folderOf("rectification")) / name;
    std::error_code error;
    fs::copy_file(from, folder.path(name), error);
    if (error)
      throw OutputFileException(folder.name() + "/" + name + ": " + error.message());
  }
}

/** \brief A picture that cannot be drawn costs the pictures, not the map. */
void
drawPictures(Tool& tool, const OutputFolder& folder, const Mapped& mapped)
{
  try {
    savePictures(folder, mapped.extraction, mapped.map);
  }
  catch (const InitFailedException& error) {
    tool.warn("not all pictures could be drawn: " + std::string(error.what()));
  }
}

/** \brief In the order of map.json, which has more of each. */
nlohmann::ordered_json
jsonOf(const std::vector<PlanePatch>& planes)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t id = 0; id < planes.size(); ++id) {
    const Eigen::Vector4d& n = planes[id].coefficients;
    list.push_back({{"id", id},
                    {"coefficients", {n[0], n[1], n[2], n[3]}},
                    {"area", planes[id].area},
                    {"rmse", planes[id].rms},
                    {"support", planes[id].support}});
  }
  return list;
}

/** \brief Which direction pictures take for up, and how far the map's frame is off it. */
void
tellUp(Tool& tool, const CompactMap& map)
{
  constexpr double degrees = 180 / 3.14159265358979323846;
  const Eigen::Vector3d up = upDirection(map);
  const double tilt = degrees * std::acos(std::min(1.0, up.dot(upAxis(map))));
  tool.details()["up"] = {up.x(), up.y(), up.z()};
  tool.details()["tilt_deg"] = tilt;
  if (tilt > least_tilt_told)
    tool.tell("tilted",
              "the frame of the map by " + shortNumber(tilt) +
                  " degrees, by its planes; pictures are drawn along the floor");
}

void
tellMap(Tool& tool, const ChainOptions& options, const Mapped& mapped)
{
  tellPlanes(tool,
             mapped.extraction.clusters.patches,
             mapped.extraction.input_labels,
             mapped.extraction.finite_points);
  tool.details()["planes"] = jsonOf(mapped.map.planes);
  tellUp(tool, mapped.map);
  tellCompactness(tool, mapped.extraction.finite_points, mapped.map, options.output);
}

} // namespace

std::vector<std::string>
makeMap(Tool& tool,
        const ChainOptions& options,
        const Chain& chain,
        const Sequence& sequence,
        bool draws,
        OutputFolder& folder)
{
  StepTimer timer(tool.report());
  Mapped mapped = sequence.posed
                      ? mapSequence(tool, options, *sequence.posed, folder, timer)
                      : mapCloud(tool, options, timer);
  timer.finish("paint");
  tool.stopIfInterrupted();

  saveCompactMap(folder.path(""), mapped.map, options.texture.outputs);
  saveNormals(folder.path("mesh.ply"),
              mapped.extraction.mesh,
              mapped.extraction.clusters.labels);
  if (sequence.is_rectified)
    takeAlong(chain, folder);
  timer.finish("write map");
  if (draws)
    drawPictures(tool, folder, mapped);
  timer.finish("pictures");
  tool.stopIfInterrupted();
  std::vector<std::string> names = filesIn(folder.path(""));
  folder.commit();
  tellMap(tool, options, mapped);
  return names;
}

} // namespace pcl::acmap
