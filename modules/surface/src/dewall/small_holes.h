#pragma once

#include "growing_mesh.h"
#include "size_constraint.h"

namespace pcl::acmap::dewall {

/** \brief Closes holes of a few sides by the triangles that turn least, as far as the
 * largest turn and the size constraint allow. For the dense rule: where noise or a fold
 * leaves no Delaunay-nearest apex that fits, a hole no larger than an edge remains. */
void
closeSmallHoles(const PointTree& tree, const SizeConstraint& size, GrowingMesh& mesh);

} // namespace pcl::acmap::dewall
