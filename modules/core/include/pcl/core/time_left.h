#pragma once

#include <pcl/core/export.h>

#include <optional>
#include <utility>
#include <vector>

namespace pcl {

/** \brief When a run reached which fraction of its work: pairs of fraction and seconds,
 * both ascending, from {0, 0} to {1, all seconds}. \ingroup core */
using RunTimes = std::vector<std::pair<double, double>>;

/** \brief Estimates how long a run will still take, by its progress and, if there was one, by
 * the times of an earlier run of the same kind. \ingroup core */
class ACMAP_EXPORT TimeLeft {
public:
  /** \param[in] earlier empty if there was none */
  explicit TimeLeft(RunTimes earlier = {})
  : earlier_(std::move(earlier))
  {}

  /** \brief Takes a told fraction of the work, which does not fall.
   * \param[in] elapsed seconds since the run began, not falling either */
  void
  tell(double fraction, double elapsed);

  /** \brief Seconds until the end; nothing while too little is known.
   * \param[in] elapsed seconds since the run began, at least those of the last \ref tell */
  std::optional<double>
  at(double elapsed) const;

  /** \brief The times of this run, which ends now. */
  RunTimes
  times(double elapsed) const;

private:
  std::optional<double>
  bySpeed(double elapsed) const;

  double
  byEarlier(double elapsed) const;

  RunTimes earlier_;
  RunTimes told_ = {{0, 0}};
  double compared_ = 0,
         expected_ = 0; ///< seconds of the same parts in this run and the earlier one
  double work_ = 0,
         worked_ = 0; ///< fraction that was done in this run, in these seconds
};

} // namespace pcl
