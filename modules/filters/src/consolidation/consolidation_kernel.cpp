#include "consolidation/candidates.h"
#include "consolidation/point_hash.h"
#include "consolidation/sensor_fit.h"
#include "consolidation/sources.h"
#include "consolidation/thinning.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/quantile.h>
#include <pcl/filters/impl/consolidation_kernel.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

namespace pcl::acmap {

namespace {

/** A propagation step of the sign from one normal to another. The flattest steps come
 * first, then they are sorted by index. */
struct SignPropagation {
  float bend; ///< 0 between normals of one plane or one arc, 1 if they are unrelated
  std::uint32_t to;
  std::uint32_t from;

  bool
  operator<(const SignPropagation& other) const // the queue returns the largest
  {
    return std::tie(bend, to, from) > std::tie(other.bend, other.to, other.from);
  }
};

/** Cosine between a normal and that of its neighbour, transported along a circular arc
 * by the reflection that the paper uses for the votes. */
float
agreement(const Representative& a, const Representative& b)
{
  const Eigen::Vector3f way = (b.point - a.point).normalized();
  const Eigen::Vector3f carried = b.normal - 2 * b.normal.dot(way) * way;
  return a.normal.dot(carried);
}

class SignSpreading {
public:
  SignSpreading(LargeVector<Representative>& representatives, double edge)
  : all_(representatives)
  , radius_(static_cast<float>(1.8 * edge))
  , hash_(entriesOf(representatives), radius_)
  , is_done_(representatives.size(), false)
  , flattest_(representatives.size())
  {}

  void
  run()
  {
    for (std::uint32_t seed = 0; seed < all_.size(); ++seed)
      if (hasNormal(all_[seed]) && !is_done_[seed])
        spreadFrom(seed);
  }

private:
  static bool
  hasNormal(const Representative& representative)
  {
    return !std::isnan(representative.normal.x());
  }

  static LargeVector<PointHash::Entry>
  entriesOf(const LargeVector<Representative>& representatives)
  {
    LargeVector<PointHash::Entry> entries;
    for (std::uint32_t i = 0; i < representatives.size(); ++i)
      if (hasNormal(representatives[i]))
        entries.push_back({representatives[i].point, i});
    return entries;
  }

  void
  spreadFrom(std::uint32_t seed)
  {
    LargeVector<std::uint32_t> component;
    std::size_t flipped = 0;
    std::priority_queue<SignPropagation> steps;
    steps.push({0, seed, seed});
    while (!steps.empty()) {
      const SignPropagation step = steps.top();
      steps.pop();
      if (is_done_[step.to])
        continue;
      is_done_[step.to] = true;
      component.push_back(step.to);
      if (component.size() % parallel_chunk == 0)
        pollRun();
      if (step.to != step.from && agreement(all_[step.from], all_[step.to]) < 0) {
        all_[step.to].normal *= -1;
        ++flipped;
      }
      pushSteps(step.to, steps);
    }
    if (2 * flipped > component.size())
      for (const std::uint32_t i : component)
        all_[i].normal *= -1;
  }

  /** Of the steps to a normal only those that are flatter than all before are queued:
   * the others would be taken after it was done. */
  void
  pushSteps(std::uint32_t from, std::priority_queue<SignPropagation>& steps)
  {
    const Representative& here = all_[from];
    hash_.visitNear(here.point, [&](const PointHash::Entry& entry) {
      const std::uint32_t to = entry.name;
      if (is_done_[to] ||
          !((entry.point - here.point).squaredNorm() < radius_ * radius_))
        return;
      const SignPropagation step{1 - std::abs(agreement(here, all_[to])), to, from};
      Queued& flattest = flattest_[to];
      if (flattest.is_queued &&
          !(SignPropagation{flattest.bend, to, flattest.from} < step))
        return;
      flattest = {step.bend, from, true};
      steps.push(step);
    });
  }

  /** The flattest step to a normal in the queue. */
  struct Queued {
    float bend = 0;
    std::uint32_t from = 0;
    bool is_queued = false;
  };

  LargeVector<Representative>& all_;
  float radius_; // metres
  PointHash hash_;
  LargeVector<std::uint8_t> is_done_;
  LargeVector<Queued> flattest_;
};

/** \brief Makes the signs of neighbouring normals consistent, from flat regions to
 * creases (after Hoppe et al., "Surface reconstruction from unorganized points", 1992).
 * A connected component keeps the side of the majority of its normals.
 * \param[in] representatives their normals are changed
 * \param[in] edge of a voxel, metres */
void
makeNormalsAgree(LargeVector<Representative>& representatives, double edge)
{
  SignSpreading(representatives, edge).run();
}

/** Returns the requested voxel size or an automatic one; 0 if it cannot be determined.
 * The remarks of the noise scale are reported. */
double
chooseVoxel(const PointView& points,
            const ConsolidationSettings& settings,
            ConsolidationReport& report)
{
  if (settings.voxel_size > 0)
    return settings.voxel_size;
  const NoiseScale scale = measureNoiseScale(points, SensorView(), settings.threads);
  report.remarks.insert(
      report.remarks.end(), scale.remarks.begin(), scale.remarks.end());
  return automaticVoxel(scale);
}

void
describe(const VoxelMoments& voxels,
         const NoiseProfile& noise,
         const SurfaceFits& fits,
         ConsolidationReport& report)
{
  report.voxel_size = voxels.lattice.edge();
  report.sigma = noise.medianThickness() * report.voxel_size;
  report.two_sided_voxels = fits.second.size();
  report.narrowed_windows = fits.narrowed;
  LargeVector<float> counts;
  for (const SurfaceFit& fit : fits.first)
    counts.push_back(fit.count);
  if (counts.empty())
    return;
  report.residual = report.sigma / std::sqrt(std::max(medianOf(counts), 1.0f));
}

void
remarkOnPoints(const VoxelMoments& voxels, ConsolidationReport& report)
{
  report.invalid_points = voxels.invalid_points;
  report.distant_points = voxels.distant_points;
  if (voxels.cells.empty())
    report.remarks.emplace_back("nothing to consolidate: no point is finite");
  if (report.distant_points > 0)
    report.remarks.push_back(std::to_string(report.distant_points) +
                             " points lie farther from the others than 2^19 voxels "
                             "and were left out");
}

LargeVector<Representative>
keptOf(const LargeVector<Candidate>& candidates, const Thinning& thinning)
{
  LargeVector<Representative> kept(thinning.kept.size());
  parallelForChunks(kept.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r)
      kept[r] = candidates[thinning.kept[r]].representative;
  });
  return kept;
}

void
faceSensors(LargeVector<Representative>& representatives,
            const SensorView& sensors,
            double edge,
            ConsolidationReport& report)
{
  report.sensors_fit = fitTheirSensors(representatives, sensors, edge);
  if (report.sensors_fit)
    return;
  makeNormalsAgree(representatives, edge);
  report.remarks.emplace_back("where the sensors stood is unknown, or does not fit "
                              "the surface: the normals "
                              "agree with their neighbours' instead");
}

} // namespace

Consolidation
consolidatePoints(const PointView& points,
                  const SensorView& sensors,
                  const ColorView& colors,
                  const ConsolidationSettings& settings,
                  const Progress& progress,
                  ConsolidationReport& report)
{
  return withThreads(settings.threads, [&] {
    report = {};
    report.points = points.size();
    StepTimer timer(report);
    progress.tell(0.0, "noise scale");
    Consolidation result;
    const double edge = chooseVoxel(points, settings, report);
    timer.finish("noise scale");
    if (!(edge > 0)) {
      report.remarks.emplace_back(
          "no voxel size can be told from these points: set one");
      return result;
    }
    progress.tell(0.2, "voxels");
    const VoxelMoments voxels =
        sumVoxels(points, sensors, edge, settings.threads, colors);
    const VoxelWindows windows(voxels);
    report.voxels = windows.size();
    remarkOnPoints(voxels, report);
    timer.finish("voxels");

    NoiseProfile noise;
    SurfaceFits fits = fitSurfaces(windows, progress, noise);
    describe(voxels, noise, fits, report);
    timer.finish("surfaces");

    progress.tell(0.8, "representatives");
    const LargeVector<Candidate> candidates = makeCandidates(windows, fits, sensors);
    fits = {};
    const Thinning thinning = thinOut(candidates, edge);
    result.representatives = keptOf(candidates, thinning);
    report.representatives = result.representatives.size();
    report.without_normal = static_cast<std::size_t>(std::count_if(
        result.representatives.begin(),
        result.representatives.end(),
        [](const Representative& r) { return std::isnan(r.normal.x()); }));
    faceSensors(result.representatives, sensors, edge, report);
    const PointLabels of_cell = representativesOfCells(windows, candidates, thinning);
    setMeanColors(voxels, of_cell, result.representatives);
    timer.finish("representatives");
    if (settings.keep_sources) {
      progress.tell(0.9, "sources");
      result.representative_of = representativesOf(points, sensors, voxels, of_cell);
      timer.finish("sources");
    }
    progress.tell(1.0, "done");
    return result;
  });
}

} // namespace pcl::acmap
