#include "naive_voting.h"

#include <Eigen/Dense>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

Eigen::Vector3d
placeOf(const VotingMesh& mesh, std::int32_t vertex)
{
  return mesh.cloud[static_cast<std::size_t>(vertex)].getVector3fMap().cast<double>();
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
  std::vector<double> lengths(mesh.cloud.size(),
                              std::numeric_limits<double>::infinity());
  lengths[vertex] = 0;
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (const TriangleMesh::Triangle& triangle : mesh.faces.triangles)
      for (const std::int32_t from : triangle)
        for (const std::int32_t to : triangle) {
          const double length = lengths[static_cast<std::size_t>(from)] +
                                (placeOf(mesh, to) - placeOf(mesh, from)).norm();
          if (length < lengths[static_cast<std::size_t>(to)]) {
            lengths[static_cast<std::size_t>(to)] = length;
            has_changed = true;
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
  NaiveVote result;
  for (const TriangleMesh::Triangle& triangle : mesh.faces.triangles) {
    Eigen::Matrix3d corners;
    Eigen::Vector3d ways;
    for (int k = 0; k < 3; ++k) {
      corners.col(k) = placeOf(mesh, triangle[static_cast<std::size_t>(k)]);
      ways[k] =
          lengths[static_cast<std::size_t>(triangle[static_cast<std::size_t>(k)])];
    }
    const Eigen::Vector3d cross =
        (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
    const Eigen::Vector3d chord = corners.rowwise().mean() - v;
    if (ways.maxCoeff() > settings.radius || chord.norm() <= settings.nearest)
      continue;
    const Eigen::Vector3d n = cross.normalized(), u = chord.normalized();
    const double cosine = -n.dot(u);
    const Eigen::Vector3d vote = n + 2 * cosine * u; // Eq. 6
    double weight =
        cross.norm() / 2 * std::exp(-ways.mean() / (settings.radius / 3)); // Eq. 8
    if (settings.is_slanted)
      weight *= 1 - cosine * cosine;
    sum += weight * vote * vote.transpose(); // Eq. 7
    front += weight * n;
    ++result.votes;
  }
  if (result.votes < settings.min_votes)
    return {};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum / sum.trace());
  result.normal = solver.eigenvectors().col(2);
  if (result.normal.dot(front) < 0)
    result.normal = -result.normal;
  result.direction = solver.eigenvectors().col(0);
  result.eigenvalues = solver.eigenvalues();
  result.vertex_class = classOf(result.eigenvalues, settings); // Eq. 9, 10
  return result;
}

} // namespace pcl::acmap::test
