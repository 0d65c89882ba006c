#pragma once

#include "filmed_scene.h"
#include "truth_file.h"

#include <pcl/core/output_folder.h>
#include <pcl/core/progress.h>

#include <cstddef>
#include <cstdint>

namespace pcl::acmap {

/** \brief Settings for filming a scene. */
struct SessionSettings {
  std::size_t observations = 0; ///< at least 1
  std::uint32_t patterns = 10;
  SimulatedLight light;
  std::uint64_t seed = 1;
  unsigned threads = 0; ///< 0 = all
};

/** \brief Statistics of the session, for summary and report. */
struct SessionCounts {
  std::size_t frames = 0;
  std::size_t seen = 0;   ///< pixels of the reference view that see a surface
  std::size_t lit = 0;    ///< of these, the ones that the projector lights
  PointCounts measurable; ///< pixels that active stereo can measure
};

/** \brief Refuses a folder with files with which a session would mix.
 * \throws OutputFileException naming what it holds */
void
requireNoSession(const OutputFolder& folder);

/** \brief Would a file of that name be a part of a session? */
bool
isSessionName(const std::string& name);

/** \brief Writes the images of the cameras under each pattern, and the ground truth of
 * each observation: disparities, visibility, poses, planes. All files are in the
 * folder's hidden part until it is committed.
 * \throws MemoryRefused when the patterns do not fit
 * \throws OutputFileException when a file could not be written completely
 * \throws CancelledException when the callback requests it */
SessionCounts
writeSession(const OutputFolder& folder,
             const FilmedScene& filmed,
             const SessionSettings& settings,
             const ProgressCallback& progress);

} // namespace pcl::acmap
