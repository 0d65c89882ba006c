#pragma once

#include "active_stereo/frame_rectifier.h"
#include "active_stereo/observation_maker.h"
#include "active_stereo/stereo_results.h"
#include "device.h"

#include <pcl/core/output_folder.h>

#include <optional>

namespace pcl::acmap {

/** \brief Creates the rectifier of the device's frames.
 * \param[in] threads 0 = all
 * \throws InputFileException when the rig cannot be matched or rectified */
FrameRectifier
rectifierOf(const GrabberOptions& options, const Device& device, unsigned threads);

/** \brief The observations of a run as point clouds, as pcl_active_stereo computes them
 * for a session. Their files are in the folder's hidden part until \ref commit. */
class CloudOutput {
public:
  /** \throws OutputFileException when the folder cannot be written to, or holds
   * observations
   * \throws InputFileException when the rig cannot be matched or rectified
   * \throws MemoryRefused */
  CloudOutput(Tool& tool, const GrabberOptions& options, const Device& device);

  /** \brief Computes a cloud, and writes it if there is an output folder.
   * \param[in] shots as received from the device
   * \throws CancelledException when the callback requests it */
  PointCloud<PointXYZRGBSigma>::ConstPtr
  make(ObservationShots shots, const ProgressCallback& progress);

  const StereoResults&
  results() const
  {
    return results_;
  }

  void
  commit();

  /** \brief Writes lines of the summary and the report. */
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
