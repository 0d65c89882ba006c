#include "corridor_bow.h"

#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>

namespace pcl::acmap::bench {
namespace {

/** Scatter of the points of one wall. */
class BowSpread {
public:
  void
  add(const Eigen::Vector2d& place)
  {
    count_ += 1;
    sum_ += place;
    products_ += place * place.transpose();
  }

  Eigen::Matrix2d
  aboutMean() const
  {
    if (count_ == 0)
      return Eigen::Matrix2d::Zero();
    return products_ - sum_ * sum_.transpose() / count_;
  }

private:
  double count_ = 0;
  Eigen::Vector2d sum_ = Eigen::Vector2d::Zero();
  Eigen::Matrix2d products_ = Eigen::Matrix2d::Zero();
};

/** -1 for the left wall, 1 for the right wall, 0 for other points: recessed doors,
 * boxes, floor. */
int
wallOf(const PointNormal& point, const Eigen::Isometry3d& T_scene_camera)
{
  constexpr double half_width = 1.2, tolerance = 0.04; // metres
  constexpr double min_cosine = 0.95;
  const Eigen::Vector3d place = T_scene_camera * point.getVector3fMap().cast<double>();
  const Eigen::Vector3d normal =
      T_scene_camera.linear() * point.getNormalVector3fMap().cast<double>();
  if (!(std::abs(normal.x()) > min_cosine) ||
      !(std::abs(std::abs(place.x()) - half_width) < tolerance))
    return 0;
  return place.x() > 0 ? 1 : -1;
}

/** Common direction of both walls in some observations, in radians from z. */
double
directionOf(const RectificationMap& map,
            const std::vector<PlanarPose>& poses,
            std::size_t begin,
            std::size_t end)
{
  std::array<BowSpread, 2> walls;
  for (std::size_t i = begin; i < end; ++i) {
    const Eigen::Isometry3d truth = isometryOf(map.truth[i]);
    const Eigen::Isometry3d pose = isometryOf(poses[i]);
    for (const PointNormal& point : *map.clouds[i])
      if (const int wall = wallOf(point, truth)) {
        const Eigen::Vector3d place = pose * point.getVector3fMap().cast<double>();
        walls[wall > 0].add({place.x(), place.z()});
      }
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(walls[0].aboutMean() + walls[1].aboutMean());
  const Eigen::Vector2d along = solver.eigenvectors().col(1);
  return std::atan(along[0] / along[1]);
}

} // namespace

double
bowOf(const RectificationMap& map, const std::vector<PlanarPose>& poses)
{
  const std::size_t size = poses.size();
  const double bend = directionOf(map, poses, size - size / 3, size) -
                      directionOf(map, poses, 0, size / 3);
  return std::abs(bend) * 180 / M_PI;
}

} // namespace pcl::acmap::bench
