#pragma once

#include <string>

namespace pcl::acmap {

/** \brief The kind of input from which a compact map is computed. */
enum class StartingPoint {
  Session,           ///< raw session of a rig: all stages
  Observations,      ///< PCDs without poses
  PosedObservations, ///< PCDs with poses
  Cloud              ///< one file, in the map's frame
};

/** \brief Name for messages. */
const char*
nameOf(StartingPoint start);

/** \brief Determines the kind of an input from its files: a folder with a session.yaml
 * is a session; a folder of PCDs has poses when it has a trajectory.txt, or two
 * VIEWPOINTs that differ.
 * \param[in] skip_broken ignore PCDs that cannot be read
 * \throws InputFileException when it is another folder, or a PCD cannot be read */
StartingPoint
startingPointOf(const std::string& input, bool skip_broken);

} // namespace pcl::acmap
