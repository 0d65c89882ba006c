#include "outlines/patch_outlines.h"

#include "outlines/crease_snap.h"
#include "outlines/face_loops.h"
#include "outlines/loop.h"

#include <algorithm>

namespace pcl::acmap {

namespace outlines {
namespace {

using Triangles = TriangleMesh::Triangles;

/** For each wanted plane the triangles that have all their vertices on it. */
std::vector<Triangles>
trianglesOfPlanes(const Triangles& triangles,
                  const std::vector<bool>& is_wanted,
                  const KnownPlanes& known)
{
  std::vector<Triangles> of_planes(known.planes.size());
  const auto label = [&](std::int32_t corner) {
    return known.labels[static_cast<std::size_t>(corner)];
  };
  for (const TriangleMesh::Triangle& t : triangles) {
    const std::int32_t plane = label(t[0]);
    if (plane >= 0 && is_wanted[static_cast<std::size_t>(plane)] &&
        plane == label(t[1]) && plane == label(t[2]))
      of_planes[static_cast<std::size_t>(plane)].push_back(t);
  }
  return of_planes;
}

/** Marks the points within eight spacings of wanted planes, which is farther than their
 * outlines are moved, and some beyond. */
std::vector<bool>
pointsNear(const std::vector<bool>& is_wanted, const KnownPlanes& known)
{
  const VoxelLattice lattice(known.points, 8 * known.spacing);
  std::vector<VoxelKey> keys(known.labels.size()), near;
  VoxelHit hit;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (!lattice.locate(known.points[i], hit))
      continue;
    keys[i] = voxelKey(hit.place);
    if (known.labels[i] >= 0 && is_wanted[static_cast<std::size_t>(known.labels[i])] &&
        (near.empty() || near.back() != keys[i]))
      near.push_back(keys[i]);
  }
  const auto tidy = [&] {
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
  };
  tidy();
  for (std::size_t i = near.size(); i-- > 0;) {
    const VoxelPlace place = placeOf(near[i]);
    for (std::int32_t dx = -1; dx <= 1; ++dx)
      for (std::int32_t dy = -1; dy <= 1; ++dy)
        for (std::int32_t dz = -1; dz <= 1; ++dz)
          near.push_back(voxelKey({place[0] + dx, place[1] + dy, place[2] + dz}));
  }
  tidy();
  std::vector<bool> is_near(keys.size());
  bool was_near = false;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (i == 0 || keys[i] != keys[i - 1])
      was_near = std::binary_search(near.begin(), near.end(), keys[i]);
    is_near[i] = was_near;
  }
  return is_near;
}

/** Projects the vertices into the plane and renumbers the triangles accordingly; makes
 * them counter-clockwise. */
std::vector<Eigen::Vector2d>
flatten(const PointView& points, const PatchFrame& frame, Triangles& triangles)
{
  std::vector<std::int32_t> corners;
  for (const TriangleMesh::Triangle& t : triangles)
    corners.insert(corners.end(), t.begin(), t.end());
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  std::vector<Eigen::Vector2d> places;
  for (const std::int32_t corner : corners)
    places.push_back(
        frame.flat(points[static_cast<std::size_t>(corner)].cast<double>()));
  for (TriangleMesh::Triangle& t : triangles) {
    for (std::int32_t& corner : t)
      corner = static_cast<std::int32_t>(
          std::lower_bound(corners.begin(), corners.end(), corner) - corners.begin());
    const auto place = [&](std::size_t k) {
      return places[static_cast<std::size_t>(t[k])];
    };
    if (signedArea({place(0), place(1), place(2)}) < 0)
      std::swap(t[1], t[2]);
  }
  return places;
}

/** A boundary loop moved onto the creases and simplified. */
Loop
shaped(const Loop& loop, const CreaseSnap& snap, double tolerance)
{
  Loop snapped;
  for (const Eigen::Vector2d& moved : snap(loop))
    if (snapped.empty() || (moved - snapped.back()).norm() > 1e-9)
      snapped.push_back(moved);
  return uncrossed(simplified(snapped, tolerance));
}

std::vector<Eigen::Vector3f>
lift(const Loop& loop, const PatchFrame& frame)
{
  std::vector<Eigen::Vector3f> points;
  for (const Eigen::Vector2d& place : loop)
    points.push_back(frame.lifted(place).cast<float>());
  return points;
}

} // namespace

void
setPolygons(const std::vector<Loop>& shaped,
            double min_area,
            double spacing,
            PlanePatch& patch)
{
  std::vector<Loop> large;
  for (const Loop& loop : shaped)
    if (std::abs(signedArea(loop)) >= min_area)
      large.push_back(loop);
  const std::vector<Loop> loops = disentangled(large, 1e-3 * spacing);
  const PatchFrame frame{patch};
  const Nesting nesting = nestingOf(loops, min_area);
  for (const std::size_t rim : nesting.rims) {
    patch.polygons.push_back({lift(loops[rim], frame), {}});
    patch.area += signedArea(loops[rim]);
  }
  for (const auto& [hole, rim] : nesting.holes) {
    patch.polygons[rim].holes.push_back(lift(loops[hole], frame));
    patch.area += signedArea(loops[hole]);
  }
}

namespace {

std::vector<Loop>
meshLoops(const PointView& points,
          const CreaseSnap& snap,
          double tolerance,
          const PatchFrame& frame,
          Triangles triangles)
{
  const std::vector<Eigen::Vector2d> places = flatten(points, frame, triangles);
  std::vector<Loop> loops;
  for (const std::vector<std::int32_t>& rim : faceLoops(triangles, places)) {
    Loop loop;
    for (const std::int32_t corner : rim)
      loop.push_back(places[static_cast<std::size_t>(corner)]);
    loops.push_back(shaped(loop, snap, tolerance));
    if (loops.back().size() < 3)
      loops.pop_back();
  }
  return loops;
}

/** A strip, or a plane that is too small for an outline, as rectangles: the mesh is too
 * coarse for its width, but it shows where along its axis the strip exists. */
std::vector<Loop>
rectangles(const KnownPlanes& known, std::size_t own, const CreaseSnap& snap)
{
  const PatchFrame frame{known.planes[own].patch};
  std::vector<double> along;
  for (std::size_t i = 0; i < known.labels.size(); ++i)
    if (known.labels[i] == static_cast<std::int32_t>(own))
      along.push_back(frame.flat(known.points[i].cast<double>()).x());
  std::sort(along.begin(), along.end());
  constexpr double longest_gap = 4; // spacings
  const double half_width = known.planes[own].half_size.y();
  std::vector<Loop> loops;
  for (std::size_t begin = 0, end = 0; begin < along.size(); begin = end) {
    for (end = begin + 1; end < along.size() &&
                          along[end] - along[end - 1] < longest_gap * known.spacing;)
      ++end;
    const double from = along[begin] - known.spacing / 2;
    const double to = along[end - 1] + known.spacing / 2;
    const Loop plain{
        {from, -half_width}, {to, -half_width}, {to, half_width}, {from, half_width}};
    Loop loop;
    std::int32_t line;
    for (const Eigen::Vector2d& corner : plain)
      loop.push_back(snap.moved(corner, line));
    if (signedArea(loop) < signedArea(plain) / 2)
      loop = plain; // both sides were moved onto the same line
    loops.push_back(std::move(loop));
  }
  return loops;
}

/** For each plane the area of the faces that have two or three corners on it. */
std::vector<double>
areasOfPlanes(const Triangles& triangles, const KnownPlanes& known)
{
  std::vector<double> areas(known.planes.size(), 0.0);
  for (const TriangleMesh::Triangle& t : triangles) {
    const auto label = [&](std::size_t k) {
      return known.labels[static_cast<std::size_t>(t[k])];
    };
    const std::int32_t plane =
        label(0) == label(1) || label(0) == label(2) ? label(0) : label(1);
    if (plane < 0 || (plane != label(0) && plane != label(2)))
      continue;
    const auto corner = [&](std::size_t k) -> Eigen::Vector3d {
      return known.points[static_cast<std::size_t>(t[k])].cast<double>();
    };
    areas[static_cast<std::size_t>(plane)] +=
        (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 2;
  }
  return areas;
}

double
areaOf(const std::vector<Loop>& loops)
{
  double area = 0;
  for (const Loop& loop : loops)
    area += std::abs(signedArea(loop));
  return area;
}

} // namespace

MeshOutlines::MeshOutlines(const TriangleMesh::Triangles& triangles,
                           const std::vector<bool>& is_wanted,
                           const KnownPlanes& known,
                           double most_of_faces)
: known_(known)
, most_of_faces_(most_of_faces)
{
  if (std::find(is_wanted.begin(), is_wanted.end(), true) == is_wanted.end())
    return;
  grid_.emplace(known, known.spacing, 0, pointsNear(is_wanted, known));
  of_planes_ = trianglesOfPlanes(triangles, is_wanted, known);
  seen_areas_ = areasOfPlanes(triangles, known);
}

void
MeshOutlines::outline(std::size_t plane, PlanePatch& patch) const
{
  const KnownPlane& own = known_.planes[plane];
  const double spacing = known_.spacing;
  const CreaseSnap snap(*grid_, known_.planes, plane, 2 * spacing);
  if (own.trust != PlaneTrust::Strip)
    setPolygons(meshLoops(known_.points, snap, spacing, {own.patch}, of_planes_[plane]),
                4 * spacing * spacing,
                spacing,
                patch);
  if (!patch.polygons.empty())
    return;
  const std::vector<Loop> loops = rectangles(known_, plane, snap);
  if (areaOf(loops) <= most_of_faces_ * seen_areas_[plane])
    setPolygons(loops, 0, spacing, patch);
}

} // namespace outlines

void
outlineFromMesh(const TriangleMesh::Triangles& triangles, KnownPlanes& known)
{
  for (KnownPlane& plane : known.planes)
    plane.patch.area = 0; // of the outlines from here on; before, of its members
  if (known.planes.empty() || !(known.spacing > 0) || triangles.empty())
    return;
  const std::vector<bool> all(known.planes.size(), true);
  constexpr double any = std::numeric_limits<double>::infinity();
  const outlines::MeshOutlines mesh(triangles, all, known, any);
  for (std::size_t p = 0; p < known.planes.size(); ++p)
    mesh.outline(p, known.planes[p].patch);
}

} // namespace pcl::acmap
