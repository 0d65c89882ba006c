#include <pcl/core/impl/zero_points.h>

namespace pcl::acmap {

std::optional<Indices>
withoutZeros(const PointView& points)
{
  constexpr std::size_t few = 1000; // one of so many
  std::size_t zeros = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    zeros += points[i].isZero(0);
  if (zeros * few <= points.size() || zeros == points.size())
    return std::nullopt;
  Indices kept;
  kept.reserve(points.size() - zeros);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!points[i].isZero(0))
      kept.push_back(static_cast<index_t>(i));
  return kept;
}

} // namespace pcl::acmap
