#pragma once

#include <pcl/pipeline/observation_sequence.h>

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

/** \brief Determines the kind of an input from its files: a folder with a session.yaml
 * is a session; a folder of PCDs has poses when it has a trajectory.txt, or two
 * VIEWPOINTs that differ. A file of several observations is the same as a folder of them.
 * \param[in] skip_broken ignore PCDs that cannot be read
 * \param[in] recorded of \ref openRecording for the input
 * \throws InputFileException when it is another folder, or a PCD cannot be read */
StartingPoint
startingPointOf(const std::string& input,
                bool skip_broken,
                const std::optional<ObservationSequence>& recorded = {});

} // namespace pcl::acmap
