#pragma once

#include "plane_input.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/property_map.h>

#include <cstdint>
#include <tuple>
#include <vector>

namespace pcl::acmap::bench {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/** \brief A point, its normal and its index in the input, as CGAL changes the order. */
using CgalPoint = std::tuple<CgalKernel::Point_3, CgalKernel::Vector_3, std::int32_t>;
using CgalPoints = std::vector<CgalPoint>;
using CgalPointMap = CGAL::Nth_of_tuple_property_map<0, CgalPoint>;
using CgalNormalMap = CGAL::Nth_of_tuple_property_map<1, CgalPoint>;

inline constexpr unsigned cgal_neighbours = 48;

/** \brief Maximum angle between the normals of a point and of its plane, degrees. With
 * CGAL's default of 25, noise of a depth camera removes 5 % of the points from their
 * planes. */
inline constexpr double cgal_maximum_angle = 45;

/** \brief Computes the normals with pca_estimate_normals on one thread. */
CgalPoints
cgalPointsOf(const PlaneInput& input);

} // namespace pcl::acmap::bench
