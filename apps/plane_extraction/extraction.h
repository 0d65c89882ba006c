#pragma once

#include "plane_options.h"

#include <pcl/pipeline/plane_mapping.h>

#include <memory>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Finds the planes of a cloud, or of a mesh, as a step of the tool, with its
 * progress, warnings, summary and report.
 * \param[in] viewpoints of a cloud with a field `view`, metres
 * \param[in] mesh whose vertices are the points of the cloud; empty: none
 * \throws UsageError if an option does not fit the cloud
 * \throws MemoryRefused when this machine has not enough memory */
MappedPlanes
extractPlanes(Tool& tool,
              const PlaneOptions& options,
              const std::shared_ptr<const PointCloudFile>& cloud,
              std::vector<Eigen::Vector3f> viewpoints,
              TriangleMesh mesh = {});

/** \param[in] input name of the input
 * \throws NothingFound, with the reasons, when there is no plane */
void
requirePlanes(const Tool& tool, const std::string& input, const MappedPlanes& found);

} // namespace pcl::acmap
