#include "outlines/contour_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap::outlines {

namespace {

// Lengths in cells, of which two are a spacing.
constexpr double line_reach = 1.05;
constexpr double min_touch = 1.8, max_gap = 8, corner_gap = 16, corner_reach = 8;

/** The span of a plane's crease along which a side of a cell runs: a joint one before
 * others, then the nearest one. */
ContourPiece
pieceOf(const Eigen::Vector2d& from,
        const Eigen::Vector2d& to,
        std::size_t plane,
        const Creases& creases)
{
  const Eigen::Vector2d middle = (from + to) / 2;
  const Eigen::Vector2d inner(from.y() - to.y(), to.x() - from.x());
  ContourPiece best;
  double best_rank = std::numeric_limits<double>::infinity();
  for (const std::size_t number : creases.of_planes[plane]) {
    const Crease& crease = creases.creases[number];
    const std::size_t k = crease.sideOf(plane);
    const CreaseLine& line = crease.lines[k];
    const double distance = std::abs(line.distance(middle));
    if (distance > line_reach)
      continue;
    const double along = line.along(middle), slack = 0.75 / line.cells_per_metre;
    for (const CreaseSpan& span : crease.spans[k]) {
      const double rank = distance + (span.joint ? 0 : 10);
      if (along < span.from - slack || along > span.to + slack || rank >= best_rank ||
          span.side * line.normal.dot(inner) < -0.5)
        continue;
      best_rank = rank;
      best.crease = static_cast<std::int32_t>(number);
      best.side = span.side;
    }
  }
  return best;
}

bool
areSame(const ContourPiece& a, const ContourPiece& b)
{
  return a.crease == b.crease && a.side == b.side;
}

void
makeFree(ContourPiece& piece)
{
  piece.crease = ContourPiece::free;
  piece.side = 0;
}

/** Joins neighbours along the same crease, or both free, also the last and the first. */
void
joinEqual(std::vector<ContourPiece>& pieces)
{
  std::vector<ContourPiece> joined;
  for (const ContourPiece& piece : pieces)
    if (!joined.empty() && areSame(joined.back(), piece))
      joined.back().count += piece.count;
    else
      joined.push_back(piece);
  if (joined.size() > 1 && areSame(joined.back(), joined.front())) {
    joined.front().first = joined.back().first;
    joined.front().count += joined.back().count;
    joined.pop_back();
  }
  pieces = std::move(joined);
}

} // namespace

bool
meetNear(const Crease& a,
         const Crease& b,
         std::size_t plane,
         const Eigen::Vector2d& begin,
         const Eigen::Vector2d& end,
         Eigen::Vector2d& place)
{
  constexpr double min_sine = 0.17;
  const CreaseLine &first = a.lines[a.sideOf(plane)],
                   &second = b.lines[b.sideOf(plane)];
  const double sine = cross(first.direction, second.direction);
  if (std::abs(sine) < min_sine)
    return false;
  place = first.origin +
          cross(Eigen::Vector2d(second.origin - first.origin), second.direction) /
              sine * first.direction;
  const double reach = corner_reach + (end - begin).norm() / 2;
  return (place - begin).norm() <= reach && (place - end).norm() <= reach;
}

std::vector<ContourPiece>
piecesOf(const Loop& contour, std::size_t plane, const Creases& creases)
{
  const std::size_t size = contour.size();
  const auto corner = [&](std::size_t i) { return contour[i % size]; };
  std::vector<ContourPiece> pieces;
  for (std::size_t i = 0; i < size; ++i) {
    pieces.push_back(pieceOf(corner(i), corner(i + 1), plane, creases));
    pieces.back().first = i;
    pieces.back().count = 1;
  }
  joinEqual(pieces);
  for (ContourPiece& piece : pieces)
    if (piece.crease != ContourPiece::free) {
      const Crease& crease = creases.creases[static_cast<std::size_t>(piece.crease)];
      const CreaseLine& line = crease.lines[crease.sideOf(plane)];
      const Eigen::Vector2d way =
          corner(piece.first + piece.count) - corner(piece.first);
      if (std::abs(way.dot(line.direction)) < min_touch && pieces.size() > 1)
        makeFree(piece);
    }
  joinEqual(pieces);
  for (std::size_t i = 0; i < pieces.size() && pieces.size() > 2; ++i) {
    const ContourPiece& before = pieces[(i + pieces.size() - 1) % pieces.size()];
    const ContourPiece& after = pieces[(i + 1) % pieces.size()];
    if (pieces[i].crease == ContourPiece::free && areSame(before, after) &&
        static_cast<double>(pieces[i].count) <= max_gap) {
      pieces[i].crease = before.crease;
      pieces[i].side = before.side;
    }
  }
  joinEqual(pieces);
  std::vector<ContourPiece> kept;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const ContourPiece& before = pieces[(i + pieces.size() - 1) % pieces.size()];
    const ContourPiece& after = pieces[(i + 1) % pieces.size()];
    Eigen::Vector2d place;
    const bool is_corner =
        pieces[i].crease == ContourPiece::free &&
        static_cast<double>(pieces[i].count) < corner_gap &&
        before.crease != ContourPiece::free && after.crease != ContourPiece::free &&
        before.crease != after.crease &&
        meetNear(creases.creases[static_cast<std::size_t>(before.crease)],
                 creases.creases[static_cast<std::size_t>(after.crease)],
                 plane,
                 corner(pieces[i].first),
                 corner(pieces[i].first + pieces[i].count),
                 place);
    if (!is_corner)
      kept.push_back(pieces[i]);
  }
  return kept;
}

} // namespace pcl::acmap::outlines
