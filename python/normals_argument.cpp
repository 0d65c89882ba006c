#include "normals_argument.h"

namespace pcl::acmap::python {

Normals
pythonNormals(VotedNormals&& votes, bool with_curvatures, ReportObject report)
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

Normals
restored(const Normals& read)
{
  const PointView normals = pointRowsOf("normals", read.normals).view;
  const PointView directions = pointRowsOf("directions", read.directions).view;
  const auto saliency = read.saliency.unchecked<1>();
  const auto vertex_class = read.vertex_class.unchecked<1>();
  requireAsMany("directions", directions.size(), normals.size());
  requireAsMany("saliency", static_cast<std::size_t>(saliency.size()), normals.size());
  requireAsMany(
      "vertex_class", static_cast<std::size_t>(vertex_class.size()), normals.size());
  VotedNormals votes;
  for (py::ssize_t i = 0; i < saliency.size(); ++i) {
    VotedNormal& voted = votes.normals.emplace_back();
    voted.normal = normals[static_cast<std::size_t>(i)];
    voted.direction = directions[static_cast<std::size_t>(i)];
    voted.saliency = saliency(i);
    voted.vertex_class = static_cast<VertexClass>(vertex_class(i));
  }
  Normals result = pythonNormals(std::move(votes), false, read.report);
  result.curvature_directions = read.curvature_directions;
  result.curvatures = read.curvatures;
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
