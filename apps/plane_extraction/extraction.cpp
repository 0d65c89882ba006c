#include "extraction.h"

#include "length_check.h"
#include "setter_option.h"
#include "stage_reports.h"

#include <pcl/core/patch_text.h>
#include <pcl/core/process_memory.h>
#include <pcl/pipeline/cloud_labels.h>
#include <pcl/pipeline/mapped_planes.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

constexpr std::size_t max_lines = 20, lines_of_many = 5;

std::size_t
countLabelled(const PointLabels& labels)
{
  return static_cast<std::size_t>(std::count_if(
      labels.begin(), labels.end(), [](auto label) { return label >= 0; }));
}

/** Tells each item of a list that is sorted by decreasing size, or the largest ones if
 * there are many.
 * \param[in] plural of what it is */
template <typename Item>
void
tellEach(const std::string& what,
         const std::string& plural,
         const std::vector<Item>& items,
         StageLog& log)
{
  const std::size_t listed = items.size() <= max_lines ? items.size() : lines_of_many;
  for (std::size_t id = 0; id < listed; ++id)
    log.tell(what + " " + std::to_string(id), textOf(items[id]));
  if (listed < items.size())
    log.tell("further " + plural,
             std::to_string(items.size() - listed) + " smaller ones, in the file");
}

void
tellCylinders(const MappedPlanes& found, StageLog& log)
{
  const std::size_t points = countLabelled(found.cylinder_labels);
  log.details["points_on_cylinders"] = points;
  log.tell("cylinders", std::to_string(found.cylinders.size()));
  if (!found.cylinders.empty())
    log.tell("on cylinders", percent(points, found.finite_points) + " of the points");
  tellEach("cylinder", "cylinders", found.cylinders, log);
}

void
tellInSpace(const PlaneMappingReport& report, StageLog& log)
{
  nlohmann::ordered_json& details = log.details;
  if (report.consolidation)
    tellConsolidation(*report.consolidation, log);
  else if (report.mode == MappingMode::Paper)
    log.tell("consolidated", "no, the paper takes raw points");
  else if (report.noise_scale)
    log.tell("consolidated", "no, the points lie close enough to their surface");
  if (report.mesh)
    details["mesh"] = jsonOf(*report.mesh);
  details["votes"] = jsonOf(*report.votes);
  details["report"] = jsonOf(*report.planes);
}

void
tellInPicture(const PlaneMappingReport& report, StageLog& log)
{
  nlohmann::ordered_json& details = log.details;
  tellDepthNoise(report.depth_planes->noise, log);
  details["report"] = jsonOf(*report.depth_planes, {{"noise"}});
  if (report.refinement)
    tellRefinement(*report.refinement, log);
  if (report.mesh)
    details["mesh"] = jsonOf(*report.mesh);
  if (report.votes)
    details["votes"] = jsonOf(*report.votes);
}

/** The bits of the description before and after. */
void
tellBits(const PlaneMappingReport& report, StageLog& log)
{
  const auto tell = [&](const std::string& what, double before, double after) {
    log.tell("description",
             what + ": " + std::to_string(std::lround(before)) + " bits before, " +
                 std::to_string(std::lround(after)) + " after");
  };
  if (report.cylinders && report.cylinders->cylinders > 0)
    tell("cylinders", report.cylinders->bits_before, report.cylinders->bits_after);
  if (report.boxes && report.boxes->boxes > 0)
    tell("boxes", report.boxes->bits_before, report.boxes->bits_after);
  if (report.recesses && report.recesses->recesses > 0)
    tell("recesses", report.recesses->bits_before, report.recesses->bits_after);
}

/** Changes both steps that find planes, of which a mapping has copies. */
template <typename Change>
void
changePlanes(PlaneMapping& mapping, const Change& change)
{
  PlaneMapping::Clustering clustering = mapping.getClustering();
  PlaneMapping::DepthSegmentation segmentation = mapping.getDepthSegmentation();
  change(clustering);
  change(segmentation);
  mapping.setClustering(clustering);
  mapping.setDepthSegmentation(segmentation);
}

} // namespace

CostCallback
costCheck(const RunControls& controls)
{
  return [&controls](const std::string& work, std::size_t bytes, double seconds) {
    constexpr double long_time = 60;
    if (bytes > 0)
      requireMemory(bytes, work);
    if (seconds > long_time && controls.warn_at_once)
      controls.warn_at_once("the paper's clustering compares each hypothesis with all "
                            "points within 0.8 m "
                            "of it: that may take about " +
                            std::to_string(std::lround(seconds / 60)) +
                            " min; without --paper it takes seconds");
  };
}

PlaneMapping
mappingOf(const PlaneOptions& options, unsigned threads)
{
  PlaneMapping mapping = options.stage;
  if (options.paper)
    mapping.setMode(MappingMode::Paper);
  mapping.setDepthSensor(options.sensor);
  mapping.setComputeCylinders(options.findsPrimitives());
  mapping.setComputeBoxes(options.findsPrimitives());
  mapping.setNumberOfThreads(threads);
  return mapping;
}

void
tellMapping(const PlaneMappingReport& report, StageLog& log)
{
  log.warn(report.remarks);
  log.details["mode"] = nameIn(mapping_mode_names, report.mode);
  if (report.assessment)
    tellAssessment(*report.assessment, log);
  log.details["consolidated_points"] = report.consolidated_points;
  if (report.depth_planes)
    tellInPicture(report, log);
  else
    tellInSpace(report, log);
  if (report.cylinders)
    log.details["cylinder_report"] = jsonOf(*report.cylinders);
  if (report.boxes)
    log.details["box_report"] = jsonOf(*report.boxes);
  if (report.recesses)
    log.details["recess_report"] = jsonOf(*report.recesses);
  tellBits(report, log);
  for (const auto& [step, seconds] : report.seconds)
    log.report.seconds.emplace_back(step, seconds);
}

void
addPlaneChoices(Tool& tool, PlaneOptions& options)
{
  CLI::App& app = tool.options();
  PlaneMapping& stage = options.stage;
  tool.addLengthOrAuto(
      "--consolidate",
      [&stage](double voxel_size) {
        PlaneMapping::Consolidation consolidation = stage.getConsolidation();
        consolidation.setVoxelSize(voxel_size);
        stage.setConsolidation(consolidation);
        stage.setConsolidationPolicy(ConsolidationPolicy::Always);
      },
      "The voxel's edge in metres to which a cloud is consolidated "
      "[default: by its noise and spacing, and not at all where that "
      "is small]; given for a mesh, its vertices are taken as a "
      "cloud");
  addSetter<double>(
      app,
      "--min-area",
      [&stage](double area) {
        changePlanes(stage, [area](auto& step) { step.setMinArea(area); });
      },
      "Least area of a plane in square metres [default: 0.1, or 0.3 % of the "
      "surface where that is less]",
      "M2");
  addSetter<double>(
      app,
      "--tolerance",
      [&stage](double distance) {
        PlaneMapping::Clustering clustering = stage.getClustering();
        clustering.setDistanceThreshold(distance);
        stage.setClustering(clustering);
      },
      "How far off a plane in metres points and bumps are still of it "
      "[default: by the noise, warped walls up to 0.025]",
      "M");
  tool.addSensor(options.sensor);
  app.add_flag_callback(
      "--regular",
      [&stage] { changePlanes(stage, [](auto& step) { step.setRegularize(true); }); },
      "Turn planes to be exactly parallel or at right angles to larger ones, "
      "within their own uncertainty and a degree");
  app.add_flag_function(
      "--primitives,!--no-primitives",
      [&](std::int64_t times) { options.primitives = times > 0; },
      "Find cylinders, too: columns, pipes and curved walls, which replace the planes "
      "that they describe in fewer bits; and boxes and recesses such as closed doors, "
      "whose sides and leaves stay planes [default: " +
          std::string(options.primitives_by_default ? "yes" : "no") + "]");
}

void
checkChoices(const PlaneOptions& options)
{
  const auto refuse = [&](bool is_given, const std::string& option) {
    if (options.paper && is_given)
      throw UsageError(option + " departs from the paper, leave it out with --paper");
  };
  const PlaneMapping::Clustering& clustering = options.stage.getClustering();
  refuse(options.consolidates(), "--consolidate");
  refuse(clustering.getMinArea() > 0, "--min-area");
  refuse(clustering.getDistanceThreshold().has_value(), "--tolerance");
  refuse(clustering.getRegularize(), "--regular");
  refuse(options.primitives.value_or(false), "--primitives");
  if (options.sensor != DepthSensor::Automatic && options.isInSpace())
    throw UsageError(
        "--sensor is not used with --consolidate, --tolerance and --paper, "
        "which work in space: leave it out");
}

MappedPlanes
extractPlanes(const PlaneOptions& options,
              const CloudRows& rows,
              const std::shared_ptr<const PointCloudFile>& file,
              std::vector<Eigen::Vector3f> viewpoints,
              const RunControls& controls,
              StageLog& log,
              TriangleMesh mesh)
{
  if (const double size = options.stage.getConsolidation().getVoxelSize(); size > 0)
    requireFineLength("--consolidate", size, requirePoints(rows), log);
  PlaneMapping mapping = mappingOf(options, controls.threads);
  mapping.setInputCloud(rows, file);
  mapping.setInputMesh(std::move(mesh));
  mapping.setViewpoints(std::move(viewpoints));
  mapping.setCostCallback(costCheck(controls));
  mapping.setProgressCallback(controls.progress);
  MappedPlanes found;
  try {
    mapping.compute(found);
  }
  catch (const UnorganizedPointCloudException&) {
    throw UsageError(needs_picture);
  }
  tellMapping(mapping.getReport(), log);
  warnOfSensor(options, found, log);
  return found;
}

void
warnOfSensor(const PlaneOptions& options, const MappedPlanes& found, StageLog& log)
{
  if (found.planes.empty() && options.sensor == DepthSensor::Stereo)
    log.warn("--sensor stereo expects noise that is even in inverse depth; where the "
             "cloud's is not, leave --sensor out");
}

void
requirePlanes(const std::string& input, const MappedPlanes& found, const StageLog& log)
{
  if (found.planes.empty() && found.cylinders.empty())
    log.failWithNothing(input + ": no plane was found");
}

void
tellPlanes(const MappedPlanes& found, StageLog& log)
{
  const std::size_t on_planes = countLabelled(found.labels);
  log.details["input_points"] = found.labels.size();
  log.details["finite_points"] = found.finite_points;
  log.details["points_on_planes"] = on_planes;
  log.tell("planes", std::to_string(found.planes.size()));
  log.tell("on planes", percent(on_planes, found.finite_points) + " of the points");
  tellEach("plane", "planes", found.planes, log);
  if (!found.cylinder_labels.empty())
    tellCylinders(found, log);
  if (log.details.contains("box_report")) {
    log.tell("boxes", std::to_string(found.boxes.size()));
    tellEach("box", "boxes", found.boxes, log);
  }
  if (log.details.contains("recess_report")) {
    log.tell("recesses", std::to_string(found.recesses.size()));
    tellEach("recess", "recesses", found.recesses, log);
  }
}

SceneView
sceneViewOf(const MappedPlanes& found)
{
  SceneView view;
  view.up = found.up;
  if (!view.up && found.assumed_up.z() > 0) // assumed of what is no view of a camera
    view.up = found.assumed_up;
  if (view.up)
    view.sensor_origin.reset();
  else
    view.sensor_origin = found.sensor_origin;
  view.sensor_orientation = found.sensor_orientation;
  view.hide_backs = true;
  return view;
}

void
savePicture(const std::string& path, const MappedPlanes& found)
{
  saveSnapshot(
      path,
      coloredByLabel(withLabels(found.vertices.copy(), labelsOfVertices(found))),
      found.mesh,
      sceneViewOf(found));
}

} // namespace pcl::acmap
