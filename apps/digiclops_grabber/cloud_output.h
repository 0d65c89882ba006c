#pragma once

#include "active_stereo/frame_rectifier.h"
#include "active_stereo/observation_maker.h"
#include "active_stereo/stereo_results.h"
#include "device.h"

#include <pcl/core/output_folder.h>

#include <optional>

namespace pcl::acmap {

/** \brief Makes the device's frames ready for matching.
 * \param[in] threads 0 = all
 * \throws InputFileException when the rig cannot be matched or rectified */
FrameRectifier
rectifierOf(const GrabberOptions& options, const Device& device, unsigned threads);

/** \brief The observations of a run as point clouds, as pcl_active_stereo makes them of a
 * session. Their files are in the folder's hidden part until \ref commit. */
class CloudOutput {
public:
  /** \throws OutputFileException when the folder cannot be written to, or holds
   * observations
   * \throws InputFileException when the rig cannot be matched or rectified
   * \throws MemoryRefused */
  CloudOutput(Tool& tool, const GrabberOptions& options, const Device& device);

  /** \brief Makes a cloud, and writes it where a folder is wanted.
   * \param[in] shots as the device gave them
   * \throws CancelledException when the callback says so */
  PointCloud<PointXYZRGBSigma>::ConstPtr
  make(ObservationShots shots, const ProgressCallback& progress);

  const StereoResults&
  results() const
  {
    return results_;
  }

  void
  commit();

  /** \brief Lines of the summary and the report. */
  void
  tell(Tool& tool) const;

private:
  StereoOptions options_;
  FrameRectifier rectifier_;
  SearchRange range_;
  ObservationMaker maker_;
  std::optional<OutputFolder> folder_;
  StereoResults results_;
};

} // namespace pcl::acmap
