#include "entropy_grid.h"
#include "map_extent.h"
#include "moving_cells.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/mapping/impl/map_entropy_kernel.h>

#include <oneapi/tbb/parallel_for.h>

namespace pcl::acmap {

struct MapEntropyEvaluator::State {
  MapEntropySettings settings;
  MapEntropyReport counts;
  std::vector<MovingCells> observations;
  EntropyGrid grid;
};

namespace {

void
count(const EntropyCells& observation, MapEntropyReport& report)
{
  ++report.observations;
  report.points += observation.points;
  report.invalid_points += observation.invalid_points;
  report.distant_points += observation.distant_points;
  report.directed_points += observation.directed_points;
  report.cells += observation.cells.size();
}

double
weightOf(const std::vector<EntropyCells>& observations)
{
  double sum = 0;
  for (const EntropyCells& observation : observations)
    for (const EntropyCell& cell : observation.cells)
      sum += cell.weight;
  return sum;
}

} // namespace

MapEntropyEvaluator::MapEntropyEvaluator(const std::vector<EntropyCells>& observations,
                                         const MapEntropySettings& settings)
{
  requireSmoothing(settings);
  state_.reset(new State{settings, {}, {}, EntropyGrid(settings)});
  const double unit = unitFor(weightOf(observations));
  for (const EntropyCells& observation : observations) {
    count(observation, state_->counts);
    state_->observations.emplace_back(observation, settings, unit);
  }
}

MapEntropyEvaluator::~MapEntropyEvaluator() = default;

MapEntropyEvaluator::MapEntropyEvaluator(const MapEntropyEvaluator& other)
: state_(new State(*other.state_))
{}

MapEntropyEvaluator::MapEntropyEvaluator(MapEntropyEvaluator&& other) noexcept =
    default;

MapEntropyEvaluator&
MapEntropyEvaluator::operator=(MapEntropyEvaluator other) noexcept
{
  state_.swap(other.state_);
  return *this;
}

MapEntropyTerms
MapEntropyEvaluator::evaluate(const std::vector<PlanarPose>& poses,
                              MapEntropyReport& report,
                              std::vector<Eigen::Vector3d>* gradient)
{
  const std::vector<MovingCells>& observations = state_->observations;
  const std::size_t size = observations.size();
  if (poses.size() != size)
    throw acmap::BadArgument("each observation needs one pose");
  for (const PlanarPose& pose : poses)
    requirePlanarPose(pose);
  addCounts(state_->counts, report);
  if (gradient)
    gradient->assign(size, Eigen::Vector3d::Zero());
  std::vector<BinRange> ranges;
  BinRange all;
  MapExtent extent;
  for (std::size_t i = 0; i < size; ++i) {
    ranges.push_back(observations[i].rangeUnder(poses[i]));
    all.add(ranges[i]);
    extent.add(observations[i].extent(), PlanarMotion(poses[i]));
  }
  if (!canHaveGrid(ranges, extent.weight(), state_->settings, report))
    return {};

  EntropyGrid& grid = state_->grid;
  grid.begin(all);
  grid.tell(report);
  for (std::size_t i = 0; i < size; ++i)
    observations[i].fill(grid, poses[i]);
  MapEntropyTerms terms = grid.finish(extent.weight(), gradient != nullptr);
  terms.points = state_->counts.points - state_->counts.invalid_points;
  terms.dimensions = extent.dimensions(state_->settings.bin_size);
  remarkOnMap(terms, state_->settings, report);
  if (gradient)
    oneapi::tbb::parallel_for(std::size_t{0}, size, [&](std::size_t i) {
      (*gradient)[i] = observations[i].forces(grid, poses[i]) / extent.weight();
    });
  return terms;
}

MapEntropyTerms
mapEntropy(const std::vector<EntropyCells>& observations,
           const std::vector<PlanarPose>& poses,
           const MapEntropySettings& settings,
           MapEntropyReport& report,
           std::vector<Eigen::Vector3d>* gradient)
{
  return MapEntropyEvaluator(observations, settings).evaluate(poses, report, gradient);
}

} // namespace pcl::acmap
