#pragma once

#include <pcl/core/impl/arguments.h>
#include <pcl/core/progress.h>

#include <utility>

namespace pcl {

/** \brief Base class of the stages of "Active Stereo Based Compact Mapping" with the
 * settings and results that all of them have in common.
 * \tparam ReportT type of the report of a run \ingroup core */
template <typename ReportT>
class StageControls {
public:
  /** \brief Sets the number of threads (0 for all, default); the result does not depend
   * on it. \throws BadArgumentException above 1024 */
  void
  setNumberOfThreads(unsigned int threads = 0)
  {
    threads_ = acmap::requiredThreads(threads);
  }

  unsigned int
  getNumberOfThreads() const
  {
    return threads_;
  }

  /** \brief Sets a callback that is informed about the progress and may stop the run.
   */
  void
  setProgressCallback(ProgressCallback callback)
  {
    progress_ = std::move(callback);
  }

  /** \brief Counts, seconds and remarks of the last run. */
  const ReportT&
  getReport() const
  {
    return report_;
  }

protected:
  StageControls() = default;
  StageControls(const StageControls&) = default;
  StageControls(StageControls&&) = default;
  StageControls&
  operator=(const StageControls&) = default;
  StageControls&
  operator=(StageControls&&) = default;
  ~StageControls() = default;

  unsigned int threads_ = 0;
  ProgressCallback progress_;
  ReportT report_;
};

} // namespace pcl
