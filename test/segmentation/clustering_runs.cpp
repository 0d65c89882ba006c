#include "clustering_runs.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace pcl::acmap::test {
namespace {

bool
areSameBytes(const void* a, const void* b, std::size_t size)
{
  return std::memcmp(a, b, size) == 0; // compares bytes, as covariances may be NaN
}

bool
areSame(const PlanePatch& a, const PlanePatch& b)
{
  const auto same = [](const auto& x, const auto& y) {
    return areSameBytes(&x, &y, sizeof x);
  };
  return same(a.coefficients, b.coefficients) && same(a.center, b.center) &&
         same(a.axis_u, b.axis_u) && same(a.axis_v, b.axis_v) &&
         same(a.covariance, b.covariance) && a.support == b.support &&
         same(a.effective_support, b.effective_support) && same(a.rms, b.rms) &&
         same(a.area, b.area) &&
         std::equal(a.polygons.begin(),
                    a.polygons.end(),
                    b.polygons.begin(),
                    b.polygons.end(),
                    [](const auto& x, const auto& y) {
                      return x.outer == y.outer && x.holes == y.holes;
                    });
}

} // namespace

void
setMesh(Clustering& clustering, const VotingMesh& mesh)
{
  const Voted voted = voteOn(mesh);
  clustering.setInputCloud(mesh.cloud.makeShared());
  clustering.setInputNormals(voted.normals.makeShared());
  clustering.setVertexClasses(voted.classes.makeShared());
  clustering.setTriangles(mesh.faces);
}

Clustered
clusterOn(const VotingMesh& mesh, const SetClustering& set)
{
  Clustering clustering;
  setMesh(clustering, mesh);
  set(clustering);
  return runClustering(clustering);
}

Clustered
clusterAsPaper(const PointCloud<PointNormal>& cloud,
               const std::function<void(PlaneHypothesisClustering<PointNormal>&)>& set)
{
  PlaneHypothesisClustering<PointNormal> clustering;
  clustering.setInputCloud(cloud.makeShared());
  clustering.setNoiseDriven(false);
  set(clustering);
  return runClustering(clustering);
}

bool
areSame(const Clustered& a, const Clustered& b)
{
  return a.labels == b.labels && a.source_labels == b.source_labels &&
         std::equal(a.patches.begin(),
                    a.patches.end(),
                    b.patches.begin(),
                    b.patches.end(),
                    [](const auto& x, const auto& y) { return areSame(x, y); });
}

double
angleFrom(const PlanePatch& patch, const Eigen::Vector3d& direction)
{
  const Eigen::Vector3d normal = patch.coefficients.head<3>();
  return std::atan2(normal.cross(direction).norm(), std::abs(normal.dot(direction)));
}

} // namespace pcl::acmap::test
