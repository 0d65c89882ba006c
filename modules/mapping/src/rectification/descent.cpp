#include "descent.h"

#include <algorithm>
#include <deque>
#include <vector>

namespace pcl::acmap {
namespace {

constexpr std::size_t max_pairs = 12;
constexpr int max_steps = 100;
constexpr int max_tries = 12;       ///< trials of the step length
constexpr double shortening = 0.4;  ///< factor from one trial to the next
constexpr double first_step = 0.3;  ///< length of the first step
constexpr double longest = 3;       ///< maximum step of a variable
constexpr double sufficient = 1e-4; ///< Armijo constant

/** The last steps and the changes of the gradient. */
class CurvaturePairs {
public:
  void
  add(const Eigen::VectorXd& step, const Eigen::VectorXd& change)
  {
    const double curvature = step.dot(change);
    if (!(curvature > 1e-10))
      return;
    pairs_.push_back({step, change, 1 / curvature});
    if (pairs_.size() > max_pairs)
      pairs_.pop_front();
  }

  void
  clear()
  {
    pairs_.clear();
  }

  bool
  empty() const
  {
    return pairs_.empty();
  }

  /** The two-loop recursion of L-BFGS. */
  Eigen::VectorXd
  direction(const Eigen::VectorXd& gradient) const
  {
    Eigen::VectorXd d = -gradient;
    if (pairs_.empty())
      return d * (first_step / std::max(1e-12, gradient.norm()));
    std::vector<double> shares(pairs_.size());
    for (std::size_t i = pairs_.size(); i-- > 0;) {
      shares[i] = pairs_[i].inverse * pairs_[i].step.dot(d);
      d -= shares[i] * pairs_[i].change;
    }
    const Pair& last = pairs_.back();
    d /= last.inverse * last.change.squaredNorm();
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      d += (shares[i] - pairs_[i].inverse * pairs_[i].change.dot(d)) * pairs_[i].step;
    return d;
  }

private:
  struct Pair {
    Eigen::VectorXd step, change;
    double inverse; ///< inverse of their dot product
  };

  std::deque<Pair> pairs_;
};

} // namespace

std::size_t
descend(const Objective& objective,
        Eigen::VectorXd& u,
        double min_fall,
        const DescentObserver& observer)
{
  Eigen::VectorXd gradient(u.size());
  double value = objective(u, gradient);
  std::size_t evaluations = 1;
  CurvaturePairs pairs;
  for (int step = 0; step < max_steps;) {
    Eigen::VectorXd d = pairs.direction(gradient);
    d *= longest / std::max(longest, d.cwiseAbs().maxCoeff());
    const double slope = gradient.dot(d);
    Eigen::VectorXd next_u, next_gradient(u.size());
    double next = value;
    double length = 1;
    bool falls = false;
    for (int i = 0; slope < 0 && i < max_tries && !falls; ++i, length *= shortening) {
      next_u = u + length * d;
      next = objective(next_u, next_gradient);
      ++evaluations;
      falls = next <= value + sufficient * length * slope;
    }
    if (!falls && pairs.empty())
      break;
    if (!falls) { // The pairs are misleading: try again with the gradient only.
      pairs.clear();
      continue;
    }
    const double fall = value - next;
    pairs.add(next_u - u, next_gradient - gradient);
    u.swap(next_u);
    gradient.swap(next_gradient);
    value = next;
    ++step;
    if (observer)
      observer(u, value);
    if (fall < min_fall)
      break;
  }
  return evaluations;
}

} // namespace pcl::acmap
