#include "free_space.h"

#include "ball_visit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

constexpr double beside = 2; // reaches: where rays begin, past their own surface
constexpr double never = std::numeric_limits<double>::infinity();

/** \brief Which of two lengths is preferred: the larger one of those that end.
 * \return 1 for the first, -1 for the second, 0 for none */
int
largerGap(double first, double second)
{
  if (std::isfinite(first) && std::isfinite(second))
    return (first > second) - (first < second);
  return std::isfinite(first) - std::isfinite(second);
}

} // namespace

/** A ray near a point of the tree. */
struct FreeSpace::Ray {
  std::int32_t point;
  Eigen::Vector3d origin, direction;
  double from;  ///< where it begins, metres from the origin
  double reach; ///< it ends where a point is nearer than this, metres
};

/** Where a ray ends. */
struct FreeSpace::End {
  double distance;    ///< from its origin, metres; infinite if it leaves the cloud
  std::int32_t point; ///< of the tree
};

FreeSpace::FreeSpace(const PointTree& tree,
                     const LargeVector<Eigen::Vector3f>& normals,
                     const Eigen::Vector3d& up)
: tree_(tree)
, normals_(normals)
, up_(up)
{
  for (std::int32_t leaf = 0; leaf < tree.leafCount(); ++leaf)
    box_.extend(tree.boxOfLeaf(leaf).cast<double>());
}

int
FreeSpace::sideOf(std::int32_t point, const Eigen::Vector3d& normal, double reach) const
{
  constexpr double steep = 0.5;
  const double rise = normal.dot(up_);
  if (std::abs(rise) <= steep)
    return sideOfWall(point, (normal - rise * up_).normalized(), reach);
  const auto gap = [&](double sign) {
    return endOf({point, tree_.position(point), sign * up_, beside * reach, reach})
        .distance;
  };
  const int upper = largerGap(gap(1), gap(-1));
  return (upper < 0) == (rise < 0) ? 1 : -1;
}

/** \param[in] level unit vector, horizontal
 * \return see \ref sideOf */
int
FreeSpace::sideOfWall(std::int32_t point,
                      const Eigen::Vector3d& level,
                      double reach) const
{
  const Eigen::Vector3d origin = tree_.position(point);
  constexpr double farther = 0.5; // metres, thicker than walls
  for (const double distance :
       {beside * reach, std::max(farther, 2 * beside * reach)}) {
    const auto has_floor = [&](double sign) {
      const Eigen::Vector3d place = origin + sign * distance * level;
      return endsAtFloor({point, place, -up_, 0, reach});
    };
    const int floors = has_floor(1) - has_floor(-1);
    if (floors != 0)
      return floors;
  }
  const auto gap = [&](double sign) {
    return endOf({point, origin, sign * level, beside * reach, reach}).distance;
  };
  return largerGap(gap(1), gap(-1));
}

/** Does a ray downwards end at a flat, level surface? It does not if it begins between the
 * sides of a thin wall, or touches a wall. */
bool
FreeSpace::endsAtFloor(const Ray& ray) const
{
  constexpr double level = 0.8; // cosine
  const End end = endOf(ray);
  return end.distance > 0 && std::isfinite(end.distance) &&
         std::abs(normals_[static_cast<std::size_t>(end.point)].cast<double>().dot(
             up_)) > level;
}

FreeSpace::End
FreeSpace::endOf(const Ray& ray) const
{
  constexpr int max_steps = 1024; // along a wall, steps are short
  double along = ray.from;
  for (int step = 0; step < max_steps; ++step) {
    const Eigen::Vector3d place = ray.origin + along * ray.direction;
    if (!box_.contains(place))
      break;
    const End nearest = nearestTo(place, ray);
    if (nearest.distance < ray.reach)
      return {along, nearest.point};
    along += nearest.distance - ray.reach / 2;
  }
  return {never, ray.point};
}

/** \return the nearest point and its distance from the place, metres */
FreeSpace::End
FreeSpace::nearestTo(const Eigen::Vector3d& place, const Ray& ray) const
{
  End nearest{(place - tree_.position(ray.point)).norm(), ray.point};
  visitBall(tree_,
            ray.point,
            place,
            nearest.distance,
            [&](std::int32_t, std::int32_t first, std::int32_t end) {
              for (std::int32_t i = first; i < end; ++i) {
                const double distance = (tree_.position(i) - place).norm();
                if (distance < nearest.distance)
                  nearest = {distance, i};
              }
            });
  return nearest;
}

} // namespace pcl::acmap::ACMAP_DEWALL
