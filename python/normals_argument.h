#pragma once

#include "array_view.h"

#include <pcl/features/impl/voting_kernel.h>
#include <pcl/segmentation/impl/plane_clustering_kernel.h>

#include <memory>
#include <optional>

namespace pcl::acmap::python {

/** \brief Result of vote_normals: arrays that refer to the votes. */
struct Normals {
  std::shared_ptr<VotedNormals> votes;
  py::array_t<float> normals, directions, saliency;
  py::array_t<std::uint8_t> vertex_class;
  std::optional<py::array_t<float>> curvature_directions, curvatures;
  ReportObject report;
};

struct ShownNormals {
  static constexpr auto name =
      py::detail::const_name("Union[acmap.Normals, numpy.ndarray[float32[n, 3]]]");
};

/** \brief Normals, or an array of them; checked by \ref setNormals. */
using NormalsArgument = ShownAs<ShownNormals>;

/** \brief Creates Normals with arrays that refer to them. */
Normals
pythonNormals(VotedNormals&& votes, bool with_curvatures, ReportObject report);

/** \brief Completes what was unpickled. \throws py::value_error if it does not fit */
Normals
restored(const Normals& read);

/** \brief Sets the normals of hypotheses; those of vote_normals also set creases and
 * curvatures.
 * \param[in,out] hypotheses their points are set
 * \throws py::type_error, py::value_error when it is neither, or not one per point */
void
setNormals(const NormalsArgument& argument, PlaneHypotheses& hypotheses);

} // namespace pcl::acmap::python
