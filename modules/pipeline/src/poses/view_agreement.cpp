#include "poses/view_agreement.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

constexpr std::size_t max_seen = 80000, max_sample = 4000;

/** Each n-th of the points, so that at most \a maximum are left. */
std::vector<Eigen::Vector3f>
thinned(const std::vector<Eigen::Vector3f>& points, std::size_t maximum)
{
  const std::size_t every = points.size() / maximum + 1;
  std::vector<Eigen::Vector3f> left;
  for (std::size_t i = 0; i < points.size(); i += every)
    left.push_back(points[i]);
  return left;
}

std::vector<Eigen::Vector3f>
finitePoints(const PointView& points)
{
  constexpr float nearest = 0.05F, farthest = 1e4F; // metres
  std::vector<Eigen::Vector3f> seen;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float range = points[i].norm();
    if (range > nearest && range < farthest) // neither is true for NaN
      seen.push_back(points[i]);
  }
  return thinned(seen, max_seen);
}

} // namespace

void
RangeView::Ranges::add(float range)
{
  low = low == 0 ? range : std::min(low, range);
  high = std::max(high, range);
}

RangeView::RangeView(const PointView& points, bool is_depth_image)
: is_depth_image_(is_depth_image)
{
  const std::vector<Eigen::Vector3f> seen = finitePoints(points);
  sample_ = thinned(seen, max_sample);
  // the finest pixels in most of which there are several points
  constexpr std::size_t points_per_pixel = 3;
  for (const int edge : {180, 90, 45}) {
    edge_ = edge;
    fill(seen);
    std::size_t filled = 0;
    for (const Face& face : faces_)
      filled += static_cast<std::size_t>(std::count_if(
          face.pixels.begin(), face.pixels.end(), [](const Ranges& pixel) {
            return pixel.high > 0;
          }));
    if (seen.size() >= points_per_pixel * filled)
      break;
  }
}

RangeView::Place
RangeView::placeOf(const Eigen::Vector3f& point) const
{
  int axis = 0;
  const float ahead = point.cwiseAbs().maxCoeff(&axis);
  const auto pixel = [&](float across) {
    const float place = (across / ahead + 1) / 2 * static_cast<float>(edge_);
    return std::clamp(static_cast<int>(place), 0, edge_ - 1);
  };
  return {static_cast<std::size_t>(2 * axis + (point[axis] < 0 ? 1 : 0)),
          pixel(point[(axis + 1) % 3]),
          pixel(point[(axis + 2) % 3])};
}

void
RangeView::fill(const std::vector<Eigen::Vector3f>& points)
{
  for (Face& face : faces_)
    face.pixels.clear();
  for (const Eigen::Vector3f& point : points) {
    const Place place = placeOf(point);
    std::vector<Ranges>& pixels = faces_[place.face].pixels;
    if (pixels.empty())
      pixels.resize(static_cast<std::size_t>(edge_) * static_cast<std::size_t>(edge_));
    pixels[static_cast<std::size_t>(place.row * edge_ + place.column)].add(
        point.norm());
  }
}

double
RangeView::sigma(double range) const
{
  constexpr double most =
      0.3; // metres: nothing agrees with what is farther than was seen
  return std::min(
      most, is_depth_image_ ? 0.01 + 0.006 * range * range : 0.025 + 0.004 * range);
}

std::optional<double>
RangeView::agreementAt(const Eigen::Vector3f& point) const
{
  constexpr double through = -2, occluded = -0.5;
  constexpr double farthest = 1e6; // metres, also of poses in millimetres
  const double range = point.norm();
  if (!(range > 0 && range < farthest))
    return {};
  const Place place = placeOf(point);
  const std::vector<Ranges>& pixels = faces_[place.face].pixels;
  if (pixels.empty())
    return {};
  const auto at = [&](int column, int row) {
    return pixels[static_cast<std::size_t>(row * edge_ + column)];
  };
  const Ranges& center = at(place.column, place.row);
  if (center.high == 0)
    return {};
  Ranges around = center;
  for (int row = std::max(0, place.row - 1); row <= std::min(edge_ - 1, place.row + 1);
       ++row)
    for (int column = std::max(0, place.column - 1);
         column <= std::min(edge_ - 1, place.column + 1);
         ++column)
      if (const Ranges pixel = at(column, row); pixel.high > 0) {
        around.add(pixel.low);
        around.add(pixel.high);
      }
  const double s = sigma(range);
  const double margin =
      is_depth_image_ ? 3 * s + 0.03 : std::min(1.0, 0.1 + 0.01 * range);
  if (around.low - range > margin)
    return through;
  if (range - around.high > margin)
    return occluded;
  const double e = std::max({center.low - range, range - center.high, 0.0});
  return std::log(0.3 + 8 * std::exp(-e * e / (2 * s * s)));
}

double
RangeView::agreementWith(const RangeView& other,
                         const Eigen::Isometry3d& T_this_other) const
{
  if (other.sample_.empty())
    return 0;
  // views that share less than half are told to be worse than they are
  constexpr double min_shared = 0.5;
  const Eigen::Isometry3f T = T_this_other.cast<float>();
  double sum = 0, shared = 0;
  for (const Eigen::Vector3f& point : other.sample_)
    if (const std::optional<double> agreement = agreementAt(T * point)) {
      sum += *agreement;
      ++shared;
    }
  return sum / std::max(shared, min_shared * static_cast<double>(other.sample_.size()));
}

double
agreementOf(const RangeView& a, const RangeView& b, const Eigen::Isometry3d& T_a_b)
{
  constexpr double rays = 180;
  return rays / 2 * (a.agreementWith(b, T_a_b) + b.agreementWith(a, T_a_b.inverse()));
}

} // namespace pcl::acmap
