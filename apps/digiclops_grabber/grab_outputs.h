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

/** \brief All outputs of a run. Session and clouds are consistent: an observation is
 * recorded when it is complete, and then its cloud is computed. */
class GrabOutputs {
public:
  using SeeCloud =
      std::function<void(const PointCloud<PointXYZRGBSigma>::ConstPtr& cloud)>;

  /** \param[in] see is called with each cloud; may be empty
   * \throws as \ref SessionOutput and \ref CloudOutput
   * \throws UsageError if both have the same folder */
  GrabOutputs(Tool& tool,
              const GrabberOptions& options,
              const Device& device,
              SeeCloud see);

  /** \brief Adds a frame; the first frame of another observation closes the one
   * before. */
  void
  take(const TrinocularFrame::ConstPtr& frame, const ProgressCallback& progress);

  /** \brief Closes the observation: records its frames, and computes its cloud.
   * \throws OutputFileException, CancelledException */
  void
  close(const ProgressCallback& progress);

  /** \brief Number of closed observations. */
  std::size_t
  observations() const
  {
    return observations_;
  }

  /** \brief Number of the current observation. */
  std::optional<std::size_t>
  openObservation() const;

  /** \brief Bytes of frames that were recorded; nothing without a session. */
  std::optional<std::uintmax_t>
  written() const;

  /** \brief Free bytes on the disk of the outputs. */
  std::optional<std::uintmax_t>
  free() const;

  /** \brief Completes the outputs and moves them to their final place.
   * \throws NothingFound when there is no point in any cloud; the session is kept */
  void
  finish();

  /** \brief Keeps complete outputs after an error, and rethrows it with a note about
   * what was kept. */
  [[noreturn]] void
  keep(const std::exception_ptr& error);

  /** \brief Writes lines of the summary and the report. */
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
  std::vector<TrinocularFrame::ConstPtr> open_; // frames of the current observation
  ShotGroups groups_;
  std::size_t observations_ = 0;
  // seconds of each step, summed over all observations
  std::map<std::string, double> seconds_;
};

} // namespace pcl::acmap
