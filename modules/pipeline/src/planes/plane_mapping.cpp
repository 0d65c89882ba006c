#include <pcl/core/cloud_assessment.h>
#include <pcl/core/cylinder_rims.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/large_memory.h>
#include <pcl/core/impl/length_remarks.h>
#include <pcl/core/impl/mesh_input.h>
#include <pcl/core/impl/observation_gap.h>
#include <pcl/core/impl/part_of_progress.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/impl/up_direction.h>
#include <pcl/core/impl/zero_points.h>
#include <pcl/core/noise_scale.h>
#include <pcl/pipeline/picture.h>
#include <pcl/pipeline/plane_mapping.h>
#include <pcl/pipeline/ranked_work.h>
#include <pcl/segmentation/box_fitting.h>
#include <pcl/segmentation/impl/depth_plane_kernel.h>
#include <pcl/segmentation/plane_conversions.h>
#include <pcl/segmentation/recess_fitting.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

namespace pcl {

namespace acmap {
namespace {

using Vertex = PlaneMapping::Vertex;
using VertexCloud = PointCloud<Vertex>;

constexpr double max_voxel = 1e9; // metres, of VoxelConsolidation::setVoxelSize

/** Is a noise scale known, and could its lengths be metres of a scene? */
bool
isInMetres(const std::optional<NoiseScale>& scale)
{
  return scale && scale->sigma <= max_voxel && scale->spacing <= max_voxel;
}

/** How far the outline of a plane may be from its true rim, metres. */
double
rimTolerance(const CylinderClusteringReport& report)
{
  constexpr double vertices = 2, sigmas = 3, maximum = 1e9;
  return std::min(maximum, vertices * report.spacing + sigmas * report.sigma);
}

/** A copy of the rows, in which the points outside of the indices are NaN. */
CloudRows
rowsOfIndices(const CloudRows& rows, const Indices& indices)
{
  requirePoints(rows, &indices);
  std::vector<bool> is_kept(rows.size());
  for (const index_t index : indices)
    is_kept[static_cast<std::size_t>(index)] = true;
  PCLPointCloud2 layout = layoutWith(rows.layout(), {});
  layout.width = rows.layout().width;
  layout.height = rows.layout().height;
  layout.is_dense = 0;
  const std::size_t step = layout.point_step, x = findField(layout, "x")->offset;
  LargeVector<std::uint8_t> kept(rows.data(), rows.data() + rows.size() * step);
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr std::array<float, 3> nowhere{nan, nan, nan};
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (!is_kept[i])
      std::memcpy(&kept[i * step + x], nowhere.data(), sizeof nowhere);
  return {std::move(layout), std::move(kept)};
}

/** The rows of some points, in their order, not organized. */
CloudRows
someRows(const CloudRows& rows, const Indices& indices)
{
  PCLPointCloud2 layout = layoutWith(rows.layout(), {});
  layout.width = static_cast<std::uint32_t>(indices.size());
  layout.height = 1;
  layout.is_dense = rows.layout().is_dense;
  const std::size_t step = layout.point_step;
  LargeVector<std::uint8_t> kept(indices.size() * step);
  for (std::size_t i = 0; i < indices.size(); ++i)
    std::memcpy(&kept[i * step],
                rows.data() + static_cast<std::size_t>(indices[i]) * step,
                step);
  return {std::move(layout), std::move(kept)};
}

/** Labels of some points become those of all points, -1 for the others. */
void
spreadLabels(const Indices& indices, std::size_t points, PointLabels& labels)
{
  if (labels.empty())
    return;
  PointLabels all(points, -1);
  for (std::size_t i = 0; i < indices.size(); ++i)
    all[static_cast<std::size_t>(indices[i])] = labels[i];
  labels = std::move(all);
}

/** The points for a mesh construction of PCL; fields that they lack are zero. */
VertexCloud::Ptr
verticesOf(const CloudRows& rows, const PointCloudFile& file)
{
  std::vector<FieldWish> wishes;
  for (const PCLPointField& field : getFields<Vertex>())
    if (field.name != "rgb" || !findColor(rows.layout()))
      wishes.push_back({field.name, field.datatype});
  VertexCloud::Ptr vertices(new VertexCloud);
  fromPCLPointCloud2(withFields(rows.copy(), wishes), *vertices);
  vertices->sensor_origin_.head<3>() = file.sensor_origin;
  vertices->sensor_orientation_ = file.sensor_orientation;
  return vertices;
}

constexpr std::int32_t removed = -1;

/** For each plane its number without the replaced ones, or removed. */
std::vector<std::int32_t>
numbersWithout(std::vector<CylinderPatch>& cylinders, std::size_t planes)
{
  std::vector<std::int32_t> numbers(planes, 0);
  for (CylinderPatch& cylinder : cylinders) {
    for (const std::int32_t plane : cylinder.planes)
      numbers[static_cast<std::size_t>(plane)] = removed;
    cylinder.planes.clear();
  }
  std::int32_t next = 0;
  for (std::int32_t& number : numbers)
    if (number != removed)
      number = next++;
  return numbers;
}

template <typename Labels>
void
renumberAll(const std::vector<std::int32_t>& numbers, Labels& labels)
{
  for (std::int32_t& label : labels)
    if (label >= 0)
      label = numbers[static_cast<std::size_t>(label)];
}

/** An edge whose neighbour is removed is open: what is beyond it is no plane. */
void
renumber(const std::vector<std::int32_t>& numbers, PlanePolygon& polygon)
{
  for (PolygonEdge& edge : polygon.edges) {
    if (edge.neighbour < 0)
      continue;
    edge.neighbour = numbers[static_cast<std::size_t>(edge.neighbour)];
    if (edge.neighbour == removed)
      edge.kind = EdgeKind::Open;
  }
}

/** Removes the planes for which cylinders stand from planes, labels and the neighbours of edges.
 * Clears CylinderPatch::planes, whose numbers are not valid any more. */
void
removeReplacedPlanes(MappedPlanes& mapped)
{
  const std::vector<std::int32_t> numbers =
      numbersWithout(mapped.cylinders, mapped.planes.size());
  std::vector<PlanePatch> kept;
  for (std::size_t p = 0; p < mapped.planes.size(); ++p) {
    if (numbers[p] == removed)
      continue;
    kept.push_back(std::move(mapped.planes[p]));
    for (PlanePolygon& polygon : kept.back().polygons)
      renumber(numbers, polygon);
  }
  mapped.planes = std::move(kept);
  renumberAll(numbers, mapped.labels);
  renumberAll(numbers, mapped.vertex_labels);
}

} // namespace
} // namespace acmap

using namespace acmap;

namespace {

/** One run of the steps. */
class PlaneMappingRun {
public:
  /** \param[in] compute_mesh also in a picture
   * \param[in] rows points
   * \param[in] file sensor and remarks of the rows */
  PlaneMappingRun(const PlaneMapping& mapping,
                  bool compute_mesh,
                  const CloudRows& rows,
                  const PointCloudFile& file,
                  const CostCallback& cost,
                  ProgressCallback progress,
                  PlaneMappingReport& report)
  : mapping_(mapping)
  , compute_mesh_(compute_mesh)
  , rows_(rows)
  , file_(file)
  , cost_(cost)
  , progress_(std::move(progress))
  , report_(report)
  , timer_(report)
  {}

  MappedPlanes
  fromMesh(TriangleMesh mesh)
  {
    MappedPlanes result = emptyResult();
    assess({});
    result.vertices = wholeRows();
    result.mesh = std::move(mesh);
    vote({}, std::nullopt, result);
    cluster({}, {}, result);
    result.labels = result.vertex_labels;
    findCylinders({}, {}, result);
    result.cylinder_labels = result.vertex_cylinders;
    result.finite_points = report_.votes->vertices - report_.votes->invalid_points;
    return result;
  }

  MappedPlanes
  inSpace(const std::vector<Eigen::Vector3f>& viewpoints)
  {
    MappedPlanes result = emptyResult();
    const bool knows_views = namesViews() && !viewpoints.empty();
    if (!knows_views)
      assess(viewpoints);
    const std::vector<Eigen::Vector3f> sensors =
        namesViews() ? viewpoints : singleSensor();
    Indices vertex_of_point;
    const bool is_consolidated = consolidate(sensors, result, vertex_of_point);
    if (!is_consolidated)
      result.vertices = wholeRows();
    triangulate(result);
    // the consolidation has already oriented its normals, and the mesh, towards the
    // sensors
    const bool turns = !is_consolidated && namesViews();
    vote(turns ? sensors : std::vector<Eigen::Vector3f>(), std::nullopt, result);
    const std::vector<Eigen::Vector3f> known_sensors =
        sensorsFit() ? sensors : std::vector<Eigen::Vector3f>();
    cluster(rows_, known_sensors, result);
    if (!mapping_.getClustering().getNoiseDriven())
      result.labels = labelsOf(result.vertex_labels, vertex_of_point, is_consolidated);
    findCylinders(rows_, known_sensors, result);
    result.finite_points =
        is_consolidated
            ? report_.consolidation->points - report_.consolidation->invalid_points
            : report_.votes->vertices - report_.votes->invalid_points;
    return result;
  }

  MappedPlanes
  inPicture(const Picture& picture)
  {
    MappedPlanes result = emptyResult();
    assessPicture();
    PlaneClusters clusters =
        segmentDepthPlanes(picture.seen.view,
                           picture.seen.noise,
                           mapping_.getDepthSegmentation().settings(),
                           Progress(partOf(progress_, scaled(0), scaled(0.15))),
                           report_.depth_planes.emplace());
    result.planes = std::move(clusters.patches);
    addRemarks(*report_.depth_planes);
    finish("planes");
    const PointLabels& labels = clusters.labels;
    const bool needs_mesh =
        mapping_.getComputeCylinders() || (compute_mesh_ && !result.planes.empty());
    result.labels = picture.order ? picture.order->labelsOfPoints(labels) : labels;
    result.finite_points =
        report_.depth_planes->points - report_.depth_planes->invalid_points;
    if (!needs_mesh)
      return result;
    refine(picture.order, labels, result);
    triangulate(result);
    vote({}, file_.sensor_origin, result);
    result.vertex_labels = labels;
    findCylinders(rows_, {file_.sensor_origin}, result);
    return result;
  }

  /** Sets the up direction of what was found, if it is known. */
  void
  setUp(MappedPlanes& result) const
  {
    const UpEvidence up = upEvidence();
    if (up.isKnown())
      result.up = up.value.cast<float>();
    else if (report_.assessment)
      result.assumed_up = up.value.cast<float>();
  }

  /** Finds boxes and recesses among the planes, if these are requested. */
  void
  findBoxes(MappedPlanes& result)
  {
    if (!mapping_.getComputeBoxes())
      return;
    BoxFitting fitting;
    fitting.setPlanes(result.planes);
    prepare(fitting, 1, 1);
    fitting.segment(result.boxes);
    report_.boxes = fitting.getReport();
    finish("boxes");
    RecessFitting recess_fitting;
    recess_fitting.setPlanes(result.planes);
    prepare(recess_fitting, 1, 1);
    recess_fitting.segment(result.recesses);
    report_.recesses = recess_fitting.getReport();
    finish("recesses");
  }

private:
  bool
  namesViews() const
  {
    return findField(rows_.layout(), "view", PCLPointField::INT32);
  }

  void
  assess(const std::vector<Eigen::Vector3f>& viewpoints)
  {
    CloudAssessment assessment;
    // which the caller keeps alive
    assessment.setInputCloud(
        rows_, std::shared_ptr<const PointCloudFile>(std::shared_ptr<void>(), &file_));
    assessment.setViewpoints(viewpoints);
    if (const auto& up = mapping_.getUpDirection())
      assessment.setUpDirection(*up);
    prepare(assessment, 0, 0.08);
    assessment.compute();
    report_.assessment = assessment.getReport();
    measured_scale_ = assessment.getNoiseScale();
    finish("assessment");
  }

  /** A camera's picture: its frame is that of the camera. */
  void
  assessPicture()
  {
    CloudAssessmentReport& assessment = report_.assessment.emplace();
    assessment.points = assessment.finite_points = rows_.size();
    assessment.columns = rows_.layout().height > 1 ? rows_.layout().width : 0;
    assessment.sensors = {SensorOutcome::Proved, 1, "the pixels of a picture", 0};
    assessment.up = statedUp(mapping_.getUpDirection(), file_)
                        .value_or(UpEvidence{UpOutcome::Assumed,
                                             -Eigen::Vector3d::UnitY(),
                                             0,
                                             "a picture in the frame of its camera"});
  }

  bool
  hasSensor() const
  {
    return report_.assessment && report_.assessment->sensors.isKnown();
  }

  /** The sensor of a cloud without views; none if it is not known. */
  std::vector<Eigen::Vector3f>
  singleSensor() const
  {
    if (!hasSensor())
      return {};
    return {file_.sensor_origin};
  }

  void
  finish(const char* step)
  {
    timer_.finish(step);
    returnFreeMemory();
  }

  /** Cylinders take half of the time, where they are looked for. */
  double
  timeScale() const
  {
    return mapping_.getComputeCylinders() ? 1 : 2;
  }

  /** \param[in] fraction of the time of all steps, where cylinders are looked for */
  double
  scaled(double fraction) const
  {
    return std::min(1.0, timeScale() * fraction);
  }

  /** \param[in] from, to fractions of the time of all steps, where cylinders are looked for */
  template <typename Step>
  void
  prepare(Step& step, double from, double to)
  {
    step.setNumberOfThreads(mapping_.getNumberOfThreads());
    step.setProgressCallback(partOf(progress_, scaled(from), scaled(to)));
  }

  void
  addRemarks(const Report& step)
  {
    acmap::addRemarks(report_, step.remarks);
  }

  /** Where the observations of a merged cloud do not lie on each other, no scale shows planes
   * with noise. A mesh of all points would be a knot of shards; they are consolidated to how
   * far they are apart. */
  void
  takeObservationGap(const std::vector<Eigen::Vector3f>& sensors)
  {
    NoiseScale& scale = *report_.noise_scale;
    const ObservationGap gap =
        measureObservationGap(requirePoints(rows_),
                              sensorsOf(rows_, sensors, std::nullopt),
                              scale.spacing,
                              mapping_.getNumberOfThreads());
    if (!gap.isChance())
      return;
    scale.sigma = gap.gap;
    scale.interval.reset();
    scale.is_determined = true;
    report_.remarks.push_back(
        "the observations do not lie on each other: where they overlap, the points of "
        "one are " +
        shortNumber(1000 * gap.gap) +
        " mm off the planes of another (median); their poses may be wrong");
  }

  /** \return true if the cloud was consolidated: the vertices are then the consolidated
   * points */
  bool
  consolidate(const std::vector<Eigen::Vector3f>& sensors,
              MappedPlanes& result,
              Indices& vertex_of_point)
  {
    if (mapping_.getConsolidationPolicy() == ConsolidationPolicy::Never)
      return false;
    PlaneMapping::Consolidation consolidation = mapping_.getConsolidation();
    if (mapping_.getConsolidationPolicy() == ConsolidationPolicy::WhereNoisy) {
      const auto known =
          sensors.empty() ? std::nullopt : std::make_optional(sensors.front());
      const Progress progress(progress_);
      progress.tell(0.08 * timeScale(), "noise scale");
      report_.noise_scale = measured_scale_
                                ? *measured_scale_
                                : measureNoiseScale(requirePoints(rows_),
                                                    sensorsOf(rows_, sensors, known),
                                                    mapping_.getNumberOfThreads());
      if (!needsConsolidation(*report_.noise_scale))
        takeObservationGap(sensors);
      if (report_.noise_scale->inverse_depth || !report_.noise_scale->is_determined)
        report_.remarks.push_back(report_.noise_scale->remarks.front());
      finish("noise scale");
      if (!needsConsolidation(*report_.noise_scale))
        return false;
      const double automatic = automaticVoxel(*report_.noise_scale);
      if (consolidation.getVoxelSize() == 0 && automatic <= max_voxel)
        consolidation.setVoxelSize(automatic); // else the class measures it again
    }
    consolidation.setInputCloud(rows_);
    if (namesViews())
      consolidation.setViewpoints(sensors);
    else if (!sensors.empty())
      consolidation.setSensorOrigin(sensors.front());
    consolidation.setKeepSources(!mapping_.getClustering().getNoiseDriven());
    prepare(consolidation, 0.1, 0.2);
    consolidation.filter(result.vertices);
    report_.consolidation = consolidation.getReport();
    report_.consolidated_points = report_.consolidation->representatives;
    addRemarks(*report_.consolidation);
    vertex_of_point = consolidation.getVoxelOfPoint();
    finish("consolidate");
    return true;
  }

  void
  refine(const std::optional<PictureOrder>& order,
         const PointLabels& labels,
         MappedPlanes& result)
  {
    PlaneMapping::Refinement refinement;
    const auto cloud = std::make_shared<const PCLPointCloud2>(rows_.copy());
    refinement.setInputCloud(
        order ? std::make_shared<const PCLPointCloud2>(order->arrange(*cloud)) : cloud);
    refinement.setPlanes(result.planes, labels);
    prepare(refinement, 0.15, 0.2);
    const PCLPointCloud2::Ptr refined(new PCLPointCloud2);
    refinement.filter(*refined);
    result.vertices = CloudRows(refined);
    report_.refinement = refinement.getReport();
    finish("refine");
  }

  void
  triangulate(MappedPlanes& result)
  {
    const MeshConstruction<Vertex>::Ptr construction = mapping_.getMeshConstruction();
    const auto given =
        std::dynamic_pointer_cast<DeWallTriangulation<Vertex>>(construction);
    const DeWallRule rule = given ? given->getAcceptanceRule() : DeWallRule::Guarded;
    if (cost_)
      cost_("triangulating this cloud",
            estimateDeWallMemory(result.vertices.size(), true, rule),
            0);
    if (given && given->getSearchMethod()) {
      DeWallTriangulation<Vertex> dewall = *given;
      dewall.setInputCloud(verticesOf(result.vertices, file_));
      runDeWall(dewall, result);
    }
    else if (given) {
      DeWallTriangulation<PCLPointCloud2> dewall;
      static_cast<DeWallParameters&>(dewall) = *given;
      dewall.setInputCloud(result.vertices);
      if (!report_.assessment || report_.depth_planes ||
          report_.assessment->sensors.outcome == SensorOutcome::Stated)
        dewall.setSensorOrigin(file_.sensor_origin);
      if (isConsolidatedScan())
        dewall.setScan(rows_, mesh_edge_in_voxels * report_.consolidation->voxel_size);
      runDeWall(dewall, result);
    }
    else {
      std::vector<Vertices> polygons;
      construction->setInputCloud(verticesOf(result.vertices, file_));
      construction->reconstruct(polygons);
      result.mesh.triangles = trianglesOf(polygons);
    }
    finish("triangulate");
  }

  /** Did one sensor measure all points, as these prove? */
  bool
  isProved() const
  {
    return report_.assessment && !report_.depth_planes &&
           report_.assessment->sensors.outcome == SensorOutcome::Proved;
  }

  /** Can the surface have been seen from its sensors? The rays prove it better than the
   * surface. */
  bool
  sensorsFit() const
  {
    return !report_.consolidation || report_.consolidation->sensors_fit || isProved();
  }

  /** Are the vertices consolidated from a scan that one sensor measured? */
  bool
  isConsolidatedScan() const
  {
    return report_.consolidation && isProved();
  }

  template <typename DeWall>
  void
  runDeWall(DeWall& dewall, MappedPlanes& result)
  {
    if (const auto up =
            upWithoutSensors(result.vertices, upEvidence(), hasSensor(), sensorsFit()))
      dewall.setUpDirection(*up);
    constexpr bool takes_scan =
        std::is_same_v<DeWall, DeWallTriangulation<PCLPointCloud2>>;
    if (dewall.getMaximumEdgeLength() == 0 && report_.consolidation &&
        !(takes_scan && isConsolidatedScan()))
      dewall.setMaximumEdgeLength(mesh_edge_in_voxels *
                                  report_.consolidation->voxel_size);
    prepare(dewall, 0.2, 0.32);
    dewall.reconstruct(result.mesh);
    report_.mesh = dewall.getReport();
    result.spacing = report_.mesh->median_spacing;
    addRemarks(*report_.mesh);
  }

  /** \param[in] origin of the one sensor that saw all vertices, if it is known */
  void
  vote(std::vector<Eigen::Vector3f> viewpoints,
       const std::optional<Eigen::Vector3f>& origin,
       MappedPlanes& result)
  {
    PlaneMapping::Voting voting = mapping_.getVoting();
    voting.setInputCloud(result.vertices);
    voting.setTriangles(result.mesh);
    voting.setViewpoints(std::move(viewpoints));
    if (origin)
      voting.setSensorOrigin(*origin);
    prepare(voting, 0.32, 0.37);
    voting.compute(result.normals);
    report_.votes = voting.getReport();
    if (result.spacing == 0)
      result.spacing = report_.votes->mean_edge;
    finish("votes");
  }

  void
  cluster(const CloudRows& source,
          const std::vector<Eigen::Vector3f>& sensors,
          MappedPlanes& result)
  {
    PlaneMapping::Clustering clustering = mapping_.getClustering();
    clustering.setInputCloud(result.vertices);
    clustering.setInputNormals(result.normals);
    clustering.setTriangles(result.mesh);
    const bool has_source = source && clustering.getNoiseDriven();
    if (has_source)
      clustering.setSourceCloud(source, sensors);
    if (cost_)
      cost_("clustering the planes", 0, clustering.estimateSeconds());
    prepare(clustering, 0.37, 0.5);
    clustering.segment(result.planes);
    report_.planes = clustering.getReport();
    addRemarks(*report_.planes);
    result.vertex_labels = clustering.getLabels();
    if (has_source)
      result.labels = clustering.getSourceLabels();
    finish("planes");
  }

  /** Replaces planes by cylinders, if these are requested.
   * \param[in] source the cloud of the input, or null */
  void
  findCylinders(const CloudRows& source,
                const std::vector<Eigen::Vector3f>& sensors,
                MappedPlanes& result)
  {
    if (!mapping_.getComputeCylinders())
      return;
    PlaneMapping::CylinderClustering clustering = mapping_.getCylinderClustering();
    clustering.setInputCloud(result.vertices);
    clustering.setInputNormals(result.normals);
    clustering.setTriangles(result.mesh);
    clustering.setPlanes(
        result.planes, result.vertex_labels, source ? result.labels : PointLabels());
    if (source)
      clustering.setSourceCloud(source, sensors);
    if (source && !sensors.empty() && isInMetres(report_.noise_scale))
      clustering.setSourceScale(*report_.noise_scale);
    prepare(clustering, 0.5, 1);
    clustering.segment(result.cylinders);
    report_.cylinders = clustering.getReport();
    result.vertex_cylinders = clustering.getLabels();
    if (source)
      result.cylinder_labels = clustering.getSourceLabels();
    removeReplacedPlanes(result);
    if (!result.cylinders.empty())
      joinAtCylinders(
          rimTolerance(*report_.cylinders), result.cylinders, result.planes);
    finish("cylinders");
  }

  MappedPlanes
  emptyResult() const
  {
    MappedPlanes result;
    result.sensor_origin = file_.sensor_origin;
    result.sensor_orientation = file_.sensor_orientation;
    return result;
  }

  /** The up direction, by what is known of it. */
  UpEvidence
  upEvidence() const
  {
    if (report_.assessment)
      return report_.assessment->up;
    UpEvidence up;
    if (const auto& given = mapping_.getUpDirection())
      up = {UpOutcome::Stated, *given, 1, "stated"};
    return up;
  }

  /** The points of the input as vertices, which no other process has. */
  CloudRows
  wholeRows() const
  {
    CloudRows rows = rows_;
    rows.setShares(nullptr);
    return rows;
  }

  static PointLabels
  labelsOf(const PointLabels& of_vertices,
           const Indices& vertex_of_point,
           bool is_consolidated)
  {
    if (!is_consolidated)
      return of_vertices;
    PointLabels labels;
    labels.reserve(vertex_of_point.size());
    for (const index_t vertex : vertex_of_point)
      labels.push_back(vertex < 0 ? -1 : of_vertices[static_cast<std::size_t>(vertex)]);
    return labels;
  }

  const PlaneMapping& mapping_;
  const bool compute_mesh_;
  const CloudRows& rows_;
  const PointCloudFile& file_;
  const CostCallback& cost_;
  ProgressCallback progress_;
  PlaneMappingReport& report_;
  StepTimer timer_;
  std::optional<NoiseScale> measured_scale_; ///< by the assessment
};

} // namespace

namespace {

/** Says where the planes contradict the noise that was measured, or are few. */
void
remarkContradictions(const MappedPlanes& found, PlaneMappingReport& report)
{
  constexpr double times = 3, most = 0.5, few = 0.2;
  const std::optional<NoiseScale>& scale = report.noise_scale;
  const double limit =
      scale && scale->is_determined ? times * scale->sigma : 0; // 0: not known
  double area = 0, rough_area = 0, roughest = 0;
  for (const PlanePatch& plane : found.planes) {
    area += plane.area;
    rough_area += plane.rms > limit ? plane.area : 0;
    roughest = std::max(roughest, plane.rms);
  }
  if (limit > 0 && rough_area > most * area)
    report.remarks.push_back(
        shortNumber(100 * rough_area / area) +
        " % of the area of the planes is rougher than " + shortNumber(times) +
        " times the noise of " + shortNumber(1000 * scale->sigma) +
        " mm, the roughest by " + shortNumber(1000 * roughest) +
        " mm: they may be several surfaces (setDistanceThreshold, --tolerance)");
  const auto on_planes = static_cast<double>(
      std::count_if(found.labels.begin(), found.labels.end(), [](std::int32_t label) {
        return label >= 0;
      }));
  const auto points = static_cast<double>(found.finite_points);
  if (!found.planes.empty() && on_planes < few * points)
    report.remarks.push_back("only " + shortNumber(100 * on_planes / points) +
                             " % of the points are on planes");
}

} // namespace

PlaneMapping::PlaneMapping()
: construction_(new DeWallTriangulation<Vertex>)
{}

void
PlaneMapping::setInputCloud(std::shared_ptr<const PointCloudFile> cloud)
{
  acmap::requireGiven(cloud);
  rows_ = sharedCloud(cloud);
  input_ = std::move(cloud);
}

void
PlaneMapping::setInputCloud(const CloudRows& rows,
                            std::shared_ptr<const PointCloudFile> file)
{
  rows_ = rows;
  input_ = file ? std::move(file) : std::make_shared<const PointCloudFile>();
}

void
PlaneMapping::setIndices(const PointIndicesConstPtr& indices)
{
  // shares the lifetime of the PointIndices
  indices_ = indices ? IndicesConstPtr(indices, &indices->indices) : nullptr;
}

void
PlaneMapping::setViewpoints(std::vector<Eigen::Vector3f> viewpoints)
{
  requireViewpoints(viewpoints);
  viewpoints_ = std::move(viewpoints);
}

void
PlaneMapping::setUpDirection(const Eigen::Vector3d& up)
{
  given_up_ = requiredDirection(up);
}

void
PlaneMapping::setMode(MappingMode mode)
{
  const bool is_paper = mode == MappingMode::Paper;
  mode_ = mode;
  policy_ = is_paper ? ConsolidationPolicy::Never : ConsolidationPolicy::WhereNoisy;
  const auto dewall = std::make_shared<DeWallTriangulation<Vertex>>();
  if (is_paper)
    dewall->setAcceptanceRule(DeWallRule::Strict);
  construction_ = dewall;
  voting_.setPaperMode(is_paper);
  clustering_.setNoiseDriven(!is_paper);
}

void
PlaneMapping::setMeshConstruction(const MeshConstruction<Vertex>::Ptr& construction)
{
  if (!construction)
    throw acmap::BadArgument("the mesh construction is a null pointer");
  construction_ = construction;
}

void
PlaneMapping::compute(MappedPlanes& result)
{
  runSteps(compute_mesh_, result);
}

void
PlaneMapping::runSteps(bool compute_mesh, MappedPlanes& result)
{
  CloudRows rows = indices_ ? rowsOfIndices(rows_, *indices_) : rows_;
  PlaneMappingReport report;
  std::optional<Indices> kept;
  if (input_mesh_.triangles.empty() && !rows.shares())
    kept = withoutZeros(requirePoints(rows));
  if (kept) {
    report.remarks.push_back(std::to_string(rows.size() - kept->size()) +
                             " points at (0, 0, 0) are no points, and were left out");
    rows =
        rows.layout().height > 1 ? rowsOfIndices(rows, *kept) : someRows(rows, *kept);
  }
  const PointView points = requirePoints(rows);
  const bool has_mesh = !input_mesh_.triangles.empty();
  const std::optional<Picture> picture =
      has_mesh ? std::nullopt
               : planePictureOf(points, rows.layout().width, getUsedDepthSensor());
  std::optional<RankedWork> work;
  if (ranks_ && ranks_->size() > 1 && !rows.shares() && !has_mesh && !picture &&
      policy_ != ConsolidationPolicy::Never) {
    work.emplace(ranks_,
                 rows,
                 viewpoints_.empty() ? std::vector{input_->sensor_origin} : viewpoints_,
                 threads_);
    rows.setShares(work->shares(work->own()));
  }
  report.mode = mode_;
  MappedPlanes found;
  PlaneMappingRun run(
      *this, compute_mesh, rows, *input_, cost_callback_, progress_, report);
  if (has_mesh) {
    requireCornersInside(input_mesh_.triangles, points.size());
    found = run.fromMesh(input_mesh_);
  }
  else if (picture)
    found = run.inPicture(*picture);
  else
    found = run.inSpace(viewpoints_);
  run.setUp(found);
  run.findBoxes(found);
  remarkContradictions(found, report);
  if (kept && rows.size() == kept->size()) {
    spreadLabels(*kept, rows_.size(), found.labels);
    spreadLabels(*kept, rows_.size(), found.cylinder_labels);
  }
  if (!report.mesh) // else it has told them
    addRemarks(report, lengthRemarks(points));
  result = std::move(found);
  report_ = std::move(report);
}

void
PlaneMapping::compute(std::vector<ModelCoefficients>& coefficients,
                      std::vector<PointIndices>& inliers)
{
  MappedPlanes found;
  runSteps(false, found);
  const PCLHeader& header = rows_.layout().header;
  inliers = toPointIndices(found.labels, found.planes.size(), header);
  coefficients.assign(found.planes.size(), {});
  for (std::size_t i = 0; i < found.planes.size(); ++i) {
    coefficients[i].header = header;
    toModelCoefficients(found.planes[i], coefficients[i]);
  }
}

void
PlaneMapping::segment(PointIndices& inliers, ModelCoefficients& coefficients)
{
  std::vector<ModelCoefficients> all_coefficients;
  std::vector<PointIndices> all_inliers;
  compute(all_coefficients, all_inliers);
  inliers = all_inliers.empty() ? PointIndices() : std::move(all_inliers.front());
  coefficients = all_coefficients.empty() ? ModelCoefficients()
                                          : std::move(all_coefficients.front());
}

} // namespace pcl
