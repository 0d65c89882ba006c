#pragma once

#include <string>

namespace pcl::acmap {

/** \brief Where the way to a compact map begins. */
enum class StartingPoint {
  Session,           ///< raw, of a rig: all stages
  Observations,      ///< PCDs without poses
  PosedObservations, ///< PCDs with poses
  Cloud              ///< one file, in the map's frame
};

/** \brief As users read it. */
const char*
nameOf(StartingPoint start);

/** \brief Tells by what lies there: session.yaml makes a session, a folder of PCDs has
 * poses when it has a trajectory.txt, or two VIEWPOINTs that differ.
 * \param[in] skip_broken PCDs that cannot be read have no say
 * \throws InputFileException when it is a folder of neither, or a PCD cannot be read */
StartingPoint
startingPointOf(const std::string& input, bool skip_broken);

} // namespace pcl::acmap
