#pragma once

#include "tool.h"

#include <pcl/pipeline/plane_mapping.h>
#include <pcl/visualization/mesh_snapshot.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Options that affect which planes are found. */
struct PlaneOptions {
  PlaneMapping stage; ///< with the options of its steps
  DepthSensor sensor = DepthSensor::Automatic;
  /** \brief Cylinders, boxes and recesses, too; by default the tool decides. */
  std::optional<bool> primitives;
  bool paper = false; ///< set by the tool: \ref MappingMode::Paper

  /** \brief Was `--consolidate` given? */
  bool
  consolidates() const
  {
    return stage.getConsolidationPolicy() == ConsolidationPolicy::Always;
  }

  /** \brief Is a cloud to be processed in space, even if it is a single view? */
  bool
  isInSpace() const
  {
    return paper || stage.getUsedDepthSensor() == DepthSensor::Laser;
  }

  bool primitives_by_default = false; ///< set by the tool, for all but the paper's way

  bool
  findsPrimitives() const
  {
    return primitives.value_or(primitives_by_default && !paper);
  }
};

/** \brief Adds the options to the command line. */
void
addPlaneChoices(Tool& tool, PlaneOptions& options);

/** \brief Checks that these options are compatible.
 * \throws UsageError */
void
checkChoices(const PlaneOptions& options);

/** \brief A callback that refuses work for which there is not enough memory, and warns of
 * work that takes long. */
CostCallback
costCheck(const RunControls& controls);

/** \brief The mapping of planes with these options.
 * \param[in] threads 0 = all */
PlaneMapping
mappingOf(const PlaneOptions& options, unsigned threads);

/** \brief Finds the planes of a cloud, or of a mesh, and reports all steps: warnings,
 * summary, JSON report and seconds.
 * \param[in] file sensor and remarks of the rows; null if they are of several files
 * \param[in] viewpoints of a cloud with a field `view`, metres
 * \param[in] mesh whose vertices are the points of the cloud; empty: none
 * \throws UsageError if an option does not fit the cloud
 * \throws MemoryLimitException when this machine has not enough memory */
MappedPlanes
extractPlanes(const PlaneOptions& options,
              const CloudRows& rows,
              const std::shared_ptr<const PointCloudFile>& file,
              std::vector<Eigen::Vector3f> viewpoints,
              const RunControls& controls,
              StageLog& log,
              TriangleMesh mesh = {});

/** \brief Warns if no plane was found because of the given sensor. */
void
warnOfSensor(const PlaneOptions& options, const MappedPlanes& found, StageLog& log);

/** \brief Reports all steps of a mapping: warnings, summary, JSON report and seconds. */
void
tellMapping(const PlaneMappingReport& report, StageLog& log);

/** \param[in] input name of the input
 * \throws NothingFound, with the reasons, when there is neither a plane nor a cylinder */
void
requirePlanes(const std::string& input, const MappedPlanes& found, const StageLog& log);

/** \brief Adds lines to the summary: the number of planes, the fraction of the points
 * on them, and each plane, or the largest ones if there are many; the same for cylinders
 * and boxes and recesses if these were searched. */
void
tellPlanes(const MappedPlanes& found, StageLog& log);

/** \brief A view from a position next to the sensor, with back faces culled. */
SceneView
sceneViewOf(const MappedPlanes& found);

/** \brief Draws the mesh as PNG, coloured by plane, with back faces culled. */
void
savePicture(const std::string& path, const MappedPlanes& found);

} // namespace pcl::acmap
