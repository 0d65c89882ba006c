#pragma once

#include <pcl/acquisition/pattern_sequence_grabber.h>

#include <mutex>
#include <optional>

namespace pcl::acmap {

/** \brief Determines the next shot of a sequence and keeps the statistics. All
 * functions may be called from any thread. */
class SequenceProgress {
public:
  /** \brief Identification of a frame. */
  struct Shot {
    std::uint64_t number = 0;
    std::int32_t observation = 0;
    std::int32_t pattern = TrinocularFrame::no_pattern;
  };

  explicit SequenceProgress(std::size_t patterns);

  Shot
  next();

  /** \brief To be called before a shot is passed on; makes the following shot the next
   * one. */
  void
  give(const Shot& shot);

  bool
  isLast(const Shot& shot) const
  {
    return shot.pattern + 1 == patterns_;
  }

  /** \brief Returns true if the observation of a shot was not interrupted or
   * rewound. */
  bool
  isUnderWay(const Shot& shot) const;

  /** \brief Completes the observation of a shot, which needs no further shots. */
  void
  finish(const Shot& shot);

  /** \brief Ends an observation that is incomplete. */
  void
  cutOff();

  void
  rewind();

  /** \brief Resets the report. */
  void
  beginStream();

  PatternSequenceGrabberReport
  report() const;

private:
  bool
  follows(const Shot& shot) const;

  void
  goToNextObservation();

  const std::int32_t patterns_;

  mutable std::mutex mutex_; // protects the members below
  Shot next_;                // pattern = patterns_: the observation has all its shots
  PatternSequenceGrabberReport report_;
};

} // namespace pcl::acmap
