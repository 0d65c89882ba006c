#include "map_observations.h"

#include "length_check.h"

#include <pcl/pipeline/sequence_consolidation.h>

namespace pcl::acmap {

namespace {

void
tellCounts(Tool& tool,
           std::size_t observations,
           const SequenceConsolidationReport& report)
{
  tool.tell("read",
            std::to_string(observations) + " observations, " +
                std::to_string(report.points) + " points");
  tool.tell("consolidated",
            "to " + std::to_string(report.representatives) + ", voxels of " +
                shortNumber(report.min_voxel_size) + " to " +
                shortNumber(report.max_voxel_size) + " m");
  tool.details()["consolidation"] = {{"representatives", report.representatives},
                                     {"least_voxel", report.min_voxel_size},
                                     {"largest_voxel", report.max_voxel_size}};
}

} // namespace

MapObservations
readObservations(Tool& tool, const ObservationSequence& sequence, bool skip_broken)
{
  SequenceConsolidation consolidation;
  consolidation.setSkipBroken(skip_broken);
  consolidation.setNumberOfThreads(tool.threads());
  ConsolidatedObservations consolidated;
  tool.withProgress([&](const ProgressCallback& progress) {
    consolidation.setProgressCallback(progress);
    consolidation.compute(sequence, consolidated);
  });
  const SequenceConsolidationReport& report = consolidation.getReport();
  if (consolidated.places.front() == 0)
    warnOfLengths(*sequence.load(0).file, tool.controls(), tool.log());
  for (const std::string& remark : report.remarks)
    tool.warn(remark);
  tellCounts(tool, consolidated.places.size(), report);

  MapObservations observations;
  observations.trajectory = std::move(consolidated.trajectory);
  for (const std::size_t place : consolidated.places)
    observations.files.push_back(sequence.name(place));
  observations.clouds = std::move(consolidated.clouds);
  observations.weights = std::move(consolidated.weights);
  observations.load = [sequence, places = consolidated.places](std::size_t i) {
    return sequence.load(places[i]).file;
  };
  observations.points = report.points;
  observations.colored = report.colored;
  return observations;
}

} // namespace pcl::acmap
