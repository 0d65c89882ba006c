#pragma once

#include <pcl/acquisition/pattern_sequence_grabber.h>

#include <mutex>
#include <optional>

namespace pcl::acmap {

/** \brief Which shot of a sequence comes next, and what became of those before. All
 * members may be called from any thread. */
class SequenceProgress {
public:
  /** \brief What a frame is told by. */
  struct Shot {
    std::uint64_t number = 0;
    std::int32_t observation = 0;
    std::int32_t pattern = TrinocularFrame::no_pattern;
  };

  explicit SequenceProgress(std::size_t patterns);

  Shot
  next();

  /** \brief It is about to be given; the one after it is the next. */
  void
  give(const Shot& shot);

  bool
  isLast(const Shot& shot) const
  {
    return shot.pattern + 1 == patterns_;
  }

  /** \brief Whether nobody cut off or rewound what a shot belongs to. */
  bool
  isUnderWay(const Shot& shot) const;

  /** \brief The observation needs no shot after this one. */
  void
  finish(const Shot& shot);

  /** \brief An observation of which shots were given, but not all, is over. */
  void
  cutOff();

  void
  rewind();

  /** \brief The report is of what comes after. */
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

  mutable std::mutex mutex_; // of all below
  Shot next_;                // pattern = patterns_: all were given
  PatternSequenceGrabberReport report_;
};

} // namespace pcl::acmap
