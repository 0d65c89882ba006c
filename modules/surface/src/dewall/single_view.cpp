#include <pcl/surface/impl/dewall_kernel.h>

#include <Eigen/Geometry>

namespace pcl::acmap {

namespace {

/** \brief Minimum number of triples of neighbouring pixels for a decision. */
constexpr std::size_t min_triples = 100;

} // namespace

bool
isSingleView(const PointView& view, std::size_t width, const Eigen::Vector3d& origin)
{
  if (width < 2 || view.size() < 2 * width || view.size() % width != 0)
    return false;
  const auto ray = [&](std::size_t i) -> Eigen::Vector3d {
    return view[i].cast<double>() - origin;
  };
  std::size_t left_handed = 0, triples = 0;
  for (std::size_t i = 0; i + width < view.size(); ++i) {
    if (i % width + 1 == width)
      continue;
    const double volume = ray(i).cross(ray(i + 1)).dot(ray(i + width));
    if (!std::isfinite(volume) || volume == 0)
      continue;
    ++triples;
    left_handed += volume < 0;
  }
  return triples >= min_triples &&
         std::min(left_handed, triples - left_handed) * 100 <= triples;
}

} // namespace pcl::acmap
