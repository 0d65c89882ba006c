#include "mesh_steps.h"

#include <pcl/core/impl/parallel.h>

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

/** \brief Maps component numbers of a part to those of the whole mesh. */
class Numbering {
public:
  explicit Numbering(const std::vector<Part>& parts)
  : parts_(parts)
  {
    for (const Part& part : parts) {
      first_.push_back(count_);
      count_ += part.components;
    }
  }

  std::int32_t
  count() const
  {
    return count_;
  }

  std::int32_t
  inWhole(std::size_t part, std::int32_t component) const
  {
    while (component < parts_[part].first_component)
      part = (part - 1) / 2;
    return first_[part] + component - parts_[part].first_component;
  }

private:
  const std::vector<Part>& parts_;
  std::vector<std::int32_t> first_;
  std::int32_t count_ = 0;
};

void
renumberArrays(MeshArrays& arrays,
               const Numbering& numbering,
               const Part& part,
               std::size_t index)
{
  const std::int32_t end = arrays.tree.endOf(part.node);
  PollPace pace;
  for (std::int32_t i = arrays.tree.firstOf(part.node); i < end; ++i) {
    pace();
    Vertex& v = arrays.vertex(i);
    if (v.component >= 0)
      v.component = numbering.inWhole(index, v.component);
    arrays.forEachEdgeAt(i, [&](Edge& edge, std::int32_t) {
      edge.setComponent(numbering.inWhole(index, edge.componentNumber()));
    });
  }
}

void
renumber(MeshArrays& arrays, std::vector<Part>& parts, const Numbering& numbering)
{
  oneapi::tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t p) {
    Part& part = parts[p];
    PollPace pace;
    for (GrownTriangle& triangle : part.triangles) {
      pace();
      triangle.component = numbering.inWhole(p, triangle.component);
    }
    for (Joint& joint : part.joints) {
      joint.first = numbering.inWhole(p, joint.first);
      joint.second = numbering.inWhole(p, joint.second);
    }
    if (2 * p + 1 >= parts.size())
      renumberArrays(arrays, numbering, part, p);
  });
}

/** \brief Repeats the joints of the parts. Returns false if they contradict each
 * other. */
bool
replay(const std::vector<Part>& parts, ParityUnion& parity)
{
  for (const Part& part : parts)
    for (const Joint& joint : part.joints)
      if (!parity.uniteIfConsistent(joint.first, joint.second, joint.flipped))
        return false;
  return true;
}

/** \brief A triangle at an edge whose first triangle belongs to another component. */
struct Seam {
  GrownTriangle* triangle;
  Joint joint;
};

std::vector<Seam>
findSeams(MeshArrays& arrays, GrownTriangles& triangles)
{
  std::vector<Seam> seams;
  PollPace pace;
  for (GrownTriangle& triangle : triangles) {
    pace();
    for (const Side& side : sidesOf(triangle)) {
      if (!arrays.is(side.a, VertexFlag::mixed) ||
          !arrays.is(side.b, VertexFlag::mixed))
        continue;
      const Edge& edge = *arrays.find(side.a, side.b);
      const std::int32_t first = edge.componentNumber();
      if (edge.triangles == 2 && first != triangle.component)
        seams.push_back(
            {&triangle,
             {first, triangle.component, bool(edge.ascending) == (side.a < side.b)}});
    }
  }
  return seams;
}

/** \brief Joins the components edge by edge, and removes the triangles that
 * contradict. */
ParityUnion
removeContradictions(MeshArrays& arrays,
                     std::vector<Part>& parts,
                     std::int32_t components,
                     std::vector<GrownTriangle>& removed)
{
  ParityUnion parity(components);
  std::vector<GrownTriangle*> wrong;
  for (Part& part : parts) // one after the other: all seams would take much memory
    for (const auto& [triangle, joint] : findSeams(arrays, part.triangles))
      if (!parity.uniteIfConsistent(joint.first, joint.second, joint.flipped) &&
          (wrong.empty() || wrong.back() != triangle))
        wrong.push_back(triangle);
  GrowingMesh mesh(arrays, parity);
  for (GrownTriangle* triangle : wrong) {
    removed.push_back(*triangle);
    mesh.takeOut(*triangle);
  }
  std::vector<GrownTriangles*> lists;
  for (Part& part : parts)
    lists.push_back(&part.triangles);
  mesh.sweep(lists);
  return parity;
}

} // namespace

GrowingMesh
joinParts(MeshArrays& arrays,
          std::vector<Part>& parts,
          std::vector<GrownTriangle>& removed)
{
  const Numbering numbering(parts);
  renumber(arrays, parts, numbering);
  ParityUnion parity(numbering.count());
  if (!replay(parts, parity))
    parity = removeContradictions(arrays, parts, numbering.count(), removed);
  return GrowingMesh(arrays, std::move(parity));
}

} // namespace pcl::acmap::ACMAP_DEWALL
