#pragma once

#include "outlines/creases.h"

namespace pcl::acmap::outlines {

/** The cells of a plane's surface: the evidence, filled up to the creases and cut off
 * beyond them, without gaps and specks smaller than the evidence can tell. Nothing is
 * closed where a sensor looked through.
 * \param[in] plane number of the plane
 * \param[in] knows_sensors does the absence of free cells mean something?
 * \param[in,out] raster its barrier is set
 * \return the surface */
CellSet
surfaceCells(std::size_t plane,
             const Creases& creases,
             bool knows_sensors,
             PlaneRaster& raster);

} // namespace pcl::acmap::outlines
