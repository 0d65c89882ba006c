#include "sample_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace pcl::acmap::test {

namespace {

PlanePatch
makePlane()
{
  PlanePatch plane;
  plane.coefficients = {1.0 / 3, -2.0 / 3, 2.0 / 3, 1e-17};
  plane.center = {0.1, 1e6 + 0.1, -1.0 / 7};
  plane.covariance << 1e-9, 2, 3, 4, 5, 6, 7, 8, 9;
  plane.covariance(0, 2) = std::numeric_limits<double>::quiet_NaN();
  plane.support = 12345678901u;
  plane.effective_support = 0.3;
  plane.rms = 0.0123;
  plane.area = 4.5;
  plane.polygons = {{{{0.1F, 0.2F, 1e-8F}, {1, 0, 0}, {16777216.0F, 3.3333333F, 0}},
                     {{{0.25F, 0.1F, 0}, {0, -0.0F, 0}, {1, 1, 1}}}},
                    {{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, {}}};
  plane.proposed = {{{{0.3F, 0, 0}, {1, 0, 0}, {1.0F / 3, 2, 0}},
                     {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}};
  return plane;
}

TextureChart
makeChart(std::size_t polygon, std::int32_t width, std::int32_t height)
{
  TextureChart chart;
  chart.polygon = polygon;
  chart.origin = {1.0 / 3, -1e-300, 5};
  chart.texel_u = {0.1, 0, 1.0 / 7};
  chart.texel_v = {0, 0.1, 0};
  chart.colors.width = width;
  chart.colors.height = height;
  chart.image = "texture " + std::to_string(polygon) + ".png";
  return chart;
}

CylinderPatch
makeCylinder(bool is_hollow)
{
  CylinderPatch cylinder;
  cylinder.axis_point = {1.0 / 3, 1e5 + 0.1, -7};
  cylinder.axis_direction = Eigen::Vector3d(1, 2, 2) / 3;
  cylinder.axis_u = Eigen::Vector3d(2, 1, -2) / 3;
  cylinder.axis_v = cylinder.axis_direction.cross(cylinder.axis_u);
  cylinder.radius = 1.0 / 7;
  cylinder.is_hollow = is_hollow;
  cylinder.low = -0.1;
  cylinder.high = 1.0 / 3;
  cylinder.arc = is_hollow ? 2 * M_PI : 1.0 / 3;
  cylinder.covariance.setConstant(std::numeric_limits<double>::quiet_NaN());
  if (is_hollow)
    cylinder.covariance = 1e-9 * Eigen::Matrix<double, 5, 5>::Identity();
  cylinder.support = 1234567;
  cylinder.rms = 0.0123;
  cylinder.area = 4.5;
  cylinder.template_id = is_hollow ? 0 : 1;
  cylinder.saved_bits = 1e5 / 3;
  return cylinder;
}

template <typename Matrix>
bool
sameBits(const Matrix& a, const Matrix& b)
{
  return std::memcmp(a.data(), b.data(), sizeof(a)) == 0;
}

void
expectSameLoop(const std::vector<Eigen::Vector3f>& loop,
               const std::vector<Eigen::Vector3f>& wanted)
{
  ASSERT_EQ(loop.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i)
    EXPECT_TRUE(sameBits(loop[i], wanted[i])) << i << ": " << wanted[i].transpose();
}

void
expectSamePolygons(const std::vector<PlanePolygon>& polygons,
                   const std::vector<PlanePolygon>& wanted)
{
  ASSERT_EQ(polygons.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    expectSameLoop(polygons[i].outer, wanted[i].outer);
    ASSERT_EQ(polygons[i].holes.size(), wanted[i].holes.size());
    for (std::size_t k = 0; k < wanted[i].holes.size(); ++k)
      expectSameLoop(polygons[i].holes[k], wanted[i].holes[k]);
  }
}

void
expectSamePlane(const PlanePatch& plane, const PlanePatch& wanted)
{
  expectSameLabel(plane.label, wanted.label);
  EXPECT_EQ(plane.pose_modes, wanted.pose_modes);
  EXPECT_TRUE(sameBits(plane.coefficients, wanted.coefficients));
  EXPECT_TRUE(sameBits(plane.center, wanted.center));
  EXPECT_TRUE(sameBits(plane.axis_u, wanted.axis_u));
  EXPECT_TRUE(sameBits(plane.axis_v, wanted.axis_v));
  EXPECT_TRUE(sameBits(plane.covariance, wanted.covariance));
  EXPECT_EQ(plane.support, wanted.support);
  EXPECT_EQ(plane.effective_support, wanted.effective_support);
  EXPECT_EQ(plane.rms, wanted.rms);
  EXPECT_EQ(plane.area, wanted.area);
  expectSamePolygons(plane.polygons, wanted.polygons);
  expectSamePolygons(plane.proposed, wanted.proposed);
}

BoxPatch
makeBox(std::int32_t template_id, double length)
{
  BoxPatch box;
  box.center = {1.0 / 3, 1e5 + 0.1, -7};
  box.axes.col(0) = Eigen::Vector3d(1, 2, 2) / 3;
  box.axes.col(1) = Eigen::Vector3d(2, 1, -2) / 3;
  box.axes.col(2) = box.axes.col(0).cross(box.axes.col(1));
  box.size = {length, 0.5, 1.0 / 7};
  box.faces = {{{BoxFaceKind::Seen, 1},
                {BoxFaceKind::Free, -1},
                {BoxFaceKind::Snapped, 0},
                {BoxFaceKind::Free, -1},
                {BoxFaceKind::Seen, 1},
                {BoxFaceKind::Seen, 0}}};
  box.covariance = 1e-6 / 3 * Eigen::Matrix<double, 9, 9>::Identity();
  box.template_id = template_id;
  box.saved_bits = 1e5 / 3;
  return box;
}

RecessPatch
makeRecess(std::int32_t template_id, double width)
{
  const BoxPatch box = makeBox(template_id, width);
  RecessPatch recess;
  recess.center = box.center / 3;
  recess.axes = box.axes;
  recess.size = {width, 2.1, 0.1};
  recess.wall = 1;
  recess.leaf = 0;
  recess.reaches_floor = template_id == 0;
  recess.covariance = box.covariance / 7;
  recess.template_id = template_id;
  recess.saved_bits = 100.0 / 3;
  return recess;
}

void
expectSameBox(const BoxPatch& box, const BoxPatch& wanted)
{
  EXPECT_TRUE(sameBits(box.center, wanted.center));
  EXPECT_TRUE(sameBits(box.axes, wanted.axes));
  EXPECT_TRUE(sameBits(box.size, wanted.size));
  EXPECT_TRUE(sameBits(box.slant, wanted.slant));
  EXPECT_TRUE(sameBits(box.covariance, wanted.covariance));
  for (std::size_t side = 0; side < box.faces.size(); ++side) {
    EXPECT_EQ(box.faces[side].kind, wanted.faces[side].kind);
    EXPECT_EQ(box.faces[side].plane, wanted.faces[side].plane);
  }
  EXPECT_EQ(box.template_id, wanted.template_id);
  EXPECT_EQ(box.saved_bits, wanted.saved_bits);
  EXPECT_EQ(box.name, wanted.name);
}

void
expectSameCylinder(const CylinderPatch& cylinder, const CylinderPatch& wanted)
{
  EXPECT_TRUE(sameBits(cylinder.axis_point, wanted.axis_point));
  EXPECT_TRUE(sameBits(cylinder.axis_direction, wanted.axis_direction));
  EXPECT_TRUE(sameBits(cylinder.axis_u, wanted.axis_u));
  EXPECT_TRUE(sameBits(cylinder.axis_v, wanted.axis_v));
  EXPECT_TRUE(sameBits(cylinder.covariance, wanted.covariance));
  EXPECT_EQ(cylinder.radius, wanted.radius);
  EXPECT_EQ(cylinder.is_hollow, wanted.is_hollow);
  EXPECT_EQ(cylinder.low, wanted.low);
  EXPECT_EQ(cylinder.high, wanted.high);
  EXPECT_EQ(cylinder.arc, wanted.arc);
  EXPECT_EQ(cylinder.support, wanted.support);
  EXPECT_EQ(cylinder.rms, wanted.rms);
  EXPECT_EQ(cylinder.area, wanted.area);
  EXPECT_EQ(cylinder.template_id, wanted.template_id);
  EXPECT_EQ(cylinder.saved_bits, wanted.saved_bits);
  expectSameLabel(cylinder.label, wanted.label);
}

/** Compares sizes and files, not the colours. */
void
expectSamePicture(const TexturePicture& picture, const TexturePicture& wanted)
{
  EXPECT_EQ(picture.image, wanted.image);
  EXPECT_EQ(picture.image_place, wanted.image_place);
  EXPECT_EQ(picture.halvings, wanted.halvings);
  EXPECT_EQ(picture.kinds_image, wanted.kinds_image);
  EXPECT_EQ(picture.kinds_place, wanted.kinds_place);
  EXPECT_EQ(picture.colors.width, wanted.colors.width);
  EXPECT_EQ(picture.colors.height, wanted.colors.height);
}

} // namespace

CompactMap
makeSampleMap()
{
  CompactMap map;
  map.planes = {makePlane(), PlanePatch()};
  map.planes[1].coefficients = {0, 1, 0, -0.5};
  map.cylinders = {makeCylinder(true), makeCylinder(false)};
  map.cylinder_pictures = {TexturePicture(), makeChart(0, 5, 3)};
  map.cylinder_pictures[1].image_place = {1, 2};
  map.cylinder_pictures[1].halvings = 1;
  map.cylinder_pictures[1].kinds_image = "kinds.png";
  map.boxes = {makeBox(0, 2), makeBox(1, 1), makeBox(0, 2)};
  map.boxes[1].faces[3] = {BoxFaceKind::Slanted, 1};
  map.boxes[1].slant << 1.0 / 3, -2.0 / 3, 2.0 / 3, 1e5 / 3;
  map.recesses = {makeRecess(0, 0.9), makeRecess(1, 0.8), makeRecess(0, 0.9)};
  map.charts = {makeChart(0, 3, 2), makeChart(1, 1, 4)};
  map.charts[1].image_place = {7, 9};
  map.charts[1].halvings = 2;
  map.charts[1].kinds_image = "kinds.png";
  map.charts[1].kinds_place = {0, 3};
  map.exposure = 7.0 / 3;
  map.up = Eigen::Vector3d(1, -7, 3).normalized();
  map.rooms = {{{0.1, -1e-17, 1e6 / 3}, 12.3, 1.0 / 7, {0, 1}, {0}}, {}};
  map.openings = {
      {{1.0 / 3, 2, 3}, {4, 5, 0.6}, 0.9, 2.1, OpeningKind::Window, {1, 0}, {0, 1}},
      {}};
  map.openings[1].planes[0] = 1;
  map.planes[0].label = {
      "Wall \"of\" room 2, \u00e4", SurfaceRole::Wall, {7.1, 1.0 / 3}};
  map.planes[1].label = {"Leaf", SurfaceRole::DoorLeaf};
  map.cylinders[0].label = {"Column", SurfaceRole::Other, {0.3, 2.7}};
  map.boxes[1].name = "Box";
  map.recesses[0].name = "Closed door";
  map.rooms[0].label = {"Room 1", SurfaceRole::Other, {1.0 / 7, 2}};
  map.openings[0].label = {"Window of room 1", SurfaceRole::Other, {1.2, 1}};
  map.planes[0].pose_modes = {{1.0 / 3, -1e-17, 2}, {0, 0.1, 0.2}};
  map.observations = {{0, 1}, {}};
  map.trajectory.stamps = {0.1, 1e9 + 1.0 / 3};
  Eigen::Isometry3d pose(Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()));
  pose.translation() = Eigen::Vector3d(0.1, -0.2, 1e5 / 3);
  map.trajectory.poses = {Eigen::Isometry3d::Identity(), pose};
  return map;
}

void
expectSameLabel(const SurfaceLabel& label, const SurfaceLabel& wanted)
{
  EXPECT_EQ(label.name, wanted.name);
  EXPECT_EQ(label.role, wanted.role);
  if (wanted.size.allFinite())
    EXPECT_EQ(label.size, wanted.size);
  else
    EXPECT_TRUE(label.size.hasNaN());
}

void
expectSamePlanes(const CompactMap& map, const CompactMap& wanted)
{
  ASSERT_EQ(map.planes.size(), wanted.planes.size());
  for (std::size_t i = 0; i < wanted.planes.size(); ++i)
    expectSamePlane(map.planes[i], wanted.planes[i]);
}

void
expectSameCylinders(const CompactMap& map, const CompactMap& wanted)
{
  ASSERT_EQ(map.cylinders.size(), wanted.cylinders.size());
  for (std::size_t i = 0; i < wanted.cylinders.size(); ++i)
    expectSameCylinder(map.cylinders[i], wanted.cylinders[i]);
  ASSERT_EQ(map.cylinder_pictures.size(), wanted.cylinder_pictures.size());
  for (std::size_t i = 0; i < wanted.cylinder_pictures.size(); ++i)
    expectSamePicture(map.cylinder_pictures[i], wanted.cylinder_pictures[i]);
}

void
expectSameBoxes(const CompactMap& map, const CompactMap& wanted)
{
  ASSERT_EQ(map.boxes.size(), wanted.boxes.size());
  for (std::size_t i = 0; i < wanted.boxes.size(); ++i)
    expectSameBox(map.boxes[i], wanted.boxes[i]);
}

void
expectSameRecesses(const CompactMap& map, const CompactMap& wanted)
{
  ASSERT_EQ(map.recesses.size(), wanted.recesses.size());
  for (std::size_t i = 0; i < wanted.recesses.size(); ++i) {
    const RecessPatch &one = map.recesses[i], &other = wanted.recesses[i];
    EXPECT_TRUE(sameBits(one.center, other.center));
    EXPECT_TRUE(sameBits(one.axes, other.axes));
    EXPECT_TRUE(sameBits(one.size, other.size));
    EXPECT_TRUE(sameBits(one.covariance, other.covariance));
    EXPECT_EQ(one.wall, other.wall);
    EXPECT_EQ(one.leaf, other.leaf);
    EXPECT_EQ(one.reaches_floor, other.reaches_floor);
    EXPECT_EQ(one.template_id, other.template_id);
    EXPECT_EQ(one.saved_bits, other.saved_bits);
    EXPECT_EQ(one.name, other.name);
  }
}

void
expectSameCharts(const CompactMap& map, const CompactMap& wanted, bool with_images)
{
  ASSERT_EQ(map.charts.size(), wanted.charts.size());
  for (std::size_t i = 0; i < wanted.charts.size(); ++i) {
    const TextureChart& chart = map.charts[i];
    const TextureChart& other = wanted.charts[i];
    EXPECT_EQ(chart.plane, other.plane);
    EXPECT_EQ(chart.polygon, other.polygon);
    EXPECT_TRUE(sameBits(chart.origin, other.origin));
    EXPECT_TRUE(sameBits(chart.texel_u, other.texel_u));
    EXPECT_TRUE(sameBits(chart.texel_v, other.texel_v));
    expectSamePicture(chart, other);
    if (with_images) {
      EXPECT_EQ(chart.colors.values, other.colors.values);
      EXPECT_EQ(chart.kinds, other.kinds);
    }
  }
}

} // namespace pcl::acmap::test
