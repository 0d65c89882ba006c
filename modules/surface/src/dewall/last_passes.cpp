#include "mesh_steps.h"

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

Range
wholeOf(const PointTree& tree)
{
  return Range(tree, PointTree::Node{}, false);
}

/** \brief Processes the deferred edges, with apexes from all points. */
void
growAcrossPlanes(GrowingMesh& mesh,
                 const SizeConstraint& size,
                 DeWallRule rule,
                 const std::vector<Part>& parts,
                 const std::function<void()>& tick)
{
  const PointTree& tree = mesh.arrays().tree;
  const Range all = wholeOf(tree);
  Front front(tree, size, rule, mesh, tick);
  PollPace pace;
  for (const Part& part : parts)
    for (const Side& side : part.deferred) {
      pace();
      if (mesh.oppositeOf(side) >= 0)
        front.insert(mesh.asItRuns(side), all);
    }
  front.advance(all);
  front.advancePostponed(all);
  front.advanceContrary(all);
}

/** \brief Adds open edges of walls, which are not inside a single part. */
void
addSidesOfWalls(GrowingMesh& mesh, const std::vector<Part>& parts, Unfinished& begun)
{
  const std::size_t walls = parts.size() / 2; // they come before the leaves
  PollPace pace;
  for (std::size_t p = 0; p < walls; ++p)
    for (const GrownTriangle& triangle : parts[p].triangles) {
      pace();
      for (const Side& side : sidesOf(triangle))
        if (mesh.oppositeOf(side) >= 0)
          begun.sides.push_back(side);
    }
}

bool
isAnyTouched(const MeshArrays& arrays, const Refusal& refusal)
{
  return arrays.is(refusal.side.a, VertexFlag::of_wall) ||
         arrays.is(refusal.side.b, VertexFlag::of_wall) ||
         arrays.is(refusal.apex, VertexFlag::of_wall);
}

void
append(Unfinished& all, const Unfinished& more)
{
  all.sides.insert(all.sides.end(), more.sides.begin(), more.sides.end());
  all.points.insert(all.points.end(), more.points.begin(), more.points.end());
}

} // namespace

std::size_t
finishMesh(GrowingMesh& mesh,
           const SizeConstraint& size,
           DeWallRule rule,
           std::vector<Part>& parts,
           std::vector<GrownTriangle> removed,
           const std::function<void()>& tick)
{
  MeshArrays& arrays = mesh.arrays();
  mesh.setOfWall(true);
  growAcrossPlanes(mesh, size, rule, parts, tick);
  std::vector<GrownTriangles*> lists;
  for (Part& part : parts)
    lists.push_back(&part.triangles);
  lists.push_back(&mesh.triangles());
  const std::vector<GrownTriangle> of_fans = keepLargestFans(mesh, lists, true);
  removed.insert(removed.end(), of_fans.begin(), of_fans.end());
  for (const GrownTriangle& triangle : removed)
    for (const std::int32_t corner : triangle.corners)
      arrays.set(corner, VertexFlag::of_wall);

  Unfinished begun = affectedBy(removed, size, mesh);
  PollPace pace;
  for (const Part& part : parts) {
    append(begun, part.unfinished);
    for (const Refusal& refusal : part.unfinished.refusals) {
      pace();
      if (isAnyTouched(arrays, refusal))
        begun.refusals.push_back(refusal);
    }
  }
  addSidesOfWalls(mesh, parts, begun);
  const Range all = wholeOf(arrays.tree);
  Refill(size, rule, mesh, all, tick).run(std::move(begun));
  if (rule == DeWallRule::Dense)
    closeSmallHoles(size, mesh, all);
  return of_fans.size();
}

} // namespace pcl::acmap::ACMAP_DEWALL
