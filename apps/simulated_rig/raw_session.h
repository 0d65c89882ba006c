#pragma once

#include "filmed_scene.h"
#include "truth_file.h"

#include <pcl/core/output_folder.h>
#include <pcl/core/progress.h>

#include <cstddef>
#include <cstdint>

namespace pcl::acmap {

/** \brief How a scene is filmed. */
struct SessionSettings {
  std::size_t observations = 0; ///< at least 1
  std::uint32_t patterns = 10;
  SimulatedLight light;
  std::uint64_t seed = 1;
  unsigned threads = 0; ///< 0 = all
};

/** \brief What was filmed, for summary and report. */
struct SessionCounts {
  std::size_t frames = 0;
  std::size_t seen = 0;   ///< pixels of the reference that see something
  std::size_t lit = 0;    ///< of these, the ones that the projector lights
  PointCounts measurable; ///< pixels that active stereo can measure
};

/** \brief Refuses a folder that a session would mix with.
 * \throws OutputFileException naming what it holds */
void
requireNoSession(const OutputFolder& folder);

/** \brief Whether a file of that name would be a part of a session. */
bool
isSessionName(const std::string& name);

/** \brief Writes what the cameras see under each pattern, and the truth of each
 * observation: disparities, visibility, poses, planes. All is in the folder's hidden part
 * until it is committed.
 * \throws MemoryRefused when the patterns do not fit
 * \throws OutputFileException when anything could not be written whole
 * \throws CancelledException when the callback asked to stop */
SessionCounts
writeSession(const OutputFolder& folder,
             const FilmedScene& filmed,
             const SessionSettings& settings,
             const ProgressCallback& progress);

} // namespace pcl::acmap
