#pragma once

#include "cylinders/cylinder_fit.h"
#include "cylinders/surface_elements.h"
#include "description_length.h"

#include <pcl/core/progress.h>

namespace pcl::acmap::cylinders {

/** What a cylinder has to be like. */
struct CylinderLimits {
  double min_radius = 0; ///< metres
  double max_radius = 0;
};

/** The planes over the elements before cylinders are looked for. */
struct KnownFaces {
  std::vector<Eigen::Vector4d>
      planes;         ///< unit normal and offset, frame of the elements
  PointLabels labels; ///< plane of each element, -1 for none
};

/** A region of elements on one cylinder. */
struct GrownCylinder {
  CylinderFit fit;
  std::vector<std::int32_t> members; ///< ascending
  std::vector<std::int32_t> planes;  ///< that it replaces
  double gain = 0;                   ///< bits that it saves
};

/** How far round and along the axis the members of a cylinder are. */
struct CylinderReach {
  double arc = 0;       ///< radians that have members, without the gaps between them
  double arc_begin = 0; ///< radians, of the shortest arc that contains all members
  double arc_length = 0;
  double low = 0; ///< metres along the axis
  double high = 0;

  /** Depth of the arc below its chord, metres. */
  double sagitta = 0;
  double chord = 0;
};

/** \param[in] spacing of the samples, metres */
CylinderReach
reachOf(const Cylinder& cylinder, const std::vector<Sample>& samples, double spacing);

/** Finds the cylinders of a surface. Seeds are fitted to small patches by their
 * normals, grown over the neighbours, and taken in the order of the bits that they
 * save, as long as they do.
 * \throws CancelledException when the progress callback requested to stop */
std::vector<GrownCylinder>
growCylinders(const SurfaceElements& elements,
              const KnownFaces& faces,
              const CylinderLimits& limits,
              const Progress& progress);

} // namespace pcl::acmap::cylinders
