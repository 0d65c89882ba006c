#include <pcl/core/exceptions.h>
#include <pcl/segmentation/plane_conversions.h>

namespace pcl {
namespace {

using Loop = std::vector<Eigen::Vector3f>;

/** Integrals of 1, p and p p^T over the area that a loop encloses; p is relative to the
 * centre of a patch, along its axes. Clockwise loops give negative values. */
struct AreaMoments {
  double area = 0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();

  void
  add(const Loop& loop, const PlanePatch& patch)
  {
    const auto flat = [&](const Eigen::Vector3f& point) {
      const Eigen::Vector3d way = point.cast<double>() - patch.center;
      return Eigen::Vector2d(way.dot(patch.axis_u), way.dot(patch.axis_v));
    };
    for (std::size_t i = 0; i < loop.size(); ++i) { // triangles with the centre
      const Eigen::Vector2d a = flat(loop[i]), b = flat(loop[(i + 1) % loop.size()]);
      const double twice = a.x() * b.y() - a.y() * b.x();
      const Eigen::Vector2d sum = a + b;
      area += twice / 2;
      first += twice / 6 * sum;
      second +=
          twice / 24 * (a * a.transpose() + b * b.transpose() + sum * sum.transpose());
    }
  }
};

} // namespace

void
toModelCoefficients(const PlanePatch& patch, ModelCoefficients& coefficients)
{
  coefficients.values.resize(4);
  for (int i = 0; i < 4; ++i)
    coefficients.values[static_cast<std::size_t>(i)] =
        static_cast<float>(patch.coefficients[i]);
}

namespace acmap {

Eigen::Matrix3d
spreadOf(const PlanePatch& patch)
{
  AreaMoments moments;
  for (const PlanePolygon& polygon : patch.polygons) {
    moments.add(polygon.outer, patch);
    for (const Loop& hole : polygon.holes)
      moments.add(hole, patch);
  }
  const Eigen::Vector3d normal = patch.coefficients.head<3>();
  const Eigen::Matrix3d across = patch.rms * patch.rms * normal * normal.transpose();
  if (!(moments.area > 0))
    return across;
  const Eigen::Vector2d mean = moments.first / moments.area;
  const Eigen::Matrix2d along = moments.second / moments.area - mean * mean.transpose();
  Eigen::Matrix<double, 3, 2> axes;
  axes << patch.axis_u, patch.axis_v;
  return axes * along * axes.transpose() + across;
}

Loop
largestRim(const PlanePatch& patch)
{
  Loop largest;
  double maximum = 0;
  for (const PlanePolygon& polygon : patch.polygons) {
    AreaMoments moments;
    moments.add(polygon.outer, patch);
    if (moments.area > maximum) {
      maximum = moments.area;
      largest = polygon.outer;
    }
  }
  return largest;
}

} // namespace acmap

std::vector<PointIndices>
toPointIndices(const PointLabels& labels, std::size_t planes, const PCLHeader& header)
{
  std::vector<PointIndices> clusters(planes);
  for (PointIndices& indices : clusters)
    indices.header = header;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] < 0)
      continue;
    const auto plane = static_cast<std::size_t>(labels[i]);
    if (plane >= planes)
      throw acmap::BadArgument(
          "label ", plane, " of point ", i, " is that of none of ", planes, " planes");
    clusters[plane].indices.push_back(static_cast<index_t>(i));
  }
  return clusters;
}

} // namespace pcl
