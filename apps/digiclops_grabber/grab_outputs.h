#pragma once

#include "cloud_output.h"
#include "session_output.h"

#include <exception>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief All that a run writes. Session and clouds tell the same: an observation is
 * recorded when it is whole, and then its cloud is made. */
class GrabOutputs {
public:
  using SeeCloud =
      std::function<void(const PointCloud<PointXYZRGBSigma>::ConstPtr& cloud)>;

  /** \param[in] see is called with each cloud; may be empty
   * \throws as \ref SessionOutput and \ref CloudOutput
   * \throws UsageError for one folder twice */
  GrabOutputs(Tool& tool,
              const GrabberOptions& options,
              const Device& device,
              SeeCloud see);

  /** \brief Takes a frame; that of another observation closes the one before. */
  void
  take(const TrinocularFrame::ConstPtr& frame, const ProgressCallback& progress);

  /** \brief The observation is whole: its frames are recorded, its cloud is made.
   * \throws OutputFileException, CancelledException */
  void
  close(const ProgressCallback& progress);

  /** \brief How many were closed. */
  std::size_t
  observations() const
  {
    return observations_;
  }

  /** \brief Number of the observation whose frames come. */
  std::optional<std::size_t>
  openObservation() const;

  /** \brief Bytes of frames that were recorded; nothing without a session. */
  std::optional<std::uintmax_t>
  written() const;

  /** \brief Bytes that are left on the disk that is written to. */
  std::optional<std::uintmax_t>
  free() const;

  /** \brief All is there: puts it into place.
   * \throws NothingFound when there is no point in any cloud; the session stays */
  void
  finish();

  /** \brief Keeps what is whole after an error, and throws it again, with what was
   * kept. */
  [[noreturn]] void
  keep(const std::exception_ptr& error);

  /** \brief Lines of the summary and the report. */
  void
  tell() const;

private:
  void
  checkPlaces() const;

  std::string
  keepClouds();

  std::string
  keepSession();

  Tool& tool_;
  const GrabberOptions& options_;
  SeeCloud see_;
  std::optional<CloudOutput> clouds_;
  std::optional<SessionOutput> session_;
  std::vector<TrinocularFrame::ConstPtr> open_; // of one observation
  ShotGroups groups_;
  std::size_t observations_ = 0;
  std::map<std::string, double> seconds_; // of each step, of all observations
};

} // namespace pcl::acmap
