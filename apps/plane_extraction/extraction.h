#pragma once

#include "plane_options.h"
#include "plane_stages.h"

#include <vector>

namespace pcl::acmap {

/** \brief What is known at the end. */
struct Extraction {
  HypothesisMesh mesh;
  PlaneClusters clusters;
  std::vector<std::int32_t> input_labels; ///< one a point of the input
  std::size_t finite_points = 0;          ///< of the input
};

/** \param[in] input what the planes were looked for in
 * \throws NothingFound, with the reasons, when there is no plane */
void
requirePlanes(const Tool& tool, const std::string& input, const Extraction& extraction);

/** \brief Takes the vertices of a mesh for hypotheses. */
Extraction
extractFromMesh(Tool& tool,
                const PlaneOptions& options,
                StepTimer& timer,
                const PointCloudFile& file,
                TriangleMesh triangles);

/** \brief As below, where it is known who saw the points. */
Extraction
extractFromCloud(Tool& tool,
                 const PlaneOptions& options,
                 StepTimer& timer,
                 const PointCloudFile& file,
                 const SensorView& sensors);

/** \brief Meshes a cloud first, and consolidates it before that where it is noisy or the
 * options ask for it; its points are the source of the planes, unless the paper's
 * thresholds are asked for.
 * \throws InputFileException when the trajectory beside it cannot be read */
Extraction
extractFromCloud(Tool& tool,
                 const PlaneOptions& options,
                 StepTimer& timer,
                 const PointCloudFile& file);

} // namespace pcl::acmap
