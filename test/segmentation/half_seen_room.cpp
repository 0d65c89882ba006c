#include "half_seen_room.h"

#include <pcl/core/random.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {
namespace {

constexpr double width = 4, depth = 3.2, height = 2.7;

/** A room under construction, y up. */
class Builder {
public:
  explicit Builder(const HalfSeenSettings& settings)
  : settings_(settings)
  , random_(7000 + settings.seed)
  , sensor_(random_.uniform(0.4, 1.2), random_.uniform(1, 1.7), 0.2)
  {}

  HalfSeenRoom
  build()
  {
    placeColumns();
    addRectangle({0, 0, 0}, {width, 0, 0}, {0, 0, depth}, {0, 1, 0});
    addRectangle({0, 0, depth}, {width, 0, 0}, {0, height, 0}, {0, 0, -1});
    addRectangle({width, 0, 0}, {0, 0, depth}, {0, height, 0}, {-1, 0, 0});
    for (const SceneCylinder& column : room_.columns)
      addColumn(column);
    room_.sensor = turned(sensor_).cast<float>();
    for (SceneCylinder& column : room_.columns) {
      column.point = turned(column.point);
      column.axis = turned(column.axis);
    }
    room_.cloud->sensor_origin_.setZero();
    return std::move(room_);
  }

private:
  void
  placeColumns()
  {
    const std::uint64_t wanted = 1 + random_.bits() % 3;
    for (int tries = 0; tries < 200 && room_.columns.size() < wanted; ++tries) {
      const double radius = random_.uniform(0.1, 0.3);
      const Eigen::Vector3d place(
          random_.uniform(0.8, width - 0.5), 0, random_.uniform(1.2, depth - 0.5));
      if (isClear(place, radius))
        room_.columns.push_back({place, Eigen::Vector3d::UnitY(), radius});
    }
  }

  /** Neither in a wall, nor at the sensor, nor beside or behind another column. */
  bool
  isClear(const Eigen::Vector3d& place, double radius) const
  {
    constexpr double gap = 0.15;
    const Eigen::Vector2d own(place.x() - sensor_.x(), place.z() - sensor_.z());
    if (width - place.x() < radius + gap || depth - place.z() < radius + gap ||
        own.norm() < radius + 0.7)
      return false;
    return std::all_of(
        room_.columns.begin(), room_.columns.end(), [&](const SceneCylinder& other) {
          const Eigen::Vector2d theirs(other.point.x() - sensor_.x(),
                                       other.point.z() - sensor_.z());
          const double angle = std::acos(own.normalized().dot(theirs.normalized()));
          return angle > std::asin(radius / own.norm()) +
                             std::asin(other.radius / theirs.norm()) + 0.05;
        });
  }

  void
  addRectangle(const Eigen::Vector3d& corner,
               const Eigen::Vector3d& a,
               const Eigen::Vector3d& b,
               const Eigen::Vector3d& normal)
  {
    const double points = settings_.density * a.norm() * b.norm();
    for (int i = 0; i < static_cast<int>(points); ++i) {
      const double along = random_.uniform(0, 1), aside = random_.uniform(0, 1);
      const Eigen::Vector3d place = corner + along * a + aside * b;
      if (!isHidden(place))
        add(place, normal);
    }
  }

  bool
  isHidden(const Eigen::Vector3d& place) const
  {
    return std::any_of(
        room_.columns.begin(), room_.columns.end(), [&](const SceneCylinder& column) {
          const Eigen::Vector2d way(place.x() - sensor_.x(), place.z() - sensor_.z());
          const Eigen::Vector2d from(sensor_.x() - column.point.x(),
                                     sensor_.z() - column.point.z());
          const double a = way.squaredNorm(), b = way.dot(from);
          const double rest =
              b * b - a * (from.squaredNorm() - std::pow(column.radius, 2));
          return rest > 0 && -b - std::sqrt(rest) > 0 && -b - std::sqrt(rest) < a;
        });
  }

  void
  addColumn(const SceneCylinder& column)
  {
    constexpr double denser = 2.4;
    const double towards =
        std::atan2(sensor_.z() - column.point.z(), sensor_.x() - column.point.x());
    const double points = denser * settings_.density * M_PI * column.radius * height;
    for (int i = 0; i < static_cast<int>(points); ++i) {
      const double angle = towards + random_.uniform(-M_PI / 2, M_PI / 2);
      const Eigen::Vector3d normal(std::cos(angle), 0, std::sin(angle));
      add(column.point + column.radius * normal +
              random_.uniform(0, height) * Eigen::Vector3d::UnitY(),
          normal);
    }
  }

  void
  add(const Eigen::Vector3d& place, const Eigen::Vector3d& normal)
  {
    const Eigen::Vector3d way =
        settings_.is_along_rays ? (place - sensor_).normalized() : normal;
    const Eigen::Vector3f point =
        turned(place + settings_.sigma * random_.normal() * way).cast<float>();
    room_.cloud->emplace_back(point.x(), point.y(), point.z());
  }

  Eigen::Vector3d
  turned(const Eigen::Vector3d& place) const
  {
    return settings_.is_z_up ? Eigen::Vector3d(place.x(), -place.z(), place.y())
                             : place;
  }

  HalfSeenSettings settings_;
  Random random_;
  Eigen::Vector3d sensor_;
  HalfSeenRoom room_;
};

} // namespace

HalfSeenRoom
makeHalfSeenRoom(const HalfSeenSettings& settings)
{
  return Builder(settings).build();
}

} // namespace pcl::acmap::test
