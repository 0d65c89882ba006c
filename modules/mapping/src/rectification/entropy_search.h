#pragma once

#include "action_chain.h"
#include "rectification_task.h"

#include <pcl/mapping/map_entropy_kernel.h>

#include <map>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief A level of the descent: how coarse, and how much a bit weighs. */
struct EntropyLevel {
  double bin_size;
  double weight; ///< kappa
  bool direction_aware;
  bool is_sharp; ///< less the entropy in wide bins
};

/** \brief Minimises F(u) = kappa N (E - E_wide) + |u|^2 / 2 over N observations: the entropy
 * of their map against the odometry; or kappa N E + |u|^2 / 2.
 *
 * E_wide is the same entropy in bins four times as wide. E alone falls when a map shrinks,
 * and when any walls are laid on each other, however far apart; both fall by as much in
 * wide bins. What is left is how sharp walls are that are near each other already; from farther away
 * only E leads. */
class EntropySearch {
public:
  explicit EntropySearch(const RectificationTask& task)
  : task_(task)
  {}

  /** \brief The whole map. \param[in] name of the search, for the energy curve */
  void
  descendWhole(const ActionChain& chain,
               const EntropyLevel& level,
               const std::string& name,
               Eigen::VectorXd& u);

  /** \brief Windows of \a size observations, each alone: first those that begin at
   * multiples of the size, then those between. */
  void
  descendWindows(const ActionChain& chain,
                 const EntropyLevel& level,
                 std::size_t size,
                 const std::string& name,
                 Eigen::VectorXd& u);

  /** \brief Says how much of the whole work is done. */
  void
  advanceTo(double fraction)
  {
    fraction_ = fraction;
  }

  const std::vector<EntropyCells>&
  cells(const EntropyLevel& level);

  MapEntropySettings
  entropySettings(const EntropyLevel& level) const;

private:
  std::size_t
  descendPart(const ActionChain& chain,
              const EntropyLevel& level,
              std::size_t first,
              std::size_t last,
              Eigen::VectorXd& u,
              const std::string* name);

  void
  tellStep(const ActionChain& chain,
           const EntropyLevel& level,
           const std::string& name,
           const Eigen::VectorXd& u);

  void
  makeCells(const EntropyLevel& level);

  const RectificationTask& task_;
  double fraction_ = 0;
  std::map<std::pair<double, bool>, std::vector<EntropyCells>> cells_;
};

} // namespace pcl::acmap
