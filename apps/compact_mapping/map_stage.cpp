#include "map_stage.h"

#include "drawn_apart.h"

#include <pcl/core/impl/map_shift.h>
#include <pcl/core/map_file.h>
#include <pcl/core/surface_sentence.h>
#include <pcl/pipeline/map_report.h>
#include <pcl/pipeline/mapped_planes.h>
#include <pcl/texture/floor_plan.h>
#include <pcl/texture/map_ifc.h>
#include <pcl/texture/map_page.h>
#include <pcl/visualization/map_snapshot.h>
#include <pcl/visualization/mesh_snapshot.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

constexpr const char* mesh_picture = "mesh.png";
constexpr const char* planes_picture = "planes.png";
constexpr std::pair<const char*, MapView::Place> map_pictures[] = {
    {"outside.png", MapView::Place::Outside}, {"inside.png", MapView::Place::Inside}};

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

/** \brief Draws the pictures of a map that is on the disk already.
 * \return the names of those that are there
 * \throws InterruptedPartway after an interruption */
std::vector<std::string>
drawPictures(const std::string& folder,
             const PicturesApart& pictures,
             const MappedPlanes& found,
             const CompactMap& map,
             StageLog& log)
{
  pictures.draw([&] { savePictures(folder, found, map); }, log);
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

void
tellRooms(const CompactMap& map, StageLog& log)
{
  constexpr std::size_t max_told = 12;
  for (std::size_t id = 0; id < std::min(map.rooms.size(), max_told); ++id)
    log.tell("room", describeRoom(map, id));
  if (map.rooms.size() > max_told)
    log.tell("rooms", std::to_string(map.rooms.size()) + ", all in report.json");
}

/** \brief Tells what was subtracted from the coordinates of the input. */
void
tellShift(const CompactMap& map, StageLog& log)
{
  if (!map.shift.isZero(0))
    log.tell("coordinates",
             "of the input less " + shiftText(map.shift) +
                 "; those of the input in floor_plan.dxf, .geojson and map.ifc");
}

/** \param[in] tilt of the frame of the map, degrees */
void
tellTilt(double tilt, StageLog& log)
{
  if (tilt > min_tilt_told)
    log.tell("tilted",
             "the frame of the map by " + shortNumber(tilt) +
                 " degrees, by its planes; pictures are drawn along the floor");
}

void
tellMap(const ChainOptions& options,
        const MappedPlanes& found,
        const CompactMap& map,
        StageLog& log)
{
  tellPlanes(found, log);
  auto details = nlohmann::ordered_json::parse(mapDetailsText(map));
  if (!options.planes.findsPrimitives())
    for (const char* name : {"cylinders", "boxes", "recesses"})
      details.erase(name);
  log.details.update(details);
  tellRooms(map, log);
  tellTilt(details.at("tilt_deg").get<double>(), log);
  tellShift(map, log);
  tellCompactness(found.finite_points, map, options.output, log);
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

void
takeAlong(const StageStore& store, const Trajectory& before, const OutputFolder& folder)
{
  fs::create_directories(folder.path(pictureName("")));
  saveTrajectory(folder.path("trajectory_before.txt"), before);
  for (const char* name : {"plan.png", "energy.png"}) {
    const std::string to = pictureName(name);
    std::error_code error;
    fs::copy_file(store.path("rectification", name), folder.path(to), error);
    if (error)
      throw OutputFileException(folder.name() + "/" + to + ": " + error.message());
  }
}

std::vector<std::string>
writeMap(const ChainOptions& options,
         const MappedPlanes& found,
         CompactMap& map,
         const PicturesApart& pictures,
         const ProgressCallback& callback,
         OutputFolder& folder,
         StageLog& log)
{
  const double written = pictures.canBeDrawn() ? 0.4 : 1; // fraction of the progress
  const Progress progress(callback);
  progress.tell(0, "writing the map");
  StepTimer timer(log.report);
  const FloorPlan plan = makeFloorPlan(map);
  if (!hasMapPage() && options.formats == formatsByDefault())
    log.warn("no map.html: this acmap was built without its modules");
  saveCompactMap(folder.path(""), map, options.texture.outputs);
  double done = 0.4;
  for (const std::string& format : options.formats) {
    progress.tell(written * done, "writing " + format);
    done += 0.6 / static_cast<double>(options.formats.size());
    if (format == "html")
      saveMapPage(folder.path("map.html"), folder.path(""), posesBefore(folder));
    else if (format == "ifc")
      saveMapIfc(folder.path("map.ifc"), map, plan);
    else
      saveFloorPlan(folder.path("floor_plan." + format), plan);
  }
  if (options.has_pictures) {
    fs::create_directories(folder.path(pictureName("")));
    saveFloorPlan(folder.path(pictureName("floor_plan.png")), plan);
  }
  saveMappedMesh(folder.path("mesh.ply"), found);
  stopIfInterrupted();
  std::vector<std::string> names = filesOf(folder);
  folder.commit();
  timer.finish("write map");
  if (pictures.canBeDrawn()) {
    progress.tell(written, "drawing");
    prepareForPictures(options.output);
    for (std::string& name : drawPictures(options.output, pictures, found, map, log))
      names.push_back(std::move(name));
  }
  timer.finish("pictures");
  tellMap(options, found, map, log);
  log.details["plan"] = nlohmann::ordered_json::parse(planDetailsText(map, plan));
  return names;
}

MapFigures
compareMap(const ChainOptions& options,
           const ChainState& made,
           const StageLog& told,
           const SessionTruth& truth)
{
  const CompactMap map = loadMapFile((fs::path(options.output) / "map.json").string());
  MapFigures figures = compareWithTruth(map, *made.observations, made.before, truth);
  const auto& bytes = told.details.at("bytes");
  figures.compactness =
      bytes.at("raw").get<double>() / std::max(bytes.at("textured").get<double>(), 1.0);
  return figures;
}

} // namespace pcl::acmap
