#pragma once

#include "tool.h"

#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/visual_odometry.h>

#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Options of the user. */
struct EgomotionOptions {
  std::vector<std::string> inputs; ///< one folder, or PCDs in their order
  std::string output;
  VisualOdometry::Egomotion stage;
  bool measures_path = true; ///< unless the user states what it is
  bool pictures = false;
  std::string truth; ///< trajectory to compare with; empty: none

  /** \brief Is it stated that the camera moves in six degrees of freedom instead of three? */
  bool
  isRigid() const
  {
    return stage.getMotionModel() == MotionModel::Rigid;
  }

  /** \brief Is the input one folder? A path that is no PCD is refused as a folder. */
  bool
  hasFolder() const;
};

/** \brief Adds the options to the command line. */
void
addOptions(Tool& tool, EgomotionOptions& options);

/** \brief Adds only the options for the motions. */
void
addMotionChoices(CLI::App& app, EgomotionOptions& options);

/** \brief Opens the inputs, without poses.
 * \param[in] scale metres in a unit of the clouds
 * \throws InputFileException if it is no folder, or holds no PCD file */
ObservationSequence
observationsOf(const EgomotionOptions& options, double scale);

/** \brief Reports the motions of a sequence: warnings, summary and details.
 * \param[in] plan path of a picture of the trajectory */
void
tellOdometry(const EgomotionOptions& options,
             const ObservationSequence& sequence,
             const VisualOdometryResult& found,
             const std::string& plan,
             StageLog& log);

/** \brief Estimates the poses of a sequence and writes them into a folder: the complete
 * work of pcl_visual_egomotion.
 * \param[in] sequence the observations of the options' inputs
 * \throws according to the exit codes of its documentation page */
void
estimatePoses(const EgomotionOptions& options,
              const ObservationSequence& sequence,
              const RunControls& controls,
              StageLog& log);

} // namespace pcl::acmap
