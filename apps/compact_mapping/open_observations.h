#pragma once

#include "rgbd_import/rgbd_options.h"
#include "stage_log.h"

#include <pcl/core/point_cloud_reader.h>
#include <pcl/pipeline/bag_settings.h>
#include <pcl/pipeline/observation_sequence.h>

#include <cstddef>
#include <optional>
#include <string>

namespace pcl::acmap {

/** \brief The kind of input from which a compact map is computed. */
enum class StartingPoint {
  Session,           ///< raw session of a rig: all stages
  Observations,      ///< PCDs, or a file of several observations, without poses
  PosedObservations, ///< the same with poses
  Cloud              ///< one file, in the map's frame
};

/** \brief Name for messages. */
const char*
nameOf(StartingPoint start);

/** \brief An input that was looked at. */
struct MapInput {
  StartingPoint start = StartingPoint::Cloud;
  /** \brief The observations of a file that has several, an E57 file of several scans or a
   * bag of ROS, or those of an RGB-D folder. */
  std::optional<ObservationSequence> recorded;
};

/** \brief Determines the kind of an input from its files: a folder with a session.yaml
 * is a session; a folder of PCDs has poses when it has a trajectory.txt, or two
 * VIEWPOINTs that differ. A file of several observations and an RGB-D folder are the same as
 * a folder of them.
 * \param[in] bag how a bag is read; an RGB-D folder takes each n-th frame, too
 * \param[in] skip_broken ignore PCDs that cannot be read
 * \param[in] reader with the shift that is stated
 * \throws InputFileException when it is another folder, or a bag or the header of a PCD
 * cannot be read */
MapInput
openObservations(const std::string& path,
                 const BagSettings& bag,
                 bool skip_broken,
                 const RgbdOptions& rgbd,
                 const PointCloudReader& reader);

/** \brief Writes the observations of a file as a folder of PCDs, with trajectory.txt if
 * their poses are known, as a step of the chain. The detail `shift` is that of the
 * sequence.
 * \param[in] path of the file
 * \throws InputFileException when an observation cannot be read */
void
importRecording(const std::string& path,
                const ObservationSequence& sequence,
                const std::string& folder,
                const RunControls& controls,
                StageLog& log);

} // namespace pcl::acmap
