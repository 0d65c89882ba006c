#include "chain/pinhole.h"

#include <cmath>
#include <cstddef>

namespace pcl::acmap {

namespace {

/** \brief Straight line fitted to pairs (slope of a ray, pixel). */
class RayLine {
public:
  void
  add(double slope, double pixel)
  {
    n_ += 1;
    s_ += slope;
    p_ += pixel;
    ss_ += slope * slope;
    sp_ += slope * pixel;
    pp_ += pixel * pixel;
  }

  bool
  isDetermined() const
  {
    return n_ >= 100 && variance() > 1e-6;
  }

  double
  focalLength() const
  {
    return (sp_ / n_ - s_ / n_ * p_ / n_) / variance();
  }

  double
  center() const
  {
    return (p_ - focalLength() * s_) / n_;
  }

  /** \brief Mean squared distance from the line, squared pixels. */
  double
  residual() const
  {
    const double covariance = sp_ / n_ - s_ / n_ * p_ / n_;
    return pp_ / n_ - p_ / n_ * p_ / n_ - covariance * covariance / variance();
  }

private:
  double
  variance() const
  {
    return ss_ / n_ - s_ / n_ * s_ / n_;
  }

  double n_ = 0, s_ = 0, p_ = 0, ss_ = 0, sp_ = 0, pp_ = 0;
};

} // namespace

std::optional<Pinhole>
fitPinhole(const CameraView& view)
{
  constexpr int step = 5;
  constexpr double max_residual = 0.25; // squared pixels
  RayLine across, down;
  for (int row = 0; row < view.image.height; row += step)
    for (int column = 0; column < view.image.width; column += step) {
      const Eigen::Vector3d point =
          view.points[static_cast<std::size_t>(row) * view.image.width + column]
              .cast<double>();
      if (!point.allFinite() || point.z() <= 0)
        continue;
      across.add(point.x() / point.z(), column);
      down.add(point.y() / point.z(), row);
    }
  if (!across.isDetermined() || !down.isDetermined())
    return std::nullopt;
  if (!(across.residual() < max_residual) || !(down.residual() < max_residual))
    return std::nullopt;
  const Pinhole pinhole{{across.focalLength(), down.focalLength()},
                        {across.center(), down.center()}};
  if (!(pinhole.focal_length.minCoeff() > 1))
    return std::nullopt;
  return pinhole;
}

} // namespace pcl::acmap
