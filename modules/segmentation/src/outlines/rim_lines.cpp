#include "outlines/rim_lines.h"

#include <pcl/core/impl/polyline_corners.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap::outlines {

namespace {

/** Sums over the middles of the sides up to a corner of a rim. */
struct RimSums {
  double count = 0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();

  Eigen::Matrix2d
  scatterSince(const RimSums& begin) const
  {
    const Eigen::Vector2d sum = first - begin.first;
    return second - begin.second - sum * sum.transpose() / (count - begin.count);
  }
};

std::vector<RimSums>
sumsOf(const Loop& rim)
{
  std::vector<RimSums> sums(rim.size());
  for (std::size_t i = 1; i < rim.size(); ++i) {
    const Eigen::Vector2d middle = (rim[i - 1] + rim[i]) / 2 - rim[0];
    sums[i].count = sums[i - 1].count + 1;
    sums[i].first = sums[i - 1].first + middle;
    sums[i].second = sums[i - 1].second + middle * middle.transpose();
  }
  return sums;
}

/** Sum of the squared distances from the best line, with the price of the line. */
double
costOf(const Eigen::Matrix2d& scatter, double noise)
{
  constexpr double axis_price = 8, other_price = 12;
  constexpr double weight = 0.5; // neighbouring sides are not independent
  const double scale = weight / (noise * noise);
  const double half = (scatter(0, 0) - scatter(1, 1)) / 2;
  const double smallest = (scatter(0, 0) + scatter(1, 1)) / 2 -
                          std::sqrt(half * half + scatter(0, 1) * scatter(0, 1));
  const double along_axis = std::min(scatter(0, 0), scatter(1, 1));
  return std::min(scale * along_axis + axis_price,
                  scale * std::max(smallest, 0.0) + other_price);
}

RimLine
lineOf(const std::vector<RimSums>& sums,
       const Loop& rim,
       std::size_t from,
       std::size_t to,
       double noise)
{
  const Eigen::Matrix2d scatter = sums[to].scatterSince(sums[from]);
  RimLine line{rim[0] + (sums[to].first - sums[from].first) /
                            (sums[to].count - sums[from].count),
               Eigen::Vector2d::UnitX(),
               from,
               to};
  Eigen::Matrix2d along_axes = scatter;
  along_axes(0, 1) = along_axes(1, 0) = 0;
  const bool is_on_axis = costOf(scatter, noise) >= costOf(along_axes, noise) - 1e-9;
  if (!is_on_axis)
    line.direction =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(scatter).eigenvectors().col(1);
  else if (scatter(1, 1) > scatter(0, 0))
    line.direction = Eigen::Vector2d::UnitY();
  if (line.direction.dot(rim[to] - rim[from]) < 0)
    line.direction = -line.direction;
  return line;
}

} // namespace

std::vector<std::size_t>
breakPoints(const Loop& rim)
{
  constexpr double tolerance = 0.9; // cells
  std::vector<std::uint8_t> is_kept(rim.size(), 0);
  is_kept.front() = is_kept.back() = 1;
  markKept(rim, 0, rim.size() - 1, tolerance, is_kept);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < rim.size(); ++i)
    if (is_kept[i])
      kept.push_back(i);
  return kept;
}

bool
RimLine::meet(const Eigen::Vector2d& point,
              const Eigen::Vector2d& along,
              Eigen::Vector2d& place) const
{
  constexpr double min_sine = 0.26;
  const double sine = cross(direction, along);
  if (std::abs(sine) < min_sine)
    return false;
  place = middle + cross(Eigen::Vector2d(point - middle), along) / sine * direction;
  return true;
}

std::vector<RimLine>
rimLines(const Loop& rim, double noise)
{
  constexpr std::size_t max_skipped = 120; // break points within a line
  const std::vector<std::size_t> points = breakPoints(rim);
  const std::vector<RimSums> sums = sumsOf(rim);
  std::vector<double> costs(points.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> before(points.size(), 0);
  costs[0] = 0;
  for (std::size_t j = 1; j < points.size(); ++j)
    for (std::size_t i = j - std::min(j, max_skipped); i < j; ++i) {
      const double cost =
          costs[i] + costOf(sums[points[j]].scatterSince(sums[points[i]]), noise);
      if (cost < costs[j]) {
        costs[j] = cost;
        before[j] = i;
      }
    }
  std::vector<RimLine> lines;
  for (std::size_t j = points.size() - 1; j > 0; j = before[j])
    lines.push_back(lineOf(sums, rim, points[before[j]], points[j], noise));
  std::reverse(lines.begin(), lines.end());
  return lines;
}

void
refineLines(const Loop& rim,
            const std::vector<Eigen::Vector2d>& points,
            double points_a_bin,
            std::vector<RimLine>& lines)
{
  constexpr double min_bin = 2, inside = 2, outside = 1.5, at_corners = 1; // cells
  constexpr double none = -std::numeric_limits<double>::infinity();
  std::vector<Eigen::Vector2d> near; // along the line, and outwards
  for (RimLine& line : lines) {
    const Eigen::Vector2d outwards(line.direction.y(), -line.direction.x());
    double begin = (rim[line.from] - line.middle).dot(line.direction);
    double end = (rim[line.to] - line.middle).dot(line.direction);
    if (end - begin > 4 * at_corners + min_bin) {
      begin += at_corners;
      end -= at_corners;
    }
    if (!(end > begin))
      continue;
    near.clear();
    for (const Eigen::Vector2d& point : points) {
      const double along = (point - line.middle).dot(line.direction);
      const double off = (point - line.middle).dot(outwards);
      if (along >= begin && along <= end && off >= -inside && off <= outside)
        near.emplace_back(along, off);
    }
    const auto count = static_cast<double>(near.size());
    const double bin = std::max(min_bin, points_a_bin * (end - begin) / count);
    std::vector<double> outermost(static_cast<std::size_t>((end - begin) / bin) + 1,
                                  none);
    for (const Eigen::Vector2d& point : near) {
      double& farthest = outermost[static_cast<std::size_t>((point.x() - begin) / bin)];
      farthest = std::max(farthest, point.y());
    }
    outermost.erase(std::remove(outermost.begin(), outermost.end(), none),
                    outermost.end());
    if (outermost.empty())
      continue;
    double sum = 0;
    for (const double off : outermost)
      sum += off;
    line.middle += sum / static_cast<double>(outermost.size()) * outwards;
  }
}

Loop
cornersOf(const std::vector<RimLine>& lines, const Loop& rim)
{
  constexpr double max_off = 6; // cells
  Loop corners;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    const Eigen::Vector2d& at = rim[lines[i].to];
    Eigen::Vector2d corner;
    if (lines[i].meet(lines[i + 1].middle, lines[i + 1].direction, corner) &&
        (corner - at).norm() <= max_off) {
      corners.push_back(corner);
      continue;
    }
    corners.push_back(lines[i].nearest(at));
    if ((lines[i + 1].nearest(at) - corners.back()).norm() > 0.5)
      corners.push_back(lines[i + 1].nearest(at));
  }
  return corners;
}

} // namespace pcl::acmap::outlines
