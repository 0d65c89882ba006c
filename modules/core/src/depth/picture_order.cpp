#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/depth_view.h>
#include <pcl/core/impl/quantile.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap {

namespace depth {
namespace {

constexpr std::size_t min_lines = 20;
constexpr std::size_t max_lines = 10000;
constexpr std::size_t min_points = 1000;

/** That many points of a picture have enough whole rows to show its lines. The rays of a
 * large cloud that is no picture need not be kept and sorted beyond them. */
constexpr std::size_t first_points = 256 * 1024;
static_assert(first_points > min_lines * max_lines);

/** Columns or rows of an image: one coordinate of the rays, evenly spaced. */
struct PictureLines {
  double first = 0;
  double pitch = 0;
  std::size_t number = 0;

  /** Index of the line closest to a ray. */
  std::size_t
  lineOf(double ray) const
  {
    return static_cast<std::size_t>(std::lround((ray - first) / pitch));
  }
};

/** Centres of the runs of sorted values that are separated by gaps; empty if there are
 * more runs than an image has lines. */
std::vector<double>
middlesOfRuns(const std::vector<double>& sorted)
{
  // radians at the image centre; coordinates are rounded to 1e-6 of this, or to the
  // number of digits of a text file
  constexpr double gap = 1e-4;
  std::vector<double> middles;
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= sorted.size(); ++i) {
    if (i < sorted.size() && sorted[i] - sorted[i - 1] < gap)
      continue;
    middles.push_back((sorted[begin] + sorted[i - 1]) / 2);
    begin = i;
    if (middles.size() > max_lines)
      return {};
  }
  return middles;
}

std::optional<PictureLines>
findLines(std::vector<double> rays)
{
  std::sort(rays.begin(), rays.end());
  const std::vector<double> middles = middlesOfRuns(rays);
  if (middles.size() < min_lines)
    return std::nullopt;
  std::vector<double> gaps;
  for (std::size_t i = 1; i < middles.size(); ++i)
    gaps.push_back(middles[i] - middles[i - 1]);
  PictureLines lines{middles.front(), medianOf(gaps), 0};
  // computed over the whole image, because the error of a single gap would accumulate
  const double span = middles.back() - middles.front();
  const double steps = std::round(span / lines.pitch);
  if (!(steps < static_cast<double>(max_lines)))
    return std::nullopt;
  lines.pitch = span / steps;
  lines.number = static_cast<std::size_t>(steps) + 1;
  std::size_t even = 0;
  for (const double middle : middles) {
    const double place = (middle - lines.first) / lines.pitch;
    constexpr double tolerance = 0.2; // pixels
    even += std::abs(place - std::round(place)) < tolerance ? 1 : 0;
  }
  if (20 * even < 19 * middles.size())
    return std::nullopt;
  return lines;
}

} // namespace
} // namespace depth

std::vector<Eigen::Vector3f>
PictureOrder::arrange(const PointView& points) const
{
  std::vector<Eigen::Vector3f> arranged(
      width * height,
      Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  for (std::size_t i = 0; i < pixels.size(); ++i)
    if (pixels[i] != nowhere)
      arranged[pixels[i]] = points[i];
  return arranged;
}

PCLPointCloud2
PictureOrder::arrange(const PCLPointCloud2& cloud) const
{
  PCLPointCloud2 arranged;
  arranged.header = cloud.header;
  arranged.fields = cloud.fields;
  arranged.is_bigendian = cloud.is_bigendian;
  arranged.point_step = cloud.point_step;
  arranged.width = static_cast<std::uint32_t>(width);
  arranged.height = static_cast<std::uint32_t>(height);
  arranged.row_step = arranged.width * cloud.point_step;
  arranged.is_dense = 0;
  arranged.data.assign(width * height * cloud.point_step, 0);
  const std::size_t position = findField(cloud, "x")->offset;
  const Eigen::Vector3f none =
      Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  for (std::size_t pixel = 0; pixel < width * height; ++pixel)
    std::memcpy(&arranged.data[pixel * cloud.point_step + position],
                none.data(),
                3 * sizeof(float));
  for (std::size_t i = 0; i < pixels.size(); ++i)
    if (pixels[i] != nowhere)
      std::memcpy(&arranged.data[pixels[i] * cloud.point_step],
                  &cloud.data[i * cloud.point_step],
                  cloud.point_step);
  return arranged;
}

PointLabels
PictureOrder::labelsOfPoints(const PointLabels& of_pixels) const
{
  PointLabels labels;
  labels.reserve(pixels.size());
  for (const std::size_t pixel : pixels)
    labels.push_back(pixel == nowhere ? -1 : of_pixels[pixel]);
  return labels;
}

std::optional<PictureOrder>
findPictureOrder(const PointView& points)
{
  using namespace depth;
  std::vector<double> x, y;
  std::vector<std::size_t> measured;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d point = points[i].cast<double>();
    if (!point.allFinite() || !(point.z() > 0))
      continue;
    x.push_back(point.x() / point.z());
    y.push_back(point.y() / point.z());
    measured.push_back(i);
    if (measured.size() == first_points && (!findLines(x) || !findLines(y)))
      return std::nullopt;
  }
  if (measured.size() < min_points)
    return std::nullopt;
  const std::optional<PictureLines> columns = findLines(x);
  const std::optional<PictureLines> rows = columns ? findLines(y) : std::nullopt;
  if (!rows)
    return std::nullopt;
  PictureOrder order;
  order.width = columns->number;
  order.height = rows->number;
  order.pixels.assign(points.size(), PictureOrder::nowhere);
  std::vector<bool> is_taken(order.width * order.height, false);
  std::size_t doubled = 0;
  for (std::size_t k = 0; k < measured.size(); ++k) {
    const std::size_t pixel = rows->lineOf(y[k]) * order.width + columns->lineOf(x[k]);
    doubled += is_taken[pixel] ? 1 : 0;
    is_taken[pixel] = true;
    order.pixels[measured[k]] = pixel;
  }
  // several views of one camera, or points on a lattice
  if (100 * doubled > measured.size())
    return std::nullopt;
  return order;
}

std::optional<PictureView>
PictureView::find(const PointView& points, std::size_t width)
{
  PictureView picture(points, width);
  if (points.size() == 0 || (width > 0 && width < points.size()))
    return picture;
  picture.order_ = findPictureOrder(points);
  if (!picture.order_)
    return std::nullopt;
  picture.arranged_ = picture.order_->arrange(points);
  picture.width_ = picture.order_->width;
  return picture;
}

} // namespace pcl::acmap
