#pragma once

#include "figure_inputs.h"
#include "figure_plan.h"

#include <pcl/core/compact_map.h>
#include <pcl/core/trinocular_rig.h>

#include <cstddef>
#include <string>

namespace pcl::acmap {

/** \brief What the table says of a session and its map, beside what the paper says. */
struct FigureNumbers {
  std::size_t observations = 0;
  std::size_t patterns = 0;  ///< an observation
  std::size_t points = 0;    ///< finite ones of all observations
  int width = 0, height = 0; ///< px, of an image
  std::size_t planes = 0;
  double area = 0;       ///< square metres of all planes
  double ate_before = 0; ///< metres, on the floor, in the map's frame
  double ate_after = 0;
  std::size_t map_bytes = 0; ///< of map.glb
};

/** \brief Counts the points of all observations, and what else there is to tell.
 * \throws InputFileException when a cloud cannot be read */
FigureNumbers
numbersOf(const FilmedSession& session,
          const MappedSession& mapped,
          const CompactMap& map);

/** \brief The text of figures.md: the table, and each figure with what it shows. */
std::string
figurePage(const FigureNumbers& numbers, const FigurePlan& plan);

} // namespace pcl::acmap
