#pragma once

#include "observation_maker.h"
#include "tool.h"

#include <map>
#include <set>
#include <string>

namespace pcl::acmap {

/** \brief What came of all observations, for summary and report. */
class StereoResults {
public:
  void
  add(const ObservationShots& shots, const MadeObservation& made);

  /** \brief Takes the \ref entries of an earlier run.
   * \throws nlohmann::json::exception when they are something else */
  void
  takeEntries(const nlohmann::ordered_json& entries);

  /** \brief Whether an observation is among them. */
  bool
  has(std::size_t observation) const
  {
    return numbers_.count(observation) != 0;
  }

  std::size_t
  observations() const
  {
    return entries_.size();
  }

  std::size_t
  points() const
  {
    return points_;
  }

  /** \throws InputFileException when there was no frame to make them of
   * \throws NothingFound when there is no point in any */
  void
  requireAny(Tool& tool, const StereoOptions& options, const ShotSource& source) const;

  /** \brief Summary, report and warnings.
   * \param[in] options what the user asked for
   * \param[in] source at its end */
  void
  tell(Tool& tool,
       const StereoOptions& options,
       const ShotSource& source,
       const SearchRange& range) const;

  /** \brief Share of the pixels that have a disparity, in [0, 1]. */
  double
  matchedShare() const;

  /** \brief Likewise as text, in percent. */
  std::string
  matchedText() const;

  /** \brief Why the others have none, most frequent first: "3.1 % untextured, ...". */
  std::string
  rejected() const;

  /** \brief For the report: of each observation its counts, in their order. */
  const nlohmann::ordered_json&
  entries() const
  {
    return entries_;
  }

  /** \brief What was odd about the observations, as warnings. */
  void
  warnOfRemarks(Tool& tool) const;

private:
  void
  warn(Tool& tool, const StereoOptions& options, const ShotSource& source) const;

  /** \brief A remark that several observations may have. */
  struct Remark {
    std::size_t first = 0; ///< number of the observation
    std::size_t count = 0;
  };

  void
  addEntry(const nlohmann::ordered_json& entry);

  void
  addRemark(const std::string& text, std::size_t observation);

  nlohmann::ordered_json entries_ = nlohmann::ordered_json::array();
  std::size_t pixels_ = 0;
  std::size_t points_ = 0;
  std::size_t too_near_ = 0;
  std::size_t too_far_ = 0;
  std::size_t frames_ = 0;
  std::array<std::size_t, disparity_outcomes> outcomes_{};
  std::map<std::string, Remark> remarks_;
  std::set<std::size_t> numbers_;
};

} // namespace pcl::acmap
