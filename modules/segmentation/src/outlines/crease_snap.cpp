#include "outlines/crease_snap.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::outlines {

CreaseSnap::CreaseSnap(const labeling::CandidateGrid& grid,
                       const std::vector<KnownPlane>& planes,
                       std::size_t own,
                       double reach)
: grid_(grid)
, frame_{planes[own].patch}
, reach_(reach)
, lines_(planes.size())
{
  constexpr double min_sine = 0.3; // lines of flatter junctions are too uncertain
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const Eigen::Vector4d& other = planes[p].patch.coefficients;
    const Eigen::Vector3d normal = other.head<3>();
    const Eigen::Vector2d flat(normal.dot(frame_.patch.axis_u),
                               normal.dot(frame_.patch.axis_v));
    const double length = flat.norm();
    if (p == own || length < min_sine)
      continue;
    lines_[p].normal = flat / length;
    lines_[p].offset = -(normal.dot(frame_.patch.center) + other[3]) / length;
  }
}

bool
CreaseSnap::corner(const Line& a,
                   const Line& b,
                   const Eigen::Vector2d& place,
                   Eigen::Vector2d& found) const
{
  const double determinant = a.normal.x() * b.normal.y() - a.normal.y() * b.normal.x();
  if (std::abs(determinant) < 0.3)
    return false;
  found = Eigen::Vector2d(a.offset * b.normal.y() - b.offset * a.normal.y(),
                          b.offset * a.normal.x() - a.offset * b.normal.x()) /
          determinant;
  return (found - place).norm() < 1.5 * reach_;
}

/** Is the other plane really near the position of the crease? Beside an opening the
 * intersection line continues without it. */
bool
CreaseSnap::isAt(const Eigen::Vector2d& place, std::size_t plane) const
{
  VoxelHit hit;
  if (!grid_.lattice().locate(frame_.lifted(place).cast<float>(), hit))
    return false;
  for (std::int32_t dx = -1; dx <= 1; ++dx)
    for (std::int32_t dy = -1; dy <= 1; ++dy)
      for (std::int32_t dz = -1; dz <= 1; ++dz) {
        const std::int32_t entry = grid_.find(
            voxelKey({hit.place[0] + dx, hit.place[1] + dy, hit.place[2] + dz}));
        if (entry >= 0 && grid_[entry].holds(static_cast<std::int32_t>(plane)))
          return true;
      }
  return false;
}

std::vector<std::size_t>
CreaseSnap::near(const Eigen::Vector2d& place, double reach) const
{
  std::vector<std::size_t> planes;
  for (std::size_t p = 0; p < lines_.size(); ++p) {
    const Line& line = lines_[p];
    const double distance = std::abs(line.distance(place));
    if (!line.normal.isZero() && distance <= reach && isAt(line.nearest(place), p))
      planes.push_back(p);
  }
  std::sort(planes.begin(), planes.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(lines_[a].distance(place)) < std::abs(lines_[b].distance(place));
  });
  return planes;
}

Eigen::Vector2d
CreaseSnap::moved(const Eigen::Vector2d& place, std::int32_t& line) const
{
  const std::vector<std::size_t> planes = near(place, reach_);
  line = planes.empty() ? -1 : static_cast<std::int32_t>(planes[0]);
  if (planes.empty())
    return place;
  Eigen::Vector2d found;
  if (planes.size() > 1 && corner(lines_[planes[0]], lines_[planes[1]], place, found))
    return found;
  return lines_[planes[0]].nearest(place);
}

Loop
CreaseSnap::operator()(const Loop& loop) const
{
  Loop snapped;
  std::vector<std::int32_t> line_of(loop.size(), -1);
  for (std::size_t i = 0; i < loop.size(); ++i)
    snapped.push_back(moved(loop[i], line_of[i]));
  bridge(loop, line_of, snapped);
  return snapped;
}

/** Moves short sequences of points between points on one line onto that line as well,
 * with a larger reach: the mesh is ragged where normals are mixed. */
void
CreaseSnap::bridge(const Loop& loop,
                   const std::vector<std::int32_t>& line_of,
                   Loop& snapped) const
{
  constexpr std::size_t longest = 6; // points
  const std::size_t size = loop.size();
  for (std::size_t i = 0; i < size; ++i) {
    if (line_of[i] < 0 || line_of[(i + 1) % size] >= 0)
      continue;
    std::size_t gap = 1;
    while (gap <= longest && line_of[(i + gap) % size] < 0)
      ++gap;
    if (gap > longest || line_of[(i + gap) % size] != line_of[i])
      continue;
    const Line& line = lines_[static_cast<std::size_t>(line_of[i])];
    for (std::size_t k = 1; k < gap; ++k)
      if (std::abs(line.distance(loop[(i + k) % size])) < 2 * reach_)
        snapped[(i + k) % size] = line.nearest(loop[(i + k) % size]);
  }
}

} // namespace pcl::acmap::outlines
