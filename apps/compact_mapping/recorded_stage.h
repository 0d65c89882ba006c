#pragma once

#include "map_stage.h"

namespace pcl::acmap {

/** \brief Replays a session at the pace at which it was recorded, maps it while its frames
 * arrive (\ref CompactMapping::start), and writes the map as \ref makeMap does; tells how
 * long the map took after the last shot, and how late the mapping was.
 * \param[in] observations folder for these; it is removed if the replay is not finished
 * \param[in,out] folder is committed
 * \return names of the files
 * \throws NothingFound when there is no plane */
std::vector<std::string>
mapAsRecorded(const ChainOptions& options,
              const std::string& observations,
              bool draws,
              OutputFolder& folder,
              const RunControls& controls,
              StageLog& log);

} // namespace pcl::acmap
