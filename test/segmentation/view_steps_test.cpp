#include <pcl/core/random.h>
#include <pcl/segmentation/impl/plane_clustering_kernel.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace pcl::acmap::test {
namespace {

using Height = std::function<double(double x, int observation)>;

struct SeenPoint {
  Eigen::Vector3f place;
  std::int32_t observation;
};

/** \brief Height of a step as a function of x, metres. */
double
stepAt(double x)
{
  return x < 2 ? 0 : 0.025;
}

/** \brief A floor of 4 x 2 m, observed by ten overlapping observations, each 1.6 m
 * wide. */
struct SeenFloor {
  static constexpr int observations = 10;
  static constexpr double length = 4, width = 2, spacing = 0.05;

  std::vector<SeenPoint> points;
  std::vector<Eigen::Vector3f> origins;
  std::vector<Eigen::Vector3f> vertices; ///< with a step, as in a merged map
  PlaneHypotheses hypotheses;

  /** \param[in] height as measured by an observation, metres */
  explicit SeenFloor(const Height& height, bool is_known = true)
  {
    Random random(3);
    for (int k = 0; k < observations; ++k) {
      origins.emplace_back(static_cast<float>(middleOf(k)), 1.0F, 1.5F);
      for (int i = 0; i < 6000; ++i) {
        const double x = middleOf(k) + random.uniform(-0.8, 0.8);
        const double y = random.uniform(0, width);
        if (x >= 0 && x <= length)
          points.push_back(
              {Eigen::Vector3d(x, y, height(x, k) + 0.003 * random.normal())
                   .cast<float>(),
               is_known ? k : -1});
      }
    }
    makeMesh();
  }

  PlaneClusters
  cluster() const
  {
    PlaneClusteringSettings settings;
    settings.noise_driven = true;
    settings.normal_angle = 0.2;
    PlaneClusteringReport report;
    const PlaneSource source{
        PointView(points[0].place.data(), sizeof(SeenPoint), points.size()),
        SensorView(&points[0].observation, sizeof(SeenPoint), origins)};
    return clusterPlanes(hypotheses, source, settings, Progress(), report);
  }

private:
  static double
  middleOf(int observation)
  {
    return length * (observation + 0.5) / observations;
  }

  void
  makeMesh()
  {
    const int columns = static_cast<int>(length / spacing) + 1;
    const int rows = static_cast<int>(width / spacing) + 1;
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        const double x = column * spacing;
        vertices.emplace_back(
            Eigen::Vector3d(x, row * spacing, stepAt(x)).cast<float>());
        hypotheses.normals.emplace_back(Eigen::Vector3f::UnitZ());
        if (row == 0 || column == 0)
          continue;
        const std::int32_t corner = row * columns + column;
        hypotheses.triangles.push_back(
            {corner, corner - 1 - columns, corner - columns});
        hypotheses.triangles.push_back({corner, corner - 1, corner - 1 - columns});
      }
    hypotheses.points =
        PointView(vertices[0].data(), sizeof vertices[0], vertices.size());
  }
};

TEST(ViewSteps, floorThatPosesToreApartIsOnePlane)
{
  // observations from the sixth one on are 25 mm too high
  const PlaneClusters found =
      SeenFloor([](double, int k) { return k < 5 ? 0 : 0.025; }).cluster();
  ASSERT_EQ(found.patches.size(), 1U);
  EXPECT_NEAR(found.patches[0].area, 8, 0.5);
  EXPECT_NEAR(found.patches[0].coefficients[2], 1, 1e-3);
  const auto labelled =
      std::count(found.source_labels.begin(), found.source_labels.end(), 0);
  EXPECT_GT(static_cast<double>(labelled),
            0.98 * static_cast<double>(found.source_labels.size()));
}

TEST(ViewSteps, stepThatObservationsSeeStays)
{
  const PlaneClusters found =
      SeenFloor([](double x, int) { return stepAt(x); }).cluster();
  EXPECT_EQ(found.patches.size(), 2U);
}

TEST(ViewSteps, stepStaysWherePosesErrToo)
{
  const PlaneClusters found = SeenFloor([](double x, int k) {
                                return stepAt(x) + 0.004 * std::sin(2.0 * k);
                              }).cluster();
  EXPECT_EQ(found.patches.size(), 2U);
}

TEST(ViewSteps, withoutObservationsNothingIsRuledOut)
{
  const PlaneClusters found =
      SeenFloor([](double, int k) { return k < 5 ? 0 : 0.025; }, false).cluster();
  EXPECT_EQ(found.patches.size(), 2U);
}

} // namespace
} // namespace pcl::acmap::test
