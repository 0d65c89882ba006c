#pragma once

#include "map_stage.h"

#include <pcl/core/trinocular_frame.h>
#include <pcl/pipeline/compact_mapping.h>

#include <chrono>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

class LiveWindow;

/** \brief A recording that ended early, of which a map was made. */
struct MissingObservations {
  std::string ended_by;         ///< a line; \ref by_the_user
  std::size_t observations = 0; ///< of the map

  /** \brief Fails after the map was written.
   * \param[in] output folder of the map
   * \throws InterruptedPartway, OutputFileException naming what ended the recording */
  [[noreturn]] void
  fail(const std::string& output) const;
};

inline constexpr const char* by_the_user = "interrupted";

/** \brief The map of observations that are still being made (\ref CompactMapping::start):
 * of a camera, or of a session that is replayed. */
class LiveMap {
public:
  /** \param[in] options are referred to
   * \param[in] rig of rectified frames
   * \param[in] observations folder for these; it is removed with this object unless
   * \ref finish or \ref keep was called
   * \param[in] window shows the map so far, and is used by the thread of this object's
   * user only; may be null
   * \throws what \ref setUpStereo does */
  LiveMap(const ChainOptions& options,
          const TrinocularRig& rig,
          std::string observations,
          unsigned threads,
          LiveWindow* window);

  LiveMap(const LiveMap&) = delete;
  LiveMap&
  operator=(const LiveMap&) = delete;

  /** \brief Removes the observations of a map that was not finished. */
  ~LiveMap();

  /** \brief Adds a complete observation; waits as long as too many wait already.
   * \param[in] frames rectified
   * \throws what its processing, or that of earlier ones, has thrown */
  void
  add(const std::vector<TrinocularFrame::ConstPtr>& frames);

  /** \brief Number of observations that were added; of a finished map, those that it was
   * made of. */
  std::size_t
  observations() const
  {
    return made_of_.value_or(mapping_.getNumberOfObservations());
  }

  /** \brief Number of observations whose files are complete. */
  std::size_t
  processed() const
  {
    const std::lock_guard lock(mutex_);
    return processed_;
  }

  /** \brief Shows what is new in the window. */
  void
  show();

  /** \brief After a fault of the processing, the map is made of the observations before
   * it; their files are removed before it is written, since the fault may be a full
   * disk.
   * \param[in] fault one line */
  void
  keepProcessed(const std::string& fault);

  /** \brief The user has ended the recording. */
  void
  noteInterrupted()
  {
    ended_by_ = by_the_user;
  }

  /** \brief Keeps the observations, though there will be no map. */
  void
  keep()
  {
    is_kept_ = true;
  }

  /** \brief Completes the map, writes it as \ref makeMap does, and tells how long that took
   * after the last observation, and how late the mapping was. A full disk on the way is
   * told, too, see \ref missing.
   * \param[in,out] folder is committed
   * \return names of the files
   * \throws NothingFound when there is no plane */
  std::vector<std::string>
  finish(const PicturesApart& pictures,
         OutputFolder& folder,
         const RunControls& controls,
         StageLog& log);

  /** \brief Why the recording ended early, if it did. */
  std::optional<MissingObservations>
  missing() const;

private:
  using Clock = std::chrono::steady_clock;

  void
  removeObservations() const;

  void
  note(const MappingState& state);

  void
  tellLateness(double recorded, StageLog& log) const;

  const ChainOptions& options_;
  std::string folder_; ///< of the observations
  LiveWindow* window_;
  bool is_kept_ = false;
  bool is_partial_ = false;                ///< \ref keepProcessed was called
  std::string ended_by_;                   ///< of \ref missing
  std::optional<Clock::time_point> begin_; ///< of the first observation
  std::optional<std::size_t> made_of_;     ///< observations of the finished map

  mutable std::mutex mutex_; ///< of what \ref note writes
  std::optional<MappingState> news_;
  std::size_t processed_ = 0;
  std::size_t waits_ = 0;
  std::size_t largest_backlog_ = 0;
  double largest_lag_ = 0; ///< seconds

  CompactMapping mapping_; ///< its threads end before what they tell goes
};

/** \brief Where the map of a part of the observations is, for a message. */
std::string
partialMapText(std::size_t observations, const std::string& output);

/** \brief The result of a replay. */
struct ReplayedMap {
  std::vector<std::string> files; ///< their names
  std::optional<MissingObservations> missing;
};

/** \brief Replays a session at the pace at which it was recorded, and maps it while its
 * frames arrive.
 *
 * When the user interrupts the replay, or it fails, the map is made of the observations
 * that were complete by then; a second interruption stops that, too.
 * \param[in] observations folder for these; it is removed if there is no map
 * \param[in] window may be null
 * \param[in,out] folder is committed
 * \throws NothingFound when there is no plane */
ReplayedMap
mapAsRecorded(const ChainOptions& options,
              const std::string& observations,
              const PicturesApart& pictures,
              LiveWindow* window,
              OutputFolder& folder,
              const RunControls& controls,
              StageLog& log);

} // namespace pcl::acmap
