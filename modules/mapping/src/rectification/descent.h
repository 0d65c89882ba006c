#pragma once

#include <Eigen/Core>

#include <functional>

namespace pcl::acmap {

/** \brief Returns the value at u and computes its gradient. */
using Objective =
    std::function<double(const Eigen::VectorXd& u, Eigen::VectorXd& gradient)>;

/** \brief Called after each step with the current value. */
using DescentObserver = std::function<void(const Eigen::VectorXd& u, double value)>;

/** \brief Minimises by L-BFGS (Nocedal and Wright, algorithm 7.4) with backtracking: 12
 * pairs, at most 100 steps, and each step changes a variable by at most 3.
 * \param[in,out] u in: start; out: minimum; the value never increases
 * \param[in] min_fall stops after a step with a smaller decrease
 * \return number of evaluations */
std::size_t
descend(const Objective& objective,
        Eigen::VectorXd& u,
        double min_fall,
        const DescentObserver& observer = {});

} // namespace pcl::acmap
