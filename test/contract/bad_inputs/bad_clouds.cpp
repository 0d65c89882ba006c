#include "bad_clouds.h"

#include <pcl/core/random.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                infinity = std::numeric_limits<float>::infinity();

using Change = std::function<void(Cloud&)>;

void
resize(Cloud& cloud, std::size_t points)
{
  cloud.points.resize(points);
  cloud.width = static_cast<std::uint32_t>(points);
  cloud.height = 1;
}

Change
every(std::size_t step, float x, float y, float z)
{
  return [=](Cloud& cloud) {
    for (std::size_t i = 0; i < cloud.size(); i += step)
      cloud.points[i].getVector3fMap() = Eigen::Vector3f(x, y, z);
    cloud.is_dense = false;
  };
}

Change
scaled(float x, float y, float z)
{
  return [=](Cloud& cloud) {
    for (PointXYZ& point : cloud.points)
      point.getVector3fMap() =
          point.getVector3fMap().cwiseProduct(Eigen::Vector3f(x, y, z));
  };
}

Change
shifted(float offset)
{
  return [=](Cloud& cloud) {
    for (PointXYZ& point : cloud.points)
      point.getVector3fMap().array() += offset;
  };
}

Change
only(std::size_t points)
{
  return [=](Cloud& cloud) { resize(cloud, points); };
}

Change
claimed(std::uint32_t width, std::uint32_t height)
{
  return [=](Cloud& cloud) {
    cloud.width = width;
    cloud.height = height;
  };
}

struct CloudChange {
  std::string name;
  Answer answer;
  Change change;
};

std::vector<CloudChange>
cloudChanges()
{
  constexpr float largest = std::numeric_limits<float>::max();
  constexpr std::uint32_t all_bits = std::numeric_limits<std::uint32_t>::max();
  return {
      {"as it is", Answer::Any, [](Cloud&) {}},
      {"without points", Answer::Told, only(0)},
      {"of one point", Answer::Any, only(1)},
      {"of two points", Answer::Any, only(2)},
      {"of three points", Answer::Any, only(3)},
      {"of NaN", Answer::Told, every(1, nan, nan, nan)},
      {"half of NaN", Answer::Told, every(2, nan, nan, nan)},
      {"half of NaN in x", Answer::Told, every(2, nan, 0, 1)},
      {"of infinities", Answer::Told, every(1, infinity, infinity, infinity)},
      {"half of infinities", Answer::Told, every(2, 0, 0, -infinity)},
      {"with some NaN", Answer::Told, every(10, nan, nan, nan)},
      {"NaN that claims to be dense",
       Answer::Told,
       [](Cloud& cloud) {
         every(2, nan, nan, nan)(cloud);
         cloud.is_dense = true;
       }},
      {"doubled", Answer::Any, [](Cloud& cloud) { cloud = doubled(cloud); }},
      {"in one place", Answer::Any, every(1, 1, 2, 3)},
      {"at the sensor", Answer::Any, every(1, 0, 0, 0)},
      {"on a line", Answer::Any, scaled(1, 0, 0)},
      {"on the axis", Answer::Any, scaled(0, 0, 1)},
      {"on a plane through the sensor", Answer::Any, scaled(1, 0, 1)},
      {"on an exact plane",
       Answer::Any,
       [](Cloud& cloud) {
         for (PointXYZ& point : cloud.points)
           point.z = 2;
       }},
      {"in disorder",
       Answer::Any,
       [](Cloud& cloud) {
         const std::uint32_t width = cloud.width, height = cloud.height;
         cloud = permuted(cloud, 1);
         claimed(width, height)(cloud);
       }},
      {"behind the sensor", Answer::Any, scaled(1, 1, -1)},
      {"of 1e9 m", Answer::Any, scaled(1e9F, 1e9F, 1e9F)},
      {"of 1e30 m", Answer::Any, scaled(1e30F, 1e30F, 1e30F)},
      {"of the largest numbers", Answer::Any, every(1, largest, -largest, largest)},
      {"of 1e-30 m", Answer::Any, scaled(1e-30F, 1e-30F, 1e-30F)},
      {"of subnormal numbers", Answer::Any, scaled(1e-40F, 1e-40F, 1e-40F)},
      {"at 1e6 m", Answer::Any, shifted(1e6F)},
      {"at 1e9 m", Answer::Any, shifted(1e9F)},
      {"with a point at 1e9 m", Answer::Any, every(100000, 1e9F, 1e9F, 1e9F)},
      {"with a point at 1e30 m", Answer::Any, every(100000, 1e30F, 0, 1e30F)},
      {"of 0 x 0 that has points", Answer::Any, claimed(0, 0)},
      {"that claims a row more", Answer::Refused, [](Cloud& cloud) { ++cloud.height; }},
      {"that claims a point less",
       Answer::Refused,
       [](Cloud& cloud) { --cloud.width; }},
      {"that claims no column", Answer::Refused, claimed(0, 5)},
      {"that claims 2^16 x 2^16", Answer::Refused, claimed(1U << 16U, 1U << 16U)},
      {"that claims all", Answer::Refused, claimed(all_bits, all_bits)},
      {"whose sensor is at NaN",
       Answer::Any,
       [](Cloud& cloud) { cloud.sensor_origin_.setConstant(nan); }},
      {"whose sensor is at 1e30 m",
       Answer::Any,
       [](Cloud& cloud) { cloud.sensor_origin_.setConstant(1e30F); }},
      {"whose sensor has no direction", Answer::Any, [](Cloud& cloud) {
         cloud.sensor_orientation_.coeffs().setZero();
       }}};
}

} // namespace

const Cloud&
goodView()
{
  static const Cloud view = [] {
    Random random(1);
    Cloud cloud(64, 48);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const double u = (static_cast<double>(i % 64) - 31.5) / 52,
                   v = (static_cast<double>(i / 64) - 23.5) / 52;
      const double depth = 2 / (1 + std::abs(u)) + random.uniform(-1e-3, 1e-3);
      cloud.points[i] = toPoint(depth * Eigen::Vector3d(u, v, 1));
    }
    return cloud;
  }();
  return view;
}

const Cloud&
goodRoom()
{
  static const Cloud room = makeRoom(0.2, 0.1, 3);
  return room;
}

const Kinds<Cloud::Ptr>&
badClouds()
{
  static const Kinds<Cloud::Ptr> kinds = [] {
    Kinds<Cloud::Ptr> made{{"null pointer", Answer::Refused, [] { return nullptr; }}};
    for (const bool is_view : {true, false})
      for (const CloudChange& change : cloudChanges())
        made.push_back(
            {(is_view ? "view " : "room ") + change.name, change.answer, [=] {
               const Cloud::Ptr cloud =
                   (is_view ? goodView() : goodRoom()).makeShared();
               change.change(*cloud);
               return cloud;
             }});
    return made;
  }();
  return kinds;
}

Kinds<IndicesPtr>
badIndices(std::size_t points)
{
  const auto last = static_cast<index_t>(points - 1);
  const auto of = [](const Indices& indices) {
    return [=] { return std::make_shared<Indices>(indices); };
  };
  const auto many = [=](index_t step) {
    return [=] {
      const auto indices = std::make_shared<Indices>();
      for (index_t i = 0; i <= last; ++i)
        indices->push_back(i / step * step);
      return indices;
    };
  };
  return {{"null pointer", Answer::Any, [] { return nullptr; }},
          {"none", Answer::Told, of({})},
          {"one", Answer::Any, of({last})},
          {"all", Answer::Any, many(1)},
          {"each twice", Answer::Any, many(2)},
          {"of one point", Answer::Any, many(last + 1)},
          {"outside", Answer::Refused, of({0, last + 1})},
          {"far outside", Answer::Refused, of({std::numeric_limits<index_t>::max()})},
          {"negative", Answer::Refused, of({0, 1, -1})},
          {"the most negative",
           Answer::Refused,
           of({std::numeric_limits<index_t>::min()})}};
}

Kinds<Eigen::Matrix4d>
badPoses()
{
  const auto at = [](int row, int column, double value) {
    return [=] {
      Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
      pose(row, column) = value;
      return pose;
    };
  };
  const auto times = [](double factor) {
    return [=] {
      Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
      pose.topLeftCorner<3, 3>() *= factor;
      return pose;
    };
  };
  return {{"of identity", Answer::Any, at(0, 0, 1)},
          {"of NaN in the rotation", Answer::Refused, at(0, 1, nan)},
          {"of NaN in the translation", Answer::Refused, at(2, 3, nan)},
          {"of infinity", Answer::Refused, at(2, 3, infinity)},
          {"mirrored", Answer::Refused, at(0, 0, -1)},
          {"inverted", Answer::Refused, times(-1)},
          {"scaled by 2", Answer::Refused, times(2)},
          {"scaled by 0", Answer::Refused, times(0)},
          {"sheared", Answer::Refused, at(0, 1, 0.5)},
          {"with a perspective", Answer::Refused, at(3, 0, 0.1)},
          {"with a weight of 2", Answer::Refused, at(3, 3, 2)},
          {"rounded", Answer::Any, at(0, 1, 1e-5)},
          {"at 1e9 m", Answer::Any, at(0, 3, 1e9)},
          {"at 1e10 m", Answer::Refused, at(0, 3, 1e10)},
          {"at 1e300 m", Answer::Refused, at(0, 3, 1e300)}};
}

Kinds<PointCloud<Normal>::Ptr>
badNormals(std::size_t points)
{
  const auto of = [](std::size_t size, float x, float z) {
    return [=] {
      const PointCloud<Normal>::Ptr normals(new PointCloud<Normal>);
      normals->resize(size, Normal(x, 0, z));
      return normals;
    };
  };
  return {{"null pointer", Answer::Any, [] { return nullptr; }},
          {"of equal direction", Answer::Any, of(points, 0, -1)},
          {"of NaN", Answer::Told, of(points, nan, nan)},
          {"of NaN in x", Answer::Told, of(points, nan, 1)},
          {"of infinity", Answer::Told, of(points, infinity, 0)},
          {"of zero", Answer::Told, of(points, 0, 0)},
          {"of length 1e30", Answer::Any, of(points, 1e30F, 0)},
          {"of length 1e-30", Answer::Any, of(points, 0, 1e-30F)},
          {"that are none", Answer::Refused, of(0, 0, 1)},
          {"one less", Answer::Refused, of(points - 1, 0, 1)},
          {"one more", Answer::Refused, of(points + 1, 0, 1)}};
}

Kinds<TriangleMesh>
badMeshes(std::size_t points)
{
  const auto of = [](const TriangleMesh::Triangles& triangles) {
    return [=] {
      TriangleMesh mesh;
      mesh.triangles = triangles;
      return mesh;
    };
  };
  using Corner = TriangleMesh::Triangle::value_type;
  const auto n = static_cast<Corner>(points);
  return {
      {"without triangles", Answer::Any, of({})},
      {"of one triangle", Answer::Any, of({{0, 1, 64}})},
      {"of a corner outside", Answer::Refused, of({{0, 1, n}})},
      {"of a corner far outside",
       Answer::Refused,
       of({{0, 1, std::numeric_limits<Corner>::max()}})},
      {"of a negative corner", Answer::Refused, of({{0, 1, static_cast<Corner>(-1)}})},
      {"of the most negative corner",
       Answer::Refused,
       of({{std::numeric_limits<Corner>::min(), 1, n}})},
      {"of one corner", Answer::Any, of({{5, 5, 5}, {6, 6, 7}})},
      {"twice the same", Answer::Any, of({{0, 1, 64}, {0, 1, 64}, {1, 0, 64}})},
      {"of an edge of five",
       Answer::Any,
       of({{0, 1, 64}, {0, 1, 65}, {0, 1, 66}, {1, 0, 67}, {1, 0, 68}})}};
}

Kinds<std::vector<Eigen::Vector3f>>
badViewpoints()
{
  using Places = std::vector<Eigen::Vector3f>;
  const auto of = [](const Places& places) { return [=] { return places; }; };
  return {{"none", Answer::Any, of({})},
          {"one", Answer::Any, of({{0, 0, 0}})},
          {"at NaN", Answer::Refused, of({{0, nan, 0}})},
          {"at infinity", Answer::Refused, of({{0, 0, 0}, {0, 0, infinity}})},
          {"at 1e30 m", Answer::Refused, of({{1e30F, 0, 0}})}};
}

PlanePatch
goodPlane()
{
  PlanePatch plane;
  plane.coefficients = {0, 0, -1, 2};
  plane.center = {0, 0, 2};
  plane.axis_u = -Eigen::Vector3d::UnitX();
  plane.covariance = 1e-8 * Eigen::Matrix3d::Identity();
  plane.support = 1000;
  plane.effective_support = 100;
  plane.rms = 0.001;
  plane.area = 1;
  PlanePolygon square;
  square.outer = {{-.5F, -.5F, 2}, {-.5F, .5F, 2}, {.5F, .5F, 2}, {.5F, -.5F, 2}};
  plane.polygons = {square};
  return plane;
}

namespace {

/** Three planes, of which the second one is changed. */
std::function<std::vector<PlanePatch>()>
with(const std::function<void(PlanePatch&)>& change)
{
  return [=] {
    std::vector<PlanePatch> planes(3, goodPlane());
    change(planes[1]);
    return planes;
  };
}

} // namespace

Kinds<std::vector<PlanePatch>>
badPlanes()
{
  using Planes = std::vector<PlanePatch>;
  using Patch = PlanePatch;
  return {
      {"none", Answer::Any, [] { return Planes(); }},
      {"as they are", Answer::Any, with([](Patch&) {})},
      {"of NaN", Answer::Told, with([](Patch& p) { p.coefficients[0] = nan; })},
      {"without normal", Answer::Told, with([](Patch& p) {
         p.coefficients.setZero();
       })},
      {"of length 2", Answer::Any, with([](Patch& p) { p.coefficients *= 2; })},
      {"at infinity", Answer::Told, with([](Patch& p) {
         p.coefficients[3] = infinity;
       })},
      {"with a centre of NaN", Answer::Any, with([](Patch& p) { p.center[0] = nan; })},
      {"with an axis of zero", Answer::Any, with([](Patch& p) { p.axis_u.setZero(); })},
      {"with axes of NaN", Answer::Any, with([](Patch& p) {
         p.axis_v.setConstant(nan);
       })},
      {"with covariance of NaN", Answer::Any, with([](Patch& p) {
         p.covariance.setConstant(nan);
       })},
      {"with negative covariance", Answer::Any, with([](Patch& p) {
         p.covariance *= -1;
       })}};
}

Kinds<std::vector<PlanePatch>>
badPolygons()
{
  using Patch = PlanePatch;
  return {{"without polygons", Answer::Any, with([](Patch& p) { p.polygons.clear(); })},
          {"with a polygon without points", Answer::Any, with([](Patch& p) {
             p.polygons[0].outer.clear();
           })},
          {"with a polygon of two points", Answer::Any, with([](Patch& p) {
             p.polygons[0].outer.resize(2);
           })},
          {"with a point of NaN", Answer::Told, with([](Patch& p) {
             p.polygons[0].outer[0].setConstant(nan);
           })},
          {"with a point at 1e30 m", Answer::Any, with([](Patch& p) {
             p.polygons[0].outer[0].setConstant(1e30F);
           })},
          {"with a crossed polygon", Answer::Any, with([](Patch& p) {
             std::swap(p.polygons[0].outer[0], p.polygons[0].outer[1]);
           })},
          {"with a hole of one point", Answer::Any, with([](Patch& p) {
             p.polygons[0].holes = {{{0, 0, 2}}};
           })},
          {"with edges missing", Answer::Any, with([](Patch& p) {
             p.polygons[0].edges.resize(1);
           })},
          {"with a neighbour outside", Answer::Any, with([](Patch& p) {
             p.polygons[0].edges.resize(4, {EdgeKind::Crease, 99});
           })},
          {"with a neighbour far outside", Answer::Any, with([](Patch& p) {
             p.polygons[0].edges.resize(4, {EdgeKind::Arc, -7});
           })}};
}

} // namespace pcl::acmap::test
