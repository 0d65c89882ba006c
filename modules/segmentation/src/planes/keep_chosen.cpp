#include <pcl/segmentation/impl/plane_clustering_kernel.h>

#include <algorithm>

namespace pcl::acmap {
namespace {

/** \param[in,out] values one per element of an array, or empty */
template <typename Vector>
void
keep(const std::vector<std::int32_t>& chosen, Vector& values)
{
  if (values.empty())
    return;
  Vector kept;
  kept.reserve(chosen.size());
  for (const std::int32_t index : chosen)
    kept.push_back(values[static_cast<std::size_t>(index)]);
  values = std::move(kept);
}

} // namespace

void
keepChosen(const std::vector<std::int32_t>& chosen, PlaneHypotheses& hypotheses)
{
  std::vector<std::int32_t> numbers(hypotheses.normals.size(), -1);
  for (std::size_t i = 0; i < chosen.size(); ++i)
    numbers[static_cast<std::size_t>(chosen[i])] = static_cast<std::int32_t>(i);
  TriangleMesh::Triangles triangles;
  for (TriangleMesh::Triangle triangle : hypotheses.triangles) {
    for (std::int32_t& corner : triangle)
      corner = numbers[static_cast<std::size_t>(corner)];
    if (*std::min_element(triangle.begin(), triangle.end()) >= 0)
      triangles.push_back(triangle);
  }
  hypotheses.triangles = std::move(triangles);
  keep(chosen, hypotheses.normals);
  keep(chosen, hypotheses.is_crease);
  keep(chosen, hypotheses.curvatures);
}

} // namespace pcl::acmap
