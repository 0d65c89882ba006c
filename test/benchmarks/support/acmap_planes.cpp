#include "plane_finders.h"

#include "meshes.h"
#include "voted_hypotheses.h"

#include <pcl/filters/impl/consolidation_kernel.h>
#include <pcl/surface/impl/dewall_kernel.h>

namespace pcl::acmap::bench {
namespace {

PointView
viewOf(const PlaneInput& input)
{
  return PointView(&input.points->front().x, sizeof(PointXYZ), input.points->size());
}

TriangleMesh
meshAsItIs(const PlaneInput& input)
{
  DeWallInput seen;
  seen.points = viewOf(input);
  seen.threads = 1;
  if (!input.origins.empty())
    seen.sensor_origin = input.origins.front().cast<double>();
  DeWallReport report;
  return triangulateDeWall(seen, DeWallSettings(), Progress(), report);
}

VotedNormals
voteOn(const PlaneHypotheses& hypotheses)
{
  VotingSettings voting;
  voting.threads = 1;
  VotingReport report;
  return voteNormals(hypotheses.points,
                     hypotheses.triangles,
                     SensorView(),
                     voting,
                     Progress(),
                     report);
}

/** \param[in] distance metres; 0 for the automatic one */
FoundPlanes
findPlanesAt(const PlaneInput& input, double distance)
{
  return timedPlanes([&] {
    FoundPlanes found;
    found.labels.assign(input.points->size(), -1);
    const NoiseScale scale = measureNoiseScale(viewOf(input), SensorView(), 1);
    const SensorView sensors = input.sensors();
    PlaneHypotheses hypotheses;
    Consolidation consolidation;
    if (needsConsolidation(scale)) {
      ConsolidationSettings settings;
      settings.threads = 1;
      settings.voxel_size = automaticVoxel(scale);
      ConsolidationReport report;
      consolidation = consolidatePoints(
          viewOf(input), sensors, ColorView(), settings, Progress(), report);
      const LargeVector<Representative>& all = consolidation.representatives;
      hypotheses.points =
          PointView(all.front().point.data(), sizeof(Representative), all.size());
      hypotheses.triangles = meshOf(consolidation, settings.voxel_size).triangles;
    }
    else {
      hypotheses.points = viewOf(input);
      hypotheses.triangles = meshAsItIs(input).triangles;
    }
    addVotes(voteOn(hypotheses), hypotheses);
    PlaneClusteringSettings clustering;
    clustering.noise_driven = true;
    if (distance > 0)
      clustering.plane_distance = distance;
    clustering.threads = 1;
    PlaneClusteringReport planes;
    PlaneClusters clusters = clusterPlanes(
        hypotheses, {viewOf(input), sensors}, clustering, Progress(), planes);
    for (const PlanePatch& patch : clusters.patches)
      found.planes.push_back(patch.coefficients);
    if (!clusters.source_labels.empty())
      found.labels.assign(clusters.source_labels.begin(), clusters.source_labels.end());
    return found;
  });
}

} // namespace

FoundPlanes
findAcmapPlanes(const PlaneInput& input)
{
  return findPlanesAt(input, 0);
}

FoundPlanes
findAcmapPlanesWithin(const PlaneInput& input)
{
  return findPlanesAt(input, input.tolerance);
}

} // namespace pcl::acmap::bench
