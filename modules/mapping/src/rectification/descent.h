#pragma once

#include <Eigen/Core>

#include <functional>

namespace pcl::acmap {

/** \brief The value at u, and its derivatives. */
using Objective =
    std::function<double(const Eigen::VectorXd& u, Eigen::VectorXd& gradient)>;

/** \brief Called after each step with the value reached. */
using DescentObserver = std::function<void(const Eigen::VectorXd& u, double value)>;

/** \brief Minimises by L-BFGS (Nocedal and Wright, algorithm 7.4) with backtracking: 12
 * pairs, at most 100 steps, in none of which a variable moves by more than 3.
 * \param[in,out] u from where, to where; the value never rises
 * \param[in] least_fall a step that gains less is the last
 * \return number of evaluations */
std::size_t
descend(const Objective& objective,
        Eigen::VectorXd& u,
        double least_fall,
        const DescentObserver& observer = {});

} // namespace pcl::acmap
