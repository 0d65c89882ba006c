#pragma once

#include "mesh_checker.h"

namespace pcl::acmap::bench {

/** \brief Boundary loops of a mesh without vertices near a boundary of the model: holes
 * that the model does not have.
 * \param[in] reach maximum distance, in the unit of the points */
std::size_t
countForeignHoles(const test::Points& points,
                  const test::Triangles& mesh,
                  const test::Triangles& model,
                  double reach);

} // namespace pcl::acmap::bench
