#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/plane_distance.h>
#include <pcl/pipeline/pose_errors.h>

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <cstring>
#include <random>

namespace pcl::acmap::test {
namespace {

using Eigen::Vector3d;

/** A corridor along x with walls of 2 m every 2 m on both sides, and an observation every metre
 * that sees the walls beside it. */
class Corridor {
public:
  explicit Corridor(std::size_t observations,
                    const Eigen::Isometry3d& frame = Eigen::Isometry3d::Identity())
  : frame_(frame)
  {
    for (std::size_t i = 0; i < observations; ++i) {
      Eigen::Isometry3d pose = frame;
      pose.translate(Vector3d(static_cast<double>(i), 0, 0));
      model.poses.push_back(pose);
    }
    model.up = frame.linear() * Vector3d::UnitZ();
    for (std::size_t wall = 0; 2 * wall < observations; ++wall)
      for (const double side : {-1.0, 1.0})
        addWall(2 * static_cast<double>(wall), side);
  }

  /** \param[in] sees which observations see which planes
   * \param[in] offset of the points of an observation from a plane, metres */
  template <typename Sees, typename Offset>
  void
  see(const Sees& sees, const Offset& offset)
  {
    for (std::size_t plane = 0; plane < planes.size(); ++plane)
      for (std::size_t view = 0; view < model.poses.size(); ++view)
        if (sees(view, plane))
          addPoints(view, plane, offset(view, plane));
  }

  /** A flat piece of 20 cm, along the corridor, that is no plane of the map.
   * \param[in] x metres along the corridor, of its begin */
  void
  seeClutter(std::size_t view, double x)
  {
    for (int i = 0; i < 20; ++i)
      for (int k = 0; k < 20; ++k)
        addPoint(frame_ * Vector3d(x + 0.01 * i, 0.4, 0.02 + 0.01 * k), view, -1);
  }

  CompactMap
  map()
  {
    PCLPointCloud2 layout = layoutWith({},
                                       {{"x", PCLPointField::FLOAT32},
                                        {"y", PCLPointField::FLOAT32},
                                        {"z", PCLPointField::FLOAT32},
                                        {"view", PCLPointField::INT32}});
    layout.width = static_cast<std::uint32_t>(labels_.size());
    layout.height = 1;
    LargeVector<std::uint8_t> rows(bytes_.begin(), bytes_.end());
    CompactMap map;
    map.planes = planes;
    addPoseErrors(
        CloudRows(std::move(layout), std::move(rows)), labels_, model, map.planes);
    return map;
  }

  PoseErrorModel model;
  std::vector<PlanePatch> planes;

private:
  static constexpr double width = 2, height = 2;

  void
  addWall(double begin, double side)
  {
    PlanePatch wall;
    const Vector3d normal = frame_.linear() * Vector3d(0, -side, 0);
    wall.center = frame_ * Vector3d(begin + width / 2, side, 0);
    wall.axis_u = frame_.linear() * Vector3d::UnitX();
    wall.axis_v = normal.cross(wall.axis_u);
    wall.coefficients << normal, -normal.dot(wall.center);
    wall.covariance = 1e-12 * Eigen::Matrix3d::Identity();
    PlanePolygon polygon;
    for (const auto& [u, v] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      polygon.outer.push_back(
          (wall.center + u * width / 2 * wall.axis_u + v * height / 2 * wall.axis_v)
              .cast<float>());
    wall.polygons = {polygon};
    planes.push_back(wall);
  }

  void
  addPoints(std::size_t view, std::size_t plane, double offset)
  {
    const PlanePatch& wall = planes[plane];
    for (int i = 0; i < 16; ++i)
      for (int k = 0; k < 16; ++k)
        addPoint(wall.center + (i / 7.5 - 1) * wall.axis_u +
                     (k / 7.5 - 1) * wall.axis_v + offset * wall.coefficients.head<3>(),
                 view,
                 static_cast<std::int32_t>(plane));
  }

  void
  addPoint(const Vector3d& place, std::size_t view, std::int32_t plane)
  {
    const Eigen::Vector3f stored = place.cast<float>();
    const auto number = static_cast<std::int32_t>(view);
    const std::size_t at = bytes_.size();
    bytes_.resize(at + 16);
    std::memcpy(&bytes_[at], stored.data(), 12);
    std::memcpy(&bytes_[at + 12], &number, 4);
    labels_.push_back(plane);
  }

  Eigen::Isometry3d frame_;
  std::vector<std::uint8_t> bytes_;
  PointLabels labels_;
};

/** Each observation sees the walls that it is between, and the next ones. */
bool
isNear(std::size_t view, std::size_t plane)
{
  const auto wall = static_cast<double>(2 * (plane / 2));
  return std::abs(static_cast<double>(view) - wall - 1) <= 1.5;
}

double
noiseOf(std::size_t view, std::size_t plane)
{
  std::mt19937 random(static_cast<unsigned>(31 * view + plane + 7));
  return 0.002 * std::normal_distribution<double>()(random);
}

TEST(PoseErrors, CancelBetweenPlanesThatWereSeenTogether)
{
  Corridor corridor(13);
  corridor.see(isNear, noiseOf);
  const CompactMap map = corridor.map();
  const std::size_t last = map.planes.size() - 2;
  // the width where the corridor ends, against the way from there to its begin
  const double width = distanceBetween(map, last, last + 1).deviation;
  const double bend = distanceBetween(map, 0, last).deviation;
  EXPECT_FALSE(distanceBetween(map, 0, last).is_at_least);
  EXPECT_GT(width, 0.0002);
  EXPECT_LT(width, 0.004);
  EXPECT_GT(bend, 1.5 * width);
}

TEST(PoseErrors, GrowWithTheOdometrysWherePlanesDoNotTell)
{
  const auto deviation = [](double factor) {
    Corridor corridor(9);
    corridor.model.noise.length *= factor;
    corridor.model.noise.length_per_metre *= factor;
    corridor.model.noise.turn *= factor;
    // no wall is seen by two of the observations
    corridor.see(
        [](std::size_t view, std::size_t plane) { return view == 2 * (plane / 2); },
        [](std::size_t, std::size_t) { return 0.0; });
    const CompactMap map = corridor.map();
    return distanceBetween(map, 0, map.planes.size() - 2).deviation;
  };
  EXPECT_NEAR(deviation(2) / deviation(1), 2, 0.05);
}

TEST(PoseErrors, DoNotDependOnTheFrame)
{
  const Eigen::Isometry3d frame(Eigen::Translation3d(3, -2, 7) *
                                Eigen::AngleAxisd(1, Vector3d(1, 2, 3).normalized()));
  Corridor one(9), other(9, frame);
  one.see(isNear, noiseOf);
  other.see(isNear, noiseOf);
  const CompactMap first = one.map(), second = other.map();
  for (std::size_t plane = 1; plane < first.planes.size(); ++plane) {
    const double wanted = first.planes[plane].covariance(2, 2);
    EXPECT_NEAR(second.planes[plane].covariance(2, 2), wanted, 0.05 * wanted);
  }
}

TEST(PoseErrors, GiveCovariancesThatContainTheModes)
{
  Corridor corridor(13);
  corridor.model.up.reset(); // in six degrees of freedom
  corridor.see(isNear, noiseOf);
  const CompactMap map = corridor.map();
  for (const PlanePatch& plane : map.planes) {
    ASSERT_FALSE(plane.pose_modes.empty());
    Eigen::Matrix3d rest = plane.covariance;
    for (const Vector3d& mode : plane.pose_modes)
      rest -= mode * mode.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(rest);
    EXPECT_GT(solver.eigenvalues().minCoeff(), -1e-9 * plane.covariance.norm());
  }
}

/** Two rooms that no plane joins: what was seen of the second one lies where the rectification has
 * put it, off by an error that the odometry knows better. */
struct TwoRooms {
  static constexpr std::size_t views = 12, begin = 6; ///< of the second room
  static constexpr double off = 0.02, step = 0.003, turn = 0.0005;

  explicit TwoRooms(unsigned seed)
  : corridor(views)
  {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    error = off * normal(random);
    corridor.model.noise = {2 * step, 0, 2 * turn, 0}; // as it is stated
    corridor.model.before = corridor.model.poses;
    for (std::size_t i = 1; i < views; ++i) {
      Eigen::Isometry3d motion =
          corridor.model.poses[i - 1].inverse() * corridor.model.poses[i];
      if (i == begin)
        motion.translation().y() -= error;
      motion.translation() += step * Vector3d(normal(random), normal(random), 0);
      motion.rotate(Eigen::AngleAxisd(turn * normal(random), Vector3d::UnitZ()));
      corridor.model.before[i] = corridor.model.before[i - 1] * motion;
    }
    corridor.see(
        [](std::size_t view, std::size_t plane) {
          return isNear(view, plane) && (view < begin) == (plane < begin);
        },
        [&](std::size_t, std::size_t) { return 0.001 * normal(random); });
  }

  Corridor corridor;
  double error; ///< metres, across, of the second room
};

TEST(PoseErrors, AreThoseOfRoomsThatTheRectificationHasMoved)
{
  constexpr unsigned draws = 60;
  double sum = 0;
  for (unsigned seed = 0; seed < draws; ++seed) {
    TwoRooms rooms(seed);
    const CompactMap map = rooms.corridor.map();
    const PlaneDistance across = distanceBetween(map, 0, map.planes.size() - 1);
    sum += std::pow(rooms.error / across.deviation, 2);
  }
  const double normalised = std::sqrt(sum / draws);
  EXPECT_GT(normalised, 0.65);
  EXPECT_LT(normalised, 1.2);
}

TEST(PoseErrors, AreNotThoseOfTheOtherFaceOfAThinWall)
{
  constexpr std::size_t behind = 8; // an observation that nothing else joins to plane 0
  const auto deviationWith = [](bool sees_back) {
    Corridor corridor(9);
    corridor.model.poses[behind].translation() = Vector3d(1, -2, 0);
    corridor.see(
        [&](std::size_t view, std::size_t plane) {
          return view == behind ? sees_back && plane == 0 : isNear(view, plane);
        },
        [](std::size_t view, std::size_t plane) {
          return view == behind ? -0.03 : noiseOf(view, plane);
        });
    return distanceBetween(corridor.map(), 0, 1).deviation;
  };
  EXPECT_EQ(deviationWith(true), deviationWith(false));
}

TEST(PoseErrors, AreSmallerWhereClutterJoinsTheRooms)
{
  const auto deviation = [](bool has_clutter) {
    constexpr std::size_t views = 12, begin = 6; // of the second room
    Corridor corridor(views);
    corridor.see(
        [](std::size_t view, std::size_t plane) {
          return isNear(view, plane) && (view < begin) == (plane < begin);
        },
        noiseOf);
    for (int metre = 1; metre < 10; ++metre)
      for (const std::size_t view : {begin - 1, begin})
        if (has_clutter)
          corridor.seeClutter(view, metre + 0.02);
    return distanceBetween(corridor.map(), 0, corridor.planes.size() - 1).deviation;
  };
  EXPECT_LT(deviation(true), 0.5 * deviation(false));
}

TEST(PoseErrors, RefuseAnotherNumberOfPosesBefore)
{
  Corridor corridor(5);
  corridor.see(isNear, noiseOf);
  corridor.model.before.resize(4, Eigen::Isometry3d::Identity());
  EXPECT_THROW(corridor.map(), BadArgumentException);
}

TEST(PoseErrors, AreLeftOutWhereNothingIsKnown)
{
  Corridor alone(1);
  alone.see([](std::size_t, std::size_t) { return true; }, noiseOf);
  for (const PlanePatch& plane : alone.map().planes)
    EXPECT_TRUE(plane.pose_modes.empty());
  Corridor unseen(5);
  const CompactMap map = unseen.map();
  for (std::size_t p = 0; p < map.planes.size(); ++p)
    EXPECT_EQ(map.planes[p].covariance, unseen.planes[p].covariance);
  std::vector<PlanePatch> planes = unseen.planes;
  addPoseErrors({}, {}, unseen.model, planes);
  EXPECT_TRUE(planes[0].pose_modes.empty());
}

} // namespace
} // namespace pcl::acmap::test
