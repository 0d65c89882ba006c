#include "entropy_search.h"

#include "descent.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <sstream>

namespace pcl::acmap {
namespace {

constexpr double min_fall = 3e-6;        ///< of F, per observation
constexpr double min_window_fall = 1e-5; ///< the same for windows

PointView
viewOf(const std::vector<Eigen::Vector3f>& values)
{
  return values.empty() ? PointView()
                        : PointView(values.data(), sizeof(values[0]), values.size());
}

/** Windows [first, last) of a pass; the last one includes a short remainder. */
std::vector<std::pair<std::size_t, std::size_t>>
windowsOf(std::size_t observations, std::size_t size, std::size_t first)
{
  std::vector<std::pair<std::size_t, std::size_t>> windows;
  for (; first + size / 2 <= observations; first += size) {
    const std::size_t last = first + size;
    const bool rest = last + size / 2 > observations;
    windows.emplace_back(first, rest ? observations : last);
  }
  return windows;
}

std::pair<double, bool>
keyOf(const EntropyLevel& level)
{
  return {level.bin_size, level.direction_aware};
}

std::vector<EntropyCells>
part(const std::vector<EntropyCells>& all, std::size_t first, std::size_t last)
{
  return {all.begin() + static_cast<std::ptrdiff_t>(first),
          all.begin() + static_cast<std::ptrdiff_t>(last)};
}

void
remarkTooWide(double bin_size, std::vector<std::string>& remarks)
{
  std::ostringstream text;
  text << "the map is too wide for bins of " << bin_size
       << " m: only parts of it were searched with them";
  if (std::find(remarks.begin(), remarks.end(), text.str()) == remarks.end())
    remarks.push_back(text.str());
}

} // namespace

EntropyLevel
widened(const EntropyLevel& level)
{
  return {4 * level.bin_size, level.weight, level.direction_aware, false};
}

MapEntropySettings
EntropySearch::entropySettings(const EntropyLevel& level) const
{
  MapEntropySettings settings;
  settings.bin_size = level.bin_size;
  settings.smoothing = level.bin_size;
  settings.projection_weight = projectionWeight(task_.settings);
  settings.direction_aware = level.direction_aware;
  return settings;
}

const std::vector<EntropyCells>&
EntropySearch::cells(const EntropyLevel& level)
{
  auto& cells = cells_[keyOf(level)];
  if (!cells.empty())
    return cells;
  cells.resize(task_.observations.size());
  const MapEntropySettings settings = entropySettings(level);
  oneapi::tbb::parallel_for(std::size_t{0}, cells.size(), [&](std::size_t i) {
    const LevelledPoints& seen = task_.observations[i];
    cells[i] = aggregateCells(viewOf(seen.points),
                              viewOf(seen.normals),
                              settings,
                              seen.weights.empty() ? nullptr : seen.weights.data());
  });
  return cells;
}

void
EntropySearch::makeCells(const EntropyLevel& level)
{
  cells(level);
  if (level.is_sharp)
    cells(widened(level));
}

std::size_t
EntropySearch::descendPart(const ActionChain& chain,
                           const EntropyLevel& level,
                           std::size_t first,
                           std::size_t last,
                           Eigen::VectorXd& u,
                           const std::string* name)
{
  const auto size = static_cast<double>(last - first);
  const auto evaluatorAt = [&](const EntropyLevel& at) {
    return MapEntropyEvaluator(part(cells_.at(keyOf(at)), first, last),
                               entropySettings(at));
  };
  MapEntropyEvaluator fine = evaluatorAt(level);
  std::optional<MapEntropyEvaluator> coarse;
  if (level.is_sharp)
    coarse.emplace(evaluatorAt(widened(level)));
  const double weight = level.weight * task_.settings.entropy_weight * size;
  double entropy = 0;
  std::vector<Eigen::Vector3d> by_pose, coarse_by_pose;
  const Objective objective = [&](const Eigen::VectorXd& at,
                                  Eigen::VectorXd& gradient) {
    MapEntropyReport ignored;
    const std::vector<PlanarPose> poses = chain.poses(at);
    const MapEntropyTerms terms = fine.evaluate(poses, ignored, &by_pose);
    if (terms.points == 0) { // the map is larger than a grid can be
      gradient.setZero();
      return std::numeric_limits<double>::infinity();
    }
    entropy = terms.total;
    if (coarse) {
      entropy -= coarse->evaluate(poses, ignored, &coarse_by_pose).total;
      for (std::size_t i = 0; i < by_pose.size(); ++i)
        by_pose[i] -= coarse_by_pose[i];
    }
    const double prior = chain.prior(at, &gradient);
    gradient += weight * chain.gradient(poses, by_pose);
    return weight * entropy + prior;
  };
  const DescentObserver observer = [&](const Eigen::VectorXd& at, double value) {
    task_.progress.tell(fraction_, *name);
    task_.report.steps.push_back(
        {*name, level.bin_size, entropy, chain.prior(at), value});
  };
  return name ? descend(objective, u, min_fall * size, observer)
              : descend(objective, u, min_window_fall * size);
}

void
EntropySearch::descendWhole(const ActionChain& chain,
                            const EntropyLevel& level,
                            const std::string& name,
                            Eigen::VectorXd& u)
{
  makeCells(level);
  task_.report.evaluations +=
      descendPart(chain, level, 0, task_.observations.size(), u, &name);
}

void
EntropySearch::descendWindows(const ActionChain& chain,
                              const EntropyLevel& level,
                              std::size_t size,
                              const std::string& name,
                              Eigen::VectorXd& u)
{
  makeCells(level);
  const std::size_t all = task_.observations.size();
  double work = 0;
  for (const std::size_t first : {std::size_t{0}, size / 2}) {
    const auto windows = windowsOf(all, size, first);
    std::vector<std::size_t> evaluations(windows.size());
    oneapi::tbb::parallel_for(std::size_t{0}, windows.size(), [&](std::size_t i) {
      const auto [begin, end] = windows[i];
      const auto at = 3 * static_cast<Eigen::Index>(begin);
      const ActionChain part = chain.part(begin, end);
      Eigen::VectorXd v = Eigen::VectorXd::Zero(part.variables());
      v.head(part.residuals()) = u.segment(at, part.residuals());
      evaluations[i] = descendPart(part, level, begin, end, v, nullptr);
      u.segment(at, part.residuals()) = v.head(part.residuals());
    });
    for (std::size_t i = 0; i < windows.size(); ++i)
      work +=
          static_cast<double>(evaluations[i] * (windows[i].second - windows[i].first)) /
          static_cast<double>(all);
    task_.progress.tell(fraction_, name);
  }
  task_.report.evaluations += static_cast<std::size_t>(work);
  tellStep(chain, level, name, u);
}

void
EntropySearch::tellStep(const ActionChain& chain,
                        const EntropyLevel& level,
                        const std::string& name,
                        const Eigen::VectorXd& u)
{
  const auto termsAt = [&](const EntropyLevel& at) {
    MapEntropyReport ignored;
    return mapEntropy(cells(at), chain.poses(u), entropySettings(at), ignored);
  };
  const MapEntropyTerms terms = termsAt(level);
  if (terms.points == 0) {
    remarkTooWide(level.bin_size, task_.report.remarks);
    return;
  }
  const double entropy =
      terms.total - (level.is_sharp ? termsAt(widened(level)).total : 0);
  const double prior = chain.prior(u);
  const double weight = level.weight * task_.settings.entropy_weight *
                        static_cast<double>(task_.observations.size());
  task_.report.steps.push_back(
      {name, level.bin_size, entropy, prior, weight * entropy + prior});
}

} // namespace pcl::acmap
