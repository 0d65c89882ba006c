#include "map_stage.h"

#include "cloud_labels.h"
#include "drawn_apart.h"
#include "length_check.h"
#include "memory.h"

#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/map_up.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_cloud_writer.h>
#include <pcl/pipeline/map_rows.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/observation_list.h>
#include <pcl/pipeline/observation_merging.h>
#include <pcl/pipeline/plane_mapping_types.h>
#include <pcl/pipeline/ranked_work.h>
#include <pcl/texture/floor_plan.h>
#include <pcl/texture/map_ifc.h>
#include <pcl/texture/map_page.h>
#include <pcl/visualization/map_snapshot.h>
#include <pcl/visualization/mesh_snapshot.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <sstream>
#include <system_error>
#include <utility>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

constexpr const char* mesh_picture = "mesh.png";
constexpr const char* planes_picture = "planes.png";
constexpr std::pair<const char*, MapView::Place> map_pictures[] = {
    {"outside.png", MapView::Place::Outside},
    {"inside.png", MapView::Place::Inside},
    {"floor_plan.png", MapView::Place::Plan}};

/** \brief Names of the pictures that VTK draws, relative to the folder of the map. */
std::vector<std::string>
namesOfPictures()
{
  std::vector<std::string> names = {pictureName(mesh_picture),
                                    pictureName(planes_picture)};
  for (const auto& [name, from] : map_pictures)
    names.push_back(pictureName(name));
  return names;
}

/** \brief Draws them.
 * \throws OutputFileException when one could not be written */
void
savePictures(const std::string& folder,
             const MappedPlanes& found,
             const CompactMap& map)
{
  const auto place = [&](const char* name) { return folder + "/" + pictureName(name); };
  saveSnapshot(
      place(mesh_picture), found.vertices.copy(), found.mesh, sceneViewOf(found));
  savePicture(place(planes_picture), found);
  for (const auto& [name, from] : map_pictures) {
    MapView map_view;
    map_view.place = from;
    saveMapSnapshot(place(name), map, map_view);
  }
}

/** \brief Every n-th point of a map, for display: at most a million points. */
PCLPointCloud2
thinned(const CloudRows& map)
{
  constexpr std::size_t maximum = 1000000;
  return everyNth(map, map.size() / maximum + 1);
}

/** \brief Reports how much the processes had to tell each other. */
void
tellRanks(const Ranks& ranks, StageLog& log)
{
  constexpr double megabyte = 1e6;
  log.details["ranks"] = {{"processes", ranks.size()},
                          {"messages", ranks.getNumberOfMessages()},
                          {"bytes", ranks.getNumberOfBytes()}};
  log.tell("ranks",
           std::to_string(ranks.size()) + ", " +
               shortNumber(static_cast<double>(ranks.getNumberOfBytes()) / megabyte) +
               " MB in " + std::to_string(ranks.getNumberOfMessages()) + " messages");
}

MergedCloud
merge(const ChainOptions& options,
      const ObservationSequence& posed,
      const std::shared_ptr<RankedWork>& work,
      const RunControls& controls,
      StageLog& log)
{
  ObservationMerging merging = mergingOf(options, controls.threads);
  merging.setRankedWork(work);
  merging.setProgressCallback(controls.progress);
  MergedCloud merged;
  merging.compute(posed, merged);
  const MergingReport& report = merging.getReport();
  log.warn(report.remarks);
  if (report.every > 1)
    log.warn("the map has more than " + std::to_string(options.max_points) +
             " points (--max-points): it is made of each " +
             std::to_string(report.every) + "th of them");
  warnOfLengths(requirePoints(merged.cloud), controls, log);
  log.details["observations"] = report.observations;
  log.tell("read",
           std::to_string(report.observations) + " observations, " +
               std::to_string(report.points) + " points");
  if (report.refined > 0)
    log.tell("refined",
             "the quantised depth of " + std::to_string(report.refined) +
                 " observations");
  return merged;
}

Mapped
mapSequence(const ChainOptions& options,
            const Sequence& sequence,
            const OutputFolder& folder,
            const RunControls& controls,
            StageLog& log)
{
  Mapped result;
  std::vector<std::string> remarks;
  const std::shared_ptr<RankedWork> work = shareOut(options.ranks,
                                                    *sequence.posed,
                                                    controls.threads,
                                                    folder.path(""),
                                                    residentScratch(),
                                                    remarks);
  log.warn(remarks);
  {
    StepTimer timer(log.report);
    const MergedCloud merged = merge(options, *sequence.posed, work, controls, log);
    timer.finish("read");
    PlaneOptions planes = options.planes;
    planes.sensor = sensorOfMerged(planes.sensor, merged.viewpoints.size());
    result.found =
        extractPlanes(planes, merged.cloud, nullptr, merged.viewpoints, controls, log);
    StepTimer write_timer(log.report);
    savePointCloud(folder.path("map.pcd"), thinned(merged.cloud));
    write_timer.finish("write");
  }
  requirePlanes(options.input, result.found, log);
  StepTimer timer(log.report);
  result.map = paintPlanes(surfacesOf(result.found),
                           *sequence.posed,
                           work.get(),
                           options.texture,
                           controls,
                           log);
  if (work)
    tellRanks(work->ranks(), log);
  result.map.up = sequence.up.value_or(Eigen::Vector3d::Zero());
  result.map.shift = sequence.posed->shift();
  setRooms(makeFloorPlan(result.map), result.map);
  saveTrajectory(folder.path(trajectory_name), result.map.trajectory);
  saveObservationList((fs::path(options.output) / observation_list_name).string(),
                      options.output,
                      *sequence.posed);
  timer.finish("paint");
  return result;
}

Mapped
mapCloud(const ChainOptions& options, const RunControls& controls, StageLog& log)
{
  StepTimer timer(log.report);
  const Progress progress(controls.progress);
  progress.tell(0, "reading");
  const auto file = std::make_shared<PointCloudFile>();
  const CloudRows rows = loadCloudRows(options.input, controls.scale, *file);
  const std::optional<Eigen::Vector3d>& up = options.rectification.up;
  if (up && file->sensor_origin.isZero(0))
    file->up = up->normalized().cast<float>();
  timer.finish("read");
  warnOfLengths(requirePoints(rows), controls, log);
  const std::vector<Eigen::Vector3f> viewpoints =
      viewpointsOfFile(*file, options.input, controls.scale, log);
  Mapped result;
  result.found = extractPlanes(options.planes, rows, file, viewpoints, controls, log);
  requirePlanes(options.input, result.found, log);
  StepTimer paint_timer(log.report);
  result.map =
      paintPlanes(surfacesOf(result.found), rows, options.texture, controls, log);
  result.map.shift = file->shift;
  if (up)
    result.map.up = up->normalized();
  else if (file->up)
    result.map.up = file->up->cast<double>();
  setRooms(makeFloorPlan(result.map), result.map);
  paint_timer.finish("paint");
  return result;
}

/** \brief Copies the plots of the rectification next to the map. */
void
takeAlong(const Chain& chain, const OutputFolder& folder)
{
  fs::create_directories(folder.path(pictureName("")));
  const auto copy = [&](const char* name, const std::string& to) {
    const fs::path from = fs::path(chain.folderOf("rectification")) / name;
    std::error_code error;
    fs::copy_file(from, folder.path(to), error);
    if (error)
      throw OutputFileException(folder.name() + "/" + to + ": " + error.message());
  };
  // once more through memory, as a replay has it: the last bits of a rotation may change
  constexpr const char* before = "trajectory_before.txt";
  saveTrajectory(folder.path(before),
                 loadTrajectory(chain.folderOf("rectification") + "/" + before));
  for (const char* name : {"plan.png", "energy.png"})
    copy(name, pictureName(name));
}

/** \brief Draws the pictures of a map that is on the disk already.
 * \return the names of those that are there
 * \throws InterruptedPartway after an interruption */
std::vector<std::string>
drawPictures(const std::string& folder,
             const PicturesApart& pictures,
             const Mapped& mapped,
             StageLog& log)
{
  pictures.draw([&] { savePictures(folder, mapped.found, mapped.map); }, log);
  std::vector<std::string> names = namesOfPictures();
  const auto is_missing = [&](const std::string& name) {
    std::error_code error;
    return !fs::exists(fs::path(folder) / name, error);
  };
  names.erase(std::remove_if(names.begin(), names.end(), is_missing), names.end());
  std::error_code error;
  fs::remove(fs::path(folder) / pictureName(""), error); // if it is empty
  return names;
}

/** \brief Removes the pictures of an earlier map, and makes the folder for new ones. */
void
prepareForPictures(const std::string& folder)
{
  std::error_code error;
  for (const std::string& name : namesOfPictures())
    fs::remove(fs::path(folder) / name, error);
  const fs::path pictures = fs::path(folder) / pictureName("");
  fs::create_directories(pictures, error);
  if (error)
    throw OutputFileException(pictures.string() + ": " + error.message());
}

/** \brief The poses before the rectification, if there was one. */
Trajectory
posesBefore(const OutputFolder& folder)
{
  const std::string path = folder.path("trajectory_before.txt");
  std::error_code error;
  return fs::exists(path, error) ? loadTrajectory(path) : Trajectory();
}

/** \brief Names of the files of the map, relative to its folder. */
std::vector<std::string>
filesOf(const OutputFolder& folder)
{
  std::vector<std::string> names = filesIn(folder.path(""));
  const std::string pictures = folder.path(pictureName(""));
  if (std::error_code error; fs::exists(pictures, error))
    for (const std::string& name : filesIn(pictures))
      names.push_back(pictureName(name));
  return names;
}

/** \brief Reports the planes in the order of map.json, which has more details. */
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

/** \brief The same for the cylinders. */
nlohmann::ordered_json
jsonOf(const std::vector<CylinderPatch>& cylinders)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t id = 0; id < cylinders.size(); ++id) {
    const CylinderPatch& cylinder = cylinders[id];
    list.push_back({{"id", id},
                    {"radius", cylinder.radius},
                    {"length", cylinder.high - cylinder.low},
                    {"arc", cylinder.arc},
                    {"hollow", cylinder.is_hollow},
                    {"area", cylinder.area},
                    {"rmse", cylinder.rms},
                    {"support", cylinder.support},
                    {"saved_bits", cylinder.saved_bits}});
  }
  return list;
}

/** \brief The same for boxes or recesses. */
template <typename Patch>
nlohmann::ordered_json
jsonOfSizes(const std::vector<Patch>& patches)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t id = 0; id < patches.size(); ++id) {
    const Patch& patch = patches[id];
    list.push_back({{"id", id},
                    {"size", {patch.size[0], patch.size[1], patch.size[2]}},
                    {"template", patch.template_id},
                    {"saved_bits", patch.saved_bits}});
  }
  return list;
}

/** \brief Reports what was subtracted from the coordinates of the input. */
void
tellShift(const CompactMap& map, StageLog& log)
{
  if (map.shift.isZero(0))
    return;
  std::ostringstream text;
  text << std::fixed << std::setprecision(0) << map.shift.x() << ", " << map.shift.y()
       << ", " << map.shift.z();
  log.details["shift"] = {map.shift.x(), map.shift.y(), map.shift.z()};
  log.tell("coordinates",
           "of the input less " + text.str() +
               "; those of the input in floor_plan.dxf, .geojson and map.ifc");
}

/** \brief Reports the up direction of the pictures, and its tilt in the map's frame. */
void
tellUp(const CompactMap& map, StageLog& log)
{
  constexpr double degrees = 180 / 3.14159265358979323846;
  const Eigen::Vector3d up = upDirection(map);
  const double tilt = degrees * std::acos(std::min(1.0, up.dot(upAxis(map))));
  log.details["up"] = {up.x(), up.y(), up.z()};
  log.details["tilt_deg"] = tilt;
  if (tilt > min_tilt_told)
    log.tell("tilted",
             "the frame of the map by " + shortNumber(tilt) +
                 " degrees, by its planes; pictures are drawn along the floor");
}

void
tellMap(const ChainOptions& options, const Mapped& mapped, StageLog& log)
{
  tellPlanes(mapped.found, log);
  log.details["planes"] = jsonOf(mapped.map.planes);
  if (options.planes.findsPrimitives()) {
    log.details["cylinders"] = jsonOf(mapped.map.cylinders);
    log.details["boxes"] = jsonOfSizes(mapped.map.boxes);
    log.details["recesses"] = jsonOfSizes(mapped.map.recesses);
  }
  tellUp(mapped.map, log);
  tellShift(mapped.map, log);
  tellCompactness(mapped.found.finite_points, mapped.map, options.output, log);
}

} // namespace

ObservationMerging
mergingOf(const ChainOptions& options, unsigned threads)
{
  ObservationMerging merging;
  merging.setDepthSensor(mappingOf(options.planes, threads).getUsedDepthSensor());
  merging.setSkipBroken(options.texture.skip_broken);
  merging.setMaximumPoints(options.max_points);
  merging.setNumberOfThreads(threads);
  return merging;
}

std::vector<std::string>
writeMap(const ChainOptions& options,
         Mapped& mapped,
         const PicturesApart& pictures,
         OutputFolder& folder,
         StageLog& log)
{
  StepTimer timer(log.report);
  const FloorPlan plan = makeFloorPlan(mapped.map);
  saveCompactMap(folder.path(""), mapped.map, options.texture.outputs);
  for (const std::string& format : options.formats)
    if (format == "html")
      saveMapPage(folder.path("map.html"), folder.path(""), posesBefore(folder));
    else if (format == "ifc")
      saveMapIfc(folder.path("map.ifc"), mapped.map, plan);
    else
      saveFloorPlan(folder.path("floor_plan." + format), plan);
  saveNormals(folder.path("mesh.ply"), mapped.found);
  stopIfInterrupted();
  std::vector<std::string> names = filesOf(folder);
  folder.commit();
  timer.finish("write map");
  if (pictures.canBeDrawn()) {
    prepareForPictures(options.output);
    for (std::string& name : drawPictures(options.output, pictures, mapped, log))
      names.push_back(std::move(name));
  }
  timer.finish("pictures");
  tellMap(options, mapped, log);
  return names;
}

std::vector<std::string>
makeMap(const ChainOptions& options,
        const Chain& chain,
        const Sequence& sequence,
        const PicturesApart& pictures,
        OutputFolder& folder,
        const RunControls& controls,
        StageLog& log)
{
  const ScratchMemory scratch(folder.path(""), residentScratch(), memoryLimit());
  Mapped mapped = sequence.posed ? mapSequence(options, sequence, folder, controls, log)
                                 : mapCloud(options, controls, log);
  if (scratch.getRefused() > 0)
    log.warn(options.output + ": the disk is full, " + gigabytes(scratch.getRefused()) +
             " of points stayed in memory");
  stopIfInterrupted();
  if (sequence.is_rectified)
    takeAlong(chain, folder);
  return writeMap(options, mapped, pictures, folder, log);
}

} // namespace pcl::acmap
