#pragma once

#include "mesh_checker.h"

namespace pcl::acmap::bench {

/** \brief Boundary loops of a mesh none of whose corners is near a rim of the model: holes
 * that the model does not have.
 * \param[in] reach how near counts as near, in the unit of the points */
std::size_t
countForeignHoles(const test::Points& points,
                  const test::Triangles& mesh,
                  const test::Triangles& model,
                  double reach);

} // namespace pcl::acmap::bench
