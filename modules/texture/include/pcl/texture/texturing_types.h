#pragma once

#include <pcl/core/cloud_rows.h>
#include <pcl/core/fields.h>
#include <pcl/core/report.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace pcl {

/** \brief Report of the last run of PlaneTexturing. \ingroup texture */
struct TexturingReport : Report {
  std::size_t observations = 0; ///< number of observations that were added
  std::size_t pinholes =
      0; ///< of these, organized as by a pinhole camera; the texels are projected into
         ///< them
  std::size_t splatted = 0;       ///< of these, others; each point colours the texel it
                                  ///< falls into
  std::size_t colorless = 0;      ///< of these, without colour and intensity; ignored
  std::size_t invalid_points = 0; ///< points of all observations that are not finite
  std::size_t colored_points = 0; ///< with a plane within the maximum distance
  std::size_t far_points = 0;     ///< finite, but without such a plane
  std::size_t charts = 0;
  std::size_t texels = 0; ///< inside the polygons
  std::size_t seen = 0;   ///< of these, coloured by observations
  std::size_t filled = 0; ///< of these, filled from their neighbours
  double texel_size = 0;  ///< metres
  std::vector<double>
      gains; ///< factor applied to the colours of each observation, or of
             ///< each station of a merged cloud
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const TexturingReport& report, Visitor&& visit)
{
  visit({"observations"}, report.observations);
  visit({"pinholes"}, report.pinholes);
  visit({"splatted"}, report.splatted);
  visit({"colorless"}, report.colorless);
  visit({"invalid_points"}, report.invalid_points);
  visit({"colored_points"}, report.colored_points);
  visit({"far_points"}, report.far_points);
  visit({"charts"}, report.charts);
  visit({"texels"}, report.texels);
  visit({"seen"}, report.seen);
  visit({"filled"}, report.filled);
  visit({"texel_size", "m"}, report.texel_size);
  visit({"gains"}, report.gains);
}

/** \brief An observation that PlaneTexturing paints with, of any fields, as files have them.
 * \ingroup texture */
struct TexturedObservation {
  CloudRows cloud; ///< camera frame, metres; colour as `rgb` or `rgba`
  Eigen::Isometry3d T_map_camera = Eigen::Isometry3d::Identity();
  double stamp = 0; ///< seconds, for the trajectory of the map

  /** \brief Was it seen from the origin of its frame? Otherwise each point colours the
   * texel that it lies in, and the map has neither poses nor observations. */
  bool has_sensor = true;
};

/** \brief Loads an observation when it is painted; nothing if it is to be left out.
 * \ingroup texture */
using TexturedObservationLoader = std::function<std::optional<TexturedObservation>()>;

namespace acmap {

class ByteParcel;

/** \brief Returns the next message about what another process has painted; nothing after the
 * last one. */
using PaintedObservations = std::function<std::optional<ByteParcel>()>;

} // namespace acmap

} // namespace pcl
