#include "texturing/pinhole.h"

#include <cmath>

namespace pcl::acmap::texturing {
namespace {

/** Least-squares fit of value = slope * x + offset. */
class Line {
public:
  void
  add(double x, double value)
  {
    ++count_;
    x_ += x;
    value_ += value;
    xx_ += x * x;
    x_value_ += x * value;
    value_value_ += value * value;
  }

  double
  slope() const
  {
    return (x_value_ - x_ * value_ / count_) / (xx_ - x_ * x_ / count_);
  }

  double
  offset() const
  {
    return (value_ - slope() * x_) / count_;
  }

  double
  count() const
  {
    return count_;
  }

  /** Root mean square of the residuals. */
  double
  deviation() const
  {
    const double all = value_value_ - value_ * value_ / count_;
    const double explained = slope() * (x_value_ - x_ * value_ / count_);
    return std::sqrt(std::max(all - explained, 0.0) / count_);
  }

private:
  double count_ = 0, x_ = 0, value_ = 0, xx_ = 0, x_value_ = 0, value_value_ = 0;
};

} // namespace

std::optional<Pinhole>
pinholeOf(const ColoredView& view)
{
  const auto width = static_cast<std::size_t>(view.width);
  if (width < 2 || view.points.size() % width != 0 || view.points.size() < 2 * width)
    return std::nullopt;
  Line columns, rows;
  for (std::size_t i = 0; i < view.points.size(); ++i) {
    const Eigen::Vector3d point = view.points[i].cast<double>();
    if (!point.allFinite() || !(point.z() > 0))
      continue;
    columns.add(point.x() / point.z(), static_cast<double>(i % width));
    rows.add(point.y() / point.z(), static_cast<double>(i / width));
  }
  constexpr double min_points = 100, max_deviation = 1; // px
  if (columns.count() < min_points)
    return std::nullopt;
  Pinhole camera{columns.slope(),
                 rows.slope(),
                 columns.offset(),
                 rows.offset(),
                 view.width,
                 static_cast<int>(view.points.size() / width)};
  const bool is_pinhole = camera.fx > 0 && camera.fy > 0 &&
                          columns.deviation() < max_deviation &&
                          rows.deviation() < max_deviation;
  return is_pinhole ? std::optional<Pinhole>(camera) : std::nullopt;
}

} // namespace pcl::acmap::texturing
