#include <pcl/core/impl/chart_clip.h>
#include <pcl/core/impl/size_text.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>

namespace pcl::acmap {

namespace {

// The points of a polygon are floats, but the frame of the chart is not. Smaller
// distances outside of the chart, in texels, are considered rounding errors.
constexpr double slack = 0.01;

/** One of the four sides. Points inside have sign * (place[axis] - limit) <= 0. */
struct TextureBorder {
  int axis;
  double sign;
  double limit;

  double
  excess(const ChartCorner& corner) const
  {
    return sign * (corner.place[axis] - limit);
  }
};

/** Intersection of an edge with a side; it is identical for both triangles that share
 * the edge. */
ChartCorner
meeting(ChartCorner a, ChartCorner b, const TextureBorder& side)
{
  const auto& p = a.point;
  const auto& q = b.point;
  if (std::lexicographical_compare(q.data(), q.data() + 3, p.data(), p.data() + 3))
    std::swap(a, b);
  const double share = side.excess(a) / (side.excess(a) - side.excess(b));
  ChartCorner corner{a.point + share * (b.point - a.point),
                     a.place + share * (b.place - a.place)};
  corner.place[side.axis] = side.limit;
  return corner;
}

std::vector<ChartCorner>
cutOff(const std::vector<ChartCorner>& polygon, const TextureBorder& side)
{
  if (std::none_of(polygon.begin(), polygon.end(), [&](const ChartCorner& corner) {
        return side.excess(corner) > slack;
      }))
    return polygon;
  std::vector<ChartCorner> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ChartCorner& here = polygon[i];
    const ChartCorner& next = polygon[(i + 1) % polygon.size()];
    const bool is_in = side.excess(here) <= 0;
    if (is_in)
      kept.push_back(here);
    if (is_in != (side.excess(next) <= 0))
      kept.push_back(meeting(here, next, side));
  }
  return kept;
}

} // namespace

std::string
faultOfFrame(const TextureChart& chart)
{
  constexpr double min_side = 1e-6;
  constexpr double max_side = 1e3;
  constexpr double min_sine = 1e-3; // limits rounding errors of texel coordinates
  const std::int64_t width = chart.colors.width;
  const std::int64_t height = chart.colors.height;
  if (width <= 0 || height <= 0 || width * height > maximum_texels)
    return "has " + sizeText(width, height) + " texels, 1 to 2^28 are legal";
  if (!chart.origin.allFinite())
    return "has an origin that is not finite";
  const double u = chart.texel_u.norm();
  const double v = chart.texel_v.norm();
  for (const double side : {u, v})
    if (!(side >= min_side && side <= max_side))
      return "has texels with a side that is not within 1e-6 m and 1e3 m";
  if (!(chart.texel_u.cross(chart.texel_v).norm() > min_sine * u * v))
    return "has texels without an area";
  return "";
}

ChartClip::ChartClip(const TextureChart& chart)
: origin_(chart.origin)
, size_(chart.colors.width, chart.colors.height)
{
  Eigen::Matrix<double, 3, 2> axes;
  axes << chart.texel_u, chart.texel_v;
  to_place_ = (axes.transpose() * axes).inverse() * axes.transpose();
}

std::vector<ChartCorner>
ChartClip::clipped(const std::array<Eigen::Vector3d, 3>& triangle) const
{
  std::vector<ChartCorner> polygon;
  for (const Eigen::Vector3d& point : triangle)
    polygon.push_back({point, to_place_ * (point - origin_)});
  for (const TextureBorder& side : {TextureBorder{0, -1, 0},
                                    TextureBorder{0, 1, size_.x()},
                                    TextureBorder{1, -1, 0},
                                    TextureBorder{1, 1, size_.y()}})
    polygon = cutOff(polygon, side);
  for (ChartCorner& corner : polygon)
    corner.place = corner.place.cwiseMax(0).cwiseMin(size_);
  return polygon;
}

} // namespace pcl::acmap
