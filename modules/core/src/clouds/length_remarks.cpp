#include <pcl/core/impl/length_remarks.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/progress.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

namespace pcl::acmap {
namespace {

/** Scans of rooms and streets are denser than this, and smaller. */
constexpr double suspicious_spacing = 0.5;
constexpr double suspicious_extent = 1000.0;

/** Points that would be closer to each other than this, in a square as large as their
 * extent, are those of a large building: scans in millimetres have fewer. */
constexpr double dense_spacing = 0.15;

/** No building has this extent, not even in millimetres. */
constexpr double absurd_extent = 1000.0 * suspicious_extent;

/** Coordinates are floats; where their resolution is coarser than this, walls get
 * steps. */
constexpr double coarse_step = 0.001;

/** A point at this multiple of the extent from the others does not belong to the
 * scene. */
constexpr double far_extents = 100.0;

/** The 10 % and 90 % quantiles; reorders the values. */
std::pair<double, double>
quantiles(std::vector<float>& values)
{
  const std::size_t tenth = values.size() / 10;
  const auto low = values.begin() + static_cast<std::ptrdiff_t>(tenth);
  const auto high = values.end() - 1 - static_cast<std::ptrdiff_t>(tenth);
  std::nth_element(values.begin(), low, values.end());
  const float minimum = *low;
  if (low != high) // the others are already on their sides of the lower one
    std::nth_element(low + 1, high, values.end());
  return {minimum, *high};
}

std::string
farRemark(const PointView& points, const CloudExtent& extent)
{
  const Eigen::Vector3d center = (extent.minimum + extent.maximum) / 2;
  std::size_t count = 0, farthest = 0;
  double maximum = far_extents * extent.diagonal();
  const double limit = maximum;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double distance = (points[i].cast<double>() - center).norm();
    if (!(distance > limit))
      continue;
    ++count;
    if (distance > maximum) {
      maximum = distance;
      farthest = i;
    }
  }
  if (count == 0)
    return {};
  return (count == 1 ? "one point lies far away from all others, "
                     : std::to_string(count) + " points lie far away from all others, "
                                               "the farthest ") +
         std::string("at a distance of ") + shortNumber(maximum) + " m (point " +
         std::to_string(points.index(farthest)) + ")";
}

/** \param[in] median_spacing 0 if it is unknown */
bool
isSuspicious(double median_spacing, const CloudExtent& extent)
{
  const double diagonal = extent.diagonal();
  return median_spacing > suspicious_spacing ||
         (diagonal > suspicious_extent &&
          diagonal > dense_spacing * std::sqrt(extent.finite_points));
}

std::string
millimetreRemark(double median_spacing, const CloudExtent& of_points)
{
  const double extent = of_points.diagonal();
  if (!isSuspicious(median_spacing, of_points))
    return {};
  if (extent > absurd_extent)
    return "these cannot be metres: the points spread over " + shortNumber(extent) +
           " m (--scale tells the unit of the input)";
  // without the numbers of one cloud, so that a chain tells it once
  const std::string why =
      median_spacing > suspicious_spacing
          ? "stand more than " + shortNumber(suspicious_spacing) + " m apart"
          : "spread over more than " + shortNumber(suspicious_extent) + " m";
  return "looks like millimetres: the points " + why +
         "; a factor of 0.001 makes metres of millimetres (--scale 0.001), 0.01 of "
         "centimetres, 0.0254 of inches";
}

std::string
coarsenessRemark(double median_spacing, const CloudExtent& extent)
{
  const double farthest = std::max(extent.minimum.cwiseAbs().maxCoeff(),
                                   extent.maximum.cwiseAbs().maxCoeff());
  const double step = farthest * double{std::numeric_limits<float>::epsilon()};
  if (step <= coarse_step || isSuspicious(median_spacing, extent))
    return {};
  return "lies " + shortNumber(farthest) +
         " m from the origin, where coordinates are kept in steps of about " +
         shortNumber(step) + " m; take an offset off them";
}

/** Scenes in degrees of longitude and latitude are a thousandth of a degree wide, heights
 * are metres, and few places are near the meridians 0. */
std::string
degreesRemark(const CloudExtent& extent)
{
  constexpr double widest = 0.05, steepest = 100, far_from_zero = 20; // degrees, ratios
  const Eigen::Vector3d size = extent.maximum - extent.minimum,
                        middle = (extent.minimum + extent.maximum) / 2;
  const double wide = std::max(size.x(), size.y());
  if (!(wide < widest) || !(size.z() > steepest * wide) || std::abs(middle.x()) > 180 ||
      std::abs(middle.y()) > 90 ||
      middle.head<2>().cwiseAbs().minCoeff() < far_from_zero * wide)
    return {};
  return "looks like degrees of longitude and latitude: x and y spread over " +
         shortNumber(wide) + ", z over " + shortNumber(size.z()) +
         "; project them to metres first";
}

} // namespace

CloudExtent
cloudExtent(const PointView& points)
{
  constexpr std::size_t sampled = std::size_t{1} << 20, between_polls = 4096;
  const std::size_t step = points.size() / sampled + 1;
  CloudExtent extent;
  std::array<std::vector<float>, 3> values;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % between_polls == 0)
      pollRun();
    const Eigen::Vector3f point = points[i];
    if (point.allFinite() && extent.finite_points++ % step == 0)
      for (int axis = 0; axis < 3; ++axis)
        values[static_cast<std::size_t>(axis)].push_back(point[axis]);
  }
  for (int axis = 0; axis < 3 && extent.finite_points > 0; ++axis)
    std::tie(extent.minimum[axis], extent.maximum[axis]) =
        quantiles(values[static_cast<std::size_t>(axis)]);
  return extent;
}

std::vector<std::string>
lengthRemarks(const PointView& points, double median_spacing, bool is_unit_known)
{
  const CloudExtent extent = cloudExtent(points);
  std::vector<std::string> remarks;
  if (extent.diagonal() > 0)
    remarks.push_back(farRemark(points, extent));
  remarks.push_back(coarsenessRemark(median_spacing, extent));
  if (!is_unit_known)
    remarks.push_back(millimetreRemark(median_spacing, extent));
  remarks.push_back(degreesRemark(extent));
  remarks.erase(std::remove(remarks.begin(), remarks.end(), ""), remarks.end());
  return remarks;
}

} // namespace pcl::acmap
