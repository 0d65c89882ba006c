#pragma once

#include "frame_codec.h"

#include <pcl/core/trinocular_rig.h>
#include <pcl/core/yaml_node.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief `frame_000017.acf` */
std::string
frameFileName(std::uint64_t number);

/** \brief Where a file of a session stands. */
std::string
pathIn(const std::string& folder, const std::string& name);

/** \brief What `session.yaml` tells of a session that was finished. */
struct SessionSummary {
  std::string rig = "rig.yaml";  ///< file with the geometry
  std::size_t frames = 0;        ///< how many there are
  std::size_t observations = 0;  ///< different ones
  std::size_t patterns = 0;      ///< different ones, "none" not counted
  std::array<bool, 3> cameras{}; ///< which the frames have
};

/** \brief The text of a `session.yaml`. */
std::string
sessionText(const SessionSummary& summary);

/** \brief The reader behind \ref loadSessionSummary.
 * \throws InputFileException naming file, line and fault */
SessionSummary
readSessionSummary(const YamlNode& map);

/** \brief Writes `session.yaml`, onto the disk.
 * \throws OutputFileException when it could not be written whole */
void
saveSessionSummary(const std::string& folder, const SessionSummary& summary);

/** \brief Reads `session.yaml`.
 * \return nothing without such a file: the recording did not come to its end
 * \throws InputFileException naming file, line and fault */
std::optional<SessionSummary>
loadSessionSummary(const std::string& folder);

/** \brief The numbers of the frame files in a folder, ascending.
 * \throws InputFileException when the folder cannot be listed */
std::vector<std::uint64_t>
listFrames(const std::string& folder);

/** \brief Does a session, or a part of one, lie in a folder? */
bool
holdsSession(const std::string& folder);

/** \brief Why an image is not of this rig; empty when it has its size. */
std::string
faultOfSize(const ImageRecord& image, const TrinocularRig& rig);

/** \brief Why a frame is not of this rig; empty when it is. The frame must have an image
 * of the rig's size of each camera that the rig has (no baseline: no camera). */
std::string
faultUnderRig(const FrameHeader& header, const TrinocularRig& rig);

} // namespace pcl::acmap
