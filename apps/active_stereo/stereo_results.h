#pragma once

#include "observation_maker.h"
#include "tool.h"

#include <map>
#include <set>
#include <string>

namespace pcl::acmap {

/** \brief Collects the results of all observations for summary and report. */
class StereoResults {
public:
  void
  add(const ObservationShots& shots, const MadeObservation& made);

  /** \brief Adds the \ref entries of an earlier run.
   * \throws nlohmann::json::exception when they have another form */
  void
  takeEntries(const nlohmann::ordered_json& entries);

  /** \brief Is an observation among the results? */
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

  /** \throws InputFileException when there was no readable frame
   * \throws NothingFound when no observation has a point */
  void
  requireAny(Tool& tool, const StereoOptions& options, const ShotSource& source) const;

  /** \brief Writes summary, report and warnings.
   * \param[in] options of the user
   * \param[in] source at its end */
  void
  tell(Tool& tool,
       const StereoOptions& options,
       const ShotSource& source,
       const SearchRange& range) const;

  /** \brief Fraction of the pixels that have a disparity, in [0, 1]. */
  double
  matchedShare() const;

  /** \brief The same as text, in percent. */
  std::string
  matchedText() const;

  /** \brief Reasons for missing disparities, most frequent first: "3.1 % untextured,
   * ...". */
  std::string
  rejected() const;

  /** \brief Statistics of each observation, in their order, for the report. */
  const nlohmann::ordered_json&
  entries() const
  {
    return entries_;
  }

  /** \brief Reports the remarks on observations as warnings. */
  void
  warnOfRemarks(Tool& tool) const;

private:
  void
  warn(Tool& tool, const StereoOptions& options, const ShotSource& source) const;

  /** \brief A remark that may apply to several observations. */
  struct Remark {
    std::size_t first = 0; ///< number of the first observation
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
