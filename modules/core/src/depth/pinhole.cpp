#include <pcl/core/pinhole.h>

#include <cmath>
#include <vector>

namespace pcl::acmap {

namespace {

constexpr std::size_t min_rays = 100;
constexpr std::size_t max_rays = 4096;

bool
hasRay(const Eigen::Vector3f& point)
{
  return point.allFinite() && point.z() > 0 && std::isfinite(1 / point.z());
}

/** Regression of one coordinate of the rays on the pixel coordinate. */
class PinholeAxis {
public:
  void
  add(double pixel, double ray)
  {
    samples_.push_back({pixel, ray});
  }

  /** \return false if the rays are not linear in the pixels */
  bool
  fit(double& focal, double& center) const
  {
    double pixel_mean = 0, ray_mean = 0;
    for (const auto& [pixel, ray] : samples_) {
      pixel_mean += pixel;
      ray_mean += ray;
    }
    const double count = static_cast<double>(samples_.size());
    pixel_mean /= count;
    ray_mean /= count;
    double covariance = 0, variance = 0;
    for (const auto& [pixel, ray] : samples_) {
      covariance += (pixel - pixel_mean) * (ray - ray_mean);
      variance += (pixel - pixel_mean) * (pixel - pixel_mean);
    }
    const double slope = covariance / variance;
    if (!(std::abs(slope) > 1e-9 && std::abs(slope) < 1))
      return false;
    focal = 1 / slope;
    center = pixel_mean - ray_mean * focal;
    std::size_t outliers = 0;
    for (const auto& [pixel, ray] : samples_)
      outliers += !(std::abs(ray * focal + center - pixel) < 1) ? 1 : 0;
    return 20 * outliers < samples_.size();
  }

private:
  struct RaySample {
    double pixel, ray;
  };

  std::vector<RaySample> samples_;
};

} // namespace

std::optional<Pinhole>
fitPinhole(const PointView& points, std::size_t width)
{
  if (width < 2 || points.size() % width != 0)
    return std::nullopt;
  std::size_t measured = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    measured += hasRay(points[i]) ? 1 : 0;
  if (measured < min_rays)
    return std::nullopt;
  const std::size_t step = measured / max_rays + 1;
  PinholeAxis columns, rows;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!hasRay(points[i]) || seen++ % step != 0)
      continue;
    const Eigen::Vector3d point = points[i].cast<double>();
    columns.add(static_cast<double>(i % width), point.x() / point.z());
    rows.add(static_cast<double>(i / width), point.y() / point.z());
  }
  Pinhole camera;
  if (!columns.fit(camera.fx, camera.cx) || !rows.fit(camera.fy, camera.cy))
    return std::nullopt;
  return camera;
}

std::optional<Pinhole>
fitUprightPinhole(const PointView& points, std::size_t width)
{
  const std::optional<Pinhole> camera = fitPinhole(points, width);
  return camera && camera->fx > 0 && camera->fy > 0 ? camera : std::nullopt;
}

} // namespace pcl::acmap
