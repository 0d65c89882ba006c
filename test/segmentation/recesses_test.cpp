#include "box_scenes.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/random.h>
#include <pcl/segmentation/recess_fitting.h>

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

const Eigen::Vector3d room_least(-3, -1.5, -3), room_most(3, 1.2, 3); // y is down
constexpr std::size_t wall = 4; ///< number of the plane z = 3 of the room

/** An opening of the wall and the leaf in it, metres. */
struct Door {
  double left = 0; ///< x
  double width = 0.9;
  double height = 2.1;
  double depth = 0.1;
  double sill = 0; ///< height above the floor
};

std::vector<RecessPatch>
recessesOf(const std::vector<PlanePatch>& planes)
{
  RecessFitting fitting;
  fitting.setPlanes(planes);
  std::vector<RecessPatch> recesses;
  fitting.segment(recesses);
  EXPECT_EQ(fitting.getReport().recesses, recesses.size());
  EXPECT_EQ(fitting.getReport().remarks.empty(), !recesses.empty());
  return recesses;
}

Eigen::Vector3f
onWall(double x, double y)
{
  return Eigen::Vector3d(x, y, room_most.z()).cast<float>();
}

/** Cuts the outline of a door into the wall; doors of one wall from left to right. */
void
cutOpening(PlanePatch& plane, const Door& door)
{
  const double right = door.left + door.width, bottom = room_most.y() - door.sill,
               top = bottom - door.height;
  PlanePolygon& polygon = plane.polygons.at(0);
  if (door.sill > 0) {
    polygon.holes.push_back({onWall(door.left, top),
                             onWall(right, top),
                             onWall(right, bottom),
                             onWall(door.left, bottom)});
    return;
  }
  const auto isCorner = [](const Eigen::Vector3f& point) {
    return point == onWall(room_most.x(), room_most.y());
  };
  const auto corner =
      std::find_if(polygon.outer.begin(), polygon.outer.end(), isCorner);
  ASSERT_NE(corner, polygon.outer.end());
  polygon.outer.insert(corner,
                       {onWall(door.left, bottom),
                        onWall(door.left, top),
                        onWall(right, top),
                        onWall(right, bottom)});
}

void
addLeaf(RectangleMap& map, const Door& door)
{
  map.add({door.left, room_most.y() - door.sill, room_most.z() + door.depth},
          {door.width, 0, 0},
          {0, -door.height, 0});
}

RectangleMap
roomWith(const std::vector<Door>& doors)
{
  RectangleMap map;
  map.addRoom(room_least, room_most);
  // the outline begins where it does not matter, and runs along the floor to the right
  map.planes[wall].polygons[0].outer = {onWall(room_most.x(), room_least.y()),
                                        onWall(room_least.x(), room_least.y()),
                                        onWall(room_least.x(), room_most.y()),
                                        onWall(room_most.x(), room_most.y())};
  for (const Door& door : doors) {
    cutOpening(map.planes[wall], door);
    addLeaf(map, door);
  }
  return map;
}

void
expectDoor(const RecessPatch& recess, const Door& door, double tolerance)
{
  const Eigen::Vector3d center(door.left + door.width / 2,
                               room_most.y() - door.sill - door.height / 2,
                               room_most.z());
  Eigen::Matrix3d axes;
  axes << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  EXPECT_LT((recess.center - center).cwiseAbs().maxCoeff(), tolerance);
  EXPECT_LT((recess.size - Eigen::Vector3d(door.width, door.height, door.depth))
                .cwiseAbs()
                .maxCoeff(),
            tolerance);
  EXPECT_LT((recess.axes - axes).cwiseAbs().maxCoeff(), tolerance);
  EXPECT_EQ(recess.reaches_floor, door.sill == 0);
  EXPECT_GT(recess.saved_bits, 0);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      Eigen::MatrixXd(recess.covariance));
  EXPECT_GT(solver.eigenvalues().minCoeff(), 0);
}

TEST(Recesses, doorReachesTheFloor)
{
  const Door door{-0.4};
  const std::vector<RecessPatch> recesses = recessesOf(roomWith({door}).planes);
  ASSERT_EQ(recesses.size(), 1U);
  expectDoor(recesses[0], door, 1e-6);
  EXPECT_EQ(recesses[0].wall, static_cast<std::int32_t>(wall));
  EXPECT_EQ(recesses[0].leaf, 6);
  EXPECT_LT(recesses[0].covariance(8, 8), recesses[0].covariance(6, 6))
      << "its depth is known better than its width";
  EXPECT_LT(recesses[0].covariance(5, 5), recesses[0].covariance(3, 3))
      << "the opening is in the plane of the wall";
}

TEST(Recesses, windowIsClosedBelow)
{
  const Door window{0.5, 1.2, 1, 0.2, 0.9};
  RectangleMap map = roomWith({window});
  map.add({0.5, 0.3, 3}, {1.2, 0, 0}, {0, 0, 0.2}); // the sill, which faces up
  ASSERT_EQ(map.planes.back().coefficients.y(), -1);
  const std::vector<RecessPatch> recesses = recessesOf(map.planes);
  ASSERT_EQ(recesses.size(), 1U);
  expectDoor(recesses[0], window, 1e-6);
}

/** Doors in a row are polygons of one plane. */
TEST(Recesses, leavesInOnePlaneAreApart)
{
  const std::vector<Door> doors{{-2.4}, {0.2}};
  RectangleMap map = roomWith(doors);
  map.planes[6].polygons.push_back(map.planes[7].polygons[0]);
  map.planes.pop_back();
  std::vector<RecessPatch> recesses = recessesOf(map.planes);
  ASSERT_EQ(recesses.size(), 2U);
  std::sort(recesses.begin(), recesses.end(), [](const auto& a, const auto& b) {
    return a.center.x() < b.center.x();
  });
  for (std::size_t i = 0; i < 2; ++i) {
    expectDoor(recesses[i], doors[i], 1e-6);
    EXPECT_EQ(recesses[i].leaf, 6);
  }
}

TEST(Recesses, leafInPiecesIsOne)
{
  const Door door{-0.4};
  RectangleMap map = roomWith({door});
  RectangleMap parts;
  parts.add({-0.4, 1.2, 3.1}, {0.9, 0, 0}, {0, -1, 0});
  parts.add({-0.4, 0.1, 3.1}, {0.9, 0, 0}, {0, -1, 0});
  map.planes[6].polygons = {parts.planes[0].polygons[0], parts.planes[1].polygons[0]};
  const std::vector<RecessPatch> recesses = recessesOf(map.planes);
  ASSERT_EQ(recesses.size(), 1U);
  expectDoor(recesses[0], door, 1e-6);
}

TEST(Recesses, equalOnesShareTheirSize)
{
  Random random(7);
  const std::vector<RecessPatch> recesses =
      recessesOf(disturbed(roomWith({{-2.6}, {-0.4}, {1.5}}).planes, random, 1));
  ASSERT_EQ(recesses.size(), 3U);
  for (const RecessPatch& recess : recesses) {
    EXPECT_EQ(recess.template_id, 0);
    EXPECT_TRUE(recess.size.isApprox(recesses[0].size, 1e-12));
    EXPECT_TRUE(recess.size.isApprox(Eigen::Vector3d(0.9, 2.1, 0.1), 0.005));
  }
  EXPECT_GT(recesses[1].saved_bits, recesses[0].saved_bits + 20)
      << "a size that is known need not be told again";
}

TEST(Recesses, unequalOnesKeepTheirSizes)
{
  const std::vector<RecessPatch> recesses =
      recessesOf(roomWith({{-2.6, 0.9}, {-0.4, 0.85}, {1.5, 0.9, 2.1, 0.15}}).planes);
  ASSERT_EQ(recesses.size(), 3U);
  for (std::int32_t i = 0; i < 3; ++i)
    EXPECT_EQ(recesses[static_cast<std::size_t>(i)].template_id, i);
}

TEST(Recesses, widthAndHeightAreNotExchanged)
{
  const std::vector<RecessPatch> recesses =
      recessesOf(roomWith({{-2, 0.9, 1.4, 0.1, 0.5}, {0, 1.4, 0.9, 0.1, 0.5}}).planes);
  ASSERT_EQ(recesses.size(), 2U);
  EXPECT_NE(recesses[0].template_id, recesses[1].template_id);
}

TEST(Recesses, roomWithoutOpeningsHasNone)
{
  EXPECT_TRUE(recessesOf(roomWith({}).planes).empty());
}

TEST(Recesses, depthIsWithinThreeCentimetresAndHalfAMetre)
{
  for (const double depth : {-0.1, 0.02, 0.6})
    EXPECT_TRUE(recessesOf(roomWith({{-0.4, 0.9, 2.1, depth}}).planes).empty())
        << depth;
  for (const double depth : {0.04, 0.45})
    EXPECT_EQ(recessesOf(roomWith({{-0.4, 0.9, 2.1, depth}}).planes).size(), 1U)
        << depth;
}

TEST(Recesses, leafThatDoesNotCloseTheOpeningIsNone)
{
  RectangleMap map = roomWith({});
  cutOpening(map.planes[wall], {-1.5, 3});
  addLeaf(map, {-0.4}); // of a third of its width
  EXPECT_TRUE(recessesOf(map.planes).empty());
}

/** A wall of the next room, seen through a passage. */
TEST(Recesses, wallThatContinuesBehindThePassageIsNone)
{
  RectangleMap map = roomWith({});
  cutOpening(map.planes[wall], {-0.4});
  addLeaf(map, {-2, 4, 2.4, 0.4});
  EXPECT_TRUE(recessesOf(map.planes).empty());
}

TEST(Recesses, openingWithoutWallAtOneSideIsNone)
{
  const Door door{2.1}; // it ends at the corner of the room
  RectangleMap map = roomWith({});
  PlanePolygon& polygon = map.planes[wall].polygons[0];
  const auto top = static_cast<float>(room_most.y() - door.height);
  for (Eigen::Vector3f& point : polygon.outer)
    if (point.x() == 3.0F)
      point.x() = static_cast<float>(door.left);
  addLeaf(map, door);
  EXPECT_TRUE(recessesOf(map.planes).empty());
  // a lintel alone does not help
  RectangleMap lintel;
  lintel.add({door.left, top, 3}, {door.width, 0, 0}, {0, -0.6, 0});
  map.planes[wall].polygons.push_back(lintel.planes[0].polygons[0]);
  EXPECT_TRUE(recessesOf(map.planes).empty());
}

TEST(Recesses, openingThatIsNoRectangleIsNone)
{
  RectangleMap map = roomWith({{-0.4}});
  for (Eigen::Vector3f& point : map.planes[wall].polygons[0].outer)
    if (point == onWall(0.5, -0.9))
      point.x() = 0.9F; // the upper right corner
  EXPECT_TRUE(recessesOf(map.planes).empty());
}

/** Poses that drift give a wall twice: parts of it are some centimetres behind others. */
TEST(Recesses, doubledWallIsNone)
{
  RectangleMap whole = roomWith({});
  addLeaf(whole, {-3, 6, 2.7, 0.05});
  EXPECT_TRUE(recessesOf(whole.planes).empty());

  RectangleMap ragged = roomWith({});
  RectangleMap behind = roomWith({});
  std::vector<Eigen::Vector3f> hole;
  for (const Eigen::Vector2d& point : {Eigen::Vector2d(0, 0.5),
                                       Eigen::Vector2d(-0.3, -0.2),
                                       Eigen::Vector2d(0.4, -0.9),
                                       Eigen::Vector2d(1.5, -0.4),
                                       Eigen::Vector2d(1.1, 0.3)})
    hole.push_back(onWall(point.x(), point.y()));
  ragged.planes[wall].polygons[0].holes.push_back(hole);
  PlanePatch& plane = behind.planes[wall];
  plane.polygons[0].outer.assign(hole.rbegin(), hole.rend());
  for (Eigen::Vector3f& point : plane.polygons[0].outer)
    point.z() += 0.05F;
  plane.coefficients[3] += 0.05;
  plane.center.z() += 0.05;
  ragged.planes.push_back(plane);
  EXPECT_TRUE(recessesOf(ragged.planes).empty());
}

TEST(Recesses, leafOutOfParallelIsNone)
{
  RectangleMap map = roomWith({});
  cutOpening(map.planes[wall], {-0.4});
  map.add({-0.4, 1.2, 3.1}, {0.9, 0, 0.9 * std::tan(1.5 * M_PI / 180)}, {0, -2.1, 0});
  EXPECT_TRUE(recessesOf(map.planes).empty()) << "a door that stands ajar";
}

TEST(Recesses, furnishedRoomSeenInsideOutHasNone)
{
  RectangleMap map = roomWith({});
  cutOpening(map.planes[wall], {-0.4}); // the wall behind a cupboard was not seen
  map.addBox({-0.4, -0.9, 2.6}, {0.5, 1.2, 3}, "+x-x-y-z");
  EXPECT_TRUE(recessesOf(map.planes).empty());
  map.turnInsideOut();
  EXPECT_TRUE(recessesOf(map.planes).empty());
}

/** The error of the depth has the distribution that the covariance tells, which includes
 * a millimetre that a map does not know. */
TEST(Recesses, covarianceHolds)
{
  constexpr int runs = 300;
  Random random(3);
  const RectangleMap map = roomWith({{-0.45}});
  double sum = 0;
  for (int run = 0; run < runs; ++run) {
    std::vector<PlanePatch> truth = map.planes;
    for (PlanePatch& plane : truth)
      plane.covariance.diagonal().array() += 1e-6;
    std::vector<PlanePatch> measured = disturbed(truth, random, 1);
    for (std::size_t i = 0; i < measured.size(); ++i)
      measured[i].covariance = map.planes[i].covariance;
    const std::vector<RecessPatch> recesses = recessesOf(measured);
    ASSERT_EQ(recesses.size(), 1U) << run;
    const double error = recesses[0].size[2] - 0.1;
    sum += error * error / recesses[0].covariance(8, 8);
  }
  EXPECT_GT(sum / runs, 0.8);
  EXPECT_LT(sum / runs, 1.25);
}

TEST(Recesses, doNotDependOnTheFrameNorOnTheOrderOfThePlanes)
{
  Random random(5);
  const std::vector<PlanePatch> planes =
      disturbed(roomWith({{-2.4}, {0.3, 1, 2, 0.2}}).planes, random, 1);
  const std::vector<RecessPatch> recesses = recessesOf(planes);
  ASSERT_EQ(recesses.size(), 2U);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translate(Eigen::Vector3d(100, -30, 7));
  pose.rotate(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX()));
  pose.rotate(Eigen::AngleAxisd(1.1, Eigen::Vector3d::UnitY()));
  const std::vector<RecessPatch> moved = recessesOf(transformed(planes, pose));
  const std::vector<RecessPatch> others =
      recessesOf(std::vector<PlanePatch>(planes.rbegin(), planes.rend()));
  ASSERT_EQ(moved.size(), 2U);
  ASSERT_EQ(others.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT((moved[i].size - recesses[i].size).norm(), 1e-3);
    EXPECT_LT((moved[i].center - pose * recesses[i].center).norm(), 1e-3);
    EXPECT_LT((others[i].size - recesses[i].size).norm(), 1e-6);
    EXPECT_LT((others[i].center - recesses[i].center).norm(), 1e-6);
  }
}

TEST(Recesses, planesGivenTwiceAreOneRecess)
{
  const Door door{-0.4};
  std::vector<PlanePatch> planes = roomWith({door}).planes;
  const std::vector<PlanePatch> again = planes;
  planes.insert(planes.end(), again.begin(), again.end());
  const std::vector<RecessPatch> recesses = recessesOf(planes);
  ASSERT_EQ(recesses.size(), 1U);
  expectDoor(recesses[0], door, 1e-6);
}

TEST(Recesses, uglyPlanesAreSkippedAndCounted)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Door door{-0.4};
  std::vector<PlanePatch> planes = roomWith({door}).planes;
  PlanePatch ugly;
  planes.push_back(ugly); // a normal of length 0
  ugly.coefficients << 0, 1, 0, nan;
  planes.push_back(ugly);
  ugly = planes[6];
  ugly.polygons[0].outer.resize(2);
  planes.push_back(ugly);
  ugly.polygons[0].outer.assign(4, Eigen::Vector3f::Constant(NAN));
  planes.push_back(ugly);
  ugly.polygons.clear();
  planes.push_back(ugly);
  for (PlanePatch& plane : planes)
    plane.covariance.setConstant(nan); // as of planes with few points
  RecessFitting fitting;
  fitting.setPlanes(planes);
  std::vector<RecessPatch> recesses;
  fitting.segment(recesses);
  EXPECT_EQ(fitting.getReport().planes, planes.size());
  EXPECT_EQ(fitting.getReport().invalid_planes, 2U);
  ASSERT_EQ(recesses.size(), 1U);
  expectDoor(recesses[0], door, 1e-6);
  EXPECT_TRUE(recessesOf({}).empty());
}

TEST(Recesses, hugeCoordinatesAreLegal)
{
  const RectangleMap map = roomWith({{-0.4}});
  Eigen::Isometry3d far = Eigen::Isometry3d::Identity();
  for (const double distance : {1e5, 1e9, 1e30}) {
    far.translation() << distance, 0, distance;
    for (const RecessPatch& recess : recessesOf(transformed(map.planes, far)))
      EXPECT_TRUE(recess.center.allFinite() && recess.size.allFinite()) << distance;
  }
}

} // namespace
} // namespace pcl::acmap::test
