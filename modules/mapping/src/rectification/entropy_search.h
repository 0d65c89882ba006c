#pragma once

#include "action_chain.h"

#include <pcl/mapping/impl/map_entropy_kernel.h>
#include <pcl/mapping/impl/rectification_kernel.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief Observations within this number share little drift: it defines "near" for the
 * rays, and the shortest window that is searched separately. */
inline constexpr std::size_t neighbours = 16;

/** \brief Inputs and outputs of a rectification. */
struct RectificationTask {
  const std::vector<LevelledPoints>& observations;
  const RectificationSettings& settings;
  const Progress& progress;
  EntropyRectificationReport& report;
};

/** \brief mu as it was set, or the one of the mode. */
inline double
projectionWeight(const RectificationSettings& settings)
{
  return settings.projection_weight.value_or(
      settings.mode == RectificationMode::Paper ? 0.1 : 0);
}

/** \brief A level of the descent: its resolution and the weight of the entropy. */
struct EntropyLevel {
  double bin_size;
  double weight; ///< kappa
  bool direction_aware;
  bool is_sharp; ///< minus the entropy in wide bins
};

/** \brief The level whose entropy is subtracted, so that a decrease that also occurs in
 * wide bins does not count. */
EntropyLevel
widened(const EntropyLevel& level);

/** \brief Minimises F(u) = kappa N (E - E_wide) + u^T C^-1 u / 2 over N observations: the
 * entropy of their map against the odometry (\ref ActionChain::prior); or the same with E
 * instead of the difference.
 *
 * E_wide is the same entropy in bins four times as wide. E alone decreases when a map
 * shrinks, and when any walls are moved onto each other, however far apart they are; in
 * both cases E_wide decreases equally. The difference measures the sharpness of walls
 * that are already near each other; to move walls over larger distances, E is
 * needed. */
class EntropySearch {
public:
  explicit EntropySearch(const RectificationTask& task)
  : task_(task)
  {}

  /** \brief Minimises over the whole map. \param[in] name of the search, for the energy
   * curve */
  void
  descendWhole(const ActionChain& chain,
               const EntropyLevel& level,
               const std::string& name,
               Eigen::VectorXd& u);

  /** \brief Minimises over windows of \a size observations separately: first over those
   * that begin at multiples of the size, then over those shifted by half of it. */
  void
  descendWindows(const ActionChain& chain,
                 const EntropyLevel& level,
                 std::size_t size,
                 const std::string& name,
                 Eigen::VectorXd& u);

  /** \brief Sets the fraction of the work that is done. */
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
