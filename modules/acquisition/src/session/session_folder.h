#pragma once

#include "frame_codec.h"

#include <pcl/core/impl/yaml_node.h>
#include <pcl/core/trinocular_rig.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Returns the name of a frame file, for example `frame_000017.acf`. */
std::string
frameFileName(std::uint64_t number);

/** \brief Path of a file of a session. */
std::string
pathIn(const std::string& folder, const std::string& name);

/** \brief Content of `session.yaml`, which a finished session has. */
struct SessionSummary {
  std::string rig = "rig.yaml";  ///< file with the geometry
  std::size_t frames = 0;        ///< number of frames
  std::size_t observations = 0;  ///< number of different observations
  std::size_t patterns = 0;      ///< number of different patterns, without "none"
  std::array<bool, 3> cameras{}; ///< cameras of the frames
};

/** \brief The content of `session.yaml` as text. */
std::string
sessionText(const SessionSummary& summary);

/** \brief Parses `session.yaml`, for \ref loadSessionSummary.
 * \throws InputFileException naming file, line and fault */
SessionSummary
readSessionSummary(const YamlNode& map);

/** \brief Writes `session.yaml` and waits until it is on the disk.
 * \throws OutputFileException when it could not be written completely */
void
saveSessionSummary(const std::string& folder, const SessionSummary& summary);

/** \brief Reads `session.yaml`.
 * \return nothing if there is no such file: the recording was not finished
 * \throws InputFileException naming file, line and fault */
std::optional<SessionSummary>
loadSessionSummary(const std::string& folder);

/** \brief The numbers of the frame files in a folder, ascending.
 * \throws InputFileException when the folder cannot be listed */
std::vector<std::uint64_t>
listFrames(const std::string& folder);

/** \brief Returns true if a folder contains a session or a part of one. */
bool
holdsSession(const std::string& folder);

/** \brief Removes the files of a session that has no frames, as far as they are there. */
void
removeSessionFiles(const std::string& folder);

/** \brief The reason why an image does not fit a rig; empty if it has the rig's
 * size. */
std::string
faultOfSize(const ImageRecord& image, const TrinocularRig& rig);

/** \brief The reason why a frame does not fit a rig; empty if it fits. The frame must
 * have an image of the rig's size for exactly the cameras of the rig (no baseline: no
 * camera). */
std::string
faultUnderRig(const FrameHeader& header, const TrinocularRig& rig);

/** \brief Waits until a file and its entry in its folder are on the disk, so that they
 * survive a power failure.
 * \throws OutputFileException when writing to the disk failed */
void
syncToDisk(const std::string& path);

} // namespace pcl::acmap
