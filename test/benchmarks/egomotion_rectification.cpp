#include "egomotion_runs.h"
#include "egomotion_tables.h"
#include "markdown_row.h"
#include "rectification_runs.h"
#include "timing.h"

#include <pcl/filters/voxel_consolidation.h>

#include <iostream>

namespace pcl::acmap::bench {
namespace {

constexpr double voxel = 0.06; // metres, as for the other rectified scenes

PointCloud<PointNormal>::Ptr
consolidated(const EgomotionCloud& seen)
{
  const auto points = std::make_shared<PointCloud<PointNormal>>();
  for (const PointXYZRGBSigma& point : seen)
    if (point.z > 0) { // not NaN
      points->emplace_back();
      points->back().getVector3fMap() = point.getVector3fMap();
    }
  VoxelConsolidation<PointNormal> consolidation;
  consolidation.setNumberOfThreads(1);
  consolidation.setVoxelSize(voxel);
  consolidation.setViewpoints({Eigen::Vector3f::Zero()});
  consolidation.setInputCloud(points);
  const auto cloud = std::make_shared<PointCloud<PointNormal>>();
  consolidation.filter(*cloud);
  return cloud;
}

RectificationMap
mapOf(const EgomotionSequence& sequence)
{
  constexpr double usual = 0.05; // metres; a voxel of this size has weight 1
  constexpr float weight = voxel * voxel / (usual * usual);
  RectificationMap map;
  map.name = sequence.name;
  map.bin_size = 0.05;
  for (std::size_t i = 0; i < sequence.clouds.size(); ++i) {
    map.clouds.push_back(consolidated(*sequence.clouds[i]));
    map.weights.emplace_back(map.clouds.back()->size(), weight);
    map.truth.push_back(planarPartOf(sequence.truth[i]));
  }
  return map;
}

void
printRun(const EgomotionRun& chain, const RectificationRun& run)
{
  MarkdownRow()
      .text(run.name)
      .text(chain.name)
      .count(chain.failures)
      .number(run.before.unaligned, 3)
      .number(run.before.aligned, 3)
      .number(run.after.unaligned, 3)
      .number(run.after.aligned, 3)
      .text(nameOf(run.report.outcome))
      .number(chain.seconds * static_cast<double>(chain.all.pairs), 1)
      .number(run.seconds, 1)
      .print();
}

} // namespace

void
printEgomotionRectification()
{
  printHead({"session, 3D by our own stereo",
             "egomotion",
             "pairs without a motion",
             "egomotion: ATE, m",
             "aligned",
             "rectified: ATE, m",
             "aligned",
             "outcome",
             "egomotion, CPU s",
             "rectification, CPU s"});
  for (const char* scene : {"corridor_drive", "l_corridor_drive"}) {
    const EgomotionSequence sequence = driveThrough(scene);
    const RectificationMap map = mapOf(sequence);
    for (const bool refines : {true, false}) {
      const EgomotionRun chain = runChain(oursMethod(refines), sequence);
      std::vector<PlanarPose> given;
      for (const Eigen::Isometry3d& pose : chain.poses)
        given.push_back(planarPartOf(pose));
      printRun(chain, rectifyMap(map, given));
    }
  }
}

} // namespace pcl::acmap::bench
