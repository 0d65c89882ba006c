#include "pose_draws.h"

#include <pcl/core/random.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/SparseCholesky>

#include <cmath>

namespace pcl::acmap {
namespace {

constexpr std::size_t number_of_draws = 48;
constexpr int solver_iterations = 6; ///< of Gauss and Newton
constexpr double scale_error = 0.003, turn_per_metre = 0.0005, turn_share = 0.002;

/** Least squares of the links about a trajectory whose first pose stays. */
class PoseGraph {
public:
  PoseGraph(const std::vector<PoseLink>& links, const std::vector<PlanarPose>& poses)
  : links_(links)
  {
    const auto unknowns = static_cast<Eigen::Index>(3 * (poses.size() - 1));
    std::vector<Eigen::Triplet<double>> entries;
    for (const PoseLink& link : links_) {
      const PlanarPose& from = poses[link.from];
      rows_.push_back(partsOfAction(from, actionBetween(from, poses[link.to])));
      information_.push_back(link.covariance.inverse());
      const Rows weighted = information_.back() * rows_.back();
      const Eigen::Matrix<double, 6, 6> part = rows_.back().transpose() * weighted;
      for (int a = 0; a < 6; ++a)
        for (int b = 0; b < 6; ++b)
          if (placeOf(link, a) >= 0 && placeOf(link, b) >= 0)
            entries.emplace_back(placeOf(link, a), placeOf(link, b), part(a, b));
    }
    matrix_.resize(unknowns, unknowns);
    matrix_.setFromTriplets(entries.begin(), entries.end());
    solver_.compute(matrix_);
  }

  /** \param[in] residuals measured minus predicted, one a link */
  Eigen::VectorXd
  solve(const std::vector<Eigen::Vector3d>& residuals) const
  {
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(matrix_.rows());
    for (std::size_t k = 0; k < links_.size(); ++k) {
      const Eigen::Matrix<double, 6, 1> part =
          rows_[k].transpose() * (information_[k] * residuals[k]);
      for (int a = 0; a < 6; ++a)
        if (placeOf(links_[k], a) >= 0)
          gradient[placeOf(links_[k], a)] += part[a];
    }
    return solver_.solve(gradient);
  }

private:
  using Rows = Eigen::Matrix<double, 3, 6>;

  static Eigen::Index
  placeOf(const PoseLink& link, int column)
  {
    return 3 * (static_cast<Eigen::Index>(column < 3 ? link.from : link.to) - 1) +
           column % 3;
  }

  const std::vector<PoseLink>& links_;
  std::vector<Rows> rows_;
  std::vector<Eigen::Matrix3d> information_;
  Eigen::SparseMatrix<double> matrix_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

void
addTo(std::vector<PlanarPose>& poses, const Eigen::VectorXd& change)
{
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const Eigen::Vector3d one = change.segment<3>(3 * static_cast<Eigen::Index>(i - 1));
    poses[i].x += one[0];
    poses[i].z += one[1];
    poses[i].theta += one[2];
  }
}

/** The trajectory that begins at 0, with steps to which something is added. */
std::vector<PlanarPose>
pathOf(const std::vector<PoseLink>& steps, const std::vector<Eigen::Vector3d>& added)
{
  std::vector<PlanarPose> poses(1);
  for (std::size_t t = 0; t < steps.size(); ++t) {
    const PlanarPose& step = steps[t].T_from_to;
    const Eigen::Vector3d& more = added[t];
    poses.push_back(moved(poses.back(),
                          {step.x + more[0], step.z + more[1], step.theta + more[2]}));
  }
  return poses;
}

/** What a draw adds to its measurements. */
std::vector<Eigen::Vector3d>
disturbances(const std::vector<PoseLink>& links, std::size_t steps, Random& random)
{
  const double scale = scale_error * random.normal();
  const double per_metre = turn_per_metre * random.normal();
  const double share = turn_share * random.normal();
  std::vector<Eigen::Vector3d> added;
  for (std::size_t k = 0; k < links.size(); ++k) {
    const PoseLink& link = links[k];
    Eigen::Vector3d normal;
    for (double& value : normal)
      value = random.normal();
    Eigen::Vector3d one = link.covariance.llt().matrixL() * normal;
    if (k < steps) {
      const PlanarPose& step = link.T_from_to;
      one +=
          Eigen::Vector3d(scale * step.x,
                          scale * step.z,
                          per_metre * std::hypot(step.x, step.z) + share * step.theta);
    }
    added.push_back(one);
  }
  return added;
}

} // namespace

PlanarPose
PoseDraws::between(std::size_t draw, std::size_t from, std::size_t to) const
{
  return relative(draws[draw][from], draws[draw][to]);
}

Eigen::Matrix3d
PoseDraws::covarianceBetween(std::size_t from, std::size_t to) const
{
  const PlanarPose middle = relative(mean[from], mean[to]);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t draw = 0; draw < draws.size(); ++draw) {
    const Eigen::Vector3d off = differenceOf(between(draw, from, to), middle);
    covariance += off * off.transpose() / static_cast<double>(draws.size());
  }
  return covariance;
}

std::vector<PlanarPose>
PoseDraws::widened(std::size_t draw, double times) const
{
  std::vector<PlanarPose> poses = mean;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Vector3d off = times * differenceOf(draws[draw][i], mean[i]);
    poses[i] = {poses[i].x + off[0], poses[i].z + off[1], poses[i].theta + off[2]};
  }
  return poses;
}

PoseDraws
drawPoses(const StepChain& chain,
          const std::vector<PoseLink>& revisits,
          std::uint64_t seed)
{
  PoseDraws drawn;
  const std::vector<Eigen::Vector3d> nothing(chain.links.size(),
                                             Eigen::Vector3d::Zero());
  drawn.mean = pathOf(chain.links, nothing);
  std::vector<PoseLink> links = chain.links;
  links.insert(links.end(), chain.skips.begin(), chain.skips.end());
  links.insert(links.end(), revisits.begin(), revisits.end());
  for (int k = 0; k < solver_iterations; ++k) {
    std::vector<Eigen::Vector3d> residuals;
    for (const PoseLink& link : links)
      residuals.push_back(differenceOf(
          link.T_from_to, relative(drawn.mean[link.from], drawn.mean[link.to])));
    addTo(drawn.mean, PoseGraph(links, drawn.mean).solve(residuals));
  }
  const PoseGraph graph(links, drawn.mean);
  Random random(seed);
  for (std::size_t draw = 0; draw < number_of_draws; ++draw) {
    const auto added = disturbances(links, chain.links.size(), random);
    drawn.draws.push_back(drawn.mean);
    addTo(drawn.draws.back(), graph.solve(added));
  }
  return drawn;
}

} // namespace pcl::acmap
