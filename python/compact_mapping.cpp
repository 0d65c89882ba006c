#include "bindings.h"
#include "compact_map.h"
#include "kernel_call.h"
#include "mapping_report.h"
#include "named_choice.h"
#include "observation_argument.h"
#include "path_argument.h"
#include "poses.h"
#include "setter_keyword.h"

#include <pcl/pipeline/compact_mapping.h>

#include <pybind11/stl.h>

namespace pcl::acmap::python {

namespace {

using namespace py::literals;

constexpr NamedChoices<DepthSensor, 5> depth_sensors = {
    {{"auto", DepthSensor::Automatic},
     {"quantised", DepthSensor::Quantised},
     {"stereo", DepthSensor::Stereo},
     {"tof", DepthSensor::TimeOfFlight},
     {"laser", DepthSensor::Laser}}};

struct MappingSettings {
  bool paper;
  bool rectify;
  bool adjust;
  DepthSensor sensor;
  double voxel_size; ///< metres; 0: automatic
  double min_area;   ///< square metres; 0: automatic
  bool regular;
  std::optional<bool> primitives;
  double texel_size; ///< metres
  std::optional<std::array<double, 3>> up;
  std::string folder; ///< of poses; empty: none
  unsigned threads;
};

struct GivenObservation {
  std::shared_ptr<const PointCloudFile> cloud;
  std::optional<Eigen::Isometry3d> T_map_camera;
};

/** What a pcl::CompactMapping is to be given. Every call of compute creates one, because
 * it runs without the GIL: in the meantime other threads can add observations to this
 * object, or compute with it. */
struct MappingInput {
  MappingSettings settings;
  std::vector<GivenObservation> observations;
};

void
requireSense(const MappingSettings& settings)
{
  const auto refuse = [&](bool is_given, const std::string& argument) {
    if (settings.paper && is_given)
      throw py::value_error(argument + " departs from the paper: leave it out with "
                                       "paper=True");
  };
  refuse(settings.adjust, "adjust");
  refuse(settings.sensor != DepthSensor::Automatic, "sensor");
  refuse(settings.voxel_size != 0, "voxel_size");
  refuse(settings.min_area != 0, "min_area");
  refuse(settings.regular, "regular");
  refuse(settings.primitives.value_or(false), "primitives");
}

void
addObservation(MappingInput& input,
               const ViewArgument& points,
               const ColorArgument& colors,
               const std::optional<SinglePoseArgument>& pose)
{
  GivenObservation given = {observationOf(points, colors), std::nullopt};
  if (pose)
    given.T_map_camera = poseOf("pose", *pose);
  input.observations.push_back(std::move(given));
}

PlaneMapping
planeMappingOf(PlaneMapping planes, const MappingSettings& settings)
{
  PlaneMapping::Clustering clustering = planes.getClustering();
  setKeyword(
      "min_area", clustering, &PlaneMapping::Clustering::setMinArea, settings.min_area);
  clustering.setRegularize(settings.regular);
  planes.setClustering(clustering);
  PlaneMapping::DepthSegmentation segmentation = planes.getDepthSegmentation();
  segmentation.setMinArea(settings.min_area);
  segmentation.setRegularize(settings.regular);
  planes.setDepthSegmentation(segmentation);
  if (settings.voxel_size != 0) {
    PlaneMapping::Consolidation consolidation = planes.getConsolidation();
    setKeyword("voxel_size",
               consolidation,
               &PlaneMapping::Consolidation::setVoxelSize,
               settings.voxel_size);
    planes.setConsolidation(consolidation);
    planes.setConsolidationPolicy(ConsolidationPolicy::Always);
  }
  planes.setDepthSensor(settings.sensor);
  planes.setComputeMesh(false);
  if (settings.primitives) {
    planes.setComputeCylinders(*settings.primitives);
    planes.setComputeBoxes(*settings.primitives);
  }
  return planes;
}

/** \throws py::value_error for a value that a setter refuses */
void
configure(CompactMapping& mapping, const MappingSettings& settings)
{
  if (settings.paper)
    mapping.setMode(MappingMode::Paper);
  ObservationMerging merging = mapping.getMerging();
  if (settings.sensor != DepthSensor::Automatic)
    merging.setDepthSensor(settings.sensor);
  CompactMapping::Texturing texturing = mapping.getTexturing();
  setKeyword("texel_size",
             texturing,
             &CompactMapping::Texturing::setTexelSize,
             settings.texel_size);
  if (settings.up) {
    CompactMapping::Levelling levelling = mapping.getLevelling();
    setKeyword("up",
               levelling,
               &CompactMapping::Levelling::setUpDirection,
               Eigen::Vector3d(settings.up->data()));
    mapping.setLevelling(levelling);
  }
  mapping.setRectify(settings.rectify);
  mapping.setAdjust(settings.adjust);
  mapping.setMerging(merging);
  mapping.setPlaneMapping(planeMappingOf(mapping.getPlaneMapping(), settings));
  mapping.setTexturing(texturing);
  if (!settings.folder.empty())
    mapping.setFolder(settings.folder);
  mapping.setNumberOfThreads(settings.threads);
}

ReportedMap
computeMap(const MappingInput& input, const Listener& listener)
{
  CompactMapping mapping;
  configure(mapping, input.settings);
  for (const GivenObservation& given : input.observations)
    mapping.addObservation(given.cloud, given.T_map_camera);
  CompactMap map;
  callStage(listener, [&](const ProgressCallback& progress) {
    mapping.setProgressCallback(progress);
    mapping.compute(map);
  });
  return {std::move(map), reportOfMapping(mapping.getReport())};
}

constexpr const char* about_mapping =
    R"(Makes a compact map of what a camera saw: all steps of the paper in one object
(pcl::CompactMapping). Add the observations, then call compute.

paper      all steps as the paper has them, with nothing added, on raw points, which takes
           long; adjust, sensor, voxel_size, min_area, regular and primitives are refused
           with it
rectify    straightens the map before its planes are found, as the function rectify does
           (II-B.2 of the paper)
adjust     then adjusts the poses by planes, in six degrees of freedom, as the function
           adjust does
sensor     what measured the points. 'quantised' (structured light, such as a Kinect) and
           'stereo': the noise of each view is removed in its picture; 'tof' and 'laser':
           not; 'auto': only where the depth is quantised
voxel_size metres, the edge of a voxel to which the points of all observations are
           consolidated; None or 0: automatic, and only if their noise requires it
min_area   square metres, of a plane; 0: automatic
regular    turns planes to be parallel or upright to larger ones, where their uncertainty
           allows
primitives finds cylinders, too: columns, pipes and curved walls, which replace the planes
           that they describe in fewer bits; and boxes and recesses such as closed doors,
           whose sides and leaves stay planes; by default not with paper
texel_size metres, the edge of a texel of the textures; 0: 0.02, and for points that are in
           no image not finer than half their spacing
up         three numbers, the up direction in the frame of the poses; None: found by floors
           and walls, see report.levelling. The map is turned level where it is rectified,
           except with paper; CompactMap.up is its own up direction
folder     keeps the poses that were found, so that a later run with the same observations
           goes on from them; empty: none
threads    0: all; the result is the same bytes for every number)";

constexpr const char* about_observation =
    R"(Adds an observation; its arrays are copied.

points (h, w, 3) float32, metres: a view in the frame of its camera (x right, y down, z
       forward), NaN where nothing was measured
colors (h, w, 3) uint8: red, green, blue; also where points are NaN
pose   (4, 4) float64: T_map_camera; None: estimated from the colours and depths (visual
       odometry). Give the poses of all observations, or of none.)";

constexpr const char* about_computation =
    R"(Computes the map of all observations. Returns a CompactMap, without planes if there are
none; its report then tells why.

progress called with (fraction, step); stops the run when it returns False)";

} // namespace

void
bindCompactMapping(py::module_& module)
{
  const CompactMapping defaults;
  const PlaneMapping::Clustering& clustering =
      defaults.getPlaneMapping().getClustering();
  py::class_<MappingInput>(module, "CompactMapping", about_mapping)
      .def(py::init([](bool paper,
                       bool rectify,
                       bool adjust,
                       const std::string& sensor,
                       std::optional<double> voxel_size,
                       double min_area,
                       bool regular,
                       std::optional<bool> primitives,
                       double texel_size,
                       const std::optional<std::array<double, 3>>& up,
                       const PathArgument& folder,
                       unsigned threads) {
             const MappingSettings settings = {paper,
                                               rectify,
                                               adjust,
                                               chosen("sensor", sensor, depth_sensors),
                                               voxel_size.value_or(0),
                                               min_area,
                                               regular,
                                               primitives,
                                               texel_size,
                                               up,
                                               pathOf("folder", folder),
                                               threads};
             requireSense(settings);
             CompactMapping checked;
             configure(checked, settings);
             return MappingInput{settings, {}};
           }),
           py::kw_only(),
           "paper"_a = false,
           "rectify"_a = defaults.getRectify(),
           "adjust"_a = defaults.getAdjust(),
           "sensor"_a = nameOf(DepthSensor::Automatic, depth_sensors),
           "voxel_size"_a = py::none(),
           "min_area"_a = clustering.getMinArea(),
           "regular"_a = clustering.getRegularize(),
           "primitives"_a = py::none(),
           "texel_size"_a = defaults.getTexturing().getTexelSize(),
           "up"_a = py::none(),
           "folder"_a = "",
           "threads"_a = defaults.getNumberOfThreads())
      .def("add_observation",
           &addObservation,
           about_observation,
           "points"_a,
           "colors"_a,
           "pose"_a = py::none())
      .def("__repr__",
           [](const MappingInput& input) {
             return "acmap.CompactMapping(observations=" +
                    std::to_string(input.observations.size()) + ")";
           })
      .def("compute", &computeMap, about_computation, "progress"_a = py::none());
}

} // namespace pcl::acmap::python
