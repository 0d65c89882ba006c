#include "voting/curvature.h"
#include "voting/voter.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/core/noise_scale.h>
#include <pcl/features/impl/voting_kernel.h>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

namespace pcl::acmap {
namespace voting {
namespace {

/** A disc with a radius of this number of mean edges contains about forty triangles. In
 * a slab of noisy points it must be large compared with the noise, within a limited
 * amount of work. */
double
automaticRadius(double mean_edge, double sigma)
{
  constexpr double edges = 2.5, max_edges = 8, sigmas = 8;
  return std::clamp(sigmas * sigma, edges * mean_edge, max_edges * mean_edge);
}

/** Calls vote (voter, vertex) for each vertex, with one voter per thread. The progress
 * is reported in several parts, so that a callback can stop the run. */
template <typename MakeVoter, typename Vote>
void
pollAll(std::size_t vertices,
        const Progress& progress,
        double from,
        double to,
        const char* step,
        const MakeVoter& makeVoter,
        const Vote& vote)
{
  oneapi::tbb::enumerable_thread_specific<decltype(makeVoter())> voters(makeVoter);
  constexpr std::size_t parts = 16, grain = 256; // a view has about 6000 vertices
  for (std::size_t part = 0; part < parts; ++part) {
    progress.tell(from + (to - from) * static_cast<double>(part) / parts, step);
    const std::size_t begin = vertices * part / parts;
    const std::size_t end = vertices * (part + 1) / parts;
    using Range = oneapi::tbb::blocked_range<std::size_t>;
    oneapi::tbb::parallel_for(Range(begin, end, grain), [&](const Range& range) {
      auto& voter = voters.local();
      for (std::size_t v = range.begin(); v < range.end(); ++v)
        vote(voter, v);
    });
  }
}

void
turnToSensors(const PointView& points,
              const SensorView& sensors,
              LargeVector<VotedNormal>& normals)
{
  if (!sensors.isKnown())
    return;
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const Eigen::Vector3f* sensor = sensors[v];
    if (sensor && normals[v].normal.dot(*sensor - points[v]) < 0)
      normals[v].normal = -normals[v].normal;
  }
}

void
describe(const Electorate& electorate,
         const LargeVector<VotedNormal>& normals,
         bool paper,
         VotingReport& report)
{
  for (std::size_t v = 0; v < electorate.points.size(); ++v)
    report.invalid_points += electorate.points[v].allFinite() ? 0 : 1;
  for (const Face& face : electorate.faces)
    report.degenerate_triangles += face.area > 0 ? 0 : 1;
  for (const VotedNormal& voted : normals) {
    report.votes += voted.votes;
    switch (voted.vertex_class) {
    case VertexClass::Surface:
      ++report.surface;
      break;
    case VertexClass::Crease:
      ++report.crease;
      break;
    case VertexClass::Corner:
      ++report.corner;
      break;
    default:
      ++report.unknown;
    }
  }
  if (report.triangles == 0)
    report.remarks.emplace_back("without triangles nobody votes: set a mesh");
  else if (report.unknown > 0)
    report.remarks.push_back(
        std::to_string(report.unknown) +
        (paper ? " vertices got no vote" : " vertices got less than 3 votes") +
        " and have no normal");
}

void
voteCurvatures(const PointView& points,
               const Electorate& electorate,
               double radius,
               const Progress& progress,
               VotedNormals& result)
{
  result.curvatures.resize(points.size());
  pollAll(
      points.size(),
      progress,
      0.7,
      1.0,
      "curvatures",
      [&] { return CurvatureVoter(points, electorate.rings, result.normals, radius); },
      [&](CurvatureVoter& voter, std::size_t v) {
        result.curvatures[v] = voter.vote(static_cast<std::int32_t>(v));
      });
}

} // namespace
} // namespace voting

VotedNormals
voteNormals(const PointView& points,
            const TriangleMesh::Triangles& triangles,
            const SensorView& sensors,
            const VotingSettings& settings,
            const Progress& progress,
            VotingReport& report)
{
  using namespace voting;
  return withThreads(settings.threads, [&] {
    report = {};
    report.vertices = points.size();
    report.triangles = triangles.size();
    StepTimer timer(report);
    progress.tell(0.0, "rings");
    const Electorate electorate(points, triangles);
    report.mean_edge = electorate.rings.meanEdge();
    timer.finish("rings");

    progress.tell(0.2, "noise scale");
    report.sigma = measureNoiseScale(points, sensors, settings.threads).sigma;
    report.radius = settings.radius > 0
                        ? settings.radius
                        : automaticRadius(report.mean_edge, report.sigma);
    const double nearest = std::min(2 * report.sigma, report.radius / 3);
    timer.finish("noise scale");

    VotedNormals result;
    result.normals.resize(points.size(), noNormal());
    pollAll(
        points.size(),
        progress,
        0.3,
        settings.compute_curvatures ? 0.7 : 1.0,
        "votes",
        [&] { return Voter(electorate, report.radius, nearest, settings); },
        [&](Voter& voter, std::size_t v) {
          result.normals[v] = voter.vote(static_cast<std::int32_t>(v));
        });
    turnToSensors(points, sensors, result.normals);
    timer.finish("votes");

    if (settings.compute_curvatures) {
      voteCurvatures(points, electorate, report.radius, progress, result);
      timer.finish("curvatures");
    }
    describe(electorate, result.normals, settings.paper, report);
    progress.tell(1.0, "done");
    return result;
  });
}

} // namespace pcl::acmap
