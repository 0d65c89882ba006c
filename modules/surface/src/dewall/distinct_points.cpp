#include "mesh_steps.h"

#include <cstring>

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

std::uint64_t
hash(const std::array<float, 3>& position)
{
  std::uint64_t h = 0x9e3779b97f4a7c15u;
  for (const float value : position) {
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    h = (h ^ bits) * 0xbf58476d1ce4e5b9u;
    h ^= h >> 29;
  }
  return h;
}

/** \brief Open-addressing set of positions. */
class PositionSet {
public:
  explicit PositionSet(std::size_t maximum)
  {
    std::size_t slots = 16;
    while (slots < 2 * maximum)
      slots *= 2;
    slots_.assign(slots, -1);
  }

  /** \brief Returns false if a point of the list already has this position. */
  bool
  insert(const std::vector<SourcePoint>& points, const std::array<float, 3>& position)
  {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t slot = hash(position) & mask;; slot = (slot + 1) & mask) {
      if (slots_[slot] < 0) {
        slots_[slot] = static_cast<std::int32_t>(points.size());
        return true;
      }
      if (points[static_cast<std::size_t>(slots_[slot])].position == position)
        return false;
    }
  }

private:
  std::vector<std::int32_t> slots_;
};

} // namespace

std::vector<SourcePoint>
distinctPoints(const PointView& view, DeWallReport& report)
{
  report.points = view.size();
  std::vector<SourcePoint> points;
  points.reserve(view.size());
  PositionSet seen(view.size());
  for (std::size_t i = 0; i < view.size(); ++i) {
    const Eigen::Vector3f p = view[i];
    if (!p.allFinite()) {
      ++report.invalid_points;
      continue;
    }
    // Adding zero converts -0 to 0.
    const std::array<float, 3> position{p.x() + 0.0f, p.y() + 0.0f, p.z() + 0.0f};
    if (seen.insert(points, position))
      points.push_back({position, view.index(i)});
    else
      ++report.duplicate_points;
  }
  return points;
}

} // namespace pcl::acmap::ACMAP_DEWALL
