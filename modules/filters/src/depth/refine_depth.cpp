#include <pcl/core/impl/moments.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/filters/impl/depth_refinement_kernel.h>

#include <Eigen/LU>

#include <cmath>
#include <limits>

namespace pcl::acmap {

namespace depth {
namespace {

/** Local plane of inverse depth in the image near a pixel: value + slopes . (column,
 * row). */
struct LocalPlane {
  double value = 0;
  Eigen::Vector2d slopes = Eigen::Vector2d::Zero(); ///< 1/m per pixel
  std::size_t support = 0;
};

/** Regression of inverse depth in a window around each pixel that is not on a plane. */
class PictureSmoothing {
public:
  static constexpr std::size_t fewest = 5; ///< minimum number of pixels of a surface

  /** \param[in] inverse_depths those of pixels on planes have already been replaced; 0
   * for pixels without a measurement */
  PictureSmoothing(const DepthView& view,
                   const std::vector<double>& inverse_depths,
                   double sigma)
  : width_(static_cast<std::int64_t>(view.width()))
  , height_(static_cast<std::int64_t>(view.height()))
  , inverse_depths_(inverse_depths)
  , gate_(2.5 * sigma)
  {}

  LocalPlane
  at(std::size_t pixel) const
  {
    LocalPlane plane;
    plane.value = inverse_depths_[pixel];
    // the first round estimates the slopes, the second one selects the pixels on the
    // plane
    constexpr int rounds = 2;
    for (int round = 0; round < rounds; ++round)
      if (!fit(static_cast<std::int64_t>(pixel), plane))
        break;
    return plane;
  }

private:
  bool
  fit(std::int64_t pixel, LocalPlane& plane) const
  {
    constexpr std::int64_t reach = 4; // pixels; the noise of neighbours is correlated
    const std::int64_t column = pixel % width_, row = pixel / width_;
    Moments sum;
    for (std::int64_t y = std::max<std::int64_t>(row - reach, 0);
         y <= std::min(row + reach, height_ - 1);
         ++y)
      for (std::int64_t x = std::max<std::int64_t>(column - reach, 0);
           x <= std::min(column + reach, width_ - 1);
           ++x) {
        const double measured =
            inverse_depths_[static_cast<std::size_t>(y * width_ + x)];
        const Eigen::Vector2d way(static_cast<double>(x - column),
                                  static_cast<double>(y - row));
        const double off = measured - plane.value - plane.slopes.dot(way);
        if (measured > 0 && std::abs(off) < gate_)
          sum += momentsOf({way.x(), way.y(), measured});
      }
    plane.support = static_cast<std::size_t>(sum.count);
    if (plane.support < fewest)
      return false;
    const double n = sum.count;
    const double xx = sum.xx - sum.x * sum.x / n, xy = sum.xy - sum.x * sum.y / n;
    const double yy = sum.yy - sum.y * sum.y / n;
    const Eigen::Vector2d right(sum.xz - sum.x * sum.z / n, sum.yz - sum.y * sum.z / n);
    Eigen::Matrix2d matrix;
    matrix << xx + 1, xy, xy, yy + 1; // a few pixels in a row only define one slope
    plane.slopes = matrix.inverse() * right;
    plane.value = (sum.z - plane.slopes.dot(Eigen::Vector2d(sum.x, sum.y))) / n;
    return true;
  }

  std::int64_t width_;
  std::int64_t height_;
  const std::vector<double>& inverse_depths_;
  double gate_;
};

/** Converts a local plane to the coefficients (a, b, c) of inverse depth over rays. */
Eigen::Vector3d
inRays(const LocalPlane& local,
       const Eigen::Vector3d& ray,
       const Eigen::Vector2d& focal)
{
  const Eigen::Vector2d slopes = local.slopes.cwiseProduct(focal);
  return {slopes.x(), slopes.y(), local.value - slopes.dot(ray.head<2>())};
}

} // namespace
} // namespace depth

RefinedDepth
refineDepth(const DepthView& view,
            const NoiseScale::InverseDepth& noise,
            const DepthPlanes* known,
            unsigned threads,
            const Progress& progress,
            DepthRefinementReport& report)
{
  using namespace depth;
  report = {};
  report.noise = noise;
  report.points = view.size();
  report.invalid_points = view.size() - view.measured();
  StepTimer timer(report);
  DepthPlaneSettings settings;
  settings.noise = noise;
  const DepthPlanes found = known ? *known : findDepthPlanes(view, settings, progress);
  report.planes = found.planes.size();
  timer.finish("planes");

  const Eigen::Vector3f none =
      Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  RefinedDepth refined;
  refined.points.assign(view.size(), none);
  refined.normals.assign(view.size(), none);
  const auto rayOf = [&](std::size_t pixel) {
    return view.rayOf(pixel % view.width(), pixel / view.width());
  };
  const auto set =
      [&](std::size_t pixel, double inverse_depth, const Eigen::Vector3d& inverse) {
        refined.points[pixel] = (rayOf(pixel) / inverse_depth).cast<float>();
        refined.normals[pixel] = -inverse.normalized().cast<float>();
      };
  std::vector<double> inverse_depths(view.size(), 0);
  std::vector<std::uint8_t> is_on_plane(view.size(), 0);
  for (std::size_t pixel = 0; pixel < view.size(); ++pixel) {
    inverse_depths[pixel] = static_cast<double>(view.inverseDepth(pixel));
    if (found.labels[pixel] < 0 || !(inverse_depths[pixel] > 0))
      continue;
    const Eigen::Vector3d& inverse =
        found.planes[static_cast<std::size_t>(found.labels[pixel])].inverse;
    const double of_plane = inverse.dot(rayOf(pixel));
    if (!(of_plane > 0))
      continue; // its ray does not intersect the plane
    inverse_depths[pixel] = of_plane;
    set(pixel, of_plane, inverse);
    is_on_plane[pixel] = 1;
    ++report.on_planes;
  }
  const PictureSmoothing smoothing(view, inverse_depths, noise.sigma());
  const double max_move = 1.5 * std::max(noise.step, noise.sigma());
  struct Counts {
    std::size_t smoothed = 0, withdrawn = 0;
  };
  const Counts counts = withThreads(threads, [&] {
    return parallelReduceChunks(
        view.size(),
        Counts{},
        [&](std::size_t begin, std::size_t end) {
          Counts some;
          for (std::size_t pixel = begin; pixel < end; ++pixel) {
            if (is_on_plane[pixel] || !(inverse_depths[pixel] > 0))
              continue;
            const LocalPlane local = smoothing.at(pixel);
            if (local.support < PictureSmoothing::fewest) {
              ++some.withdrawn;
              continue;
            }
            ++some.smoothed;
            set(pixel,
                std::clamp(local.value,
                           std::max(inverse_depths[pixel] - max_move,
                                    inverse_depths[pixel] / 2),
                           inverse_depths[pixel] + max_move),
                inRays(local, rayOf(pixel), view.focal()));
          }
          return some;
        },
        [](Counts& sum, const Counts& next) {
          sum.smoothed += next.smoothed;
          sum.withdrawn += next.withdrawn;
        });
  });
  report.smoothed = counts.smoothed;
  report.withdrawn = counts.withdrawn;
  timer.finish("smoothing");
  return refined;
}

} // namespace pcl::acmap
