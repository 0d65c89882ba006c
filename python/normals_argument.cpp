#include "normals_argument.h"

namespace pcl::acmap::python {

Normals
pythonNormals(VotedNormals&& votes, bool with_curvatures, py::object report)
{
  Normals result;
  result.votes = std::make_shared<VotedNormals>(std::move(votes));
  const auto owner = owned(std::shared_ptr<VotedNormals>(result.votes)).second;
  const LargeVector<VotedNormal>& all = result.votes->normals;
  result.normals = fieldOf<float>(
      all, 3, owner, [](const VotedNormal& one) { return one.normal.data(); });
  result.directions = fieldOf<float>(
      all, 3, owner, [](const VotedNormal& one) { return one.direction.data(); });
  result.saliency = fieldOf<float>(
      all, 0, owner, [](const VotedNormal& one) { return &one.saliency; });
  result.vertex_class =
      fieldOf<std::uint8_t>(all, 0, owner, [](const VotedNormal& one) {
        return reinterpret_cast<const std::uint8_t*>(&one.vertex_class);
      });
  result.curvature_directions = py::none();
  result.curvatures = py::none();
  if (with_curvatures) {
    const std::vector<VotedCurvature>& bends = result.votes->curvatures;
    result.curvature_directions =
        fieldOf<float>(bends, 3, owner, [](const VotedCurvature& one) {
          return one.direction.data();
        });
    static_assert(offsetof(VotedCurvature, second) ==
                  offsetof(VotedCurvature, first) + sizeof(float));
    result.curvatures = fieldOf<float>(
        bends, 2, owner, [](const VotedCurvature& one) { return &one.first; });
  }
  result.report = std::move(report);
  return result;
}

void
setNormals(const NormalsArgument& argument, PlaneHypotheses& hypotheses)
{
  const std::size_t points = hypotheses.points.size();
  if (py::isinstance<Normals>(argument)) {
    const std::shared_ptr<VotedNormals> votes = argument.cast<const Normals&>().votes;
    requireAsMany("normals", votes->normals.size(), points);
    for (const VotedNormal& voted : votes->normals) {
      hypotheses.normals.push_back(voted.normal);
      hypotheses.curvatures.push_back(1 - voted.saliency);
      hypotheses.is_crease.push_back(voted.vertex_class >= VertexClass::Crease ? 1 : 0);
    }
    return;
  }
  const PointView view = pointRowsOf("normals", argument).view;
  requireAsMany("normals", view.size(), points);
  for (std::size_t i = 0; i < view.size(); ++i) {
    Eigen::Vector3f normal = view[i];
    normal /= normal.norm(); // zero normals become NaN, which means unknown
    hypotheses.normals.push_back(normal);
  }
}

} // namespace pcl::acmap::python
