#include <pcl/core/impl/depth_view.h>
#include <pcl/core/progress.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

constexpr std::size_t enough_pixels = 1000;

bool
isMeasured(const Eigen::Vector3f& point)
{
  return point.allFinite() && point.z() > 0;
}

} // namespace

DepthView::DepthView(std::size_t width, std::vector<float> inverse_depths)
: width_(width)
, height_(inverse_depths.size() / width)
, measured_(static_cast<std::size_t>(
      std::count_if(inverse_depths.begin(),
                    inverse_depths.end(),
                    [](float inverse) { return inverse > 0; })))
, inverse_depths_(std::move(inverse_depths))
{}

std::optional<DepthView>
DepthView::recognize(const PointView& points, std::size_t width)
{
  if (width < 2 || points.size() < enough_pixels || points.size() % width != 0)
    return std::nullopt;
  std::vector<float> inverse_depths(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f point = points[i];
    const float inverse = 1 / point.z();
    if (isMeasured(point) && std::isfinite(inverse))
      inverse_depths[i] = inverse;
  }
  DepthView view(width, std::move(inverse_depths));
  if (view.measured() < enough_pixels)
    return std::nullopt;
  const std::optional<Pinhole> camera = fitPinhole(points, width);
  if (!camera)
    return std::nullopt;
  view.camera_ = *camera;
  for (std::size_t column = 0; column < view.width(); ++column)
    view.x_of_column_.push_back(view.ray(static_cast<double>(column), 0).x());
  for (std::size_t row = 0; row < view.height(); ++row)
    view.y_of_row_.push_back(view.ray(0, static_cast<double>(row)).y());
  return view;
}

namespace {

/** Statistics of the steps between neighbouring values. */
struct Steps {
  std::size_t number = 0;
  double median = 0;
  double spread = 0; ///< interquartile range, relative to the median
};

Steps
stepsOf(std::vector<double>& values)
{
  std::sort(values.begin(), values.end());
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = values[i] - values[i - 1];
    constexpr double rounding_of_floats = 1e-6;
    if (step > rounding_of_floats * values[i])
      steps.push_back(step);
  }
  Steps result;
  result.number = steps.size();
  if (steps.empty())
    return result;
  std::sort(steps.begin(), steps.end());
  result.median = steps[steps.size() / 2];
  result.spread =
      (steps[3 * steps.size() / 4] - steps[steps.size() / 4]) / result.median;
  return result;
}

} // namespace

double
measureDepthStep(const PointView& points)
{
  constexpr std::size_t wanted = 1 << 15;
  const std::size_t stride = points.size() / wanted + 1;
  std::vector<double> depths;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    pollRun(); // each of these points may bring in pages around it
    if (isMeasured(points[i]))
      depths.push_back(static_cast<double>(points[i].z()));
  }
  if (depths.size() < enough_pixels)
    return 0;
  const Steps of_depth = stepsOf(depths);
  // fewer distinct depths are not sufficient; with more, each point has its own depth
  constexpr std::size_t fewest = 8, points_a_depth = 8;
  if (of_depth.number < fewest || of_depth.number * points_a_depth > depths.size())
    return 0;
  for (double& depth : depths)
    depth = 1 / depth;
  const Steps of_inverse = stepsOf(depths);
  // uniform steps of depth come from a lattice, or from a file in millimetres
  constexpr double even = 0.4;
  // far from the origin, as heights of a survey in millimetres, a lattice is even in both
  constexpr double finest = 1e-5; // 1/m: no camera has such steps
  return of_inverse.spread < even && of_inverse.spread < of_depth.spread + 0.05 &&
                 of_inverse.median > finest
             ? of_inverse.median
             : 0;
}

std::optional<MeasuredDepthView>
measureDepthView(const PointView& points, std::size_t width)
{
  std::optional<DepthView> view = DepthView::recognize(points, width);
  if (!view)
    return std::nullopt;
  const NoiseScale::InverseDepth noise =
      measureInverseDepthNoise(*view, measureDepthStep(points));
  return MeasuredDepthView{std::move(*view), noise};
}

} // namespace pcl::acmap
