#pragma once

#include <pcl/core/progress.h>

#include <utility>

namespace pcl {

/** \brief What every stage of "Active Stereo Based Compact Mapping" lets its user set and
 * ask beside its own parameters. Base of the classes of the stages.
 * \tparam ReportT what a run tells of itself \ingroup core
 */
template <typename ReportT>
class StageControls {
public:
  /** \brief Sets the number of threads (0 = all, default); the result is the same. */
  void
  setNumberOfThreads(unsigned int threads = 0)
  {
    threads_ = threads;
  }

  unsigned int
  getNumberOfThreads() const
  {
    return threads_;
  }

  /** \brief Sets who is told about the progress and may stop the run. */
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
