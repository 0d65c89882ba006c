#pragma once

#include "chain.h"
#include "plane_extraction/extraction.h"

#include <pcl/core/compact_map.h>
#include <pcl/core/output_folder.h>
#include <pcl/pipeline/map_comparison.h>
#include <pcl/pipeline/observation_merging.h>

namespace pcl::acmap {

class PicturesApart;

/** \brief Minimum tilt that is reported, in degrees. */
inline constexpr double min_tilt_told = 2;

/** \brief Result for the input. */
struct Mapped {
  MappedPlanes found;
  CompactMap map;
};

/** \brief The merging with these options, without progress.
 * \param[in] threads 0 = all */
ObservationMerging
mergingOf(const ChainOptions& options, unsigned threads);

/** \brief Writes a map with its floor plan and its mesh, then draws its pictures, and
 * reports it.
 * \param[in,out] folder is committed before the first picture is drawn
 * \return names of the files
 * \throws InterruptedPartway after an interruption while pictures were drawn */
std::vector<std::string>
writeMap(const ChainOptions& options,
         Mapped& mapped,
         const PicturesApart& pictures,
         OutputFolder& folder,
         StageLog& log);

/** \brief Computes a compact map of observations, or of one cloud, and writes it with
 * its mesh, thinned points, poses and pictures, as a step of the chain.
 * \param[in] sequence the observations; without poses: one cloud, the options' input
 * \param[in,out] folder is committed
 * \return names of the files
 * \throws NothingFound when there is no plane
 * \throws what its steps throw */
std::vector<std::string>
makeMap(const ChainOptions& options,
        const Chain& chain,
        const Sequence& sequence,
        const PicturesApart& pictures,
        OutputFolder& folder,
        const RunControls& controls,
        StageLog& log);

/** \brief Compares the finished map of a sequence with the ground truth of its session.
 * \param[in] sequence with poses
 * \throws InputFileException when an observation has no true pose, or a result of the
 * chain cannot be read */
MapFigures
compareMap(const ChainOptions& options,
           const Chain& chain,
           const Sequence& sequence,
           const SessionTruth& truth);

} // namespace pcl::acmap
