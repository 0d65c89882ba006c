#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/plane_distance.h>
#include <pcl/pipeline/pose_accuracy.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <map>
#include <utility>

namespace pcl {

namespace {

/** \brief Distances of points of an observation from a plane. */
struct Offsets {
  double sum = 0, squares = 0;
  std::size_t count = 0;

  double
  mean() const
  {
    return sum / static_cast<double>(count);
  }

  double
  varianceOfMean() const
  {
    const auto n = static_cast<double>(count);
    return std::max(squares / n - mean() * mean(), 0.0) / n;
  }
};

/** \brief A pair of observations that saw the same plane. */
struct ViewPair {
  double distance; ///< between their positions, metres
  double
      half_square; ///< half of the squared difference of their offsets, less its noise
};

/** \brief The offsets of each plane by observation. */
std::vector<std::map<std::int32_t, Offsets>>
offsetsOf(const CloudRows& cloud,
          const PointLabels& labels,
          const std::vector<PlanePatch>& planes,
          std::size_t views)
{
  std::vector<std::map<std::int32_t, Offsets>> offsets(planes.size());
  const PCLPointField* const field =
      acmap::findField(cloud.layout(), "view", PCLPointField::INT32);
  if (!field || labels.size() != cloud.size())
    return offsets;
  const acmap::PointView points = acmap::requirePoints(cloud);
  const std::size_t step = cloud.layout().point_step;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] < 0)
      continue;
    std::int32_t view = 0;
    std::memcpy(&view, cloud.data() + i * step + field->offset, sizeof view);
    if (view < 0 || static_cast<std::size_t>(view) >= views)
      continue;
    const auto plane = static_cast<std::size_t>(labels[i]);
    const double offset = planes[plane].coefficients.dot(
        Eigen::Vector3d(points[i].cast<double>()).homogeneous());
    Offsets& of_view = offsets[plane][view];
    of_view.sum += offset;
    of_view.squares += offset * offset;
    ++of_view.count;
  }
  return offsets;
}

std::vector<ViewPair>
pairsOf(const std::vector<std::map<std::int32_t, Offsets>>& offsets,
        const std::vector<Eigen::Vector3f>& viewpoints)
{
  constexpr std::size_t min_points = 200;
  std::vector<ViewPair> pairs;
  for (const std::map<std::int32_t, Offsets>& plane : offsets)
    for (auto a = plane.begin(); a != plane.end(); ++a)
      for (auto b = std::next(a); b != plane.end(); ++b) {
        if (a->second.count < min_points || b->second.count < min_points)
          continue;
        const double difference = a->second.mean() - b->second.mean();
        const auto place = [&](std::int32_t view) {
          return viewpoints[static_cast<std::size_t>(view)].cast<double>().eval();
        };
        pairs.push_back({(place(a->first) - place(b->first)).norm(),
                         (difference * difference - a->second.varianceOfMean() -
                          b->second.varianceOfMean()) /
                             2});
      }
  return pairs;
}

/** \brief Fits pose^2 + drift^2 h^2 / 2 to the pairs, as a line over h^2. */
MapAccuracy
fitted(std::vector<ViewPair> pairs)
{
  constexpr std::size_t bins = 8;
  std::sort(pairs.begin(), pairs.end(), [](const ViewPair& a, const ViewPair& b) {
    return std::pair(a.distance, a.half_square) < std::pair(b.distance, b.half_square);
  });
  double weights = 0, x_sum = 0, y_sum = 0, xx = 0, xy = 0;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    const std::size_t begin = bin * pairs.size() / bins,
                      end = (bin + 1) * pairs.size() / bins;
    double x = 0, y = 0;
    for (std::size_t k = begin; k < end; ++k) {
      x += pairs[k].distance * pairs[k].distance / 2;
      y += pairs[k].half_square;
    }
    const auto n = static_cast<double>(end - begin);
    x /= n;
    y /= n;
    // the spread of a mean of squares grows with it
    const double weight = n / std::pow(std::max(y, 1e-8), 2);
    weights += weight;
    x_sum += weight * x;
    y_sum += weight * y;
    xx += weight * x * x;
    xy += weight * x * y;
  }
  const double determinant = weights * xx - x_sum * x_sum;
  double slope = determinant > 0 ? (weights * xy - x_sum * y_sum) / determinant : 0;
  slope = std::max(slope, 0.0);
  const double base = std::max((y_sum - slope * x_sum) / weights, 0.0);
  MapAccuracy accuracy;
  accuracy.pose = std::sqrt(base);
  accuracy.drift = std::sqrt(slope);
  return accuracy;
}

} // namespace

MapAccuracy
measurePoseAccuracy(const CloudRows& cloud,
                    const PointLabels& labels,
                    const std::vector<PlanePatch>& planes,
                    const std::vector<Eigen::Vector3f>& viewpoints)
{
  constexpr std::size_t min_pairs = 8;
  if (!cloud || viewpoints.size() < 2)
    return {};
  std::vector<ViewPair> pairs =
      pairsOf(offsetsOf(cloud, labels, planes, viewpoints.size()), viewpoints);
  return pairs.size() < min_pairs ? MapAccuracy() : fitted(std::move(pairs));
}

void
setAccuracy(const MapAccuracy& accuracy, CompactMap& map)
{
  map.accuracy = accuracy;
  for (std::size_t p = 0; p < map.planes.size(); ++p)
    map.planes[p].covariance(2, 2) += acmap::poseVariance(map, p);
}

} // namespace pcl
