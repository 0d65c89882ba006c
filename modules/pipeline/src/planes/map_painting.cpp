#include <pcl/core/exceptions.h>
#include <pcl/core/impl/length_remarks.h>
#include <pcl/pipeline/map_painting.h>
#include <pcl/pipeline/surface_names.h>

#include <algorithm>
#include <optional>

namespace pcl {

namespace {

PlaneTexturing<PointXYZRGB>
texturingOfMap(const CompactMap& surfaces, const MapPainting& painting)
{
  PlaneTexturing<PointXYZRGB> texturing = painting.texturing;
  texturing.clearObservations();
  texturing.setNumberOfThreads(painting.threads);
  texturing.setPlanes(surfaces.planes);
  texturing.setCylinders(surfaces.cylinders);
  texturing.setProgressCallback(painting.progress);
  if (painting.cost)
    painting.cost(
        "painting the planes", acmap::wholeBytes(texturing.estimateMemory()), 0);
  return texturing;
}

/** Paints, and adds what is not painted. */
void
paint(PlaneTexturing<PointXYZRGB>& texturing,
      const CompactMap& surfaces,
      PaintedMap& painted)
{
  CompactMap& map = painted.map;
  texturing.texture(map);
  painted.report = texturing.getReport();
  map.boxes = surfaces.boxes;
  map.recesses = surfaces.recesses;
  map.shift = surfaces.shift;
}

void
addNew(const std::vector<std::string>& remarks, std::vector<std::string>& all)
{
  for (const std::string& remark : remarks)
    if (std::find(all.begin(), all.end(), remark) == all.end())
      all.push_back(remark);
}

} // namespace

PaintedMap
paintMap(const CompactMap& surfaces,
         const ObservationSequence& sequence,
         const MapPainting& painting)
{
  PlaneTexturing<PointXYZRGB> texturing = texturingOfMap(surfaces, painting);
  PaintedMap painted;
  std::vector<std::string> of_lengths, remarks = sequence.remarks();
  const auto load = [&](std::size_t i) -> std::optional<TexturedObservation> {
    try {
      const PosedObservation seen = sequence.load(i);
      addNew(seen.remarks, remarks);
      if (i == 0)
        of_lengths = acmap::lengthRemarks(seen.file->points());
      return TexturedObservation{
          acmap::sharedCloud(seen.file), seen.T_map_camera, sequence.stamp(i), true};
    }
    catch (const InputFileException& error) {
      if (!painting.skip_broken)
        throw;
      remarks.push_back("left out: " + std::string(error.what()));
      return std::nullopt;
    }
  };
  for (std::size_t i = 0; i < sequence.size(); ++i)
    texturing.addObservationLoader([&load, i] { return load(i); });
  paint(texturing, surfaces, painted);
  if (painted.map.trajectory.poses.empty())
    throw InputFileException("none of the observations can be read");
  sequence.requireDifferent(painted.map.trajectory.poses);
  addNew(of_lengths, painted.remarks);
  addNew(remarks, painted.remarks);
  nameParts(painted.map);
  return painted;
}

PaintedMap
paintMap(const CompactMap& surfaces,
         const CloudRows& cloud,
         const MapPainting& painting)
{
  PlaneTexturing<PointXYZRGB> texturing = texturingOfMap(surfaces, painting);
  texturing.addObservationLoader([&]() -> std::optional<TexturedObservation> {
    return TexturedObservation{cloud, Eigen::Isometry3d::Identity(), 0, false};
  });
  PaintedMap painted;
  paint(texturing, surfaces, painted);
  nameParts(painted.map);
  return painted;
}

} // namespace pcl
