#pragma once

#include "figure_inputs.h"
#include "figure_plan.h"

#include <pcl/core/compact_map.h>
#include <pcl/core/trinocular_rig.h>

#include <cstddef>
#include <string>

namespace pcl::acmap {

/** \brief Numbers of a session and its map, for the comparison with those of the
 * paper. */
struct FigureNumbers {
  std::size_t observations = 0;
  std::size_t patterns = 0;  ///< per observation
  std::size_t points = 0;    ///< finite points of all observations
  int width = 0, height = 0; ///< px, image size
  std::size_t planes = 0;
  double area = 0;       ///< square metres of all planes
  double ate_before = 0; ///< metres, on the floor, in the map's frame
  double ate_after = 0;
  std::size_t map_bytes = 0; ///< size of map.glb
};

/** \brief Counts the points of all observations, and collects the other numbers.
 * \throws InputFileException when a cloud cannot be read */
FigureNumbers
numbersOf(const FilmedSession& session,
          const MappedSession& mapped,
          const CompactMap& map);

/** \brief The text of figures.md: the table, and each figure with its description. */
std::string
figurePage(const FigureNumbers& numbers, const FigurePlan& plan);

} // namespace pcl::acmap
