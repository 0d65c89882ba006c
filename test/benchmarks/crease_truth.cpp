#include "crease_truth.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::bench {
namespace {

constexpr double touching = 1e-6; // metres

bool
meetAtAnAngle(const TruthSurface& a, const TruthSurface& b)
{
  constexpr double parallel_cosine = 0.9;
  return a.plane != b.plane && std::abs(a.normal.dot(b.normal)) < parallel_cosine;
}

bool
isOnBorder(const TruthSurface& surface, const Eigen::Vector3d& point)
{
  const Eigen::Vector3d place = surface.coordinates(point);
  return std::min({std::abs(place[0]),
                   std::abs(place[1]),
                   std::abs(place[0] - surface.size[0]),
                   std::abs(place[1] - surface.size[1])}) < touching;
}

/** The four edges of a rectangle, split into pieces. */
std::vector<EdgePiece>
borderOf(const SimulatedRectangle& rectangle)
{
  constexpr double step = 0.01;
  const Eigen::Vector3d &u = rectangle.edge_u, &v = rectangle.edge_v;
  const Eigen::Vector3d &corner = rectangle.corner, beyond_u = corner + u,
                        beyond_v = corner + v;
  std::vector<EdgePiece> pieces;
  for (const auto& [begin, edge] : {std::pair(corner, u),
                                    std::pair(corner, v),
                                    std::pair(beyond_v, u),
                                    std::pair(beyond_u, v)}) {
    const int count = std::max(1, static_cast<int>(edge.norm() / step));
    for (int k = 0; k < count; ++k)
      pieces.push_back({begin + (k + 0.5) / count * edge, edge.norm() / count, 0, 0});
  }
  return pieces;
}

double
areaSeen(const TruthSurface& surface, const Eigen::Vector3d& middle, double reach)
{
  const Eigen::Vector3d place = surface.coordinates(middle);
  int first[2], last[2];
  for (int axis = 0; axis < 2; ++axis) {
    const double cell = surface.size[axis] / surface.cells[axis];
    first[axis] = std::max(0, static_cast<int>((place[axis] - reach) / cell));
    last[axis] = std::min(surface.cells[axis] - 1,
                          static_cast<int>((place[axis] + reach) / cell));
  }
  std::size_t cells = 0;
  for (int i = first[0]; i <= last[0]; ++i)
    for (int j = first[1]; j <= last[1]; ++j)
      cells += surface.visible[surface.cellIndex(i, j)];
  return static_cast<double>(cells) * surface.cellArea();
}

} // namespace

std::vector<EdgePiece>
edgePieces(const SceneTruth& truth)
{
  const std::vector<TruthSurface>& surfaces = truth.surfaces();
  std::vector<EdgePiece> pieces;
  for (std::size_t a = 0; a < surfaces.size(); ++a)
    for (EdgePiece& piece : borderOf(surfaces[a].rectangle))
      for (std::size_t b = 0; b < surfaces.size(); ++b) {
        const TruthSurface& other = surfaces[b];
        // if two borders coincide, only the first one counts
        if (!meetAtAnAngle(surfaces[a], other) ||
            other.distance(piece.place) > touching ||
            (b < a && isOnBorder(other, piece.place)))
          continue;
        piece.first = a;
        piece.second = b;
        pieces.push_back(piece);
      }
  return pieces;
}

bool
isSeen(const SceneTruth& truth, const EdgePiece& piece, double voxel)
{
  constexpr double min_part = 0.25;
  return std::min(areaSeen(truth.surfaces()[piece.first], piece.place, voxel),
                  areaSeen(truth.surfaces()[piece.second], piece.place, voxel)) >
         min_part * voxel * voxel;
}

} // namespace pcl::acmap::bench
