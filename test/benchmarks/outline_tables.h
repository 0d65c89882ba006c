#pragma once

#include "outline_maps.h"

namespace pcl::acmap::bench {

/** \brief Outlines of simulated scenes with true poses, compared with the visible truth:
 * with the points of the scene's sensor, and with one for every pixel in reach.
 * \param[in] scenes names of standard scenes */
void
printSimulatedOutlines(const std::vector<std::string>& scenes,
                       const OutlineOptions& options);

/** \brief The surfaces that PolyFit makes of the same scenes, knowing the true planes,
 * beside ours. Must be called before any thread is started.
 * \param[in] scenes names of standard scenes */
void
printPolyfitOutlines(const std::vector<std::string>& scenes,
                     const OutlineOptions& options);

/** \brief CPU time of the outlines of maps of up to a thousand planes. */
void
printOutlineSizes();

/** \brief Outlines of real scans, without truth. */
void
printScanOutlines(const OutlineOptions& options);

} // namespace pcl::acmap::bench
