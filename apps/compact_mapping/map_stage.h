#pragma once

#include "chain_options.h"

#include <pcl/core/compact_map.h>
#include <pcl/core/output_folder.h>
#include <pcl/core/progress.h>
#include <pcl/core/trajectory.h>
#include <pcl/pipeline/chain.h>
#include <pcl/pipeline/map_comparison.h>
#include <pcl/pipeline/observation_merging.h>

#include <string>
#include <vector>

namespace pcl::acmap {

class PicturesApart;

/** \brief Minimum tilt that is reported, in degrees. */
inline constexpr double min_tilt_told = 2;

/** \brief The merging with these options, without progress.
 * \param[in] threads 0 = all */
ObservationMerging
mergingOf(const ChainOptions& options, unsigned threads);

/** \brief Copies the plots of the rectification, and the poses before it, next to the
 * map. */
void
takeAlong(const StageStore& store,
          const Trajectory& before,
          const OutputFolder& folder);

/** \brief Writes a map with its floor plan and its mesh, then draws its pictures, and
 * reports it.
 * \param[in] progress of the writing
 * \param[in,out] map as \ref saveCompactMap
 * \param[in,out] folder is committed before the first picture is drawn
 * \return names of the files
 * \throws InterruptedPartway after an interruption while pictures were drawn */
std::vector<std::string>
writeMap(const ChainOptions& options,
         const MappedPlanes& found,
         CompactMap& map,
         const PicturesApart& pictures,
         const ProgressCallback& progress,
         OutputFolder& folder,
         StageLog& log);

/** \brief Compares the finished map of a sequence with the ground truth of its session.
 * \param[in] made by the chain
 * \param[in] told of the map
 * \throws InputFileException when an observation has no true pose, or the map cannot be
 * read */
MapFigures
compareMap(const ChainOptions& options,
           const ChainState& made,
           const StageLog& told,
           const SessionTruth& truth);

} // namespace pcl::acmap
