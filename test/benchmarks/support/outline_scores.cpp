#include "outline_scores.h"

#include "units.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::bench {
namespace {

constexpr double cell_area = raster_cell * raster_cell;
constexpr int deep = 5; // cells

/** \brief Polygons of an outline, projected onto a face. */
std::vector<std::vector<FlatLoop>>
projected(const PlaneOutline& outline, const VisibleFace& face)
{
  std::vector<std::vector<FlatLoop>> polygons = outline.polygons;
  for (std::vector<FlatLoop>& polygon : polygons)
    for (FlatLoop& loop : polygon)
      for (Eigen::Vector2d& place : loop)
        place = face.frame.flat(outline.frame.lifted(place));
  return polygons;
}

CellSet
rasterOf(const std::vector<std::vector<FlatLoop>>& polygons)
{
  Eigen::AlignedBox2d box;
  for (const std::vector<FlatLoop>& polygon : polygons)
    box.extend(boxOf(polygon));
  CellSet cells(box);
  for (const std::vector<FlatLoop>& polygon : polygons)
    cells.addInside(polygon);
  return cells;
}

bool
isNear(const PlaneOutline& outline, const VisibleFace& face)
{
  constexpr double max_angle = 5 * degree;
  constexpr double max_offset = 0.03; // metres, mean of the corners
  if (outline.coefficients.head<3>().dot(face.coefficients.head<3>()) <
      std::cos(max_angle))
    return false;
  double sum = 0;
  for (const OutlineEdge& edge : outline.edges)
    sum += std::abs(face.coefficients.head<3>().dot(edge.from) + face.coefficients[3]);
  return sum <= max_offset * static_cast<double>(outline.edges.size());
}

std::int32_t
findFace(const PlaneOutline& outline, const VisibleTruth& truth)
{
  std::int32_t best = -1;
  double maximum = 0;
  for (std::size_t f = 0; f < truth.faces.size(); ++f) {
    const VisibleFace& face = truth.faces[f];
    if (outline.edges.empty() || !isNear(outline, face))
      continue;
    const CellSet cells = rasterOf(projected(outline, face));
    double on_face = 0;
    cells.forEach([&](int i, int j) { on_face += cell_area * face.all.has(i, j); });
    if (on_face > maximum && 2 * on_face >= cells.area()) {
      maximum = on_face;
      best = static_cast<std::int32_t>(f);
    }
  }
  return best;
}

void
scoreArea(const VisibleFace& face, const CellSet& inside, OutlineScores& scores)
{
  face.seen.forEach([&](int i, int j) {
    scores.seen += cell_area;
    scores.joined += cell_area;
    if (inside.has(i, j)) {
      scores.common += cell_area;
      return;
    }
    scores.missing += cell_area;
    if (face.seen.hasAllNear(i, j, deep))
      scores.missing_inside += cell_area;
  });
  inside.forEach([&](int i, int j) {
    if (face.seen.has(i, j))
      return;
    scores.joined += cell_area;
    if (face.all.has(i, j)) {
      scores.unseen += cell_area;
      return;
    }
    scores.nothing += cell_area;
    if (!face.all.hasNear(i, j, deep))
      scores.nothing_inside += cell_area;
  });
}

/** \brief Edges that planes of one face share with planes of another. */
std::vector<OutlineEdge>
sharedEdges(const std::vector<PlaneOutline>& outlines,
            const std::vector<std::int32_t>& face_of_plane,
            std::size_t face_a,
            std::size_t face_b)
{
  std::vector<OutlineEdge> shared;
  for (std::size_t p = 0; p < outlines.size(); ++p)
    if (face_of_plane[p] == static_cast<std::int32_t>(face_a))
      for (const OutlineEdge& edge : outlines[p].edges)
        if (std::any_of(
                edge.partners.begin(), edge.partners.end(), [&](std::size_t other) {
                  return face_of_plane[other] == static_cast<std::int32_t>(face_b);
                }))
          shared.push_back(edge);
  return shared;
}

void
scoreCreases(const std::vector<PlaneOutline>& outlines,
             const VisibleTruth& truth,
             OutlineScores& scores)
{
  constexpr double near = 0.01, far = 0.5; // metres
  std::vector<std::vector<const PlaneOutline*>> planes(truth.faces.size());
  for (std::size_t p = 0; p < outlines.size(); ++p)
    if (scores.face_of_plane[p] >= 0)
      planes[static_cast<std::size_t>(scores.face_of_plane[p])].push_back(&outlines[p]);
  std::array<std::size_t, 2> faces{};
  std::vector<OutlineEdge> shared; // of these faces
  const auto distanceTo = [&](std::size_t face, const Eigen::Vector3d& place) {
    double minimum = std::numeric_limits<double>::infinity();
    for (const PlaneOutline* plane : planes[face])
      minimum = std::min(minimum, plane->distanceWithin(place));
    return minimum;
  };
  for (const CreaseSample& sample : truth.creases) {
    scores.creases += raster_cell;
    const double distance = std::max(distanceTo(sample.faces[0], sample.place),
                                     distanceTo(sample.faces[1], sample.place));
    if (distance > far)
      continue;
    scores.found += raster_cell;
    scores.gaps += distance > near ? raster_cell : 0;
    if (faces != sample.faces) {
      faces = sample.faces;
      shared = sharedEdges(outlines, scores.face_of_plane, faces[0], faces[1]);
    }
    if (std::any_of(shared.begin(), shared.end(), [&](const OutlineEdge& edge) {
          return edge.distance(sample.place) <= near;
        }))
      scores.shared += raster_cell;
  }
}

double
distanceToVertices(const std::vector<PlaneOutline>& outlines,
                   const Eigen::Vector3d& corner)
{
  double minimum = 0.5; // metres
  for (const PlaneOutline& outline : outlines)
    for (const OutlineEdge& edge : outline.edges)
      minimum = std::min(minimum, (edge.from - corner).norm());
  return minimum;
}

} // namespace

OutlineScores
scoreOutlines(const std::vector<PlaneOutline>& outlines, const VisibleTruth& truth)
{
  OutlineScores scores;
  for (const PlaneOutline& outline : outlines) {
    scores.face_of_plane.push_back(findFace(outline, truth));
    if (scores.face_of_plane.back() < 0)
      scores.unmatched_area += countOutlines({outline}).area;
  }
  for (std::size_t f = 0; f < truth.faces.size(); ++f) {
    std::vector<std::vector<FlatLoop>> polygons;
    for (std::size_t p = 0; p < outlines.size(); ++p)
      if (scores.face_of_plane[p] == static_cast<std::int32_t>(f))
        for (std::vector<FlatLoop>& polygon : projected(outlines[p], truth.faces[f]))
          polygons.push_back(std::move(polygon));
    if (!polygons.empty())
      scoreArea(truth.faces[f], rasterOf(polygons), scores);
  }
  scoreCreases(outlines, truth, scores);
  for (const Eigen::Vector3d& corner : truth.corners)
    scores.corners.push_back(distanceToVertices(outlines, corner));
  return scores;
}

} // namespace pcl::acmap::bench
