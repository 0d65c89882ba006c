#include <pcl/core/impl/observation_gap.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

namespace {

using pcl::acmap::measureObservationGap;
using pcl::acmap::ObservationGap;
using pcl::acmap::PointView;
using pcl::acmap::SensorView;

struct Seen {
  Eigen::Vector3f point;
  std::int32_t view;
};

constexpr double spacing = 0.01; // metres, of one observation
constexpr double noise = 0.002;

/** Adds a corner of three square metres, as one observation saw it. */
void
addCorner(const Eigen::Isometry3f& pose, std::int32_t view, std::vector<Seen>& cloud)
{
  std::mt19937 random(static_cast<unsigned>(view) + 1);
  std::uniform_real_distribution<float> along(0, 1);
  std::normal_distribution<float> across(0, noise);
  constexpr int of_a_wall = 10000;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < of_a_wall; ++i) {
      Eigen::Vector3f point(along(random), along(random), along(random));
      point[axis] = across(random);
      cloud.push_back({pose * point, view});
    }
}

ObservationGap
gapOf(const std::vector<Seen>& cloud, unsigned threads = 0)
{
  const std::vector<Eigen::Vector3f> origins(3, Eigen::Vector3f::Zero());
  return measureObservationGap(
      PointView(cloud.empty() ? nullptr : &cloud[0].point, sizeof(Seen), cloud.size()),
      SensorView(cloud.empty() ? nullptr : &cloud[0].view, sizeof(Seen), origins),
      spacing,
      threads);
}

/** Three observations of the corner, each turned and shifted further by an error. */
std::vector<Seen>
observedWith(float angle, float shift)
{
  std::vector<Seen> cloud;
  for (std::int32_t view = 0; view < 3; ++view) {
    Eigen::Isometry3f pose(Eigen::AngleAxisf(angle * static_cast<float>(view),
                                             Eigen::Vector3f(1, 2, 3).normalized()));
    pose.translation() = Eigen::Vector3f::Constant(shift * static_cast<float>(view));
    addCorner(pose, view, cloud);
  }
  return cloud;
}

TEST(ObservationGap, isNoiseWherePosesAreRight)
{
  const ObservationGap gap = gapOf(observedWith(0, 0));
  EXPECT_GT(gap.places, 1000u);
  EXPECT_NEAR(gap.gap, noise, noise);
  EXPECT_FALSE(gap.isChance());
}

TEST(ObservationGap, isChanceWherePosesAreWrong)
{
  const ObservationGap gap = gapOf(observedWith(0.7F, 0.15F));
  EXPECT_TRUE(gap.isChance()) << gap.gap << " of " << gap.radius << " at "
                              << gap.places;
}

TEST(ObservationGap, smallErrorsOfPosesAreNoChance)
{
  EXPECT_FALSE(gapOf(observedWith(0.002F, 0.003F)).isChance());
}

TEST(ObservationGap, nothingIsComparedWithoutSeveralObservations)
{
  std::vector<Seen> cloud;
  EXPECT_EQ(gapOf(cloud).places, 0u);
  addCorner(Eigen::Isometry3f::Identity(), 1, cloud);
  EXPECT_EQ(gapOf(cloud).places, 0u);
  for (Seen& seen : cloud)
    seen.view = 7; // there is none
  EXPECT_EQ(gapOf(cloud).places, 0u);
}

TEST(ObservationGap, leavesOutWhatIsNotFinite)
{
  std::vector<Seen> cloud = observedWith(0, 0);
  for (std::size_t i = 0; i < cloud.size(); i += 3)
    cloud[i].point[i % 3] = std::numeric_limits<float>::quiet_NaN();
  const ObservationGap gap = gapOf(cloud);
  EXPECT_GT(gap.places, 1000u);
  EXPECT_FALSE(gap.isChance());
}

TEST(ObservationGap, isTheSameForAnyThreads)
{
  const std::vector<Seen> cloud = observedWith(0.7F, 0.15F);
  const ObservationGap one = gapOf(cloud, 1), four = gapOf(cloud, 4);
  EXPECT_EQ(one.gap, four.gap);
  EXPECT_EQ(one.places, four.places);
}

} // namespace
