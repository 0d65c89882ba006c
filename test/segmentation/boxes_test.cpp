#include "box_scenes.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/random.h>
#include <pcl/segmentation/box_fitting.h>

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl::acmap::test {
namespace {

const Eigen::Vector3d room_least(-3, -1.5, -3), room_most(3, 1.2, 3); // y is down

std::vector<BoxPatch>
boxesOf(const std::vector<PlanePatch>& planes)
{
  BoxFitting fitting;
  fitting.setPlanes(planes);
  std::vector<BoxPatch> boxes;
  fitting.segment(boxes);
  EXPECT_EQ(fitting.getReport().boxes, boxes.size());
  EXPECT_EQ(fitting.getReport().remarks.empty(), !boxes.empty());
  return boxes;
}

RectangleMap
emptyRoom()
{
  RectangleMap map;
  map.addRoom(room_least, room_most);
  return map;
}

/** The side of a box whose outward direction is nearest to a given one. */
std::size_t
sideTowards(const BoxPatch& box, const Eigen::Vector3d& direction)
{
  Eigen::Index axis = 0;
  const Eigen::Vector3d along = box.axes.transpose() * direction;
  along.cwiseAbs().maxCoeff(&axis);
  return static_cast<std::size_t>(2 * axis) + (along[axis] < 0 ? 1 : 0);
}

void
expectBox(const BoxPatch& box,
          const Eigen::Vector3d& least,
          const Eigen::Vector3d& most,
          double tolerance)
{
  Eigen::Vector3d half = Eigen::Vector3d::Zero();
  for (int axis = 0; axis < 3; ++axis)
    half += box.axes.col(axis).cwiseAbs() * box.size[axis] / 2;
  EXPECT_LT((box.center - (least + most) / 2).cwiseAbs().maxCoeff(), tolerance);
  EXPECT_LT((half - (most - least) / 2).cwiseAbs().maxCoeff(), tolerance);
  EXPECT_LT((box.axes.transpose() * box.axes - Eigen::Matrix3d::Identity())
                .cwiseAbs()
                .maxCoeff(),
            1e-9);
  EXPECT_GT(box.axes.determinant(), 0);
  EXPECT_GT(box.saved_bits, 0);
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(
                box.covariance.bottomRightCorner<3, 3>())
                .eigenvalues()
                .minCoeff(),
            0);
}

TEST(Boxes, crateStandsOnTheFloor)
{
  RectangleMap map = emptyRoom();
  const std::size_t room = map.planes.size();
  const Eigen::Vector3d least(-0.4, 0.7, 0.5), most(0.4, 1.2, 1.1);
  map.addBox(least, most, "+x-x-y+z-z");
  const std::vector<BoxPatch> boxes = boxesOf(map.planes);
  ASSERT_EQ(boxes.size(), 1U);
  expectBox(boxes[0], least, most, 1e-6);
  EXPECT_NEAR(boxes[0].size[0], 0.8, 1e-6);
  EXPECT_NEAR(boxes[0].size[2], 0.5, 1e-6) << "sizes fall";
  const BoxFace& bottom = boxes[0].faces[sideTowards(boxes[0], {0, 1, 0})];
  EXPECT_EQ(bottom.kind, BoxFaceKind::Snapped);
  EXPECT_EQ(map.planes[static_cast<std::size_t>(bottom.plane)].coefficients.y(), -1);
  for (const Eigen::Vector3d& direction : {Eigen::Vector3d(1, 0, 0),
                                           Eigen::Vector3d(0, -1, 0),
                                           Eigen::Vector3d(0, 0, -1)}) {
    const BoxFace& face = boxes[0].faces[sideTowards(boxes[0], direction)];
    EXPECT_EQ(face.kind, BoxFaceKind::Seen);
    ASSERT_GE(face.plane, static_cast<std::int32_t>(room));
    EXPECT_TRUE(map.planes[static_cast<std::size_t>(face.plane)]
                    .coefficients.head<3>()
                    .isApprox(direction));
  }
}

TEST(Boxes, cupboardLeansAgainstTheWallAndItsTopIsFree)
{
  RectangleMap map = emptyRoom();
  const Eigen::Vector3d least(1, -0.6, 2.6), most(1.9, 1.2, 3);
  map.addBox(least, most, "+x-x-z");
  const std::vector<BoxPatch> boxes = boxesOf(map.planes);
  ASSERT_EQ(boxes.size(), 1U);
  expectBox(boxes[0], least, most, 1e-6);
  const auto kindTowards = [&](double x, double y, double z) {
    return boxes[0].faces[sideTowards(boxes[0], {x, y, z})].kind;
  };
  EXPECT_EQ(kindTowards(0, 0, 1), BoxFaceKind::Snapped);
  EXPECT_EQ(kindTowards(0, 1, 0), BoxFaceKind::Snapped);
  EXPECT_EQ(kindTowards(0, -1, 0), BoxFaceKind::Free);
  EXPECT_GT(boxes[0].covariance(6, 6), boxes[0].covariance(8, 8))
      << "its height is known less than its depth";
}

/** The lower part of a desk is below the picture of a near camera. */
TEST(Boxes, deskReachesTheFloorAtOneCorner)
{
  RectangleMap map = emptyRoom();
  const Eigen::Vector3d least(-3, 0.5, 1), most(-2.2, 1.2, 2.6);
  map.addBox(least, most, "+x-y-z");
  for (PlanePatch& plane : map.planes)
    for (Eigen::Vector3f& point : plane.polygons[0].outer) {
      if (plane.coefficients.x() == 1 && point.x() > -2.5F && point.z() == 1.0F &&
          point.y() > 1)
        point.y() = 0.7F; // a corner of the face +x
      if (plane.coefficients.z() == -1 && point.z() == 1.0F && point.y() > 1)
        point.y() = 0.8F; // the lower edge of the face -z
    }
  const std::vector<BoxPatch> boxes = boxesOf(map.planes);
  ASSERT_EQ(boxes.size(), 1U);
  expectBox(boxes[0], least, most, 1e-6);
}

TEST(Boxes, deskThatPicturesCutEverywhereIsNone)
{
  RectangleMap map = emptyRoom();
  map.addBox({-3, 0.5, 1}, {-2.2, 1.2, 2.6}, "+x-y-z");
  for (PlanePatch& plane : map.planes)
    for (Eigen::Vector3f& point : plane.polygons[0].outer)
      if (point.z() >= 1 && point.z() < 2.7F && point.x() < -2.1F &&
          point.y() == 1.2F && std::abs(plane.coefficients.y()) < 0.5 &&
          point.x() > -3.1F &&
          (plane.coefficients.x() == 1 || plane.coefficients.z() == -1))
        point.y() = point.z() == 1.0F && point.x() > -2.3F ? 0.65F : 1;
  EXPECT_TRUE(boxesOf(map.planes).empty());
}

TEST(Boxes, oneWhoseTopIsInThePlaneOfAnotherOneIsApart)
{
  RectangleMap map = emptyRoom();
  map.addBox({-2, 0.7, 0}, {-1.4, 1.2, 0.5}, "+x-x-y+z-z");
  map.addBox({0, 0.7, 0}, {0.9, 1.2, 0.5}, "+x-x+z-z");
  const auto top = std::find_if(
      map.planes.begin() + 6, map.planes.end(), [](const PlanePatch& plane) {
        return plane.coefficients.y() == -1;
      });
  RectangleMap other;
  other.addBox({0, 0.7, 0}, {0.9, 1.2, 0.5}, "-y");
  top->polygons.push_back(other.planes[0].polygons[0]);
  top->center.x() = -0.5;
  const std::vector<BoxPatch> boxes = boxesOf(map.planes);
  ASSERT_EQ(boxes.size(), 2U);
  EXPECT_NEAR(boxes[0].size.prod(), 0.9 * 0.5 * 0.5, 0.001);
  EXPECT_NEAR(boxes[1].size.prod(), 0.6 * 0.5 * 0.5, 0.001);
  EXPECT_NE(boxes[0].template_id, boxes[1].template_id);
}

TEST(Boxes, roomIsNone)
{
  EXPECT_TRUE(boxesOf(emptyRoom().planes).empty());
}

TEST(Boxes, furnishedRoomSeenInsideOutIsNone)
{
  RectangleMap map = emptyRoom();
  map.addBox({-0.4, 0.7, 0.5}, {0.4, 1.2, 1.1}, "+x-x-y+z-z");
  map.turnInsideOut();
  EXPECT_TRUE(boxesOf(map.planes).empty());
}

TEST(Boxes, twoFacesInTheAirAreNone)
{
  RectangleMap map;
  map.addBox({0, 0, 0}, {1, 1, 1}, "+x-y");
  EXPECT_TRUE(boxesOf(map.planes).empty());
  map.addBox({0, 0, 0}, {1, 1, 1}, "+z");
  EXPECT_TRUE(boxesOf(map.planes).empty()) << "three sides are known of four";
  map.addBox({0, 0, 0}, {1, 1, 1}, "-x");
  EXPECT_EQ(boxesOf(map.planes).size(), 1U);
}

TEST(Boxes, facesOutOfSquareAreNone)
{
  RectangleMap map = emptyRoom();
  map.add({0, 1.2, 0}, {0, -0.6, 0}, {0, 0, 0.8}); // -x
  const double lean = 0.6 * std::tan(8 * M_PI / 180);
  map.add({0, 0.6, 0}, {0.7, lean, 0}, {0, 0, 0.8}); // a top that slopes by 9 degrees
  EXPECT_TRUE(boxesOf(map.planes).empty());
}

/** Adds a convex polygon, clockwise as it is seen. */
void
addPolygon(RectangleMap& map, std::vector<Eigen::Vector3d> corners)
{
  std::reverse(corners.begin(), corners.end());
  const Eigen::Vector3d u = corners[1] - corners[0], across = corners[2] - corners[0];
  map.add(corners[0], u, across - across.dot(u) / u.squaredNorm() * u);
  std::vector<Eigen::Vector3f>& outer = map.planes.back().polygons[0].outer;
  outer.clear();
  for (const Eigen::Vector3d& corner : corners)
    outer.push_back(corner.cast<float>());
}

/** A desk against the wall z = 3, whose top falls towards the room by 20 cm. */
struct SlantedDesk {
  double left = -0.5, right = 0.4, front = 2.4, floor = 1.2, low = 0.5, high = 0.3;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();

  void
  addTo(RectangleMap& map) const
  {
    const auto add = [&](std::vector<Eigen::Vector3d> corners) {
      for (Eigen::Vector3d& corner : corners)
        corner = pose * corner;
      addPolygon(map, corners);
    };
    add({{left, floor, front},
         {left, low, front},
         {right, low, front},
         {right, floor, front}});
    add({{left, floor, 3}, {left, high, 3}, {left, low, front}, {left, floor, front}});
    add({{right, floor, 3},
         {right, floor, front},
         {right, low, front},
         {right, high, 3}});
    add({{left, low, front}, {left, high, 3}, {right, high, 3}, {right, low, front}});
  }

  /** Towards the room and upwards. */
  Eigen::Vector3d
  slope() const
  {
    return pose.linear() * Eigen::Vector3d(0, front - 3, high - low).normalized();
  }
};

TEST(Boxes, deskWithASlantedTop)
{
  RectangleMap map = emptyRoom();
  const SlantedDesk desk;
  desk.addTo(map);
  const std::vector<BoxPatch> boxes = boxesOf(map.planes);
  ASSERT_EQ(boxes.size(), 1U);
  expectBox(
      boxes[0], {desk.left, desk.high, desk.front}, {desk.right, desk.floor, 3}, 1e-6);
  const BoxFace& top = boxes[0].faces[sideTowards(boxes[0], {0, -1, 0})];
  EXPECT_EQ(top.kind, BoxFaceKind::Slanted);
  EXPECT_EQ(top.plane, static_cast<std::int32_t>(map.planes.size()) - 1);
  EXPECT_TRUE(boxes[0].slant.isApprox(map.planes.back().coefficients, 1e-12));
  EXPECT_LT((boxes[0].slant.head<3>() - desk.slope()).norm(), 1e-6);
  EXPECT_EQ(boxes[0].faces[sideTowards(boxes[0], {0, 0, 1})].kind,
            BoxFaceKind::Snapped);
}

/** A pedestal of which one side leans, by 18 degrees. */
TEST(Boxes, pedestalWithATaperedSide)
{
  RectangleMap map = emptyRoom();
  const double floor = 1.2, top = 0.3;
  addPolygon(map,
             {{-0.3, floor, 0}, {-0.3, top, 0.3}, {0.3, top, 0.3}, {0.3, floor, 0}});
  addPolygon(
      map, {{-0.3, floor, 0.8}, {-0.3, top, 0.8}, {-0.3, top, 0.3}, {-0.3, floor, 0}});
  addPolygon(map,
             {{0.3, floor, 0}, {0.3, top, 0.3}, {0.3, top, 0.8}, {0.3, floor, 0.8}});
  addPolygon(map,
             {{-0.3, top, 0.3}, {-0.3, top, 0.8}, {0.3, top, 0.8}, {0.3, top, 0.3}});
  const std::vector<BoxPatch> boxes = boxesOf(map.planes);
  ASSERT_EQ(boxes.size(), 1U);
  expectBox(boxes[0], {-0.3, top, 0}, {0.3, floor, 0.8}, 1e-6);
  EXPECT_EQ(boxes[0].faces[sideTowards(boxes[0], {0, 0, -1})].kind,
            BoxFaceKind::Slanted);
  EXPECT_EQ(boxes[0].faces[sideTowards(boxes[0], {0, 0, 1})].kind, BoxFaceKind::Free);
}

TEST(Boxes, saddleRoofIsNoSlantedSide)
{
  RectangleMap map = emptyRoom();
  const double left = -0.5, right = 0.5, front = 0, back = 1, floor = 1.2, eaves = 0.6,
               ridge = 0.2;
  addPolygon(map,
             {{left, floor, front},
              {left, eaves, front},
              {right, eaves, front},
              {right, floor, front}});
  addPolygon(map,
             {{right, floor, back},
              {right, eaves, back},
              {left, eaves, back},
              {left, floor, back}});
  addPolygon(map,
             {{left, floor, back},
              {left, eaves, back},
              {left, ridge, 0.5},
              {left, eaves, front},
              {left, floor, front}});
  addPolygon(map,
             {{right, floor, front},
              {right, eaves, front},
              {right, ridge, 0.5},
              {right, eaves, back},
              {right, floor, back}});
  addPolygon(map,
             {{left, eaves, front},
              {left, ridge, 0.5},
              {right, ridge, 0.5},
              {right, eaves, front}});
  addPolygon(map,
             {{left, ridge, 0.5},
              {left, eaves, back},
              {right, eaves, back},
              {right, ridge, 0.5}});
  EXPECT_TRUE(boxesOf(map.planes).empty());
}

TEST(Boxes, equalSlantedOnesShareTheirSize)
{
  Random random(11);
  RectangleMap map = emptyRoom();
  SlantedDesk desk;
  desk.addTo(map);
  desk.pose.rotate(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitY()));
  desk.addTo(map); // at the wall x = 3
  SlantedDesk flatter;
  flatter.left = 1.2;
  flatter.right = 2.1;
  flatter.low = 0.4;
  flatter.addTo(map);
  const std::vector<BoxPatch> boxes = boxesOf(disturbed(map.planes, random, 1));
  ASSERT_EQ(boxes.size(), 3U);
  std::vector<BoxPatch> equal;
  std::int32_t of_flatter = -1;
  for (const BoxPatch& box : boxes)
    if (box.slant.y() < -0.97) // 14 degrees
      of_flatter = box.template_id;
    else
      equal.push_back(box);
  ASSERT_EQ(equal.size(), 2U);
  EXPECT_EQ(equal[0].template_id, equal[1].template_id);
  EXPECT_TRUE(equal[0].size.isApprox(equal[1].size, 1e-12));
  EXPECT_NE(of_flatter, equal[0].template_id) << "its size is equal, but not its side";
}

TEST(Boxes, pillarIsOneAndTheCornerOfACorridorIsNone)
{
  RectangleMap pillar = emptyRoom();
  pillar.addBox({0, -1.5, 0}, {0.4, 1.2, 0.5}, "+x-x+z-z");
  const std::vector<BoxPatch> boxes = boxesOf(pillar.planes);
  ASSERT_EQ(boxes.size(), 1U);
  expectBox(boxes[0], {0, -1.5, 0}, {0.4, 1.2, 0.5}, 1e-6);

  RectangleMap pilaster = emptyRoom();
  pilaster.addBox({0, -1.5, 2.8}, {0.4, 1.2, 3}, "+x-x-z");
  EXPECT_EQ(boxesOf(pilaster.planes).size(), 1U);

  // the block inside of the angle, up to the walls at the ends of both arms
  RectangleMap whole = emptyRoom();
  whole.addBox({-1, -1.5, -1}, {3, 1.2, 3}, "-x-z");
  EXPECT_TRUE(boxesOf(whole.planes).empty());
  // as far as it was seen
  RectangleMap part = emptyRoom();
  part.addBox({-1, -1.5, -1}, {1.5, 1.2, 1}, "-x-z");
  EXPECT_TRUE(boxesOf(part.planes).empty());
  // a block around which a corridor leads
  RectangleMap block = emptyRoom();
  block.addBox({-2, -1.5, -2}, {2, 1.2, 2}, "+x-x+z-z");
  EXPECT_TRUE(boxesOf(block.planes).empty());
}

/** Between two doors that are set back the wall has two reveals. */
TEST(Boxes, wallBetweenDoorsIsNone)
{
  RectangleMap map;
  map.add({-3, 1.2, -2}, {6, 0, 0}, {0, 0, 5}); // floor
  PlanePatch wall;
  {
    RectangleMap one;
    one.add({-3, 1.2, 3}, {6, 0, 0}, {0, -2.7, 0});
    wall = one.planes[0];
  }
  const std::vector<std::pair<float, float>> outline{{-3, 1.2F},
                                                     {-1.5F, 1.2F},
                                                     {-1.5F, -0.9F},
                                                     {-0.6F, -0.9F},
                                                     {-0.6F, 1.2F},
                                                     {0.6F, 1.2F},
                                                     {0.6F, -0.9F},
                                                     {1.5F, -0.9F},
                                                     {1.5F, 1.2F},
                                                     {3, 1.2F},
                                                     {3, -1.5F},
                                                     {-3, -1.5F}};
  wall.polygons[0].outer.clear();
  for (const auto& [x, y] : outline)
    wall.polygons[0].outer.emplace_back(x, y, 3);
  map.planes.push_back(wall);
  for (const double left : {-1.5, 0.6}) {
    map.add({left, 1.2, 3.1}, {0.9, 0, 0}, {0, -2.1, 0});     // the door
    map.add({left, 1.2, 3}, {0, 0, 0.1}, {0, -2.1, 0});       // faces +x
    map.add({left + 0.9, 1.2, 3}, {0, -2.1, 0}, {0, 0, 0.1}); // faces -x
    map.add({left, -0.9, 3}, {0.9, 0, 0}, {0, 0, 0.1});       // its head
  }
  EXPECT_TRUE(boxesOf(map.planes).empty());
}

RectangleMap
twoCrates(const Eigen::Vector3d& second_size)
{
  RectangleMap map = emptyRoom();
  map.addBox({-0.4, 0.7, 0.5}, {0.4, 1.2, 1.1}, "+x-x-y+z-z");
  const Eigen::Vector3d corner(1.2, 1.2 - second_size.y(), -2);
  map.addBox(corner, corner + second_size, "+x-x-y+z-z");
  return map;
}

TEST(Boxes, equalOnesShareTheirSize)
{
  Random random(7);
  const RectangleMap map = twoCrates({0.6, 0.5, 0.8}); // the same, turned
  const std::vector<BoxPatch> boxes = boxesOf(disturbed(map.planes, random, 1));
  ASSERT_EQ(boxes.size(), 2U);
  EXPECT_EQ(boxes[0].template_id, 0);
  EXPECT_EQ(boxes[1].template_id, 0);
  EXPECT_TRUE(boxes[0].size.isApprox(boxes[1].size, 1e-12));
  EXPECT_TRUE(boxes[0].size.isApprox(Eigen::Vector3d(0.8, 0.6, 0.5), 0.005));
  EXPECT_NEAR(boxes[0].center.x() + boxes[1].center.x(), 0 + 1.5, 0.003);
  EXPECT_GT(
      boxes[1].saved_bits,
      boxesOf(disturbed(twoCrates({0.6, 0.5, 0.9}).planes, random, 1))[1].saved_bits)
      << "a size that is known need not be told again";
}

TEST(Boxes, unequalOnesKeepTheirSizes)
{
  const std::vector<BoxPatch> boxes = boxesOf(twoCrates({0.6, 0.5, 0.85}).planes);
  ASSERT_EQ(boxes.size(), 2U);
  EXPECT_NE(boxes[0].template_id, boxes[1].template_id);
  EXPECT_NEAR(boxes[0].size[0], 0.85, 1e-6);
  EXPECT_NEAR(boxes[1].size[0], 0.8, 1e-6);
}

/** Errors of center and size have the distribution that the covariance tells, which
 * includes a millimetre and a milliradian that a map does not know. */
TEST(Boxes, covarianceHolds)
{
  constexpr int runs = 300;
  Random random(3);
  RectangleMap map = emptyRoom();
  const Eigen::Vector3d least(-0.4, 0.7, 0.5), most(0.4, 1.2, 1.1);
  map.addBox(least, most, "+x-x-y+z-z");
  double sum = 0;
  for (int run = 0; run < runs; ++run) {
    std::vector<PlanePatch> truth = map.planes;
    for (PlanePatch& plane : truth)
      plane.covariance.diagonal().array() += 1e-6;
    std::vector<PlanePatch> measured = disturbed(truth, random, 1);
    for (std::size_t i = 0; i < measured.size(); ++i)
      measured[i].covariance = map.planes[i].covariance;
    const std::vector<BoxPatch> boxes = boxesOf(measured);
    ASSERT_EQ(boxes.size(), 1U) << run;
    Eigen::Vector2d error; // along x and z, where both sides were seen
    Eigen::Matrix2d covariance;
    error << boxes[0].size[0] - 0.8, boxes[0].size[1] - 0.6;
    covariance = boxes[0].covariance.block<2, 2>(6, 6);
    sum += error.dot(covariance.inverse() * error) / 2;
  }
  EXPECT_GT(sum / runs, 0.8);
  EXPECT_LT(sum / runs, 1.25);
}

TEST(Boxes, doNotDependOnTheFrameNorOnTheOrderOfThePlanes)
{
  Random random(5);
  RectangleMap map = twoCrates({0.6, 0.5, 0.9});
  map.planes = disturbed(map.planes, random, 1);
  const std::vector<BoxPatch> boxes = boxesOf(map.planes);
  ASSERT_EQ(boxes.size(), 2U);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translate(Eigen::Vector3d(100, -30, 7));
  pose.rotate(Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -0.5).normalized()));
  const std::vector<BoxPatch> moved = boxesOf(transformed(map.planes, pose));
  std::vector<PlanePatch> reversed(map.planes.rbegin(), map.planes.rend());
  const std::vector<BoxPatch> others = boxesOf(reversed);
  ASSERT_EQ(moved.size(), 2U);
  ASSERT_EQ(others.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT((moved[i].size - boxes[i].size).norm(), 1e-3);
    EXPECT_LT((moved[i].center - pose * boxes[i].center).norm(), 1e-3);
    EXPECT_LT((others[i].size - boxes[i].size).norm(), 1e-6);
    EXPECT_LT((others[i].center - boxes[i].center).norm(), 1e-6);
  }
}

TEST(Boxes, uglyPlanesAreSkippedAndCounted)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  RectangleMap map = emptyRoom();
  map.addBox({-0.4, 0.7, 0.5}, {0.4, 1.2, 1.1}, "+x-x-y+z-z");
  std::vector<PlanePatch> planes = map.planes;
  PlanePatch ugly;
  planes.push_back(ugly); // a normal of length 0
  ugly.coefficients << 0, 1, 0, nan;
  planes.push_back(ugly);
  ugly = map.planes[7];
  ugly.polygons[0].outer.resize(2);
  planes.push_back(ugly);
  ugly.polygons[0].outer.assign(4, Eigen::Vector3f::Constant(NAN));
  planes.push_back(ugly);
  ugly.polygons.clear();
  planes.push_back(ugly);
  for (PlanePatch& plane : planes)
    plane.covariance.setConstant(nan); // as of planes with few points
  BoxFitting fitting;
  fitting.setPlanes(planes);
  std::vector<BoxPatch> boxes;
  fitting.segment(boxes);
  EXPECT_EQ(fitting.getReport().planes, planes.size());
  EXPECT_EQ(fitting.getReport().invalid_planes, 2U);
  ASSERT_EQ(boxes.size(), 1U);
  expectBox(boxes[0], {-0.4, 0.7, 0.5}, {0.4, 1.2, 1.1}, 1e-6);
  EXPECT_TRUE(boxes[0].covariance.allFinite());
}

TEST(Boxes, hugeCoordinatesAreLegal)
{
  RectangleMap map = emptyRoom();
  map.addBox({-0.4, 0.7, 0.5}, {0.4, 1.2, 1.1}, "+x-x-y+z-z");
  Eigen::Isometry3d far = Eigen::Isometry3d::Identity();
  for (const double distance : {1e5, 1e9, 1e30}) {
    far.translation() << distance, 0, distance;
    for (const BoxPatch& box : boxesOf(transformed(map.planes, far)))
      EXPECT_TRUE(box.center.allFinite() && box.size.allFinite()) << distance;
  }
}

} // namespace
} // namespace pcl::acmap::test
