#pragma once

#include "array_view.h"

#include <pcl/features/voting_kernel.h>
#include <pcl/segmentation/plane_clustering_kernel.h>

#include <memory>

namespace pcl::acmap::python {

/** \brief What vote_normals returns: arrays over the votes. */
struct Normals {
  std::shared_ptr<VotedNormals> votes;
  py::array normals, directions, saliency, vertex_class;
  py::object curvature_directions, curvatures;
  py::object report;
};

struct ShownNormals {
  static constexpr auto name =
      py::detail::const_name("Union[acmap.Normals, numpy.ndarray[float32[n, 3]]]");
};

/** \brief Normals, or an array of them: checked by \ref setNormals. */
using NormalsArgument = Argument<ShownNormals>;

/** \brief Normals with arrays over them. */
Normals
pythonNormals(VotedNormals&& votes, bool with_curvatures, py::object report);

/** \brief Makes hypotheses of normals; those of vote_normals also tell of creases and of
 * curvature.
 * \param[in,out] hypotheses their points are set
 * \throws py::type_error, py::value_error when it is neither, or there is not one a point */
void
setNormals(const NormalsArgument& argument, PlaneHypotheses& hypotheses);

} // namespace pcl::acmap::python
