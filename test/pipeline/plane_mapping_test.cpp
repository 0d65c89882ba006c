#include "clouds.h"
#include "depth_room.h"

#include <pcl/conversions.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/random.h>
#include <pcl/pipeline/plane_mapping.h>
#include <pcl/simulation/simulated_observation.h>
#include <pcl/simulation/standard_scenes.h>
#include <pcl/surface/gp3.h>
#include <pcl/surface/impl/gp3.hpp>

#include <gmock/gmock.h>

namespace pcl::acmap::test {
namespace {

using testing::Each;
using testing::ElementsAreArray;
using testing::Ge;

/** Two views of an office, merged. */
class Office : public testing::Test {
protected:
  static void
  SetUpTestSuite()
  {
    SimulatedScene office = standardScene("office");
    office.sensor.points /= 3;
    const MergedObservations merged = mergeObservations(office, 2, 1);
    const auto file = std::make_shared<PointCloudFile>();
    file->cloud = cloudOf(merged);
    cloud_ = file;
    for (const Eigen::Isometry3d& pose : merged.trajectory.poses)
      viewpoints_.push_back(pose.translation().cast<float>());
  }

  static void
  TearDownTestSuite()
  {
    cloud_.reset();
  }

  static PlaneMapping
  mapping()
  {
    PlaneMapping mapping;
    mapping.setInputCloud(cloud_);
    mapping.setViewpoints(viewpoints_);
    return mapping;
  }

  static inline std::shared_ptr<const PointCloudFile> cloud_;
  static inline std::vector<Eigen::Vector3f> viewpoints_;
};

std::vector<Eigen::Vector4d>
equationsOf(const std::vector<PlanePatch>& planes)
{
  std::vector<Eigen::Vector4d> equations;
  for (const PlanePatch& plane : planes)
    equations.push_back(plane.coefficients);
  return equations;
}

/** The same with the single classes, one after the other. */
std::vector<PlanePatch>
chained(const std::shared_ptr<const PointCloudFile>& cloud,
        const std::vector<Eigen::Vector3f>& viewpoints)
{
  using Vertex = PlaneMapping::Vertex;
  const PointCloud<Vertex>::Ptr points(new PointCloud<Vertex>),
      vertices(new PointCloud<Vertex>);
  fromPCLPointCloud2(cloud->cloud, *points);
  VoxelConsolidation<Vertex> consolidation;
  consolidation.setInputCloud(points);
  consolidation.setViewpoints(viewpoints);
  consolidation.filter(*vertices);
  DeWallTriangulation<Vertex> dewall;
  dewall.setInputCloud(vertices);
  dewall.setMaximumEdgeLength(mesh_edge_in_voxels *
                              consolidation.getReport().voxel_size);
  TriangleMesh mesh;
  dewall.reconstruct(mesh);
  NormalVectorVoting<Vertex> voting;
  voting.setInputCloud(vertices);
  voting.setTriangles(mesh);
  const PointCloud<Normal>::Ptr normals(new PointCloud<Normal>);
  const PointCloud<Label>::Ptr classes(new PointCloud<Label>);
  voting.compute(*normals);
  voting.getVertexClasses(*classes);
  PlaneHypothesisClustering<Vertex> clustering;
  clustering.setInputCloud(vertices);
  clustering.setInputNormals(normals);
  clustering.setVertexClasses(classes);
  clustering.setTriangles(mesh);
  clustering.setNoiseDriven(true);
  clustering.setSourceCloud(points, viewpoints);
  std::vector<PlanePatch> planes;
  clustering.segment(planes);
  return planes;
}

TEST_F(Office, isMappedAsTheClassesOneByOneWould)
{
  MappedPlanes found;
  PlaneMapping mapping = this->mapping();
  mapping.compute(found);
  EXPECT_EQ(equationsOf(found.planes), equationsOf(chained(cloud_, viewpoints_)));
  ASSERT_GE(found.planes.size(), 3U);
  EXPECT_EQ(found.labels.size(), cloud_->points().size());
  EXPECT_EQ(found.finite_points, cloud_->points().size());
  const std::size_t vertices = found.vertices.size();
  EXPECT_EQ(found.vertex_labels.size(), vertices);
  EXPECT_EQ(found.normals.size(), vertices);
  EXPECT_LT(vertices, found.labels.size() / 5);
  const PlaneMappingReport& report = mapping.getReport();
  EXPECT_TRUE(report.consolidation && report.mesh && report.votes && report.planes);
  EXPECT_FALSE(report.depth_planes);
}

/** A ground of 6 by 6 metres, a kilometre above the origin.
 * \param[in] noise metres, one standard deviation */
std::shared_ptr<PointCloudFile>
groundAbove(double noise)
{
  Random random(4);
  PointCloud<PointXYZ> ground;
  for (int i = 0; i < 120 * 120; ++i)
    ground.push_back(
        PointXYZ(static_cast<float>(0.05 * (i % 120) + random.uniform(-0.01, 0.01)),
                 static_cast<float>(0.05 * (i / 120) + random.uniform(-0.01, 0.01)),
                 static_cast<float>(1000 + noise * random.normal())));
  const auto file = std::make_shared<PointCloudFile>();
  toPCLPointCloud2(ground, file->cloud);
  return file;
}

TEST(PlaneMapping, facesFreeSpaceIfNoSensorIsKnown)
{
  for (const double noise : {0.0, 0.03})
    for (const MappingMode mode : {MappingMode::Accurate, MappingMode::Paper})
      for (const bool is_survey : {false, true}) {
        const auto file = groundAbove(mode == MappingMode::Paper ? 0 : noise);
        if (is_survey)
          file->up = Eigen::Vector3f::UnitZ();
        PlaneMapping mapping;
        mapping.setMode(mode);
        mapping.setInputCloud(std::shared_ptr<const PointCloudFile>(file));
        MappedPlanes found;
        mapping.compute(found);
        double area = 0;
        for (const PlanePatch& plane : found.planes) {
          area += plane.area;
          // the points prove no sensor, so that the side is free without a survey
          EXPECT_NEAR(is_survey ? plane.coefficients[2]
                                : std::abs(plane.coefficients[2]),
                      1,
                      1e-3);
        }
        EXPECT_GT(area, 30) << noise;
        EXPECT_EQ(found.up, file->up);
      }
}

/** Two rooms with a wall between them, of which one has the origin inside. */
TEST(PlaneMapping, roomsThatTheSensorCannotSeeFaceInwards)
{
  Cloud rooms = makeRoom(0.03, 0.4, 1);
  const Eigen::Vector3d next(0, 3.4, 0);
  rooms += moved(makeRoom(0.03, 0.4, 2), Eigen::Isometry3d(Eigen::Translation3d(next)));
  PlaneMapping mapping;
  mapping.setInputCloud(rooms.makeShared());
  MappedPlanes found;
  mapping.compute(found);
  ASSERT_TRUE(mapping.getReport().consolidation);
  EXPECT_FALSE(mapping.getReport().consolidation->sensors_fit);
  EXPECT_GE(found.planes.size(), 7U); // floors and side walls are one plane each
  for (const PlanePatch& plane : found.planes) {
    const Eigen::Vector3d corner = plane.polygons[0].outer[0].cast<double>();
    const Eigen::Vector3d middle =
        corner.y() < next.y() / 2 ? Eigen::Vector3d(0, 0, 0) : next;
    EXPECT_GT(plane.coefficients.head<3>().dot(middle) + plane.coefficients[3], 0)
        << corner.transpose();
  }
}

/** Which steps are the paper's. */
struct PaperSteps {
  bool mesh = true, votes = true, hypotheses = true;
};

/** The paper's way with the single classes: raw points, one step after the other. */
std::vector<PlanePatch>
chainedAsPaper(const PointCloud<PlaneMapping::Vertex>::Ptr& points,
               const std::vector<Eigen::Vector3f>& viewpoints,
               const PaperSteps& paper = {})
{
  using Vertex = PlaneMapping::Vertex;
  DeWallTriangulation<Vertex> dewall;
  dewall.setInputCloud(points);
  if (paper.mesh)
    dewall.setAcceptanceRule(DeWallRule::Strict);
  TriangleMesh mesh;
  dewall.reconstruct(mesh);
  NormalVectorVoting<Vertex> voting;
  voting.setPaperMode(paper.votes);
  voting.setInputCloud(points);
  voting.setTriangles(mesh);
  voting.setViewpoints(viewpoints);
  const PointCloud<Normal>::Ptr normals(new PointCloud<Normal>);
  const PointCloud<Label>::Ptr classes(new PointCloud<Label>);
  voting.compute(*normals);
  voting.getVertexClasses(*classes);
  PlaneHypothesisClustering<Vertex> clustering;
  clustering.setNoiseDriven(!paper.hypotheses);
  clustering.setInputCloud(points);
  clustering.setInputNormals(normals);
  clustering.setVertexClasses(classes);
  clustering.setTriangles(mesh);
  if (!paper.hypotheses)
    clustering.setSourceCloud(points, viewpoints);
  std::vector<PlanePatch> planes;
  clustering.segment(planes);
  return planes;
}

/** The equations, and the outlines' corners. */
std::vector<Eigen::Vector4d>
shapesOf(const std::vector<PlanePatch>& planes)
{
  std::vector<Eigen::Vector4d> shapes = equationsOf(planes);
  for (const PlanePatch& plane : planes)
    for (const PlanePolygon& polygon : plane.polygons)
      for (const Eigen::Vector3f& corner : polygon.outer)
        shapes.push_back(corner.homogeneous().cast<double>());
  return shapes;
}

/** Two views of the office with few points. */
class SparseOffice : public testing::Test {
protected:
  SparseOffice()
  {
    SimulatedScene office = standardScene("office");
    office.sensor.points /= 40;
    const MergedObservations merged = mergeObservations(office, 2, 1);
    fromPCLPointCloud2(cloudOf(merged), *points_);
    for (const Eigen::Isometry3d& pose : merged.trajectory.poses)
      viewpoints_.push_back(pose.translation().cast<float>());
    mapping_.setInputCloud(points_);
    mapping_.setViewpoints(viewpoints_);
  }

  PointCloud<PlaneMapping::Vertex>::Ptr points_{new PointCloud<PlaneMapping::Vertex>};
  std::vector<Eigen::Vector3f> viewpoints_;
  PlaneMapping mapping_;
};

TEST_F(SparseOffice, isMappedInPaperModeAsThePapersClassesOneByOneWould)
{
  EXPECT_EQ(mapping_.getMode(), MappingMode::Accurate);
  mapping_.setMode(MappingMode::Paper);
  EXPECT_EQ(mapping_.getMode(), MappingMode::Paper);
  MappedPlanes found;
  mapping_.compute(found);
  const std::vector<Eigen::Vector4d> shapes = shapesOf(found.planes);
  ASSERT_GE(found.planes.size(), 3U);
  EXPECT_GT(shapes.size(), 3 * found.planes.size()) << "planes have outlines";
  EXPECT_EQ(shapes, shapesOf(chainedAsPaper(points_, viewpoints_)));
  for (const PaperSteps& departure : {PaperSteps{false, true, true},
                                      PaperSteps{true, false, true},
                                      PaperSteps{true, true, false}})
    EXPECT_NE(shapes, shapesOf(chainedAsPaper(points_, viewpoints_, departure)))
        << departure.mesh << departure.votes << departure.hypotheses;
  const PlaneMappingReport& report = mapping_.getReport();
  EXPECT_EQ(report.mode, MappingMode::Paper);
  EXPECT_EQ(report.consolidated_points, 0U);
  EXPECT_FALSE(report.consolidation || report.noise_scale || report.depth_planes);
  EXPECT_EQ(found.vertices.size(), points_->size());
  EXPECT_EQ(found.labels.size(), points_->size());
}

TEST_F(SparseOffice, isMappedAsByDefaultAfterPaperMode)
{
  MappedPlanes usual, again;
  mapping_.compute(usual);
  EXPECT_GT(mapping_.getReport().consolidated_points, 0U);
  EXPECT_LT(mapping_.getReport().consolidated_points, points_->size());
  mapping_.setMode(MappingMode::Paper);
  mapping_.setMode(MappingMode::Accurate);
  mapping_.compute(again);
  EXPECT_EQ(shapesOf(again.planes), shapesOf(usual.planes));
}

TEST_F(SparseOffice, letsADepartureFromThePaperBeTakenBack)
{
  mapping_.setMode(MappingMode::Paper);
  mapping_.setVoting({});
  MappedPlanes found;
  mapping_.compute(found);
  EXPECT_EQ(shapesOf(found.planes),
            shapesOf(chainedAsPaper(points_, viewpoints_, {true, false, true})));
}

TEST_F(Office, givesThePaperLabelsOfAllPoints)
{
  PlaneMapping mapping = this->mapping();
  PlaneMapping::Clustering clustering;
  clustering.setNoiseDriven(false);
  mapping.setClustering(clustering);
  PlaneMapping::Consolidation consolidation;
  consolidation.setVoxelSize(0.15);
  mapping.setConsolidation(consolidation);
  double seconds = 0;
  mapping.setCostCallback([&](const std::string&, std::size_t, double expected) {
    seconds = std::max(seconds, expected);
  });
  MappedPlanes found;
  mapping.compute(found);
  EXPECT_GT(seconds, 0) << "how long it takes is known before";
  EXPECT_EQ(found.labels.size(), cloud_->points().size());
  EXPECT_THAT(found.labels, Each(Ge(-1)));
}

/** The points of the office in files, of which a part is in memory. Each is there twice, so
 * that they are worth a file. */
TEST_F(Office, hasTheSamePlanesWithItsPointsInFiles)
{
  const auto twice = std::make_shared<PCLPointCloud2>(cloud_->cloud);
  twice->data.insert(
      twice->data.end(), cloud_->cloud.data.begin(), cloud_->cloud.data.end());
  resizeRows(*twice, twice->data.size() / twice->point_step);
  MappedPlanes in_memory, in_files;
  PlaneMapping mapping = this->mapping();
  mapping.setInputCloud(CloudRows(twice));
  mapping.setComputeCylinders(true);
  mapping.compute(in_memory);
  const ScratchMemory scratch(testing::TempDir(), std::size_t{16} << 20);
  LargeVector<std::uint8_t> rows(twice->data.begin(), twice->data.end());
  mapping.setInputCloud(CloudRows(*twice, std::move(rows)));
  mapping.compute(in_files);
  EXPECT_GE(scratch.getBytes(), twice->data.size());
  EXPECT_EQ(in_files.labels, in_memory.labels);
  EXPECT_EQ(in_files.cylinder_labels, in_memory.cylinder_labels);
  EXPECT_EQ(in_files.vertices.copy().data, in_memory.vertices.copy().data);
  EXPECT_EQ(in_files.mesh.triangles, in_memory.mesh.triangles);
  EXPECT_EQ(equationsOf(in_files.planes), equationsOf(in_memory.planes));
  EXPECT_EQ(in_files.finite_points, in_memory.finite_points);
}

TEST_F(Office, takesAMeshOfPcl)
{
  const auto greedy =
      std::make_shared<GreedyProjectionTriangulation<PlaneMapping::Vertex>>();
  greedy->setSearchRadius(0.3);
  greedy->setMu(2.5);
  greedy->setMaximumNearestNeighbors(50);
  PlaneMapping mapping = this->mapping();
  mapping.setMeshConstruction(greedy);
  MappedPlanes found;
  mapping.compute(found);
  EXPECT_GE(found.planes.size(), 3U);
  EXPECT_FALSE(mapping.getReport().mesh) << "it has no report of ours";
  EXPECT_GT(found.spacing, 0);
}

TEST_F(Office, takesAMeshThatIsThere)
{
  MappedPlanes first, again;
  PlaneMapping mapping = this->mapping();
  mapping.compute(first);
  PlaneMapping of_mesh;
  of_mesh.setInputCloud(first.vertices);
  of_mesh.setInputMesh(first.mesh);
  of_mesh.compute(again);
  EXPECT_EQ(again.mesh.triangles, first.mesh.triangles);
  EXPECT_THAT(again.labels, ElementsAreArray(again.vertex_labels));
  EXPECT_GE(again.planes.size(), 3U);
  EXPECT_FALSE(of_mesh.getReport().mesh);
  of_mesh.setInputMesh({{{0, 1, 1 << 30}}, {}});
  EXPECT_THROW(of_mesh.compute(again), InitFailedException);
}

TEST_F(Office, canBeCancelledAndRefused)
{
  PlaneMapping mapping = this->mapping();
  MappedPlanes found;
  found.labels = {42};
  double last = 0;
  mapping.setProgressCallback([&](double done, const std::string&) {
    EXPECT_GE(done, last);
    last = done;
    return done < 0.5;
  });
  EXPECT_THROW(mapping.compute(found), CancelledException);
  mapping.setProgressCallback({});
  mapping.setCostCallback([](const std::string&, std::size_t bytes, double) {
    if (bytes > 0)
      throw std::bad_alloc();
  });
  EXPECT_THROW(mapping.compute(found), std::bad_alloc);
  EXPECT_EQ(found.labels, PointLabels{42});
}

TEST_F(Office, isNoPicture)
{
  PlaneMapping mapping = this->mapping();
  mapping.setDepthSensor(DepthSensor::Stereo);
  MappedPlanes found;
  EXPECT_THROW(mapping.compute(found), UnorganizedPointCloudException);
}

/** Views of the column of the office, merged. */
class Column : public testing::Test {
protected:
  static void
  SetUpTestSuite()
  {
    SimulatedScene office = standardScene("office");
    constexpr std::ptrdiff_t others = 34; // before those that see the column
    office.views.erase(office.views.begin(), office.views.begin() + others);
    place_ = office.views[0].inverse() * Eigen::Vector3d(3, 0, 5);
    upwards_ = office.views[0].linear().transpose() * Eigen::Vector3d::UnitY();
    const MergedObservations merged = mergeObservations(office, 6, 1);
    const auto file = std::make_shared<PointCloudFile>();
    file->cloud = cloudOf(merged);
    std::vector<Eigen::Vector3f> viewpoints;
    for (const Eigen::Isometry3d& pose : merged.trajectory.poses)
      viewpoints.push_back(pose.translation().cast<float>());
    mapping_.setInputCloud(std::shared_ptr<const PointCloudFile>(file));
    mapping_.setViewpoints(viewpoints);
    mapping_.compute(without_);
    mapping_.setComputeCylinders(true);
    mapping_.compute(with_);
  }

  static void
  TearDownTestSuite()
  {
    mapping_ = PlaneMapping();
    without_ = with_ = MappedPlanes();
  }

  static inline Eigen::Vector3d place_, upwards_; ///< of the axis
  static inline PlaneMapping mapping_;
  static inline MappedPlanes without_, with_;
};

TEST_F(Column, isTheOnlyCylinder)
{
  EXPECT_TRUE(without_.cylinders.empty() && without_.cylinder_labels.empty());
  ASSERT_EQ(with_.cylinders.size(), 1U);
  const CylinderPatch& column = with_.cylinders[0];
  EXPECT_NEAR(column.radius, 0.2, 0.003);
  EXPECT_GT(std::abs(column.axis_direction.dot(upwards_)), 0.9995);
  EXPECT_LT((column.axis_point - place_).cross(upwards_).norm(), 0.005);
  EXPECT_GT(column.high - column.low, 1.5);
  EXPECT_FALSE(column.is_hollow);
  EXPECT_GT(column.saved_bits, 30);
  EXPECT_TRUE(column.planes.empty()) << "their numbers are not those of the result";
  const PlaneMappingReport& report = mapping_.getReport();
  ASSERT_TRUE(report.cylinders);
  EXPECT_LT(report.cylinders->bits_after, report.cylinders->bits_before);
  EXPECT_EQ(with_.planes.size() + report.cylinders->replaced_planes,
            without_.planes.size());
}

TEST_F(Column, hasItsPointsAlone)
{
  ASSERT_EQ(with_.cylinder_labels.size(), with_.labels.size());
  ASSERT_EQ(with_.vertex_cylinders.size(), with_.vertex_labels.size());
  const auto expectApart = [](const auto& planes, const auto& cylinders) {
    std::size_t members = 0;
    for (std::size_t i = 0; i < planes.size(); ++i) {
      EXPECT_LT(planes[i], static_cast<std::int32_t>(with_.planes.size()));
      EXPECT_LT(cylinders[i], static_cast<std::int32_t>(with_.cylinders.size()));
      members += cylinders[i] >= 0 ? 1 : 0;
      EXPECT_FALSE(planes[i] >= 0 && cylinders[i] >= 0) << i;
    }
    EXPECT_GT(members, 0U);
  };
  expectApart(with_.labels, with_.cylinder_labels);
  expectApart(with_.vertex_labels, with_.vertex_cylinders);
  for (const PlanePatch& plane : with_.planes)
    for (const PlanePolygon& polygon : plane.polygons)
      for (const PolygonEdge& edge : polygon.edges)
        EXPECT_LT(edge.neighbour, static_cast<std::int32_t>(with_.planes.size()));
}

TEST_F(Column, doesNotDependOnTheThreads)
{
  PlaneMapping mapping = mapping_;
  for (const unsigned threads : {1U, 3U}) {
    mapping.setNumberOfThreads(threads);
    MappedPlanes again;
    mapping.compute(again);
    EXPECT_EQ(again.cylinder_labels, with_.cylinder_labels);
    ASSERT_EQ(again.cylinders.size(), with_.cylinders.size());
    EXPECT_EQ(again.cylinders[0].axis_point, with_.cylinders[0].axis_point);
    EXPECT_EQ(again.cylinders[0].radius, with_.cylinders[0].radius);
    EXPECT_EQ(equationsOf(again.planes), equationsOf(with_.planes));
  }
}

TEST_F(Office, hasNoColumnInItsFirstViews)
{
  PlaneMapping mapping = this->mapping();
  mapping.setComputeCylinders(true);
  MappedPlanes found;
  mapping.compute(found);
  EXPECT_TRUE(found.cylinders.empty());
  EXPECT_EQ(found.cylinder_labels, PointLabels(cloud_->points().size(), -1));
  ASSERT_TRUE(mapping.getReport().cylinders);
  EXPECT_FALSE(mapping.getReport().cylinders->remarks.empty());
}

PointCloud<PointXYZ>::Ptr
viewOf(const DepthRoom::Camera& camera)
{
  const DepthRoom room{camera};
  PointCloud<PointXYZ>::Ptr view(new PointCloud<PointXYZ>);
  for (const Eigen::Vector3f& point : room.points)
    view->push_back(PointXYZ(point.x(), point.y(), point.z()));
  view->width = DepthRoom::width;
  view->height = DepthRoom::height;
  view->is_dense = false;
  return view;
}

PointCloud<PointXYZ>::Ptr
kinectView()
{
  return viewOf({});
}

TEST(PlaneMapping, worksInThePictureWhereTheNoiseIsThatOfPixels)
{
  DepthRoom::Camera camera;
  camera.step = 0;
  camera.independent = 1e-3;
  for (const double correlated : {0.0, 2e-3}) {
    camera.correlated = correlated;
    PlaneMapping mapping;
    mapping.setInputCloud(viewOf(camera));
    mapping.setComputeMesh(false);
    MappedPlanes found;
    mapping.compute(found);
    const bool is_picture = mapping.getReport().depth_planes.has_value();
    EXPECT_EQ(is_picture, correlated == 0) << correlated;
    if (is_picture) {
      EXPECT_EQ(found.planes.size(), DepthRoom(camera).planes.size());
    }
  }
}

TEST(PlaneMapping, findsThePlanesOfAKinectInItsPicture)
{
  PlaneMapping mapping;
  mapping.setInputCloud(kinectView());
  mapping.setComputeMesh(false);
  MappedPlanes found, with_mesh;
  mapping.compute(found);
  EXPECT_GE(found.planes.size(), 3U);
  EXPECT_EQ(found.labels.size(), DepthRoom::width * DepthRoom::height);
  EXPECT_TRUE(found.mesh.triangles.empty());
  EXPECT_TRUE(mapping.getReport().depth_planes);
  mapping.setComputeMesh(true);
  mapping.compute(with_mesh);
  EXPECT_EQ(equationsOf(with_mesh.planes), equationsOf(found.planes));
  EXPECT_GT(with_mesh.mesh.triangles.size(), 10000U);
  EXPECT_THAT(with_mesh.vertex_labels, ElementsAreArray(with_mesh.labels));
  EXPECT_TRUE(mapping.getReport().refinement);
}

TEST(PlaneMapping, arrangesAViewWithoutItsNanPixels)
{
  const PointCloud<PointXYZ>::Ptr view = kinectView(), dense(new PointCloud<PointXYZ>);
  for (const PointXYZ& point : *view)
    if (point.getVector3fMap().allFinite())
      dense->push_back(point);
  PlaneMapping mapping;
  MappedPlanes organized, unorganized;
  mapping.setInputCloud(view);
  mapping.compute(organized);
  mapping.setInputCloud(dense);
  mapping.compute(unorganized);
  EXPECT_EQ(unorganized.planes.size(), organized.planes.size());
  EXPECT_EQ(unorganized.labels.size(), dense->size());
  EXPECT_GT(unorganized.vertices.layout().height, 1U);
}

TEST(PlaneMapping, consolidatesAlwaysWhereItIsTold)
{
  PlaneMapping mapping;
  mapping.setInputCloud(kinectView());
  mapping.setConsolidationPolicy(ConsolidationPolicy::Always);
  MappedPlanes found;
  mapping.compute(found);
  EXPECT_TRUE(mapping.getReport().consolidation);
  EXPECT_FALSE(mapping.getReport().depth_planes);
}

TEST(PlaneMapping, doesNotConsolidateWhatIsSparseAndExact)
{
  PointCloud<PointXYZ>::Ptr floor(new PointCloud<PointXYZ>);
  for (int i = 0; i < 60; ++i)
    for (int k = 0; k < 60; ++k)
      floor->push_back(PointXYZ(0.05F * i + 0.001F * (k % 3), 1, 0.05F * k));
  PlaneMapping mapping;
  mapping.setInputCloud(floor);
  MappedPlanes found;
  mapping.compute(found);
  ASSERT_EQ(found.planes.size(), 1U);
  EXPECT_FALSE(mapping.getReport().consolidation);
  EXPECT_EQ(found.vertices.size(), floor->size());
  EXPECT_EQ(found.labels, PointLabels(floor->size(), 0));
}

/** The points that have another label. */
std::shared_ptr<PointIndices>
pointsWithout(const PointLabels& labels, std::int32_t label)
{
  const auto others = std::make_shared<PointIndices>();
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != label)
      others->indices.push_back(static_cast<index_t>(i));
  return others;
}

/** The area of the planes that lie on a plane, square metres. */
double
areaOn(const PlanePatch& plane, const std::vector<PlanePatch>& planes)
{
  double area = 0;
  for (const PlanePatch& other : planes)
    if ((other.coefficients - plane.coefficients).norm() < 0.05)
      area += other.area;
  return area;
}

void
expectNoLabelOutside(const Indices& indices, const PointLabels& labels)
{
  std::vector<bool> is_inside(labels.size());
  for (const index_t index : indices)
    is_inside[static_cast<std::size_t>(index)] = true;
  for (std::size_t i = 0; i < labels.size(); ++i)
    ASSERT_TRUE(is_inside[i] || labels[i] == -1) << i;
}

TEST_F(Office, isMappedWithItsIndicesAlone)
{
  MappedPlanes all, rest, again;
  PlaneMapping mapping = this->mapping();
  EXPECT_FALSE(mapping.getIndices());
  mapping.compute(all);
  const std::shared_ptr<PointIndices> others = pointsWithout(all.labels, 0);
  mapping.setIndices(others);
  mapping.compute(rest);
  EXPECT_EQ(rest.labels.size(), all.labels.size());
  EXPECT_EQ(rest.finite_points, others->indices.size());
  expectNoLabelOutside(others->indices, rest.labels);
  EXPECT_GE(rest.planes.size() + 2, all.planes.size());
  EXPECT_LT(areaOn(all.planes[0], rest.planes), 0.2 * all.planes[0].area);

  const IndicesPtr indices(new Indices(others->indices));
  mapping.setIndices(indices);
  mapping.compute(again);
  EXPECT_EQ(again.labels, rest.labels);
  mapping.setIndices(PointIndicesConstPtr());
  mapping.compute(again);
  EXPECT_EQ(again.labels, all.labels);
  mapping.setIndices(indices);
  mapping.setIndices(IndicesConstPtr());
  EXPECT_FALSE(mapping.getIndices());
}

TEST_F(Office, isMappedOnItsMeshWithItsIndicesAlone)
{
  MappedPlanes first, rest;
  PlaneMapping mapping = this->mapping();
  mapping.compute(first);
  const std::shared_ptr<PointIndices> others = pointsWithout(first.vertex_labels, 0);
  mapping.setInputCloud(first.vertices);
  mapping.setInputMesh(first.mesh);
  mapping.setIndices(others);
  mapping.compute(rest);
  expectNoLabelOutside(others->indices, rest.labels);
  EXPECT_GE(rest.planes.size(), 3U);
}

TEST(PlaneMapping, leavesOutPixelsOfAPicture)
{
  PlaneMapping mapping;
  mapping.setInputCloud(kinectView());
  MappedPlanes all, rest;
  mapping.compute(all);
  const std::shared_ptr<PointIndices> others = pointsWithout(all.labels, 0);
  mapping.setIndices(others);
  mapping.compute(rest);
  EXPECT_TRUE(mapping.getReport().depth_planes);
  EXPECT_EQ(rest.vertices.layout().height, DepthRoom::height);
  EXPECT_EQ(rest.labels.size(), all.labels.size());
  expectNoLabelOutside(others->indices, rest.labels);
  EXPECT_GE(rest.planes.size() + 2, all.planes.size());
}

TEST(PlaneMapping, refusesAnIndexAsTheFiltersDo)
{
  const PointCloud<PointXYZ>::Ptr view = kinectView();
  const auto faultOf = [](const auto& run) -> std::string {
    try {
      run();
    }
    catch (const InitFailedException& fault) {
      return fault.what();
    }
    return "none";
  };
  for (const index_t index : {-1, static_cast<index_t>(view->size())}) {
    const IndicesPtr indices(new Indices{0, index});
    PlaneMapping mapping;
    mapping.setInputCloud(view);
    mapping.setIndices(indices);
    MappedPlanes found;
    VoxelConsolidation<PointXYZ> filter;
    filter.setInputCloud(view);
    filter.setIndices(indices);
    PointCloud<PointXYZ> filtered;
    EXPECT_EQ(faultOf([&] { mapping.compute(found); }),
              faultOf([&] { filter.filter(filtered); }));
    EXPECT_NE(faultOf([&] { mapping.compute(found); }), "none");
  }
}

TEST(PlaneMapping, givesTheTypesOfPcl)
{
  const PointCloud<PointXYZ>::Ptr view = kinectView();
  view->header.frame_id = "camera";
  view->header.seq = 7;
  PlaneMapping mapping;
  mapping.setInputCloud(view);
  MappedPlanes found;
  std::vector<ModelCoefficients> coefficients(99);
  std::vector<PointIndices> inliers(99);
  mapping.compute(found);
  mapping.compute(coefficients, inliers);
  EXPECT_FALSE(mapping.getReport().mesh) << "nobody asked for one";
  ASSERT_EQ(coefficients.size(), found.planes.size());
  ASSERT_EQ(inliers.size(), found.planes.size());
  std::size_t members = 0;
  for (std::size_t plane = 0; plane < inliers.size(); ++plane) {
    EXPECT_EQ(Eigen::Map<const Eigen::Vector4f>(coefficients[plane].values.data()),
              found.planes[plane].coefficients.cast<float>());
    EXPECT_EQ(coefficients[plane].header.seq, 7U);
    EXPECT_EQ(inliers[plane].header.frame_id, "camera");
    members += inliers[plane].indices.size();
    for (const index_t index : inliers[plane].indices)
      ASSERT_EQ(found.labels[static_cast<std::size_t>(index)], plane);
  }
  EXPECT_EQ(members,
            std::count_if(found.labels.begin(), found.labels.end(), [](int label) {
              return label >= 0;
            }));

  PointIndices largest;
  ModelCoefficients plane;
  mapping.segment(largest, plane);
  EXPECT_EQ(largest.indices, inliers[0].indices);
  EXPECT_EQ(plane.values, coefficients[0].values);
  mapping.setIndices(IndicesPtr(new Indices));
  mapping.segment(largest, plane);
  EXPECT_TRUE(largest.indices.empty() && plane.values.empty());
}

TEST(PlaneMapping, refusesWhatIsNoCloud)
{
  PlaneMapping mapping;
  MappedPlanes found;
  EXPECT_THROW(mapping.compute(found), InitFailedException);
  EXPECT_THROW(mapping.setInputCloud(std::shared_ptr<const PointCloudFile>()),
               InitFailedException);
  EXPECT_THROW(mapping.setInputCloud(PointCloud<PointXYZ>::Ptr()), InitFailedException);
  EXPECT_THROW(mapping.setMeshConstruction(nullptr), BadArgumentException);
  const auto lying = std::make_shared<PointCloudFile>();
  toPCLPointCloud2(*kinectView(), lying->cloud);
  lying->cloud.data.resize(100);
  mapping.setInputCloud(std::shared_ptr<const PointCloudFile>(lying));
  EXPECT_THROW(mapping.compute(found), InitFailedException);
}

TEST(PlaneMapping, ofNothingIsNothing)
{
  PointCloud<PointXYZ>::Ptr cloud(new PointCloud<PointXYZ>);
  PlaneMapping mapping;
  for (const float value : {0.0F, std::numeric_limits<float>::quiet_NaN()}) {
    cloud->assign(value == 0 ? 0 : 20, PointXYZ(value, value, value));
    mapping.setInputCloud(cloud);
    MappedPlanes found;
    mapping.compute(found);
    EXPECT_TRUE(found.planes.empty());
    EXPECT_FALSE(mapping.getReport().remarks.empty());
    EXPECT_EQ(found.finite_points, 0U);
  }
}

} // namespace
} // namespace pcl::acmap::test
