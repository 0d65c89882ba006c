#pragma once

#include <pcl/core/export.h>
#include <pcl/core/point_cloud_reader.h>
#include <pcl/pipeline/bag_settings.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/rgbd_statement.h>

#include <optional>
#include <string>

namespace pcl {

/** \brief From what a compact map is made, and so with which stage it begins.
 * \ingroup pipeline */
enum class StartingPoint {
  Session,           ///< raw session of a rig: all stages
  Observations,      ///< PCDs, or a file of several observations, without poses
  PosedObservations, ///< the same with poses
  Cloud              ///< one file, in the map's frame
};

/** \brief Name for messages. \ingroup pipeline */
ACMAP_EXPORT const char*
nameOf(StartingPoint start);

/** \brief What is stated of an input, of whatever kind it is. \ingroup pipeline */
struct InputStatement {
  PointCloudReader reader; ///< scale and shift of clouds
  BagSettings bag;         ///< an RGB-D folder takes each n-th frame, too
  RgbdStatement rgbd;
  bool skip_broken = false; ///< ignore PCDs that cannot be read
};

/** \brief An input that was opened. \ingroup pipeline */
struct MapInput {
  StartingPoint start = StartingPoint::Cloud;
  /** \brief None for a session and for one cloud. */
  std::optional<ObservationSequence> observations;
};

/** \brief Finds out what an input is, and opens its observations; points are read when they are
 * needed.
 *
 * A folder with a session.yaml is a session. A folder of PCDs has poses if it has a
 * trajectory.txt, or two VIEWPOINTs that differ. An E57 or PTX file of several scans, a bag of
 * ROS and an RGB-D folder are observations, too. Another file is one cloud, whether it can be
 * read or not.
 * \code
 * const pcl::MapInput input = pcl::openMapInput ("recording");
 * if (input.observations)
 *   mapping.setInputSequence (*input.observations,
 *                             input.start == pcl::StartingPoint::PosedObservations);
 * \endcode
 * \throws InputFileException when it is another folder, or when its bag or the header of a PCD
 * cannot be read \ingroup pipeline */
ACMAP_EXPORT MapInput
openMapInput(const std::string& path, const InputStatement& stated = {});

} // namespace pcl
