#include "cylinder_scenes.h"
#include "voting_meshes.h"

#include <pcl/core/point_types.h>
#include <pcl/segmentation/cylinder_hypothesis_clustering.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace pcl::acmap::test {
namespace {

using Cylinders = CylinderHypothesisClustering<PointXYZ>;

struct FoundCylinders {
  std::vector<CylinderPatch> patches;
  PointLabels labels;
  CylinderClusteringReport report;
};

FoundCylinders
run(Cylinders& clustering)
{
  FoundCylinders found;
  clustering.segment(found.patches);
  found.labels = clustering.getLabels();
  found.report = clustering.getReport();
  return found;
}

FoundCylinders
findIn(const Cloud& cloud)
{
  Cylinders clustering;
  clustering.setInputCloud(cloud.makeShared());
  return run(clustering);
}

FoundCylinders
findIn(const CylinderView& view, unsigned threads = 0)
{
  Cylinders clustering;
  clustering.setInputCloud(view.cloud);
  clustering.setSourceCloud(view.cloud);
  clustering.setNumberOfThreads(threads);
  return run(clustering);
}

/** Nearest patch by its radius and place; nullptr if there is none near. */
const CylinderPatch*
patchOn(const SceneCylinder& truth, const FoundCylinders& found)
{
  for (const CylinderPatch& patch : found.patches) {
    const Eigen::Vector3d way = patch.axis_point - truth.point;
    if ((way - way.dot(truth.axis) * truth.axis).norm() < 0.2 * truth.radius &&
        std::abs(patch.axis_direction.dot(truth.axis)) > 0.99 &&
        std::abs(patch.radius - truth.radius) < 0.2 * truth.radius)
      return &patch;
  }
  return nullptr;
}

/** An upright cylinder of radius 0.5 m and height 2 m with its middle at the origin, 40
 * points around. */
VotingMesh
makeColumn(double arc = 2 * M_PI)
{
  constexpr double radius = 0.5, spacing = 0.08;
  const int columns = static_cast<int>(std::lround(arc * radius / spacing)) + 1;
  return makeSheetMesh(columns, 25, spacing, [](double u, double v) {
    return Eigen::Vector3d(
        radius * std::sin(u / radius), v, radius * std::cos(u / radius));
  });
}

PointCloud<Normal>::Ptr
radialNormals(const Cloud& cloud, float sign)
{
  const auto normals = std::make_shared<PointCloud<Normal>>();
  for (const PointXYZ& point : cloud) {
    const Eigen::Vector3f across =
        sign * Eigen::Vector3f(point.x, 0, point.z).normalized();
    normals->push_back(Normal(across.x(), across.y(), across.z()));
  }
  return normals;
}

TEST(Cylinders, pointsOfAModelAreExact)
{
  const FoundCylinders found = findIn(makeColumn(1.5 * M_PI).cloud);
  ASSERT_EQ(found.patches.size(), 1U);
  const CylinderPatch& patch = found.patches[0];
  EXPECT_NEAR(patch.radius, 0.5, 1e-5);
  EXPECT_GT(std::abs(patch.axis_direction.y()), 1 - 1e-9);
  EXPECT_NEAR(patch.high - patch.low, 1.92, 1e-3);
  EXPECT_NEAR(patch.arc, 1.5 * M_PI, 0.1);
  EXPECT_LT(patch.axis_u.dot(patch.axis_point), 0.1)
      << "the axis is in the middle, not on the surface";
  EXPECT_NEAR(patch.axis_u.cross(patch.axis_v).dot(patch.axis_direction), 1, 1e-12);
  EXPECT_LT(found.report.bits_after, found.report.bits_before);
}

TEST(Cylinders, meshesHaveTheSideOfTheirNormals)
{
  const VotingMesh column = makeColumn(M_PI);
  for (const float sign : {1.0F, -1.0F}) {
    Cylinders clustering;
    clustering.setInputCloud(column.cloud.makeShared());
    clustering.setInputNormals(radialNormals(column.cloud, sign));
    clustering.setTriangles(column.faces);
    const FoundCylinders found = run(clustering);
    ASSERT_EQ(found.patches.size(), 1U);
    EXPECT_EQ(found.patches[0].is_hollow, sign < 0);
    EXPECT_NEAR(found.patches[0].radius, 0.5, 1e-5);
    EXPECT_EQ(std::count(found.labels.begin(), found.labels.end(), 0),
              static_cast<std::ptrdiff_t>(column.cloud.size()));
  }
}

TEST(Cylinders, planesOnThemFall)
{
  const VotingMesh column = makeColumn(M_PI);
  std::vector<PlanePatch> strips(4);
  PointLabels labels;
  for (std::size_t s = 0; s < strips.size(); ++s) {
    const double angle = M_PI * (static_cast<double>(s) - 1.5) / 4;
    strips[s].coefficients << std::sin(angle), 0, std::cos(angle), -0.48;
  }
  for (const PointXYZ& point : column.cloud)
    labels.push_back(std::clamp(
        static_cast<int>((std::atan2(point.x, point.z) / M_PI + 0.5) * 4), 0, 3));
  Cylinders clustering;
  clustering.setInputCloud(column.cloud.makeShared());
  clustering.setInputNormals(radialNormals(column.cloud, 1));
  clustering.setTriangles(column.faces);
  clustering.setNoise(0.01);
  clustering.setPlanes(strips, labels);
  const FoundCylinders found = run(clustering);
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_EQ(found.patches[0].planes, (std::vector<std::int32_t>{0, 1, 2, 3}));
  EXPECT_EQ(found.report.replaced_planes, 4U);
  EXPECT_LT(found.report.bits_after, found.report.bits_before);
}

TEST(Cylinders, areFittedToTheRaysOfTheSource)
{
  const CylinderView view = seeColumns(0.005, 40);
  const auto largest = std::max_element(
      view.cylinders.begin(), view.cylinders.end(), [](const auto& a, const auto& b) {
        return a.radius < b.radius;
      });
  const SceneCylinder truth = *largest;
  Cloud column;
  for (std::size_t i = 0; i < view.truth.size(); ++i)
    if (view.truth[i] == largest - view.cylinders.begin())
      column.push_back((*view.cloud)[i]);
  // A coarse mesh whose radius is 2 cm too small.
  const Eigen::Vector3d u = truth.axis.unitOrthogonal(), v = truth.axis.cross(u);
  const double radius = truth.radius - 0.02;
  const VotingMesh mesh = makeSheetMesh(
      static_cast<int>(2 * M_PI * radius / 0.04), 30, 0.04, [&](double a, double z) {
        return Eigen::Vector3d(
            truth.point + z * truth.axis +
            radius * (std::cos(a / radius) * u - std::sin(a / radius) * v));
      });
  const auto normals = std::make_shared<PointCloud<Normal>>();
  for (const PointXYZ& point : mesh.cloud) {
    const Eigen::Vector3d from = point.getVector3fMap().cast<double>() - truth.point;
    const Eigen::Vector3f across =
        (from - from.dot(truth.axis) * truth.axis).normalized().cast<float>();
    normals->push_back(Normal(across.x(), across.y(), across.z()));
  }
  Cylinders clustering;
  clustering.setInputCloud(mesh.cloud.makeShared());
  clustering.setInputNormals(normals);
  clustering.setTriangles(mesh.faces);
  clustering.setSourceCloud(column.makeShared());
  clustering.setNoise(0.01);
  const FoundCylinders found = run(clustering);
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_NEAR(found.patches[0].radius, truth.radius, 0.002);

  // a known scale of the source is not measured again
  NoiseScale scale =
      measureNoiseScale(PointView(&column[0].x, sizeof(PointXYZ), column.size()),
                        SensorView(Eigen::Vector3f(column.sensor_origin_.head<3>())));
  clustering.setSourceScale(scale);
  const FoundCylinders same = run(clustering);
  ASSERT_EQ(same.patches.size(), 1U);
  EXPECT_EQ(same.patches[0].radius, found.patches[0].radius);
  EXPECT_EQ(same.patches[0].covariance, found.patches[0].covariance);
  scale.spacing *= 20;
  clustering.setSourceScale(scale);
  const FoundCylinders coarse = run(clustering);
  EXPECT_TRUE(coarse.patches.empty() ||
              coarse.patches[0].covariance != found.patches[0].covariance);
  clustering.setSourceCloud(column.makeShared());
  EXPECT_EQ(run(clustering).patches[0].radius, found.patches[0].radius);
  scale.spacing = -1;
  EXPECT_THROW(clustering.setSourceScale(scale), BadArgumentException);
}

TEST(Cylinders, halfSeenColumnsAreFoundAmongWalls)
{
  for (const double sigma : {0.003, 0.01})
    for (const std::uint64_t seed : {40, 41}) {
      const CylinderView view = seeColumns(sigma, seed);
      const FoundCylinders found = findIn(view);
      EXPECT_EQ(found.patches.size(), view.cylinders.size()) << sigma << ' ' << seed;
      for (const SceneCylinder& truth : view.cylinders) {
        const CylinderPatch* const patch = patchOn(truth, found);
        ASSERT_NE(patch, nullptr) << truth.radius << ' ' << sigma << ' ' << seed;
        EXPECT_NEAR(patch->radius, truth.radius, sigma / 4);
        EXPECT_FALSE(patch->is_hollow);
      }
      std::size_t wrong = 0;
      for (std::size_t i = 0; i < view.truth.size(); ++i)
        wrong += (view.truth[i] >= 0) != (found.labels[i] >= 0) ? 1 : 0;
      EXPECT_LT(wrong, view.truth.size() / 50);
      EXPECT_LT(found.report.bits_after, found.report.bits_before);
    }
}

/** With a noise that is larger than the spacing, the decision about a column can depend on
 * rounding, and so on the compiler: at most one of three is missed, and none is wrong. */
TEST(Cylinders, veryNoisyColumnsAreNotMistaken)
{
  constexpr double sigma = 0.02;
  for (const std::uint64_t seed : {40, 41}) {
    const CylinderView view = seeColumns(sigma, seed);
    const FoundCylinders found = findIn(view);
    EXPECT_GE(found.patches.size(), view.cylinders.size() - 1) << seed;
    std::size_t right = 0;
    for (const SceneCylinder& truth : view.cylinders)
      if (const CylinderPatch* const patch = patchOn(truth, found)) {
        EXPECT_NEAR(patch->radius, truth.radius, sigma / 4);
        ++right;
      }
    EXPECT_EQ(right, found.patches.size()) << seed;
  }
}

TEST(Cylinders, planesThatAreGivenAreNotSearchedAgain)
{
  const CylinderView view = seeColumns(0.01, 41);
  const std::vector<Eigen::Vector4d> room = planesOfRoom();
  std::vector<PlanePatch> planes(room.size());
  PointLabels labels(view.cloud->size(), -1);
  for (std::size_t p = 0; p < room.size(); ++p) {
    planes[p].coefficients = room[p];
    for (std::size_t i = 0; i < labels.size(); ++i)
      if (view.truth[i] < 0 &&
          std::abs(
              room[p].head<3>().dot((*view.cloud)[i].getVector3fMap().cast<double>()) +
              room[p][3]) < 0.05)
        labels[i] = static_cast<std::int32_t>(p);
  }
  Cylinders clustering;
  clustering.setInputCloud(view.cloud);
  clustering.setSourceCloud(view.cloud);
  clustering.setPlanes(planes, labels, PointLabels(labels.begin(), labels.end()));
  const FoundCylinders found = run(clustering);
  EXPECT_EQ(found.report.planes, 3U);
  EXPECT_EQ(found.patches.size(), 3U);
  for (const SceneCylinder& truth : view.cylinders)
    EXPECT_NE(patchOn(truth, found), nullptr) << truth.radius;
}

TEST(Cylinders, equalColumnsShareTheirRadius)
{
  const CylinderView view = seeColumns(0.01, 40, {0.15, 0.3, 0.15});
  const FoundCylinders found = findIn(view);
  ASSERT_EQ(found.patches.size(), 3U);
  EXPECT_EQ(found.report.templates, 2U);
  std::vector<const CylinderPatch*> narrow;
  for (const CylinderPatch& patch : found.patches)
    if (patch.radius < 0.2)
      narrow.push_back(&patch);
  ASSERT_EQ(narrow.size(), 2U);
  EXPECT_EQ(narrow[0]->radius, narrow[1]->radius);
  EXPECT_EQ(narrow[0]->template_id, narrow[1]->template_id);
  EXPECT_NEAR(narrow[0]->radius, 0.15, 0.0015);
  for (const CylinderPatch* const patch : narrow) {
    EXPECT_NEAR(patch->axis_u.dot(patch->axis_direction), 0, 1e-12);
    EXPECT_NEAR(
        (patch->axis_direction.cross(patch->axis_u) - patch->axis_v).norm(), 0, 1e-12);
    EXPECT_GT(patch->covariance(4, 4), 0);
    EXPECT_LT(patch->covariance(4, 4), 1e-6);
  }
}

TEST(Cylinders, roomsWithoutColumnsHaveNone)
{
  for (const double sigma : {0.003, 0.02})
    EXPECT_TRUE(findIn(seeEmptyRoom(sigma, 40)).patches.empty()) << sigma;
}

TEST(Cylinders, wallsThatAreFlatOrBowedStayPlanes)
{
  for (const double bow : {0.0, 0.025, 0.06}) {
    const FoundCylinders found =
        findIn(seeWall([&](double x) { return bow * (1 - x * x / 9); }, 0.01, 40));
    EXPECT_TRUE(found.patches.empty()) << bow;
    EXPECT_FALSE(found.report.remarks.empty()) << "it is said why";
  }
}

TEST(Cylinders, roundWallsAreNamed)
{
  for (const bool is_hollow : {false, true}) {
    const CylinderView view = seeRoundWall(is_hollow, 0.003, 40);
    const FoundCylinders found = findIn(view);
    ASSERT_EQ(found.patches.size(), 1U);
    EXPECT_NEAR(found.patches[0].radius, 10, 0.004);
    EXPECT_EQ(found.patches[0].is_hollow, is_hollow);
  }
}

TEST(Cylinders, columnsWithoutAnyPlaneAreFound)
{
  const CylinderView view = seeColumns(0.01, 42);
  CylinderView alone;
  for (std::size_t i = 0; i < view.truth.size(); ++i)
    if (view.truth[i] >= 0)
      alone.cloud->push_back((*view.cloud)[i]);
  const FoundCylinders found = findIn(alone);
  EXPECT_EQ(found.patches.size(), view.cylinders.size());
  for (const SceneCylinder& truth : view.cylinders)
    EXPECT_NE(patchOn(truth, found), nullptr) << truth.radius;
}

TEST(Cylinders, radiiOutsideOfTheLimitsAreNotTaken)
{
  const CylinderView view = seeColumns(0.003, 40);
  Cylinders clustering;
  clustering.setInputCloud(view.cloud);
  clustering.setSourceCloud(view.cloud);
  clustering.setRadiusLimits(0.1, 0.2);
  const FoundCylinders found = run(clustering);
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_NEAR(found.patches[0].radius, 0.15, 0.002);
}

TEST(Cylinders, resultsAreTheSameForAllThreads)
{
  const CylinderView view = seeColumns(0.01, 43);
  const FoundCylinders wanted = findIn(view, 1);
  ASSERT_FALSE(wanted.patches.empty());
  for (const unsigned threads : {2U, 4U}) {
    const FoundCylinders found = findIn(view, threads);
    ASSERT_EQ(found.patches.size(), wanted.patches.size());
    EXPECT_EQ(found.labels, wanted.labels);
    for (std::size_t p = 0; p < wanted.patches.size(); ++p) {
      const CylinderPatch &a = found.patches[p], &b = wanted.patches[p];
      EXPECT_EQ(a.axis_point, b.axis_point);
      EXPECT_EQ(a.axis_direction, b.axis_direction);
      EXPECT_EQ(a.radius, b.radius);
      EXPECT_EQ(a.covariance, b.covariance);
    }
  }
}

TEST(Cylinders, invalidPointsAreSkippedAndCounted)
{
  Cloud cloud = makeColumn().cloud;
  const std::size_t size = cloud.size();
  cloud.push_back(PointXYZ(std::nanf(""), 0, 0));
  cloud.push_back(PointXYZ(0, std::numeric_limits<float>::infinity(), 0));
  const FoundCylinders found = findIn(cloud);
  EXPECT_EQ(found.report.invalid_points, 2U);
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_EQ(found.labels[size], -1);
}

TEST(Cylinders, onlyIndicesAreUsed)
{
  Cloud both = makeColumn().cloud;
  const std::size_t size = both.size();
  for (PointXYZ point : makeColumn().cloud) {
    point.x += 5;
    both.push_back(point);
  }
  Cylinders clustering;
  clustering.setInputCloud(both.makeShared());
  const auto indices = std::make_shared<Indices>();
  for (std::size_t i = 0; i < size; ++i)
    indices->push_back(static_cast<index_t>(i));
  clustering.setIndices(indices);
  const FoundCylinders found = run(clustering);
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_NEAR(found.patches[0].axis_point.x(), 0, 1e-3);
  EXPECT_EQ(found.labels.size(), both.size());
  EXPECT_EQ(found.labels.back(), -1);
}

TEST(Cylinders, degenerateCloudsEndWell)
{
  std::vector<Cloud> clouds{{},
                            makeRandomBox(1, 1),
                            makeRandomBox(7, 1),
                            makeRandomBox(500, 2),
                            makeCoincident(200),
                            makeCollinear(200),
                            withOutlier(makeColumn().cloud, 1e9F)};
  Cloud invalid;
  invalid.resize(100, PointXYZ(std::nanf(""), 0, 0));
  clouds.push_back(invalid);
  for (const float factor : {1e-30F, 1e-15F, 1e15F, 1e19F, 1e30F})
    clouds.push_back(scaled(makeColumn().cloud, factor));
  for (const Cloud& cloud : clouds)
    for (const bool has_source : {false, true}) {
      Cylinders clustering;
      clustering.setInputCloud(cloud.makeShared());
      if (has_source)
        clustering.setSourceCloud(cloud.makeShared());
      const FoundCylinders found = run(clustering);
      EXPECT_EQ(found.labels.size(), cloud.size());
      for (const CylinderPatch& patch : found.patches) {
        EXPECT_TRUE(patch.axis_point.allFinite());
        EXPECT_NEAR(patch.axis_direction.norm(), 1, 1e-9);
        EXPECT_GT(patch.radius, 0);
      }
    }
}

TEST(Cylinders, inputsThatDoNotFitAreRefused)
{
  Cylinders clustering;
  std::vector<CylinderPatch> patches;
  EXPECT_THROW(clustering.segment(patches), InitFailedException);
  const Cloud cloud = makeColumn().cloud;
  clustering.setInputCloud(cloud.makeShared());
  clustering.setPlanes({PlanePatch()}, {0, 0});
  EXPECT_THROW(clustering.segment(patches), InitFailedException);
  clustering.setPlanes({PlanePatch()}, PointLabels(cloud.size(), 1));
  EXPECT_THROW(clustering.segment(patches), InitFailedException);
  clustering.setPlanes({}, {});
  clustering.setInputNormals(std::make_shared<PointCloud<Normal>>());
  EXPECT_THROW(clustering.segment(patches), InitFailedException);
  EXPECT_THROW(clustering.setRadiusLimits(2, 1), BadArgumentException);
  EXPECT_THROW(clustering.setRadiusLimits(-1, 1), BadArgumentException);
}

/** Radii scatter as their covariances tell. */
TEST(CylinderCovariance, covarianceHolds)
{
  double squares = 0;
  std::size_t fits = 0;
  for (std::uint64_t seed = 60; seed < 70; ++seed) {
    const CylinderView view = seeColumns(0.01, seed);
    const FoundCylinders found = findIn(view);
    for (const SceneCylinder& truth : view.cylinders)
      if (const CylinderPatch* const patch = patchOn(truth, found)) {
        squares += std::pow(patch->radius - truth.radius, 2) / patch->covariance(4, 4);
        ++fits;
      }
  }
  ASSERT_GE(fits, 27U);
  // 30 values: a ratio outside of this has a chance of about 1 in 1000
  EXPECT_GT(squares / static_cast<double>(fits), 0.4);
  EXPECT_LT(squares / static_cast<double>(fits), 2.0);
}

} // namespace
} // namespace pcl::acmap::test
