#include <pcl/core/exceptions.h>
#include <pcl/core/planar_scan.h>
#include <pcl/exceptions.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

namespace pcl {
namespace {

constexpr int reach = 3; ///< neighbours on each side of an echo
/** \brief Minimum cosine of the angle of incidence on a wall. */
constexpr double min_cosine = .15;

/** An echo of a scan. */
struct Echo {
  std::size_t beam = 0;
  Eigen::Vector2d place; ///< x, z
};

std::vector<Echo>
echoesOf(const PlanarScan& scan)
{
  std::vector<Echo> echoes;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const float range = scan.ranges[i];
    if (!(range > 0 && range < scan.maximum_range))
      continue;
    const double angle = scan.first_angle + static_cast<double>(i) * scan.angle_step;
    echoes.push_back({i, range * Eigen::Vector2d(std::sin(angle), std::cos(angle))});
  }
  return echoes;
}

/** Can two neighbouring echoes be on the same wall? Not if the angle of incidence would
 * be too large. */
bool
areConnected(const Echo& a, const Echo& b, double step)
{
  const double beams = std::abs(static_cast<double>(a.beam) - double(b.beam));
  const double nearer = std::min(a.place.norm(), b.place.norm());
  const double limit = std::max(0.15, nearer * std::abs(step) * beams / min_cosine);
  return beams <= reach && (a.place - b.place).norm() < limit;
}

/** Normal of the line through the echoes around one of them, towards the laser; 0 if
 * they are not on a line. */
Eigen::Vector2d
normalAt(const std::vector<Echo>& echoes, std::size_t at, double step)
{
  std::size_t first = at;
  std::size_t last = at;
  while (first > 0 && first + reach > at &&
         areConnected(echoes[first], echoes[first - 1], step))
    --first;
  while (last + 1 < echoes.size() && last < at + reach &&
         areConnected(echoes[last], echoes[last + 1], step))
    ++last;
  const auto count = static_cast<double>(last - first + 1);
  if (count < 3)
    return Eigen::Vector2d::Zero();
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (std::size_t i = first; i <= last; ++i)
    mean += echoes[i].place / count;
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (std::size_t i = first; i <= last; ++i)
    spread += (echoes[i].place - mean) * (echoes[i].place - mean).transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(spread);
  constexpr double flat = 0.04; // thickness over length, squared
  if (!(solver.eigenvalues()[0] < flat * solver.eigenvalues()[1]))
    return Eigen::Vector2d::Zero();
  const Eigen::Vector2d normal = solver.eigenvectors().col(0);
  return normal.dot(echoes[at].place) > 0 ? -normal : normal;
}

std::size_t
countBetween(const std::vector<float>& readings, double minimum, double below)
{
  return static_cast<std::size_t>(
      std::count_if(readings.begin(), readings.end(), [=](float reading) {
        return reading >= minimum && reading < below;
      }));
}

/** \brief Finds the reading above which readings are not distances. Lasers report a
 * missing echo by a large value or a few similar ones (SICK: 81.83, 81.87, 81.91 m, or
 * 32.759 to 32.767 m if they count millimetres), so that many beams have the same
 * reading, and hardly any beams a slightly smaller one.
 * \param[in] readings metres, finite, positive; reordered */
float
rangeWithoutEcho(std::vector<float>& readings)
{
  constexpr double width = 0.01; // relative to the reading
  // over the number of slightly smaller readings
  constexpr std::size_t clear_excess = 10;
  constexpr std::size_t beams_to_a_wild_one = 10000;
  if (readings.empty())
    return 0.0F;
  const auto top = readings.end() - 1 - readings.size() / beams_to_a_wild_one;
  std::nth_element(readings.begin(), top, readings.end());
  const double reading = *top;
  const double minimum = (1.0 - width) * reading;
  const std::size_t here =
      countBetween(readings, minimum, std::numeric_limits<double>::infinity());
  const std::size_t less =
      countBetween(readings, (1.0 - 2.0 * width) * reading, minimum);
  if (here > clear_excess * (less + 1))
    return static_cast<float>(minimum);
  return std::nextafter(*std::max_element(top, readings.end()),
                        std::numeric_limits<float>::infinity());
}

} // namespace

void
excludeMissingEchoes(std::vector<PlanarScan>& scans)
{
  std::vector<float> readings;
  for (const PlanarScan& scan : scans)
    std::copy_if(scan.ranges.begin(),
                 scan.ranges.end(),
                 std::back_inserter(readings),
                 [&](float range) {
                   return std::isfinite(range) && range > 0.0F &&
                          range < scan.maximum_range;
                 });
  const float maximum = rangeWithoutEcho(readings);
  for (PlanarScan& scan : scans)
    scan.maximum_range = std::min(scan.maximum_range, maximum);
}

PlanarScanPoints
pointsOf(const PlanarScan& scan)
{
  if (!std::isfinite(scan.first_angle) || !std::isfinite(scan.angle_step))
    throw acmap::BadArgument("the angles of a scan must be finite");
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Echo> echoes = echoesOf(scan);
  PlanarScanPoints points;
  points.cloud.reset(new PointCloud<PointNormal>);
  points.missing_beams = scan.ranges.size() - echoes.size();
  for (std::size_t i = 0; i < echoes.size(); ++i) {
    const Eigen::Vector2d& place = echoes[i].place;
    const Eigen::Vector2d normal = normalAt(echoes, i, scan.angle_step);
    const bool lies_on_line = normal.squaredNorm() > 0;
    PointNormal point;
    point.getVector3fMap() << static_cast<float>(place[0]), 0,
        static_cast<float>(place[1]);
    point.getNormalVector3fMap().setConstant(none);
    if (lies_on_line)
      point.getNormalVector3fMap() << static_cast<float>(normal[0]), 0,
          static_cast<float>(normal[1]);
    points.cloud->push_back(point);
    const double range = place.norm();
    const double cosine =
        lies_on_line ? std::max(min_cosine, -normal.dot(place) / range) : 1.0;
    const double length = range * std::abs(scan.angle_step) / cosine;
    points.weights.push_back(static_cast<float>(std::clamp(length, 0.02, 0.5)));
  }
  return points;
}

} // namespace pcl
