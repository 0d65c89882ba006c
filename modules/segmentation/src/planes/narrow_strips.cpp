#include "planes/plane_growth.h"

#include "planes/plane_merge.h"

#include <Eigen/Geometry>

#include <cmath>
#include <map>

namespace pcl::acmap::planes {
namespace {

/** Reliable planes within two edges of the mesh, with the number of contacts. */
std::map<std::int32_t, std::size_t>
neighbouringPlanes(const CellGraph& graph,
                   const std::vector<GrownPlane>& planes,
                   const std::vector<std::int32_t>& owner,
                   const GrownPlane& strip)
{
  std::map<std::int32_t, std::size_t> counts;
  for (const std::int32_t member : strip.members)
    for (const std::int32_t near : graph.neighbours[static_cast<std::size_t>(member)])
      for (const std::int32_t far : graph.neighbours[static_cast<std::size_t>(near)]) {
        const std::int32_t plane = owner[static_cast<std::size_t>(far)];
        if (plane >= 0 &&
            planes[static_cast<std::size_t>(plane)].trust == PlaneTrust::Sure)
          ++counts[plane];
      }
  return counts;
}

Eigen::Vector3d
longAxis(const GrownPlane& strip)
{
  return fitPlane(strip.moments).long_axis;
}

} // namespace

bool
isNarrow(const Moments& moments, double spacing)
{
  constexpr double min_width = 1.2; // standard deviation of three points side by side
  return std::sqrt(fitPlane(moments).variances[1]) < min_width * spacing;
}

namespace {

/** Guesses the plane of one strip; it is unchanged if there is no larger plane near. */
void
raise(const CellGraph& graph,
      const std::vector<GrownPlane>& planes,
      const std::vector<std::int32_t>& owner,
      GrownPlane& strip)
{
  constexpr double across = 0.3; // cosine between strip and normal of its neighbour
  const Eigen::Vector3d along = longAxis(strip);
  const Eigen::Vector3d before = strip.plane.normal;
  std::size_t maximum = 0;
  for (const auto& [neighbour, count] :
       neighbouringPlanes(graph, planes, owner, strip)) {
    const Eigen::Vector3d& wall =
        planes[static_cast<std::size_t>(neighbour)].plane.normal;
    if (count <= maximum || std::abs(wall.dot(along)) > across)
      continue;
    maximum = count;
    const Eigen::Vector3d normal = along.cross(wall).normalized();
    strip.plane.normal = normal.dot(before) < 0 ? Eigen::Vector3d(-normal) : normal;
    strip.plane.offset = -strip.plane.normal.dot(strip.moments.mean());
  }
}

/** Are two strips on one line? The positions of their hypotheses are uncertain by half
 * a spacing.
 * \param[in] along long axis of \a a
 * \param[in] along_b that of \a b */
bool
areInLine(const GrownPlane& a,
          const GrownPlane& b,
          const Eigen::Vector3d& along,
          const Eigen::Vector3d& along_b,
          double spacing)
{
  constexpr double parallel = 0.97, aside = 2.5;
  const Eigen::Vector3d way = b.moments.mean() - a.moments.mean();
  return std::abs(along.dot(along_b)) > parallel &&
         (way - along.dot(way) * along).norm() < aside * spacing &&
         a.plane.normal.dot(b.plane.normal) > 0.5;
}

/** Is the strip along the crease of two larger planes? Then it is the rounding of that
 * crease, not a surface between them. */
bool
isRounding(const CellGraph& graph,
           const std::vector<GrownPlane>& planes,
           const std::vector<std::int32_t>& owner,
           const GrownPlane& strip)
{
  constexpr double parallel = 0.9, along_crease = 0.9, near = 2.5;
  const Eigen::Vector3d along = longAxis(strip);
  const Eigen::Vector3d middle = strip.moments.mean();
  std::vector<const Plane*> beside;
  for (const auto& [neighbour, count] :
       neighbouringPlanes(graph, planes, owner, strip)) {
    const Plane& plane = planes[static_cast<std::size_t>(neighbour)].plane;
    if (std::abs(plane.distance(middle)) < near * graph.spacing)
      beside.push_back(&plane);
  }
  for (const Plane* a : beside)
    for (const Plane* b : beside)
      if (std::abs(a->normal.dot(b->normal)) < parallel &&
          std::abs(a->normal.cross(b->normal).normalized().dot(along)) > along_crease)
        return true;
  return false;
}

void
joinStrips(double spacing, std::vector<GrownPlane>& planes)
{
  std::vector<std::size_t> strips;
  std::vector<Eigen::Vector3d> axes;
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (planes[i].trust == PlaneTrust::Strip) {
      strips.push_back(i);
      axes.push_back(longAxis(planes[i]));
    }
  for (std::size_t i = 0; i < strips.size(); ++i) {
    GrownPlane& strip = planes[strips[i]];
    for (std::size_t j = i + 1; j < strips.size(); ++j) {
      GrownPlane& other = planes[strips[j]];
      if (strip.members.empty() || other.members.empty() ||
          !areInLine(strip, other, axes[i], axes[j], spacing))
        continue;
      takeIn(strip, other, strip.plane);
      axes[i] = longAxis(strip);
    }
  }
  dropEmpty(planes);
}

} // namespace

void
raiseStrips(const CellGraph& graph, std::vector<GrownPlane>& planes)
{
  joinStrips(graph.spacing, planes);
  const std::vector<std::int32_t> owner = ownersOf(graph, planes);
  for (GrownPlane& strip : planes)
    if (strip.trust != PlaneTrust::Strip)
      continue;
    else if (isRounding(graph, planes, owner, strip))
      strip.members.clear();
    else
      raise(graph, planes, owner, strip);
  dropEmpty(planes);
}

} // namespace pcl::acmap::planes
