#pragma once

#include "rectification_worlds.h"

#include <pcl/mapping/impl/map_entropy_kernel.h>
#include <pcl/mapping/impl/rectification_kernel.h>

namespace pcl::acmap::test {

/** \brief Clouds in the format of the kernels, with sensors on the floor. */
inline std::vector<LevelledPoints>
levelledClouds(const PosedClouds& map)
{
  std::vector<LevelledPoints> observations;
  for (const auto& cloud : map.clouds) {
    LevelledPoints seen;
    for (const PointNormal& point : *cloud) {
      seen.points.emplace_back(point.getVector3fMap());
      seen.normals.emplace_back(point.getNormalVector3fMap());
    }
    observations.push_back(seen);
  }
  return observations;
}

inline std::vector<EntropyCells>
cellsOf(const PosedClouds& map, const MapEntropySettings& settings)
{
  std::vector<EntropyCells> cells;
  for (const auto& cloud : map.clouds)
    cells.push_back(aggregateCells(
        {&cloud->front().x, sizeof(PointNormal), cloud->size()}, {}, settings));
  return cells;
}

} // namespace pcl::acmap::test
