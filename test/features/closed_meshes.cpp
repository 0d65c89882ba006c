#include "closed_meshes.h"

#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace pcl::acmap::test {
namespace {

using Triangle = TriangleMesh::Triangle;

/** Creates the vertices of a lattice when they are first requested. */
class LatticeVertices {
public:
  LatticeVertices(Cloud& cloud, double spacing, double half)
  : cloud_(cloud)
  , spacing_(spacing)
  , half_(half)
  {}

  std::int32_t
  at(const std::array<int, 3>& place)
  {
    const auto [found, is_new] =
        numbers_.emplace(place, static_cast<std::int32_t>(cloud_.size()));
    if (is_new)
      cloud_.push_back(toPoint({place[0] * spacing_ - half_,
                                place[1] * spacing_ - half_,
                                place[2] * spacing_ - half_}));
    return found->second;
  }

private:
  Cloud& cloud_;
  double spacing_, half_;
  std::map<std::array<int, 3>, std::int32_t> numbers_;
};

VotingMesh
makeIcosahedron()
{
  const double golden = (1 + std::sqrt(5.0)) / 2;
  VotingMesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (const double one : {-1.0, 1.0})
      for (const double two : {-golden, golden}) {
        Eigen::Vector3d place;
        place[axis] = 0;
        place[(axis + 1) % 3] = one;
        place[(axis + 2) % 3] = two;
        mesh.cloud.push_back(toPoint(place.normalized()));
      }
  const auto place = [&](std::int32_t i) {
    return mesh.cloud[static_cast<std::size_t>(i)].getVector3fMap();
  };
  const auto isEdge = [&](std::int32_t a, std::int32_t b) {
    return (place(a) - place(b)).norm() < 1.1F; // edges have length 1.05
  };
  for (std::int32_t a = 0; a < 12; ++a)
    for (std::int32_t b = a + 1; b < 12; ++b)
      for (std::int32_t c = b + 1; c < 12; ++c)
        if (isEdge(a, b) && isEdge(b, c) && isEdge(c, a)) {
          const bool looks_out = place(a).cross(place(b)).dot(place(c)) > 0;
          mesh.faces.triangles.push_back(looks_out ? Triangle{a, b, c}
                                                   : Triangle{a, c, b});
        }
  return mesh;
}

/** Splits each triangle into four; new vertices are on the unit sphere. */
void
refineOnSphere(VotingMesh& mesh)
{
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middles;
  const auto middleOf = [&](std::int32_t a, std::int32_t b) {
    const auto [found, is_new] = middles.emplace(
        std::minmax(a, b), static_cast<std::int32_t>(mesh.cloud.size()));
    if (is_new) {
      const Eigen::Vector3d sum =
          mesh.cloud[static_cast<std::size_t>(a)].getVector3fMap().cast<double>() +
          mesh.cloud[static_cast<std::size_t>(b)].getVector3fMap().cast<double>();
      mesh.cloud.push_back(toPoint(sum.normalized()));
    }
    return found->second;
  };
  TriangleMesh::Triangles finer;
  for (const auto& [a, b, c] : mesh.faces.triangles) {
    const std::int32_t ab = middleOf(a, b), bc = middleOf(b, c), ca = middleOf(c, a);
    finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  mesh.faces.triangles = std::move(finer);
}

} // namespace

VotingMesh
makeCubeMesh(int side, double spacing)
{
  VotingMesh mesh;
  LatticeVertices vertices(mesh.cloud, spacing, side * spacing / 2);
  for (int axis = 0; axis < 3; ++axis)
    for (const bool is_far : {false, true})
      for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
          const auto corner = [&](int right, int up) {
            std::array<int, 3> place{};
            place[static_cast<std::size_t>(axis)] = is_far ? side : 0;
            place[static_cast<std::size_t>((axis + 1) % 3)] = i + right;
            place[static_cast<std::size_t>((axis + 2) % 3)] = j + up;
            return vertices.at(place);
          };
          const std::int32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1),
                             d = corner(0, 1);
          if (is_far)
            mesh.faces.triangles.insert(mesh.faces.triangles.end(),
                                        {{a, b, c}, {a, c, d}});
          else
            mesh.faces.triangles.insert(mesh.faces.triangles.end(),
                                        {{a, c, b}, {a, d, c}});
        }
  return mesh;
}

VotingMesh
makeSphereMesh(int levels, double radius)
{
  VotingMesh mesh = makeIcosahedron();
  for (int level = 0; level < levels; ++level)
    refineOnSphere(mesh);
  mesh.cloud = scaled(mesh.cloud, static_cast<float>(radius));
  return mesh;
}

} // namespace pcl::acmap::test
