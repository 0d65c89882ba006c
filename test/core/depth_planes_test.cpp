#include "depth_room.h"

#include <pcl/core/impl/depth_planes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::acmap::test {
namespace {

DepthPlanes
planesOf(const std::vector<Eigen::Vector3f>& points)
{
  const PointView view(points.data(), sizeof points[0], points.size());
  const auto depth = DepthView::recognize(view, DepthRoom::width);
  if (!depth)
    return {};
  DepthPlaneSettings settings;
  settings.noise = measureInverseDepthNoise(*depth, measureDepthStep(view));
  return findDepthPlanes(*depth, settings, Progress());
}

double
degreesBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::acos(std::min(a.dot(b), 1.0)) * 180 / M_PI;
}

/** The plane to which most pixels of a true plane were assigned. */
std::int32_t
foundFor(const DepthRoom& room, const DepthPlanes& found, std::size_t plane)
{
  std::map<std::int32_t, std::size_t> votes;
  for (std::size_t i = 0; i < room.truth.size(); ++i)
    if (room.truth[i] == static_cast<std::int32_t>(plane))
      ++votes[found.labels[i]];
  return std::max_element(
             votes.begin(),
             votes.end(),
             [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

class QuantisedRooms : public testing::TestWithParam<std::uint64_t> {};

TEST_P(QuantisedRooms, haveTheirPlanesAndNoOthers)
{
  DepthRoom::Camera camera;
  camera.seed = GetParam();
  const DepthRoom room(camera);
  const DepthPlanes found = planesOf(room.points);
  ASSERT_EQ(found.planes.size(), room.planes.size());
  std::size_t right = 0;
  for (std::size_t p = 0; p < room.planes.size(); ++p) {
    const std::int32_t own = foundFor(room, found, p);
    ASSERT_GE(own, 0) << "plane " << p;
    const DepthPlane& plane = found.planes[static_cast<std::size_t>(own)];
    EXPECT_LT(degreesBetween(plane.normal(), room.planes[p].normal), p < 3 ? 0.5 : 1.5)
        << "plane " << p;
    // depth errors at its pixels, not the distance to the camera
    std::vector<double> off;
    for (std::size_t i = 0; i < room.truth.size(); ++i) {
      if (room.truth[i] != static_cast<std::int32_t>(p))
        continue;
      right += found.labels[i] == own ? 1 : 0;
      const Eigen::Vector3d ray =
          room.points[i].cast<double>() / static_cast<double>(room.points[i].z());
      off.push_back(std::abs(1 / plane.inverse.dot(ray) - room.true_depths[i]));
    }
    std::nth_element(off.begin(), off.begin() + off.size() / 2, off.end());
    EXPECT_LT(off[off.size() / 2], 0.01) << "plane " << p;
  }
  EXPECT_GT(right, 0.97 * static_cast<double>(room.truth.size()));
}

INSTANTIATE_TEST_SUITE_P(Seeds, QuantisedRooms, testing::Values(1, 2, 3, 4, 5));

TEST(DepthPlanes, haveTheAreaOfTheirPixels)
{
  const DepthRoom room({});
  const DepthPlanes found = planesOf(room.points);
  const auto top = static_cast<std::size_t>(foundFor(room, found, 4));
  ASSERT_LT(top, found.planes.size());
  EXPECT_NEAR(found.planes[top].area, 0.8, 0.08);
  for (std::size_t p = 1; p < found.planes.size(); ++p)
    EXPECT_LE(found.planes[p].area, found.planes[p - 1].area);
}

TEST(DepthPlanes, areNotStripsOfACylinder)
{
  for (const double radius : {0.3, 0.6, 1.2}) {
    const DepthPlanes found = planesOf(depthOfCylinder({}, radius, 1.2 + radius));
    EXPECT_EQ(found.planes.size(), 0u) << radius << ' ' << found.curved;
  }
}

TEST(DepthPlanes, ofNoiseAloneAreNone)
{
  DepthRoom room({});
  std::uint64_t state = 7;
  for (std::size_t i = 0; i < room.points.size(); ++i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    const float depth = 1 + static_cast<float>(state >> 40) * 0x1p-24F * 3;
    room.points[i] *= depth / room.points[i].z();
  }
  EXPECT_TRUE(planesOf(room.points).planes.empty());
}

TEST(DepthPlanes, keepARecessApart)
{
  DepthRoom::Camera camera;
  DepthRoom room(camera);
  // a door that is 4 steps behind the wall: about 0.2 m at 4 m
  std::size_t moved = 0;
  for (std::size_t row = 20; row < 110; ++row)
    for (std::size_t column = 120; column < 180; ++column) {
      const std::size_t i = row * DepthRoom::width + column;
      if (room.truth[i] != 0)
        continue;
      Eigen::Vector3f& point = room.points[i];
      const float inverse = 1 / point.z() - 4 * 0.0029F;
      point *= 1 / inverse / point.z();
      ++moved;
    }
  ASSERT_GT(moved, 5000u);
  const DepthPlanes found = planesOf(room.points);
  EXPECT_EQ(found.planes.size(), room.planes.size() + 1);
}

TEST(DepthPlanes, stopWhenTold)
{
  const DepthRoom room({});
  const PointView points(room.points.data(), sizeof room.points[0], room.points.size());
  const auto view = DepthView::recognize(points, DepthRoom::width);
  ASSERT_TRUE(view);
  EXPECT_THROW(
      findDepthPlanes(*view,
                      {{0.0029, 1e-3, 1e-3, {}}, 0},
                      Progress([](double, const std::string&) { return false; })),
      CancelledException);
}

} // namespace
} // namespace pcl::acmap::test
