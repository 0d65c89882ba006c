#include "rectification_steps.h"

#include "ray_evidence.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pcl::acmap {
namespace {

/** A search that follows the one in windows of neighbours: its window sizes and its
 * entropy. */
struct Plan {
  const char* name;
  bool direction_aware;
  bool is_sharp;
  std::vector<std::size_t> windows; ///< followed by the whole map
};

const Plan sharp{"sharp", true, true, {4 * neighbours}};
const Plan directed{"directed", true, false, {4 * neighbours}};
const Plan undirected{"undirected", false, false, {4 * neighbours}};
const Plan gradual{
    "gradual", true, false, {2 * neighbours, 4 * neighbours, 8 * neighbours}};

/** A candidate for the rectified map. */
struct MapCandidate {
  const char* name = "";
  double scale = 1; ///< factor of the odometry noise
  Eigen::VectorXd u;
  std::vector<PlanarPose> poses;
  MapEvidence evidence;
  double wide_entropy = 0; ///< bits, E_wide of the finest bins
};

double
distanceBetween(const std::vector<PlanarPose>& a, const std::vector<PlanarPose>& b)
{
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += std::pow(a[i].x - b[i].x, 2) + std::pow(a[i].z - b[i].z, 2);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

/** Share of all rays that end on a wall seen by near observations, plus the same for
 * far ones: up to 2. */
double
confirmedShares(const MapEvidence& rays)
{
  return rays.near_rays * (1 - rays.near_contradictions) +
         rays.far_rays * (1 - rays.far_contradictions);
}

/** Median of the root mean square residuals along x, along z and of the turns, in
 * standard deviations of the given noise. */
double
usualResidual(const MapCandidate& map)
{
  const Eigen::Index actions = (map.u.size() - 1) / 3;
  Eigen::Array3d squares = Eigen::Array3d::Zero();
  for (Eigen::Index t = 0; t < actions; ++t)
    squares += map.u.segment<3>(3 * t).array().square();
  squares = map.scale * (squares / static_cast<double>(actions)).sqrt();
  std::sort(squares.data(), squares.data() + 3);
  return squares[1];
}

double
contradictionsOf(const MapEvidence& rays)
{
  return rays.near_contradictions + rays.far_contradictions;
}

/** Confirmed minus contradicted rays, as shares of all rays, by near plus by far
 * observations. */
double
balanceOf(const MapEvidence& rays)
{
  return confirmedShares(rays) - rays.near_rays * rays.near_contradictions -
         rays.far_rays * rays.far_contradictions;
}

/** Is a map clearly better than another one? Either clearly fewer rays are
 * contradicted; or, without clearly more contradictions, walls coincide more often or
 * their variance is less than half. A map that was already correct cannot be improved
 * like this. */
bool
isBetter(const MapEvidence& map, const MapEvidence& other)
{
  const double now = contradictionsOf(map);
  const double before = contradictionsOf(other);
  const bool fewer = now < std::min(0.9 * before, before - 0.03);
  const bool met = balanceOf(map) > balanceOf(other) + 0.0025;
  const bool thinner = map.orthogonal_variance < 0.5 * other.orthogonal_variance;
  return fewer || ((met || thinner) && now < before + 0.02);
}

/** Length of a path, metres. */
double
lengthOf(const std::vector<PlanarPose>& path)
{
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    length += std::hypot(path[i].x - path[i - 1].x, path[i].z - path[i - 1].z);
  return length;
}

class GuardedSearch {
public:
  GuardedSearch(const RectificationTask& task,
                EntropySearch& search,
                const std::vector<PlanarPose>& given)
  : task_(task)
  , search_(search)
  , rays_(task.observations, task.settings.bin_size)
  , chain_(given, task.settings.odometry)
  , given_(given)
  , report_(task.report)
  {}

  std::vector<PlanarPose>
  run()
  {
    judge(given_, report_.before);
    given_wide_entropy_ = wideEntropy(given_);
    if (report_.before.near_rays + report_.before.far_rays == 0)
      return end(RectificationOutcome::Undetermined,
                 "the observations see no wall in common: nothing tells how they lie");
    fitWindows();
    consider(sharp, usual_, map_scale_);
    consider(directed, usual_, map_scale_);
    if (!isConvincing(best()))
      consider(undirected, usual_, map_scale_);
    if (!isConvincing(best()))
      consider(gradual, usual_, map_scale_);
    if (!isConvincing(best())) {
      const std::size_t start = otherStart();
      consider(directed, start, locals_[start].scale);
    }
    return decide();
  }

private:
  void
  judge(const std::vector<PlanarPose>& poses, MapEvidence& evidence) const
  {
    rays_.judge(poses, evidence);
    measureQuality(task_.observations, poses, evidence);
  }

  double
  wideEntropy(const std::vector<PlanarPose>& poses) const
  {
    const EntropyLevel level = widened(levels(sharp).back());
    MapEntropyReport ignored;
    return mapEntropy(
               search_.cells(level), poses, search_.entropySettings(level), ignored)
        .total;
  }

  std::vector<EntropyLevel>
  levels(const Plan& plan) const
  {
    const double bin = task_.settings.bin_size;
    return {{4 * bin, 1, plan.direction_aware, plan.is_sharp},
            {2 * bin, 3, plan.direction_aware, plan.is_sharp},
            {bin, 10, plan.direction_aware, plan.is_sharp}};
  }

  /** Searches windows of a few observations, with more and more odometry noise. The
   * usual scale is the smallest one that the rays support. */
  void
  fitWindows()
  {
    for (const double scale : {1.0, 2.0, 4.0, 8.0, 16.0}) {
      MapCandidate local;
      local.scale = scale;
      const ActionChain chain = chain_.widened(scale);
      local.u = Eigen::VectorXd::Zero(chain.variables());
      if (scale > 1) // Where scans are far from their places, few are easier to join.
        for (const std::size_t size : {neighbours / 4, neighbours / 2})
          search_.descendWindows(
              chain, levels(directed).front(), size, "short windows", local.u);
      for (const EntropyLevel& level : levels(directed))
        search_.descendWindows(chain, level, neighbours, "windows", local.u);
      local.name = "windows";
      local.poses = chain.path(local.u);
      judge(local.poses, local.evidence);
      locals_.push_back(local);
      search_.advanceTo(std::min(0.3, 0.1 * static_cast<double>(locals_.size())));
      const bool is_wider = locals_.size() == 1 || isWider(locals_.back());
      if (is_wider)
        usual_ = locals_.size() - 1;
      const bool are_contradicted = contradictionsIn(usual_) > much_near;
      if (!are_contradicted && (!is_wider || scale >= usual_scales))
        break;
      if (locals_.size() > usual_ + 2)
        break;
    }
    // A power of two: rounding of the residuals must not change the energy.
    const double needed = std::exp2(std::ceil(
        std::log2(std::max(min_scale, 2.5 * usualResidual(locals_[usual_])))));
    map_scale_ = std::min(needed, locals_[usual_].scale);
  }

  /** Index of the result of windows, besides the usual one, that the rays contradict
   * least. */
  std::size_t
  otherStart() const
  {
    std::size_t other = usual_ == 0 ? 1 : 0;
    for (std::size_t i = 0; i < locals_.size(); ++i)
      if (i != usual_ && contradictionsIn(i) < contradictionsIn(other))
        other = i;
    return other;
  }

  /** Do the rays support the scale of a window result rather than the usual one? Not if
   * the odometry was no constraint there; if it was a strong one, the residuals say that
   * the noise is larger, too, and less is asked of the rays. */
  bool
  isWider(const MapCandidate& local) const
  {
    const double residual = usualResidual(locals_[usual_]) / locals_[usual_].scale;
    const double share = residual > 0.6 ? 0.92 : residual > 0.25 ? 0.88 : 0.0;
    return local.evidence.near_contradictions < share * contradictionsIn(usual_);
  }

  /** Share of contradicted rays within windows. */
  double
  contradictionsIn(std::size_t local) const
  {
    return locals_[local].evidence.near_contradictions;
  }

  /** \param[in] local index of the window result from which it starts
   * \param[in] scale of the odometry noise */
  void
  consider(const Plan& plan, std::size_t local, double scale)
  {
    MapCandidate found;
    found.name = plan.name;
    found.scale = scale;
    found.u = locals_[local].scale / scale * locals_[local].u;
    // A bias of precise odometry shows only in the walls that far observations share. E
    // alone would bend whatever it permits.
    const ActionChain chain =
        plan.is_sharp ? chain_.widened(scale).withCommonTurn() : chain_.widened(scale);
    for (const std::size_t size : plan.windows)
      if (size < given_.size())
        for (const EntropyLevel& level : levels(plan))
          search_.descendWindows(chain, level, size, plan.name, found.u);
    for (const EntropyLevel& level : levels(plan))
      search_.descendWhole(chain, level, plan.name, found.u);
    found.poses = chain.path(found.u);
    judge(found.poses, found.evidence);
    found.wide_entropy = wideEntropy(found.poses);
    candidates_.push_back(found);
    search_.advanceTo(0.3 + 0.11 * static_cast<double>(candidates_.size()));
  }

  /** In a correct map, rays are contradicted hardly more often than within windows. A
   * little more is permitted for walls that are seen again at another time and from
   * another side. */
  bool
  isGood(const MapCandidate& map) const
  {
    const MapEvidence& rays = map.evidence;
    return rays.near_contradictions < contradictionsIn(usual_) + 0.08 &&
           rays.far_contradictions < contradictionsIn(usual_) + 0.16 &&
           rays.far_contradictions < 3 * rays.near_contradictions + 0.03 &&
           arePairsGood(map, max_pair) && hasMet(map) && spreadOf(map) < max_spread &&
           std::max(rays.near_contradictions, rays.far_contradictions) <
               max_contradicted &&
           lengthOf(map.poses) > min_length * lengthOf(given_) &&
           strongestAction(map) < max_sigmas;
  }

  /** Do all pairs of groups of observations fit together? Where some do not, something
   * has moved, or observations lie at a wrong place. The map is trusted if these are few
   * rays and if another search has found the same. */
  bool
  arePairsGood(const MapCandidate& map, double maximum) const
  {
    if (map.evidence.pair_contradictions < maximum)
      return true;
    if (map.evidence.contradicted_pairs > max_contradicted_pairs)
      return false;
    const double moved = distanceBetween(map.poses, given_);
    return std::any_of(
        candidates_.begin(), candidates_.end(), [&](const MapCandidate& other) {
          return !areAlike(map, other) &&
                 distanceBetween(map.poses, other.poses) < 0.1 * moved + 0.1;
        });
  }

  /** Do two searches minimise the same energy? */
  static bool
  areAlike(const MapCandidate& a, const MapCandidate& b)
  {
    const auto isDirected = [](const MapCandidate& map) {
      return map.name == directed.name || map.name == gradual.name;
    };
    return &a == &b || (isDirected(a) && isDirected(b) && a.scale == b.scale);
  }

  /** By how much, in bits, the walls are less together than those of the given map, in
   * bins as wide as its errors. The sharp search can pull apart what belongs together,
   * because it subtracts this entropy, and rays do not contradict that. */
  double
  spreadOf(const MapCandidate& map) const
  {
    return map.wide_entropy - given_wide_entropy_;
  }

  /** Far observations must see about as much in common as in the result of windows:
   * rays do not contradict a map whose parts are pulled away from each other. */
  bool
  hasMet(const MapCandidate& map) const
  {
    return map.evidence.far_rays >= 0.5 * locals_[usual_].evidence.far_rays;
  }

  /** Is the map so good that no further search is needed? */
  bool
  isConvincing(const MapCandidate& map) const
  {
    const MapEvidence& rays = map.evidence;
    return isGood(map) &&
           rays.far_contradictions < 1.7 * rays.near_contradictions + 0.03 &&
           arePairsGood(map, convincing_pair);
  }

  /** Largest residual of an action, in standard deviations of the usual noise. */
  double
  strongestAction(const MapCandidate& map) const
  {
    return map.scale / std::max(map.scale, locals_[usual_].scale) *
           map.u.head(map.u.size() - 1).cwiseAbs().maxCoeff();
  }

  /** Returns the candidate with the best balance of confirmed and contradicted rays.
   * The first candidate, which is the most accurate one if several are correct, is
   * preferred unless another one is clearly better. */
  const MapCandidate&
  best() const
  {
    const auto merit = [this](const MapCandidate& map) {
      return (isGood(map) ? 1 : 0) + balanceOf(map.evidence) +
             (&map == candidates_.data() ? 0.04 : 0.0);
    };
    return *std::max_element(candidates_.begin(),
                             candidates_.end(),
                             [&](const MapCandidate& a, const MapCandidate& b) {
                               return merit(a) < merit(b);
                             });
  }

  std::vector<PlanarPose>
  decide()
  {
    const MapCandidate& map = best();
    for (const MapCandidate& other : candidates_)
      if (&other != &map && (report_.disagreement == 0 || isGood(other)))
        report_.disagreement = distanceBetween(map.poses, other.poses);
    if (!isGood(map))
      return decideAboutWindows(map);
    tell(map);
    const std::string search = std::string(map.name) + " search";
    if (!isBetter(map.evidence, report_.before))
      return end(RectificationOutcome::Kept,
                 "the given map is as good as the best one that was found (" + search +
                     ")");
    end(RectificationOutcome::Rectified,
        "the rays agree better with a map of the " + search);
    return map.poses;
  }

  void
  tell(const MapCandidate& map)
  {
    report_.after = map.evidence;
    report_.odometry_scale = map.scale;
    report_.strongest_action = strongestAction(map);
  }

  /** Where the rays contradict every map of the whole, neighbouring observations can
   * still be put right: their result is less accurate, but no far observations are laid
   * onto each other. */
  std::vector<PlanarPose>
  decideAboutWindows(const MapCandidate& whole)
  {
    const MapCandidate& windows = locals_[usual_];
    const double now = windows.evidence.near_contradictions;
    const double before = report_.before.near_contradictions;
    const bool are_better = now < std::min(0.8 * before, before - 0.01) &&
                            now < max_near &&
                            lengthOf(windows.poses) > min_length * lengthOf(given_) &&
                            strongestAction(windows) < max_sigmas;
    if (!are_better) {
      tell(whole);
      return end(RectificationOutcome::Refused, contradictionOf(whole));
    }
    tell(windows);
    report_.remarks.push_back("only neighbouring observations were fitted to each "
                              "other, because " +
                              contradictionOf(whole));
    end(RectificationOutcome::Rectified,
        "the rays agree better where neighbouring observations fit, but with no map of "
        "the whole");
    return windows.poses;
  }

  std::string
  contradictionOf(const MapCandidate& map) const
  {
    std::ostringstream text;
    text.precision(3);
    text << "rays contradict the best map found: "
         << 100 * map.evidence.near_contradictions
         << " % of those that near observations tell about and "
         << 100 * map.evidence.far_contradictions
         << " % of those that far ones do, where short windows have "
         << 100 * contradictionsIn(usual_) << " %; "
         << 100 * map.evidence.pair_contradictions
         << " % between two groups of observations; its strongest action is "
         << strongestAction(map) << " sigma; its path is "
         << lengthOf(map.poses) / lengthOf(given_)
         << " times as long as the odometry's; its entropy in wide bins is "
         << spreadOf(map) << " bits above that of the given map";
    return text.str();
  }

  std::vector<PlanarPose>
  end(RectificationOutcome outcome, const std::string& reason)
  {
    report_.outcome = outcome;
    report_.reason = reason;
    return given_;
  }

  static constexpr double max_contradicted = 0.5; ///< share of rays
  static constexpr double min_length = 2.0 / 3;   ///< against a collapse
  static constexpr double max_sigmas = 6;         ///< maximum residual of an action
  static constexpr double max_spread = 0.002;     ///< bits
  static constexpr double max_pair = 0.5; ///< share of the rays of a pair of groups
  static constexpr double convincing_pair = 0.3; ///< same, without another search
  static constexpr double much_near = 0.12; ///< same, so that wider windows are tried
  static constexpr double max_contradicted_pairs = 0.03; ///< share of far rays
  static constexpr double max_near = 0.2;   ///< share of near rays, of windows alone
  static constexpr double usual_scales = 4; ///< larger only against contradictions
  static constexpr double min_scale = 0.25; ///< of the odometry noise

  const RectificationTask& task_;
  EntropySearch& search_;
  RayEvidence rays_;
  ActionChain chain_;
  const std::vector<PlanarPose>& given_;
  EntropyRectificationReport& report_;
  double given_wide_entropy_ = 0;
  std::vector<MapCandidate> locals_; ///< results of windows only, by scale
  std::size_t usual_ = 0;            ///< index of the usual scale
  double map_scale_ = 1;             ///< scale for maps of the whole
  std::vector<MapCandidate> candidates_;
};

} // namespace

std::vector<PlanarPose>
guardedSearch(const RectificationTask& task,
              EntropySearch& search,
              const std::vector<PlanarPose>& poses)
{
  return GuardedSearch(task, search, poses).run();
}

} // namespace pcl::acmap
