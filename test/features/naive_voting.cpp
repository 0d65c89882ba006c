#include "naive_voting.h"

#include <Eigen/Dense>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Eigen::Vector3d
placeOf(const VotingMesh& mesh, std::int32_t vertex)
{
  return mesh.cloud[static_cast<std::size_t>(vertex)].getVector3fMap().cast<double>();
}

/** The unvisited vertex with the shortest path so far, or -1. */
std::int32_t
nextVertex(const std::vector<double>& lengths, const std::vector<bool>& is_done)
{
  std::int32_t best = -1;
  for (std::size_t v = 0; v < lengths.size(); ++v)
    if (!is_done[v] && lengths[v] < infinity &&
        (best < 0 || lengths[v] < lengths[static_cast<std::size_t>(best)]))
      best = static_cast<std::int32_t>(v);
  return best;
}

VertexClass
classOf(const Eigen::Vector3d& rising, const NaiveVotingSettings& settings)
{
  const double surface = rising[2] - rising[1];
  const double crease = settings.crease_weight * (rising[1] - rising[0]);
  const double corner = settings.crease_weight * settings.corner_weight * rising[0];
  if (surface >= std::max(crease, corner))
    return VertexClass::Surface;
  return crease >= corner ? VertexClass::Crease : VertexClass::Corner;
}

} // namespace

std::vector<double>
pathLengths(const VotingMesh& mesh, std::size_t vertex)
{
  std::vector<double> lengths(mesh.cloud.size(), infinity);
  std::vector<bool> is_done(mesh.cloud.size(), false);
  lengths[vertex] = 0;
  for (std::int32_t v = static_cast<std::int32_t>(vertex); v >= 0;
       v = nextVertex(lengths, is_done)) {
    is_done[static_cast<std::size_t>(v)] = true;
    for (const TriangleMesh::Triangle& triangle : mesh.faces.triangles) {
      if (triangle[0] != v && triangle[1] != v && triangle[2] != v)
        continue;
      for (const std::int32_t other : triangle) {
        double& length = lengths[static_cast<std::size_t>(other)];
        length = std::min(length,
                          lengths[static_cast<std::size_t>(v)] +
                              (placeOf(mesh, other) - placeOf(mesh, v)).norm());
      }
    }
  }
  return lengths;
}

NaiveVote
voteNaively(const VotingMesh& mesh,
            std::size_t vertex,
            const NaiveVotingSettings& settings)
{
  const std::vector<double> lengths = pathLengths(mesh, vertex);
  const Eigen::Vector3d v = placeOf(mesh, static_cast<std::int32_t>(vertex));
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Eigen::Vector3d front = Eigen::Vector3d::Zero();
  std::size_t votes = 0;
  for (const TriangleMesh::Triangle& triangle : mesh.faces.triangles) {
    double way = 0, farthest = 0;
    for (const std::int32_t corner : triangle) {
      way += lengths[static_cast<std::size_t>(corner)] / 3;
      farthest = std::max(farthest, lengths[static_cast<std::size_t>(corner)]);
    }
    const Eigen::Vector3d a = placeOf(mesh, triangle[0]),
                          b = placeOf(mesh, triangle[1]),
                          c = placeOf(mesh, triangle[2]);
    const Eigen::Vector3d cross = (b - a).cross(c - a);
    const Eigen::Vector3d chord = (a + b + c) / 3 - v;
    if (farthest > settings.radius || chord.norm() <= settings.nearest)
      continue;
    const Eigen::Vector3d n = cross.normalized(), u = chord.normalized();
    const double cosine = -n.dot(u);
    const Eigen::Vector3d vote = n + 2 * cosine * u; // Eq. 6
    const double weight = cross.norm() / 2 * std::exp(-way / (settings.radius / 3)) *
                          (1 - cosine * cosine); // Eq. 8 with the additional factor of
                                                 // the class
    sum += weight * vote * vote.transpose();     // Eq. 7
    front += weight * n;
    ++votes;
  }
  if (votes < 3)
    return {};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum / sum.trace());
  NaiveVote result;
  result.normal = solver.eigenvectors().col(2);
  if (result.normal.dot(front) < 0)
    result.normal = -result.normal;
  result.direction = solver.eigenvectors().col(0);
  result.eigenvalues = solver.eigenvalues();
  result.vertex_class = classOf(result.eigenvalues, settings); // Eq. 9, 10
  return result;
}

} // namespace pcl::acmap::test
