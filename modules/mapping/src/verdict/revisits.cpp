#include "revisits.h"

#include <pcl/core/random.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace pcl::acmap {
namespace {

constexpr double half_run = 2; ///< metres of path before and after a scan
constexpr std::size_t scans_of_run = 12;
constexpr std::size_t null_pairs = 150;
constexpr double every = 2;    ///< metres of path between scans that are asked
constexpr double min_path = 8; ///< metres of path between two visits
constexpr std::size_t max_starts = 20;
constexpr double view = 2; ///< metres from a scan to the middle of its view
constexpr double metres_per_radian = 0.7;
constexpr double revisit_doubt = 16; ///< factor of the covariance of revisits
constexpr double max_distance = 16;  ///< squared, of Mahalanobis
constexpr double clear_nats = 6;
constexpr std::array<double, 3> sigma_of_round{0.7, 2, 6}; ///< metres, largest

/** How far two views are from each other, metres. */
double
viewDistance(const PlanarPose& a, const PlanarPose& b)
{
  const Eigen::Vector2d from = PlanarMotion(a).place(0, view);
  const Eigen::Vector2d to = PlanarMotion(b).place(0, view);
  return (from - to).norm() +
         metres_per_radian * std::abs(std::remainder(a.theta - b.theta, 2 * M_PI));
}

double
largestSigma(const Eigen::Matrix3d& covariance)
{
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(covariance.topLeftCorner<2, 2>());
  return std::sqrt(std::max(0.0, solver.eigenvalues()[1]));
}

/** A scan of a run, placed in a scan of the other run. */
struct RunMatch {
  std::size_t from = 0, to = 0;
  ScanMatch match;
};

/** A run of scans laid onto another run. */
struct LaidRun {
  std::vector<RunMatch> matches;
  double merit = 0;   ///< sum of L
  double quality = 0; ///< mean
  double scatter = 0; ///< metres, of the placements that its matches mean

  double
  meanMerit() const
  {
    return matches.empty() ? 0 : merit / (180 * static_cast<double>(matches.size()));
  }
};

/** Where scan j may lie in scan i. */
struct Placement {
  PlanarPose T_i_j;
  double distance = 0; ///< squared, of Mahalanobis, from where the steps have it
  LaidRun run;

  double
  nats() const
  {
    return run.merit / 16 - distance / 2;
  }
};

class RevisitSearch {
public:
  RevisitSearch(const std::vector<BeamScan>& scans,
                const StepChain& chain,
                std::uint64_t seed,
                PoseDraws& drawn)
  : scans_(scans)
  , chain_(chain)
  , seed_(seed)
  , drawn_(drawn)
  {
    path_.push_back(0);
    for (const PoseLink& step : chain.links)
      path_.push_back(path_.back() + std::hypot(step.T_from_to.x, step.T_from_to.z));
  }

  Revisits
  run()
  {
    max_null_ = largestOfDistinct();
    std::vector<std::size_t> asked;
    for (std::size_t j = 1; j < path_.size(); ++j)
      if (path_[j] >= min_path &&
          (asked.empty() || path_[j] - path_[asked.back()] >= every))
        asked.push_back(j);
    for (std::size_t round = 0; round < sigma_of_round.size(); ++round) {
      std::vector<Answer> answers(asked.size());
      oneapi::tbb::parallel_for(std::size_t{0}, asked.size(), [&](std::size_t k) {
        answers[k] = ask(asked[k], sigma_of_round[round]);
      });
      const bool is_last = round + 1 == sigma_of_round.size();
      std::vector<std::size_t> open;
      bool is_new = false;
      for (std::size_t k = 0; k < asked.size(); ++k) {
        const Answer& answer = answers[k];
        if (!answer.links.empty()) {
          found_.links.insert(
              found_.links.end(), answer.links.begin(), answer.links.end());
          ++found_.used;
          is_new = true;
        }
        else
          open.push_back(asked[k]);
        found_.ambiguous += is_last && answer.is_ambiguous;
      }
      asked = std::move(open);
      if (is_new)
        drawn_ = drawPoses(chain_, found_.links, seed_ + round + 1);
    }
    return std::move(found_);
  }

private:
  struct Answer {
    std::vector<PoseLink> links;
    bool is_ambiguous = false;
  };

  /** Scans along the path about one, some of them if there are many. */
  std::vector<std::size_t>
  runAbout(std::size_t middle) const
  {
    std::size_t first = middle, end = middle + 1;
    while (first > 0 && path_[middle] - path_[first - 1] <= half_run)
      --first;
    while (end < path_.size() && path_[end] - path_[middle] <= half_run)
      ++end;
    std::vector<std::size_t> run;
    const std::size_t step = (end - first + scans_of_run - 1) / scans_of_run;
    for (std::size_t k = first; k < end; k += step)
      run.push_back(k);
    return run;
  }

  PlanarPose
  between(std::size_t from, std::size_t to) const
  {
    return relative(drawn_.mean[from], drawn_.mean[to]);
  }

  /** Lays the run about scan j onto that about scan i. */
  LaidRun
  laid(std::size_t i, std::size_t j, const PlanarPose& T_i_j) const
  {
    MatchPrior prior;
    prior.length = 0.15;
    prior.turn = 0.08;
    prior.reach = 0.5;
    LaidRun run;
    std::vector<Eigen::Vector2d> places;
    const std::vector<std::size_t> others = runAbout(i);
    for (const std::size_t k : runAbout(j)) {
      const PlanarPose T_i_k = composed(T_i_j, between(j, k));
      const std::size_t onto = *std::min_element(
          others.begin(), others.end(), [&](std::size_t a, std::size_t b) {
            return viewDistance(between(i, a), T_i_k) <
                   viewDistance(between(i, b), T_i_k);
          });
      const ScanMatch match =
          matchScans(scans_[onto], scans_[k], relative(between(i, onto), T_i_k), prior);
      run.merit += match.score.merit;
      run.quality += match.score.quality();
      const PlanarPose meant =
          composed(composed(between(i, onto), match.T_i_j), between(k, j));
      places.emplace_back(meant.x, meant.z);
      run.matches.push_back({onto, k, match});
    }
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& place : places)
      mean += place / static_cast<double>(places.size());
    for (const Eigen::Vector2d& place : places)
      run.scatter += (place - mean).squaredNorm() / static_cast<double>(places.size());
    run.scatter = std::sqrt(run.scatter);
    run.quality /= static_cast<double>(places.size());
    return run;
  }

  /** The largest mean L of runs at places that are distinct: how much this building
   * resembles itself. */
  double
  largestOfDistinct() const
  {
    constexpr double least_apart = 2, most_apart = 15, most_path = 60; // metres
    constexpr double moved_away = 1.2;                                 // metres
    constexpr std::size_t tries = 20000;
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    Random random(seed_);
    const auto number = [&] {
      return static_cast<std::size_t>(
          random.uniform(0, static_cast<double>(scans_.size()) - 1e-9));
    };
    for (std::size_t k = 0; k < tries && pairs.size() < null_pairs; ++k) {
      const std::size_t a = number(), b = number();
      const std::size_t i = std::min(a, b), j = std::max(a, b);
      const PlanarPose way = between(i, j);
      const double apart = std::hypot(way.x, way.z);
      if (apart > least_apart && apart < most_apart && path_[j] - path_[i] < most_path)
        pairs.emplace_back(i, j);
    }
    std::vector<double> merits(pairs.size(), 0);
    oneapi::tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t k) {
      const auto [i, j] = pairs[k];
      const PlanarPose true_place = between(i, j);
      std::optional<ScanMatch> best;
      for (const double turn : {0.0, M_PI / 2, M_PI, -M_PI / 2}) {
        const ScanMatch match = matchScans(scans_[i], scans_[j], {0, 0, turn});
        if (differenceOf(match.T_i_j, true_place).head<2>().norm() > moved_away &&
            (!best || match.score.merit > best->score.merit))
          best = match;
      }
      if (best)
        merits[k] = laid(i, j, best->T_i_j).meanMerit();
    });
    return merits.empty() ? 0 : *std::max_element(merits.begin(), merits.end());
  }

  /** The earlier scan whose view is nearest, if it may be that of the same place. */
  std::optional<std::size_t>
  partnerOf(std::size_t j, double max_sigma, double& sigma) const
  {
    std::optional<std::size_t> nearest;
    double least = 0;
    for (std::size_t i = 0; i < j && path_[j] - path_[i] > min_path; ++i) {
      const double distance = viewDistance(drawn_.mean[i], drawn_.mean[j]);
      if (!nearest || distance < least) {
        least = distance;
        nearest = i;
      }
    }
    if (!nearest)
      return nearest;
    sigma = largestSigma(drawn_.covarianceBetween(*nearest, j));
    if (sigma > max_sigma || least > 2 + 1.5 * sigma)
      return std::nullopt;
    return nearest;
  }

  std::vector<PlanarPose>
  startsOf(std::size_t i, std::size_t j, double sigma) const
  {
    constexpr double spread = 1.5;
    const double apart = std::max(0.35, sigma / 4);
    const PlanarPose mean = between(i, j);
    std::vector<PlanarPose> starts{mean};
    for (std::size_t draw = 0; draw < drawn_.draws.size() && starts.size() < max_starts;
         ++draw) {
      const Eigen::Vector3d off =
          spread * differenceOf(drawn_.between(draw, i, j), mean);
      const PlanarPose start{mean.x + off[0], mean.z + off[1], mean.theta + off[2]};
      const bool is_new =
          std::all_of(starts.begin(), starts.end(), [&](const PlanarPose& other) {
            const Eigen::Vector3d way = differenceOf(start, other);
            return way.head<2>().norm() + metres_per_radian * std::abs(way[2]) > apart;
          });
      if (is_new)
        starts.push_back(start);
    }
    return starts;
  }

  /** Where scan j may lie in scan i, one placement for each of those that are distinct. */
  std::vector<Placement>
  placementsOf(std::size_t i, std::size_t j, double sigma) const
  {
    constexpr double distinct = 0.25, distinct_turn = 0.08; // metres, radians
    MatchPrior prior;
    prior.length = 0.4;
    prior.turn = 0.2;
    Eigen::Matrix3d covariance = drawn_.covarianceBetween(i, j);
    covariance.diagonal() += Eigen::Vector3d(0.05, 0.05, 0.015).cwiseAbs2();
    const Eigen::Matrix3d information = covariance.inverse();
    const PlanarPose mean = between(i, j);
    std::vector<ScanMatch> matches;
    for (const PlanarPose& start : startsOf(i, j, sigma)) {
      const ScanMatch match = matchScans(scans_[i], scans_[j], start, prior);
      const auto same =
          std::find_if(matches.begin(), matches.end(), [&](const ScanMatch& other) {
            const Eigen::Vector3d off = differenceOf(match.T_i_j, other.T_i_j);
            return off.head<2>().norm() < distinct && std::abs(off[2]) < distinct_turn;
          });
      if (same == matches.end())
        matches.push_back(match);
      else if (match.score.merit > same->score.merit)
        *same = match;
    }
    std::vector<Placement> placements;
    for (const ScanMatch& match : matches) {
      const Eigen::Vector3d off = differenceOf(match.T_i_j, mean);
      placements.push_back(
          {match.T_i_j, off.dot(information * off), laid(i, j, match.T_i_j)});
    }
    return placements;
  }

  std::vector<PoseLink>
  linksOf(LaidRun run) const
  {
    std::stable_sort(run.matches.begin(),
                     run.matches.end(),
                     [](const RunMatch& a, const RunMatch& b) {
                       return a.match.score.merit > b.match.score.merit;
                     });
    std::vector<PoseLink> links;
    for (const RunMatch& one : run.matches)
      if (links.size() < 2 && one.match.score.quality() > 0.55 &&
          one.match.score.agree > 30)
        links.push_back(
            {one.from, one.to, one.match.T_i_j, looseCovariance(one.match)});
    return links;
  }

  /** Along axes that the scans hardly tell, revisits slide further than matching says. */
  Eigen::Matrix3d
  looseCovariance(const ScanMatch& match) const
  {
    constexpr double certain = 0.06, slide = 0.3; // metres
    Eigen::Matrix3d covariance = covarianceOf(match, revisit_doubt * chain_.inflation);
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
    solver.computeDirect(covariance.topLeftCorner<2, 2>());
    for (const int axis : {0, 1})
      if (solver.eigenvalues()[axis] > certain * certain) {
        const Eigen::Vector2d along = solver.eigenvectors().col(axis);
        covariance.topLeftCorner<2, 2>() +=
            (15 * solver.eigenvalues()[axis] + slide * slide) * along *
            along.transpose();
      }
    covariance.diagonal() += Eigen::Vector3d(0.03, 0.03, 0.008).cwiseAbs2();
    return covariance;
  }

  Answer
  ask(std::size_t j, double max_sigma) const
  {
    Answer answer;
    double sigma = 0;
    const std::optional<std::size_t> i = partnerOf(j, max_sigma, sigma);
    if (!i)
      return answer;
    const std::vector<Placement> placements = placementsOf(*i, j, sigma);
    const auto best = std::max_element(
        placements.begin(),
        placements.end(),
        [](const Placement& a, const Placement& b) { return a.nats() < b.nats(); });
    const LaidRun& run = best->run;
    if (!(best->distance < max_distance && run.quality > 0.55 &&
          run.meanMerit() > 0.45 && run.scatter < 0.2))
      return answer;
    const bool is_rare =
        run.meanMerit() > std::max(0.6, 1.05 * max_null_) || 3 * sigma < 1.6;
    const bool has_rival =
        std::any_of(placements.begin(), placements.end(), [&](const Placement& other) {
          return differenceOf(other.T_i_j, best->T_i_j).head<2>().norm() > 0.4 &&
                 other.nats() > best->nats() - clear_nats;
        });
    answer.is_ambiguous = !is_rare || has_rival;
    if (!answer.is_ambiguous)
      answer.links = linksOf(run);
    return answer;
  }

  const std::vector<BeamScan>& scans_;
  const StepChain& chain_;
  std::uint64_t seed_;
  PoseDraws& drawn_;
  std::vector<double> path_; ///< metres, along the steps
  double max_null_ = 0;
  Revisits found_;
};

} // namespace

Revisits
findRevisits(const std::vector<BeamScan>& scans,
             const StepChain& chain,
             std::uint64_t seed,
             PoseDraws& drawn)
{
  return RevisitSearch(scans, chain, seed, drawn).run();
}

} // namespace pcl::acmap
