#include "crease_scores.h"

namespace pcl::acmap::bench {
namespace {

using test::Points;
using test::ReferenceTree;

double
shareOf(double part, double whole)
{
  return whole > 0 ? part / whole : 0;
}

Points
placesOf(const std::vector<EdgePiece>& pieces)
{
  Points places;
  for (const EdgePiece& piece : pieces)
    places.push_back(piece.place);
  return places;
}

Points
chosen(const Points& vertices, const std::vector<bool>& is_crease)
{
  Points some;
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (is_crease[v])
      some.push_back(vertices[v]);
  return some;
}

std::size_t
countNear(const Points& points, const ReferenceTree& others, double reach)
{
  std::size_t count = 0;
  for (const Eigen::Vector3d& point : points)
    count += others.findWithin(point, reach) >= 0;
  return count;
}

} // namespace

CreaseScores
scoreCreases(const SceneTruth& truth,
             const Points& vertices,
             const std::vector<bool>& is_crease,
             double voxel,
             double sigma)
{
  const double reach = voxel + 2 * sigma;
  const std::vector<EdgePiece> pieces = edgePieces(truth);
  std::vector<EdgePiece> seen;
  for (const EdgePiece& piece : pieces)
    if (isSeen(truth, piece, voxel))
      seen.push_back(piece);
  const Points creases = chosen(vertices, is_crease);
  const ReferenceTree crease_tree(creases), edge_tree(placesOf(pieces)),
      seen_tree(placesOf(seen));

  CreaseScores scores;
  scores.found = creases.size();
  scores.precision = shareOf(static_cast<double>(countNear(creases, edge_tree, reach)),
                             static_cast<double>(creases.size()));
  double reached = 0;
  for (const EdgePiece& piece : seen) {
    scores.length += piece.length;
    if (crease_tree.findWithin(piece.place, reach) >= 0)
      reached += piece.length;
  }
  scores.recall = shareOf(reached, scores.length);
  scores.near_edges = countNear(vertices, seen_tree, voxel / 2);
  scores.recall_of_nearest =
      shareOf(static_cast<double>(countNear(creases, seen_tree, voxel / 2)),
              static_cast<double>(scores.near_edges));
  return scores;
}

} // namespace pcl::acmap::bench
