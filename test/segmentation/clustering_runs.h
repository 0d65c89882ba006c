#pragma once

#include "plane_meshes.h"
#include "voting_runs.h"

#include <pcl/segmentation/plane_hypothesis_clustering.h>

namespace pcl::acmap::test {

using Clustering = PlaneHypothesisClustering<PointXYZ>;
using SetClustering = std::function<void(Clustering&)>;

/** \brief Complete result of a run. */
struct Clustered {
  std::vector<PlanePatch> patches;
  PointLabels labels;
  PointLabels source_labels;
  PlaneClusteringReport report;
};

/** \brief Number of points of the cloud without a plane. */
inline std::size_t
leftOut(const Clustered& found)
{
  return static_cast<std::size_t>(
      std::count(found.labels.begin(), found.labels.end(), -1));
}

template <typename PointT>
Clustered
runClustering(PlaneHypothesisClustering<PointT>& clustering)
{
  Clustered result;
  clustering.segment(result.patches);
  result.labels = clustering.getLabels();
  result.source_labels = clustering.getSourceLabels();
  result.report = clustering.getReport();
  return result;
}

/** \brief Sets the mesh of an object, and the normals and classes that are voted on
 * it. */
void
setMesh(Clustering& clustering, const VotingMesh& mesh);

/** \brief Clusters a mesh, as by default driven by noise.
 * \param[in] set changes default settings */
Clustered
clusterOn(
    const VotingMesh& mesh, const SetClustering& set = [](Clustering&) {});

/** \brief Clusters points with normals with the paper's thresholds. */
Clustered
clusterAsPaper(
    const PointCloud<PointNormal>& cloud,
    const std::function<void(PlaneHypothesisClustering<PointNormal>&)>& set =
        [](auto&) {});

/** \brief Are both results equal in every byte? */
bool
areSame(const Clustered& a, const Clustered& b);

/** \brief Angle between a plane's normal and a direction, ignoring the sign;
 * radians. */
double
angleFrom(const PlanePatch& patch, const Eigen::Vector3d& direction);

/** \brief Signed distance of a point from the plane, metres. */
inline double
distanceFrom(const PlanePatch& patch, const Eigen::Vector3d& point)
{
  return patch.coefficients.head<3>().dot(point) + patch.coefficients[3];
}

} // namespace pcl::acmap::test
