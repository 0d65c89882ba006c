#pragma once

#include "live/observation_stream.h"

#include <pcl/pipeline/chain.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief The stages of a chain in their order: poses (II-B), merging, planes (II-C.1 and
 * 2) and textures (II-C). */
std::vector<ChainStage>
chainStages();

/** \brief Reads the one cloud that is the input. */
ChainStage
cloudStage(Chain::CloudLoader load);

/** \brief The steps with which observations are processed as they arrive. */
ObservationStream::Steps
streamSteps(const ChainSettings& settings, unsigned threads);

/** \brief Loads an observation for a texturing.
 * \return nothing if it cannot be read and may be skipped: the merging has reported it
 * \throws InputFileException if it may not be skipped */
std::optional<TexturedObservation>
loadTextured(const ObservationSequence& sequence, std::size_t i, bool skip_broken);

} // namespace pcl::acmap
