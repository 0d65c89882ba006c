#include <pcl/segmentation/impl/plane_clustering_kernel.h>

#include <algorithm>
#include <cmath>

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

/** Is a normal of unit length, but for rounding? */
bool
isUnit(const Eigen::Vector3f& normal)
{
  return std::abs(normal.squaredNorm() - 1) < 1e-5F;
}

} // namespace

std::vector<std::int32_t>
chosenOf(const Indices& indices)
{
  std::vector<std::int32_t> chosen(indices.begin(), indices.end());
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

LargeVector<Eigen::Vector3f>
unitNormals(const PointView& normals)
{
  LargeVector<Eigen::Vector3f> units;
  units.reserve(normals.size());
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Eigen::Vector3f normal = normals[i];
    units.push_back(isUnit(normal) ? normal : Eigen::Vector3f(normal / normal.norm()));
  }
  return units;
}

void
keepChosen(const std::vector<std::int32_t>& chosen,
           std::size_t points,
           PlaneHypotheses& hypotheses)
{
  std::vector<std::int32_t> numbers(points, -1);
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
