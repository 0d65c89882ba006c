#include "boxes/box_growth.h"

#include "boxes/box_pose.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap::boxes {

namespace {

constexpr double max_skew = 0.07;      ///< 4 degrees, as sine: of a right angle
constexpr double outline_error = 0.03; ///< metres; of the polygons
constexpr double max_gap = 0.08;       ///< metres; between a face and what bounds it
constexpr double behind = 0.9;         ///< share of a face that is behind its neighbour
constexpr double min_cover = 0.55;     ///< share of the seen sides that polygons cover
constexpr double min_inside = 0.88;    ///< share of the polygons that is on their sides
constexpr std::size_t min_known_sides = 4;
constexpr double max_cosine = 0.87; ///< 30 degrees, between the normals of two faces
constexpr double infinity = std::numeric_limits<double>::infinity();

HalfSpace
behindOf(const Piece& piece, double slack)
{
  return {piece.normal, slack - piece.offset};
}

bool
has(const std::vector<std::size_t>& list, std::size_t one)
{
  return std::find(list.begin(), list.end(), one) != list.end();
}

Eigen::Matrix3d
nearestRotation(const Eigen::Matrix3d& matrix)
{
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(
      matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

/** Where pieces end along a direction: the median over lines along this direction.
 * \param[in] across the lines lie side by side along it */
struct Rim {
  double end = -infinity;
  double spread = 0; ///< metres; half of the lines end within it
  double width = 0;  ///< metres, across

  Rim(const std::vector<Piece>& pieces,
      const std::vector<std::size_t>& chosen,
      const Eigen::Vector3d& direction,
      const Eigen::Vector3d& across)
  {
    constexpr int lines = 25;
    double low = infinity, high = -infinity;
    for (const std::size_t piece : chosen) {
      const auto [from, to] = rangeAlong(pieces[piece], across);
      low = std::min(low, from);
      high = std::max(high, to);
    }
    width = high - low;
    std::vector<double> ends;
    for (int line = 0; line < lines; ++line) {
      const double at = low + (line + 0.5) / lines * width;
      double last = -infinity;
      for (const std::size_t piece : chosen)
        for (const std::vector<Eigen::Vector3d>& loop : pieces[piece].loops)
          for (std::size_t i = 0; i < loop.size(); ++i)
            last = std::max(
                last,
                crossing(loop[i], loop[(i + 1) % loop.size()], at, direction, across));
      if (std::isfinite(last))
        ends.push_back(last);
    }
    if (ends.empty())
      return;
    std::sort(ends.begin(), ends.end());
    end = ends[ends.size() / 2];
    spread = ends[3 * ends.size() / 4] - ends[ends.size() / 4];
  }

private:
  static double
  crossing(const Eigen::Vector3d& from,
           const Eigen::Vector3d& to,
           double at,
           const Eigen::Vector3d& direction,
           const Eigen::Vector3d& across)
  {
    const double before = across.dot(from) - at, after = across.dot(to) - at;
    if ((before <= 0) == (after <= 0))
      return -infinity;
    const Eigen::Vector3d place = from + before / (before - after) * (to - from);
    return direction.dot(place);
  }
};

/** Everything without a slanted side. */
HalfSpace
behindSlant(const Box& box, double slack)
{
  const Eigen::Vector3d normal = box.slant.head<3>();
  return {normal, slack * normal.squaredNorm() - box.slant[3]};
}

/** The rectangle of a side; that of a slanted one lies in its plane, and the cuboid may
 * end before it on the opposite side. */
Piece
rectangleOf(const Box& box, std::size_t side)
{
  const Eigen::Vector3d outward = box.outward(side);
  const int first = (Box::axisOf(side) + 1) % 3, second = (Box::axisOf(side) + 2) % 3;
  const Eigen::Vector3d middle = box.origin + box.sides[side].position * outward;
  Piece piece;
  piece.normal = outward;
  if (box.sides[side].kind == BoxFaceKind::Slanted) {
    piece.normal = box.slant.head<3>();
    piece.offset = box.slant[3];
  }
  std::vector<Eigen::Vector3d>& corners = piece.loops.emplace_back();
  for (const auto& [u, v] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
    const std::size_t a = static_cast<std::size_t>(2 * first + u),
                      b = static_cast<std::size_t>(2 * second + v);
    const Eigen::Vector3d corner = middle + box.sides[a].position * box.outward(a) +
                                   box.sides[b].position * box.outward(b);
    corners.push_back(box.sides[side].kind == BoxFaceKind::Slanted
                          ? Eigen::Vector3d(corner - piece.height(corner) /
                                                         piece.normal.dot(outward) *
                                                         outward)
                          : corner);
  }
  return piece;
}

/** The area of a side, as far as it belongs to the box. */
double
areaOf(const Box& box, std::size_t side)
{
  const Piece rectangle = rectangleOf(box, side);
  if (box.sides[side].kind != BoxFaceKind::Slanted)
    return std::abs(clipped(rectangle, behindSlant(box, 0)).area);
  const std::size_t opposite = side ^ 1U;
  return std::abs(
      clipped(rectangle, {box.outward(opposite), box.coordinate(opposite)}).area);
}

/** The cuboid ends where its slanted side reaches furthest. */
void
placeSlant(Box& box)
{
  for (std::size_t side = 0; side < box.sides.size(); ++side)
    if (box.sides[side].kind == BoxFaceKind::Slanted) {
      const Eigen::Vector3d outward = box.outward(side);
      box.sides[side].position =
          rangeAlong(rectangleOf(box, side), outward).second - outward.dot(box.origin);
    }
}

} // namespace

BoxSearch::BoxSearch(const std::vector<PlanePatch>& planes,
                     const std::vector<Piece>& pieces)
: planes_(planes)
, pieces_(pieces)
, neighbours_(pieces.size())
, slanted_(pieces.size())
{
  // of pieces that meet, no further apart than this from their common line
  const double reach = 2 * max_gap / std::sqrt(1 - max_cosine * max_cosine);
  std::vector<Eigen::AlignedBox3d> places(pieces.size());
  for (std::size_t a = 0; a < pieces.size(); ++a)
    for (const Eigen::Vector3d& corner : pieces[a].loops.front())
      places[a].extend(corner);
  for (std::size_t a = 0; a < pieces.size(); ++a)
    for (std::size_t b = a + 1; b < pieces.size(); ++b) {
      const double cosine = std::abs(pieces[a].normal.dot(pieces[b].normal));
      if (cosine > max_cosine || places[a].exteriorDistance(places[b]) > reach ||
          !meet(pieces[a], pieces[b]) || !isConvex(pieces[a], pieces[b]))
        continue;
      const bool is_right = cosine < max_skew;
      if (is_right)
        edges_.push_back({a, b});
      (is_right ? neighbours_ : slanted_)[a].push_back(b);
      (is_right ? neighbours_ : slanted_)[b].push_back(a);
    }
}

bool
BoxSearch::isBehind(const Piece& piece, const Piece& other) const
{
  return clipped(piece, behindOf(other, outline_error)).area >= behind * piece.area;
}

/** Is each behind the other one? */
bool
BoxSearch::isConvex(const Piece& a, const Piece& b) const
{
  return isBehind(a, b) && isBehind(b, a);
}

/** Both reach their common line, at the same places. */
bool
BoxSearch::meet(const Piece& a, const Piece& b) const
{
  const Eigen::Vector3d along = a.normal.cross(b.normal).normalized();
  const auto near = [](const Piece& piece, const Piece& other) {
    return clipped(clipped(piece, behindOf(other, max_gap)),
                   {-other.normal, max_gap + other.offset});
  };
  const auto [a_low, a_high] = rangeAlong(near(a, b), along);
  const auto [b_low, b_high] = rangeAlong(near(b, a), along);
  const double common = std::min(a_high, b_high) - std::max(a_low, b_low);
  return common > 0 && common >= std::min(a_high - a_low, b_high - b_low) / 2;
}

/** May a piece be part of a side? */
bool
BoxSearch::fits(const Box& box, std::size_t side, std::size_t piece) const
{
  const Piece& one = pieces_[piece];
  if (one.normal.cross(box.outward(side)).norm() > max_skew ||
      one.normal.dot(box.outward(side)) < 0)
    return false;
  for (const std::size_t other : box.sides[side].pieces)
    if (std::abs(pieces_[other].height(planes_[one.plane].center)) > outline_error &&
        one.plane != pieces_[other].plane)
      return false;
  bool has_edge = false;
  for (std::size_t k = 0; k < box.sides.size(); ++k) {
    if (Box::axisOf(k) == Box::axisOf(side))
      continue;
    for (const std::size_t other : box.sides[k].pieces) {
      has_edge = has_edge || has(neighbours_[piece], other);
      if (!isConvex(one, pieces_[other]))
        return false;
    }
  }
  for (const std::size_t other : box.sides[side ^ 1U].pieces)
    if (!isConvex(one, pieces_[other]))
      return false;
  return has_edge;
}

/** Adds all pieces that fit, the largest first. */
void
BoxSearch::addPieces(Box& box, const std::vector<bool>& is_used) const
{
  std::vector<bool> is_taken = is_used;
  for (const Side& side : box.sides)
    for (const std::size_t piece : side.pieces)
      is_taken[piece] = true;
  while (true) {
    std::size_t best = pieces_.size(), its_side = 0;
    for (std::size_t side = 0; side < box.sides.size(); ++side)
      for (std::size_t piece = 0; piece < pieces_.size(); ++piece)
        if (!is_taken[piece] && !neighbours_[piece].empty() &&
            (best == pieces_.size() || pieces_[piece].area > pieces_[best].area) &&
            fits(box, side, piece)) {
          best = piece;
          its_side = side;
        }
    if (best == pieces_.size())
      return;
    is_taken[best] = true;
    box.sides[its_side].pieces.push_back(best);
    box.sides[its_side].kind = BoxFaceKind::Seen;
  }
}

/** The side in place of which a piece may cut a box: that which it resembles most; not
 * if this was seen. It has convex edges with two sides, is behind all, and all are behind
 * it. */
std::optional<std::size_t>
BoxSearch::sideOfSlant(const Box& box, std::size_t piece) const
{
  std::size_t its_side = 0, edges = 0;
  for (std::size_t side = 0; side < box.sides.size(); ++side) {
    if (pieces_[piece].normal.dot(box.outward(side)) >
        pieces_[piece].normal.dot(box.outward(its_side)))
      its_side = side;
    bool has_edge = false;
    for (const std::size_t other : box.sides[side].pieces) {
      if (!isConvex(pieces_[piece], pieces_[other]))
        return std::nullopt;
      has_edge =
          has_edge || has(neighbours_[piece], other) || has(slanted_[piece], other);
    }
    edges += has_edge ? 1 : 0;
  }
  if (edges < 2 || box.sides[its_side].kind == BoxFaceKind::Seen)
    return std::nullopt;
  return its_side;
}

/** The box with its largest slanted side. */
std::optional<Box>
BoxSearch::withSlant(const Box& box, const std::vector<bool>& is_used) const
{
  std::vector<std::size_t> candidates;
  for (const Side& side : box.sides)
    for (const std::size_t piece : side.pieces)
      for (const std::size_t other : slanted_[piece])
        if (!is_used[other])
          candidates.push_back(other);
  std::optional<Box> best;
  double area = 0;
  for (const std::size_t piece : candidates) {
    if (pieces_[piece].area <= area)
      continue;
    const std::optional<std::size_t> side = sideOfSlant(box, piece);
    if (!side)
      continue;
    area = pieces_[piece].area;
    best = box;
    best->sides[*side].kind = BoxFaceKind::Slanted;
    best->sides[*side].pieces = {piece};
    best->slant << pieces_[piece].normal, pieces_[piece].offset;
  }
  return best;
}

/** Coordinate, along its outward direction, at which the faces beside a side end: the
 * mean over those that reach furthest; others were seen in part only. Corners are
 * rounded over a length that is the same on all faces, so that the error of a rim falls
 * with its width. */
BoxSearch::End
BoxSearch::endOfFaces(const Box& box, std::size_t side) const
{
  std::vector<Rim> rims;
  double furthest = -infinity;
  for (std::size_t k = 0; k < box.sides.size(); ++k) {
    if (Box::axisOf(k) == Box::axisOf(side) || box.sides[k].pieces.empty())
      continue;
    const int across = 3 - Box::axisOf(k) - Box::axisOf(side);
    rims.emplace_back(
        pieces_, box.sides[k].pieces, box.outward(side), box.axes.col(across));
    furthest = std::max(furthest, rims.back().end);
  }
  double sum = 0, weights = 0, spreads = 0;
  for (const Rim& rim : rims)
    if (rim.end > furthest - max_gap) {
      sum += rim.width * rim.width * rim.end;
      spreads += rim.width * rim.width * rim.spread;
      weights += rim.width * rim.width;
    }
  return {sum / weights, spreads / weights};
}

/** Greatest coordinate of the pieces along the outward direction of a side. */
double
BoxSearch::furthestPoint(const Box& box, std::size_t side) const
{
  double furthest = -infinity;
  for (const Side& other : box.sides)
    for (const std::size_t piece : other.pieces)
      furthest =
          std::max(furthest, rangeAlong(pieces_[piece], box.outward(side)).second);
  return furthest;
}

/** Is a piece beside a side, as far as its other coordinates tell? */
bool
BoxSearch::isBeside(const Box& box, std::size_t side, const Piece& piece) const
{
  for (std::size_t k = 0; k < box.sides.size(); ++k)
    if (Box::axisOf(k) != Box::axisOf(side)) {
      const auto [low, high] = rangeAlong(piece, box.outward(k));
      const double reach = box.sides[k].kind == BoxFaceKind::Seen
                               ? box.coordinate(k)
                               : endOfFaces(box, k).position;
      if (low > reach + max_gap)
        return false;
    }
  return true;
}

/** Sets the positions of the sides that were not seen: at a plane that faces the box and
 * is where the faces end, or otherwise there. */
void
BoxSearch::bound(Box& box) const
{
  constexpr double plane_deviation = 0.002, rim_deviation = 0.01; // metres
  for (std::size_t side = 0; side < box.sides.size(); ++side) {
    Side& one = box.sides[side];
    if (one.kind == BoxFaceKind::Seen || one.kind == BoxFaceKind::Slanted)
      continue;
    const Eigen::Vector3d outward = box.outward(side);
    const double origin = outward.dot(box.origin),
                 end = endOfFaces(box, side).position - origin,
                 furthest = furthestPoint(box, side) - origin;
    double gap = max_gap;
    one.kind = BoxFaceKind::Free;
    one.plane = -1;
    one.position = end;
    one.deviation = rim_deviation;
    for (const Piece& piece : pieces_) {
      if (piece.normal.dot(outward) > -std::sqrt(1 - max_skew * max_skew))
        continue;
      // where the plane is met from the middle of the box
      const double position = piece.height(box.origin) / -piece.normal.dot(outward);
      // a face of which the lower part was not seen may reach the floor at one place
      const double miss =
          std::min(std::abs(position - end), std::abs(position - furthest));
      if (miss < gap && isBeside(box, side, piece)) {
        gap = miss;
        one.kind = BoxFaceKind::Snapped;
        one.plane = static_cast<std::int32_t>(piece.plane);
        one.position = position;
        one.deviation = plane_deviation;
      }
    }
  }
  for (Side& side : box.sides)
    if (side.kind == BoxFaceKind::Slanted)
      side.deviation = plane_deviation;
  placeSlant(box);
}

/** Do the faces end in a straight line where a side is free? Otherwise pictures ended
 * there, and the box continues. */
bool
BoxSearch::hasStraightEnds(const Box& box) const
{
  for (std::size_t side = 0; side < box.sides.size(); ++side)
    if (box.sides[side].kind == BoxFaceKind::Free &&
        endOfFaces(box, side).spread > outline_error)
      return false;
  return true;
}

/** Do polygons cover the seen sides, and no more than these? */
bool
BoxSearch::isCovered(const Box& box) const
{
  double covered = 0, all = 0;
  for (std::size_t side = 0; side < box.sides.size(); ++side) {
    if (box.sides[side].pieces.empty())
      continue;
    all += areaOf(box, side);
    for (const std::size_t piece : box.sides[side].pieces) {
      Piece part = pieces_[piece];
      for (std::size_t k = 0; k < box.sides.size(); ++k)
        if (Box::axisOf(k) != Box::axisOf(side))
          part = clipped(part, {box.outward(k), box.coordinate(k) + outline_error});
      part = clipped(part, behindSlant(box, outline_error));
      if (part.area < min_inside * pieces_[piece].area)
        return false;
      covered += part.area;
    }
  }
  return covered > min_cover * all;
}

/** Is no surface of the map deep inside? One that is shows that the normals point the
 * wrong way, and the box is a room. */
bool
BoxSearch::isSolid(const Box& box) const
{
  constexpr double min_area = 0.01; // square metres
  for (const Piece& piece : pieces_) {
    Piece part = piece;
    for (std::size_t side = 0; side < box.sides.size() && part.area > 0; ++side)
      part = clipped(part, {box.outward(side), box.coordinate(side) - max_gap});
    part = clipped(part, behindSlant(box, -max_gap));
    if (part.area > std::max(min_area, piece.area / 2))
      return false;
  }
  return true;
}

namespace {

/** A box that spans from plane to plane is a pillar or a beam, not a block of a building
 * whose corridors pass it. */
bool
spansLikeAPillar(const Box& box)
{
  const Eigen::Vector3d size = box.size();
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (box.sides[2 * axis].kind == BoxFaceKind::Snapped &&
        box.sides[2 * axis + 1].kind == BoxFaceKind::Snapped &&
        (box.count(BoxFaceKind::Free) > 0 ||
         size.maxCoeff() > size[static_cast<Eigen::Index>(axis)]))
      return false;
  return true;
}

/** The plane of a side is that of its largest piece. */
void
choosePlanes(const std::vector<Piece>& pieces, Box& box)
{
  for (Side& side : box.sides) {
    double area = 0;
    for (const std::size_t piece : side.pieces)
      if (pieces[piece].area > area) {
        area = pieces[piece].area;
        side.plane = static_cast<std::int32_t>(pieces[piece].plane);
      }
  }
}

/** Sets the origin to the middle of the pieces, and the positions of the seen sides. */
void
placeOrigin(const std::vector<Piece>& pieces, Box& box)
{
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    double low = infinity, high = -infinity;
    for (const Side& side : box.sides)
      for (const std::size_t piece : side.pieces) {
        const auto [from, to] = rangeAlong(pieces[piece], box.axes.col(axis));
        low = std::min(low, from);
        high = std::max(high, to);
      }
    middle += (low + high) / 2 * box.axes.col(axis);
  }
  box.origin = middle;
  for (std::size_t side = 0; side < box.sides.size(); ++side)
    if (box.sides[side].kind == BoxFaceKind::Seen) {
      const Piece& piece = pieces[box.sides[side].pieces.front()];
      box.sides[side].position = -piece.height(middle);
    }
}

} // namespace

std::vector<Box>
BoxSearch::grow(const ConvexEdge& edge, const std::vector<bool>& is_used) const
{
  Box box;
  Eigen::Matrix3d axes;
  axes.col(0) = pieces_[edge.a].normal;
  axes.col(1) = pieces_[edge.b].normal;
  axes.col(2) = axes.col(0).cross(axes.col(1)).normalized();
  box.axes = nearestRotation(axes);
  box.sides[0].kind = box.sides[2].kind = BoxFaceKind::Seen;
  box.sides[0].pieces = {edge.a};
  box.sides[2].pieces = {edge.b};
  addPieces(box, is_used);
  std::vector<Box> sound;
  std::optional<Box> slanted = withSlant(box, is_used);
  if (slanted && fit(*slanted))
    sound.push_back(std::move(*slanted));
  if (fit(box))
    sound.push_back(std::move(box));
  return sound;
}

/** Fits the box to its pieces. \return is it a sound one? */
bool
BoxSearch::fit(Box& box) const
{
  choosePlanes(pieces_, box);
  placeOrigin(pieces_, box);
  constexpr int rounds = 2; // the axes of the second one are those of all faces
  for (int round = 0; round < rounds; ++round) {
    bound(box);
    fitPose(planes_, box);
  }
  placeSlant(box);
  return box.count(BoxFaceKind::Free) <= box.sides.size() - min_known_sides &&
         box.size().minCoeff() > outline_error && spansLikeAPillar(box) &&
         hasStraightEnds(box) && isCovered(box) && isSolid(box);
}

} // namespace pcl::acmap::boxes
