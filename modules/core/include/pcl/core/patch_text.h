#pragma once

#include <pcl/core/box_patch.h>
#include <pcl/core/cylinder_patch.h>
#include <pcl/core/export.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/recess_patch.h>

#include <string>

namespace pcl {

/** \brief The figures of a plane in one line: "12.3 m2, rmse 6.8 mm, normal 0.000 1.000
 * 0.000". \ingroup core */
ACMAP_EXPORT std::string
textOf(const PlanePatch& plane);

/** \brief Those of a cylinder: radius, length, arc, side, rmse, bits. \ingroup core */
ACMAP_EXPORT std::string
textOf(const CylinderPatch& cylinder);

/** \brief Those of a box: size, sides, template, bits. \ingroup core */
ACMAP_EXPORT std::string
textOf(const BoxPatch& box);

/** \brief Those of a recess: size, depth, planes, template, bits. \ingroup core */
ACMAP_EXPORT std::string
textOf(const RecessPatch& recess);

} // namespace pcl
