#include "outlines/shared_outlines.h"

#include "outlines/contour_pieces.h"
#include "outlines/crease_nodes.h"
#include "outlines/patch_outlines.h"
#include "outlines/proposed_surfaces.h"
#include "outlines/rim_lines.h"
#include "outlines/sight_rays.h"
#include "outlines/surface_cells.h"

#include <pcl/core/impl/parallel.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>

namespace pcl::acmap {

namespace outlines {
namespace {

/** How a boundary is straightened; each step is simpler than the one before. */
enum class Straightening : std::uint8_t {
  Lines,   ///< free parts as the lines that describe them best
  Corners, ///< free parts by their corners
  None     ///< the sides of the cells
};

/** A boundary of the surface of a plane. */
struct Boundary {
  std::size_t plane = 0;
  Loop contour; ///< corners of cells
  std::vector<ContourPiece> pieces;
  Straightening straightening = Straightening::Lines;
};

/** A corner of an outline: on a crease, or a place of its own in the raster. */
struct OutlinePoint {
  CreasePoint on_crease;                           ///< used if its crease is not -1
  Eigen::Vector2d place = Eigen::Vector2d::Zero(); ///< used otherwise
  std::int32_t next_crease = -1;                   ///< along which the outline goes on
};

/** A corner of an outline in space. */
struct OutlineVertex {
  static constexpr std::int64_t own = -1;

  std::int64_t node = own; ///< that other outlines may have as well
  Eigen::Vector3d position;
  std::int32_t next_crease = -1;
};

using Outline = std::vector<OutlineVertex>;

/** \brief Turns the boundaries of all planes into outlines. */
class Straightener {
public:
  Straightener(const Creases& creases,
               const std::vector<PlaneRaster>& rasters,
               double spacing)
  : creases_(creases)
  , rasters_(rasters)
  , spacing_(spacing)
  {}

  std::vector<Outline>
  operator()(const std::vector<Boundary>& boundaries) const
  {
    std::vector<std::vector<OutlinePoint>> points(boundaries.size());
    oneapi::tbb::parallel_for(std::size_t{0}, boundaries.size(), [&](std::size_t i) {
      points[i] = pointsOf(boundaries[i]);
    });
    CreaseNodes nodes(creases_, rasters_, spacing_);
    for (const std::vector<OutlinePoint>& loop : points)
      for (const OutlinePoint& point : loop)
        if (point.on_crease.crease >= 0)
          nodes.add(point.on_crease);
    nodes.settle();
    std::vector<Outline> outlines(boundaries.size());
    oneapi::tbb::parallel_for(std::size_t{0}, boundaries.size(), [&](std::size_t i) {
      outlines[i] = outlineOf(points[i], rasters_[boundaries[i].plane], nodes);
    });
    return outlines;
  }

private:
  const Crease&
  creaseAt(std::int32_t number) const
  {
    return creases_.creases[static_cast<std::size_t>(number)];
  }

  const CreaseLine&
  lineOf(std::int32_t number, std::size_t plane) const
  {
    const Crease& crease = creaseAt(number);
    return crease.lines[crease.sideOf(plane)];
  }

  std::vector<OutlinePoint>
  pointsOf(const Boundary& boundary) const
  {
    std::vector<OutlinePoint> points;
    const std::vector<ContourPiece>& pieces = boundary.pieces;
    const auto isFree = [&](std::size_t i) {
      return pieces[i % pieces.size()].crease == ContourPiece::free;
    };
    if (boundary.straightening == Straightening::None) {
      for (const Eigen::Vector2d& corner : boundary.contour)
        addOwn(corner, points);
    }
    else if (pieces.size() == 1)
      addWhole(boundary, points);
    else
      for (std::size_t i = 0; i < pieces.size(); ++i)
        if (isFree(i))
          addRim(boundary, i, points);
        else if (!isFree(i + 1))
          addCorner(boundary, i, points);
    return points;
  }

  static void
  addOwn(const Eigen::Vector2d& place, std::vector<OutlinePoint>& points)
  {
    OutlinePoint point;
    point.place = place;
    points.push_back(point);
  }

  /** \param[in] piece along a crease
   * \param[in] is_after does the outline go on along it? Else it comes from there
   * \param[in] weight inverse variance of the place along the crease, square spacings */
  void
  addEnd(const ContourPiece& piece,
         bool is_after,
         std::size_t plane,
         const Eigen::Vector2d& place,
         double weight,
         std::vector<OutlinePoint>& points) const
  {
    OutlinePoint point;
    point.on_crease = {piece.crease,
                       lineOf(piece.crease, plane).along(place),
                       -1,
                       is_after ? piece.side : -piece.side,
                       weight};
    point.next_crease = is_after ? piece.crease : -1;
    points.push_back(point);
  }

  /** The lines of a polyline; none if it is straightened by its corners. */
  std::vector<RimLine>
  linesOf(const Loop& rim, const Boundary& boundary) const
  {
    if (boundary.straightening != Straightening::Lines)
      return {};
    const PlaneRaster& raster = rasters_[boundary.plane];
    std::vector<RimLine> lines = rimLines(rim, noiseOf(rim, raster));
    refineLines(rim, raster.rim_points, raster.are_rays ? 12 : 0, lines);
    return lines;
  }

  /** The corners of a polyline, straightened; without its ends. */
  static Loop
  innerCorners(const Loop& rim, const std::vector<RimLine>& lines)
  {
    if (!lines.empty())
      return cornersOf(lines, rim);
    const std::vector<std::size_t> kept = breakPoints(rim);
    Loop corners;
    for (std::size_t i = 1; i + 1 < kept.size(); ++i)
      corners.push_back(rim[kept[i]]);
    return corners;
  }

  /** Noise of a rim in cells: where no sensor looked past it, it is where the evidence
   * fades, which is less certain than where a surface ends. */
  static double
  noiseOf(const Loop& rim, const PlaneRaster& raster)
  {
    constexpr double of_rims = 1, of_frontiers = 2, min_share = 0.25;
    constexpr double fading = 0.04; // metres, over which evidence fades however fine
    constexpr int nearest = 1, farthest = 4; // cells beyond
    int all = 0, free = 0;
    for (std::size_t i = 0; i + 1 < rim.size(); ++i) {
      const Eigen::Vector2d way = rim[i + 1] - rim[i];
      const Eigen::Vector2d outwards(way.y(), -way.x());
      const Eigen::Vector2d middle = (rim[i] + rim[i + 1]) / 2;
      for (int off = nearest; off <= farthest; ++off) {
        ++all;
        free += raster.free.has(middle + (off + 0.5) * outwards) ? 1 : 0;
      }
    }
    return free > min_share * all ? of_rims
                                  : std::max(of_frontiers, fading / raster.cell);
  }

  /** A boundary without creases begins at the corner farthest from its middle. */
  void
  addWhole(const Boundary& boundary, std::vector<OutlinePoint>& points) const
  {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& corner : boundary.contour)
      middle += corner / static_cast<double>(boundary.contour.size());
    Loop rim = boundary.contour;
    const auto farthest = std::max_element(
        rim.begin(),
        rim.end(),
        [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
          return (a - middle).squaredNorm() < (b - middle).squaredNorm();
        });
    std::rotate(rim.begin(), farthest, rim.end());
    rim.push_back(rim.front());
    const std::vector<RimLine> lines = linesOf(rim, boundary);
    for (const Eigen::Vector2d& corner : innerCorners(rim, lines))
      addOwn(corner, points);
    if (lines.empty())
      addOwn(rim.front(), points);
    else {
      std::vector<RimLine> around{lines.back(), lines.front()};
      around[0].to = 0;
      for (const Eigen::Vector2d& corner : cornersOf(around, rim))
        addOwn(corner, points);
    }
  }

  void
  addCorner(const Boundary& boundary,
            std::size_t number,
            std::vector<OutlinePoint>& points) const
  {
    const ContourPiece& before = boundary.pieces[number];
    const ContourPiece& after = boundary.pieces[(number + 1) % boundary.pieces.size()];
    const Loop& contour = boundary.contour;
    const Eigen::Vector2d& begin =
        contour[(before.first + before.count) % contour.size()];
    const Eigen::Vector2d& end = contour[after.first % contour.size()];
    Eigen::Vector2d place;
    const Crease &first = creaseAt(before.crease), &second = creaseAt(after.crease);
    if (before.crease != after.crease &&
        meetNear(first, second, boundary.plane, begin, end, place)) {
      OutlinePoint point;
      point.on_crease = {
          before.crease,
          lineOf(before.crease, boundary.plane).along(place),
          static_cast<std::int32_t>(second.planes[1 - second.sideOf(boundary.plane)])};
      point.next_crease = after.crease;
      points.push_back(point);
      return;
    }
    addEnd(before, false, boundary.plane, begin, of_corners, points);
    addEnd(after, true, boundary.plane, end, of_corners, points);
  }

  /** The free part between two creases. */
  void
  addRim(const Boundary& boundary,
         std::size_t number,
         std::vector<OutlinePoint>& points) const
  {
    const std::size_t count = boundary.pieces.size();
    const ContourPiece& piece = boundary.pieces[number];
    const ContourPiece& before = boundary.pieces[(number + count - 1) % count];
    const ContourPiece& after = boundary.pieces[(number + 1) % count];
    Loop rim;
    for (std::size_t i = 0; i <= piece.count; ++i)
      rim.push_back(boundary.contour[(piece.first + i) % boundary.contour.size()]);
    std::vector<RimLine> lines = linesOf(rim, boundary);
    dropStub(before.crease, boundary.plane, rim, true, lines);
    dropStub(after.crease, boundary.plane, rim, false, lines);
    const Loop corners = innerCorners(rim, lines);
    const RimLine* const first = lines.empty() ? nullptr : &lines.front();
    const RimLine* const last = lines.empty() ? nullptr : &lines.back();
    addRimEnd(before, false, boundary.plane, rim.front(), first, points);
    for (const Eigen::Vector2d& corner : corners)
      addOwn(corner, points);
    const std::size_t end = points.size();
    addRimEnd(after, true, boundary.plane, rim.back(), last, points);
    if (points.size() - end == 2) // the end comes last
      std::swap(points[end], points[end + 1]);
  }

  /** Removes a short line at an end of a rim if the next one meets the crease as well:
   * the evidence ends early in the acute angle between a crease and a rim. */
  void
  dropStub(std::int32_t crease,
           std::size_t plane,
           const Loop& rim,
           bool at_front,
           std::vector<RimLine>& lines) const
  {
    constexpr std::size_t longest = 8; // cells
    if (lines.size() < 2 || !rasters_[plane].are_rays)
      return;
    const RimLine& stub = at_front ? lines.front() : lines.back();
    RimLine& next = at_front ? lines[1] : lines[lines.size() - 2];
    const CreaseLine& line = lineOf(crease, plane);
    const Eigen::Vector2d& end = at_front ? rim.front() : rim.back();
    const Eigen::Vector2d& begin = rim[at_front ? next.from : next.to];
    const double ahead = at_front ? -1 : 1;
    Eigen::Vector2d place;
    if (stub.to - stub.from > longest || next.to - next.from < stub.to - stub.from ||
        !next.meet(line.origin, line.direction, place) ||
        (place - end).norm() > rimReach(rasters_[plane]) ||
        ahead * (place - next.middle).dot(next.direction) <= 0 ||
        isFreeBetween(rasters_[plane], begin, place))
      return;
    if (at_front) {
      next.from = 0;
      lines.erase(lines.begin());
    }
    else {
      next.to = rim.size() - 1;
      lines.pop_back();
    }
  }

  static constexpr double of_corners = 0.5; // inverse variance, square spacings

  /** Cells from the end of a rim to its crease, at most: further only if its place is
   * exact, and a sensor that looks through between limits it. */
  static double
  rimReach(const PlaneRaster& raster)
  {
    return raster.are_rays ? 16 : 6;
  }

  static bool
  isFreeBetween(const PlaneRaster& raster,
                const Eigen::Vector2d& from,
                const Eigen::Vector2d& to)
  {
    const auto steps = static_cast<int>((to - from).norm() / 0.5) + 1;
    for (int i = 1; i < steps; ++i)
      if (raster.free.has(from + (to - from) * i / steps))
        return true;
    return false;
  }

  /** Where a rim leaves its crease: at the intersection of its first line, or else at the
   * foot of its first corner, with a second point where the line begins.
   * \param[in] rim its line; nullptr: the corner alone counts */
  void
  addRimEnd(const ContourPiece& piece,
            bool is_after,
            std::size_t plane,
            const Eigen::Vector2d& corner,
            const RimLine* rim,
            std::vector<OutlinePoint>& points) const
  {
    constexpr double min_step = 1; // cells
    const CreaseLine& line = lineOf(piece.crease, plane);
    Eigen::Vector2d place;
    if (rim && rim->meet(line.origin, line.direction, place) &&
        (place - corner).norm() <= rimReach(rasters_[plane]) &&
        !isFreeBetween(rasters_[plane], corner, place)) {
      const double sine = cross(rim->direction, line.direction);
      const auto sides = static_cast<double>(rim->to - rim->from);
      addEnd(piece, is_after, plane, place, sine * sine * sides, points);
      return;
    }
    addEnd(piece, is_after, plane, corner, of_corners, points);
    const Eigen::Vector2d begin = rim ? rim->nearest(corner) : corner;
    if (std::abs(line.distance(begin)) > min_step)
      addOwn(begin, points);
  }

  static Outline
  outlineOf(const std::vector<OutlinePoint>& points,
            const PlaneRaster& raster,
            const CreaseNodes& nodes)
  {
    Outline outline;
    const auto add = [&](const OutlineVertex& vertex) {
      if (!outline.empty() && vertex.node != OutlineVertex::own &&
          outline.back().node == vertex.node)
        outline.back().next_crease = vertex.next_crease;
      else
        outline.push_back(vertex);
    };
    const auto nodeOf = [&](std::size_t i) {
      return nodes.find(points[i % points.size()].on_crease);
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
      const OutlinePoint& point = points[i];
      if (point.on_crease.crease < 0) {
        add({OutlineVertex::own, raster.pointAt(point.place), -1});
        continue;
      }
      const std::int32_t next = point.next_crease;
      const std::size_t node = nodeOf(i);
      add({static_cast<std::int64_t>(node), nodes.position(node), next});
      if (next < 0)
        continue;
      for (const std::size_t inner : nodes.between(next, node, nodeOf(i + 1)))
        add({static_cast<std::int64_t>(inner), nodes.position(inner), next});
    }
    if (outline.size() > 1 && outline.front().node != OutlineVertex::own &&
        outline.front().node == outline.back().node)
      outline.pop_back();
    return outline;
  }

  const Creases& creases_;
  const std::vector<PlaneRaster>& rasters_;
  double spacing_;
};

/** Numbers of the loops of a plane that cross themselves or another one. */
std::vector<std::size_t>
crossingLoops(const std::vector<std::size_t>& loops,
              const std::vector<Outline>& outlines,
              const PlaneRaster& raster)
{
  struct Side {
    Eigen::Vector2d from, to;
    std::size_t loop;
  };
  std::vector<Side> sides;
  for (const std::size_t loop : loops) {
    const Outline& outline = outlines[loop];
    for (std::size_t i = 0; i < outline.size(); ++i)
      sides.push_back({raster.placeOf(outline[i].position),
                       raster.placeOf(outline[(i + 1) % outline.size()].position),
                       loop});
  }
  const auto minimum = [](const Side& side) {
    return std::min(side.from.x(), side.to.x());
  };
  std::sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) {
    return minimum(a) < minimum(b) || (minimum(a) == minimum(b) && a.loop < b.loop);
  });
  std::vector<std::size_t> crossing;
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t k = i + 1; k < sides.size(); ++k) {
      if (minimum(sides[k]) > std::max(sides[i].from.x(), sides[i].to.x()))
        break;
      Eigen::Vector2d place;
      if (segmentsCross(
              sides[i].from, sides[i].to, sides[k].from, sides[k].to, place)) {
        crossing.push_back(sides[i].loop);
        crossing.push_back(sides[k].loop);
      }
    }
  std::sort(crossing.begin(), crossing.end());
  crossing.erase(std::unique(crossing.begin(), crossing.end()), crossing.end());
  return crossing;
}

/** Outlines that do not cross: loops that would are straightened less, with the nodes of
 * all others found again, so that neighbours know. */
std::vector<Outline>
soundOutlines(const Creases& creases,
              const std::vector<PlaneRaster>& rasters,
              double spacing,
              std::vector<Boundary>& boundaries)
{
  std::vector<std::vector<std::size_t>> of_planes(rasters.size());
  for (std::size_t i = 0; i < boundaries.size(); ++i)
    of_planes[boundaries[i].plane].push_back(i);
  const Straightener straighten(creases, rasters, spacing);
  constexpr int max_rounds = 8; // each loop can change twice, neighbours after it
  for (int round = 0;; ++round) {
    std::vector<Outline> outlines = straighten(boundaries);
    bool is_sound = true;
    for (std::size_t p = 0; p < rasters.size(); ++p)
      for (const std::size_t loop : crossingLoops(of_planes[p], outlines, rasters[p])) {
        Straightening& level = boundaries[loop].straightening;
        if (level == Straightening::None)
          continue;
        is_sound = false;
        level = level == Straightening::Lines && round + 2 < max_rounds
                    ? Straightening::Corners
                    : Straightening::None;
      }
    if (is_sound || round == max_rounds)
      return outlines;
  }
}

/** An edge between two nodes, and a plane that has it. */
struct SharedEdge {
  std::int64_t low, high;
  std::size_t plane;

  bool
  operator<(const SharedEdge& other) const
  {
    return std::tie(low, high, plane) < std::tie(other.low, other.high, other.plane);
  }
};

/** \brief Tells what is beyond the edges of outlines. */
class EdgeJudge {
public:
  EdgeJudge(const std::vector<Boundary>& boundaries,
            const std::vector<Outline>& outlines,
            const Creases& creases,
            const std::vector<PlaneRaster>& rasters,
            bool knows_sensors)
  : creases_(creases)
  , rasters_(rasters)
  , knows_sensors_(knows_sensors)
  {
    for (std::size_t i = 0; i < outlines.size(); ++i)
      for (std::size_t k = 0; k < outlines[i].size(); ++k) {
        const SharedEdge edge = edgeOf(boundaries[i].plane, outlines[i], k);
        if (edge.low != OutlineVertex::own)
          edges_.push_back(edge);
      }
    std::sort(edges_.begin(), edges_.end());
  }

  PolygonEdge
  operator()(std::size_t plane, const Outline& outline, std::size_t k) const
  {
    const SharedEdge edge = edgeOf(plane, outline, k);
    if (edge.low != OutlineVertex::own)
      for (auto it = std::lower_bound(
               edges_.begin(), edges_.end(), SharedEdge{edge.low, edge.high, 0});
           it != edges_.end() && it->low == edge.low && it->high == edge.high;
           ++it)
        if (it->plane != plane)
          return {EdgeKind::Crease, static_cast<std::int32_t>(it->plane)};
    const Eigen::Vector3d& from = outline[k].position;
    const Eigen::Vector3d& to = outline[(k + 1) % outline.size()].position;
    if (outline[k].next_crease >= 0) {
      const Crease& crease =
          creases_.creases[static_cast<std::size_t>(outline[k].next_crease)];
      const std::size_t own = crease.sideOf(plane);
      const double along = ((from + to) / 2 - crease.point).dot(crease.direction);
      for (const CreaseSpan& span : crease.spans[own])
        if (span.contact && along > span.from && along < span.to)
          return {EdgeKind::Contact, static_cast<std::int32_t>(crease.planes[1 - own])};
    }
    if (!knows_sensors_)
      return {EdgeKind::Open, -1};
    return {isFreeBeyond(rasters_[plane], from, to) ? EdgeKind::Rim
                                                    : EdgeKind::Frontier,
            -1};
  }

private:
  static SharedEdge
  edgeOf(std::size_t plane, const Outline& outline, std::size_t k)
  {
    const auto [low, high] =
        std::minmax(outline[k].node, outline[(k + 1) % outline.size()].node);
    return {low, high, plane};
  }

  /** Did sensors look through beside an edge, on its right? */
  static bool
  isFreeBeyond(const PlaneRaster& raster,
               const Eigen::Vector3d& begin,
               const Eigen::Vector3d& end)
  {
    constexpr double nearest = 1.5, farthest = 5, min_share = 0.25; // cells
    const Eigen::Vector2d from = raster.placeOf(begin),
                          way = raster.placeOf(end) - from;
    const double length = way.norm();
    if (!(length > 0))
      return false;
    const Eigen::Vector2d outwards(way.y() / length, -way.x() / length);
    int all = 0, free = 0;
    for (double along = std::min(0.5, length / 2); along < length; ++along)
      for (double off = nearest; off <= farthest; ++off) {
        ++all;
        free += raster.free.has(from + along / length * way + off * outwards) ? 1 : 0;
      }
    return free > min_share * all;
  }

  const Creases& creases_;
  const std::vector<PlaneRaster>& rasters_;
  bool knows_sensors_;
  std::vector<SharedEdge> edges_;
};

/** Sets the polygons of a plane. */
void
setOutlines(const std::vector<std::size_t>& loops,
            const std::vector<Outline>& outlines,
            const EdgeJudge& judge,
            std::size_t plane,
            const PlaneRaster& raster,
            PlanePatch& patch)
{
  constexpr double min_area = 16; // cells
  std::vector<Loop> places;
  for (const std::size_t loop : loops) {
    places.emplace_back();
    for (const OutlineVertex& vertex : outlines[loop])
      places.back().push_back(raster.placeOf(vertex.position));
  }
  const Nesting nesting = nestingOf(places, min_area);
  const double square = raster.cell * raster.cell;
  const auto append =
      [&](std::size_t i, std::vector<Eigen::Vector3f>& points, PlanePolygon& polygon) {
        const Outline& outline = outlines[loops[i]];
        for (std::size_t k = 0; k < outline.size(); ++k) {
          points.push_back(outline[k].position.cast<float>());
          polygon.edges.push_back(judge(plane, outline, k));
        }
        patch.area += square * signedArea(places[i]);
      };
  for (const std::size_t rim : nesting.rims) {
    patch.polygons.emplace_back();
    append(rim, patch.polygons.back().outer, patch.polygons.back());
  }
  for (const auto& [hole, rim] : nesting.holes) {
    patch.polygons[rim].holes.emplace_back();
    append(hole, patch.polygons[rim].holes.back(), patch.polygons[rim]);
  }
}

/** Is a plane too narrow for many faces to have all their corners on it? */
bool
isNarrow(const KnownPlane& plane, double spacing)
{
  constexpr double min_width = 5; // spacings
  return plane.trust == PlaneTrust::Strip ||
         2 * plane.half_size.minCoeff() < min_width * spacing;
}

/** Adds the outlines of the mesh on narrow planes to the evidence. */
void
addNarrow(const TriangleMesh::Triangles& triangles,
          const KnownPlanes& known,
          double most_of_faces,
          std::vector<PlaneRaster>& rasters)
{
  std::vector<bool> is_narrow(rasters.size());
  for (std::size_t p = 0; p < rasters.size(); ++p)
    is_narrow[p] =
        isNarrow(known.planes[p], known.spacing) && rasters[p].seen.width() > 0;
  const MeshOutlines mesh(triangles, is_narrow, known, most_of_faces);
  for (std::size_t p = 0; p < rasters.size(); ++p) {
    if (!is_narrow[p])
      continue;
    PlanePatch outlined = known.planes[p].patch;
    mesh.outline(p, outlined);
    std::vector<Loop> loops;
    const auto add = [&](const std::vector<Eigen::Vector3f>& points) {
      loops.emplace_back();
      for (const Eigen::Vector3f& point : points)
        loops.back().push_back(rasters[p].placeOf(point.cast<double>()));
    };
    for (const PlanePolygon& polygon : outlined.polygons) {
      add(polygon.outer);
      for (const std::vector<Eigen::Vector3f>& hole : polygon.holes)
        add(hole);
    }
    CellSet cells(rasters[p].seen.width(), rasters[p].seen.height());
    fillLoops(loops, cells);
    rasters[p].seen |= cells;
  }
}

std::vector<Boundary>
planeBoundaries(const Creases& creases,
                bool knows_sensors,
                std::vector<PlaneRaster>& rasters)
{
  std::vector<std::vector<Boundary>> of_planes(rasters.size());
  oneapi::tbb::parallel_for(std::size_t{0}, rasters.size(), [&](std::size_t p) {
    if (rasters[p].seen.width() == 0)
      return;
    const CellSet cells = surfaceCells(p, creases, knows_sensors, rasters[p]);
    for (const CellLoop& corners : boundariesOf(cells)) {
      Boundary boundary;
      boundary.plane = p;
      for (const auto& [x, y] : corners)
        boundary.contour.emplace_back(x, y);
      boundary.pieces = piecesOf(boundary.contour, p, creases);
      of_planes[p].push_back(std::move(boundary));
    }
  });
  std::vector<Boundary> all;
  for (std::vector<Boundary>& boundaries : of_planes)
    std::move(boundaries.begin(), boundaries.end(), std::back_inserter(all));
  return all;
}

} // namespace
} // namespace outlines

std::size_t
outlineFromEvidence(const TriangleMesh::Triangles& triangles,
                    const SensorView& sensors,
                    const LabeledSource& source,
                    KnownPlanes& known)
{
  using namespace outlines;
  for (KnownPlane& plane : known.planes)
    plane.patch.area = 0; // of the outlines from here on; before, of its members
  if (known.planes.empty() || !(known.spacing > 0) || triangles.empty())
    return 0;
  std::vector<PlaneRaster> rasters = rastersOf(known);
  addFaces(triangles, known, rasters);
  // rings of a scanner enclose what was not seen; elsewhere points support their rectangles
  constexpr double any = std::numeric_limits<double>::infinity();
  const double most_of_faces = source.sensors.single()    ? 2
                               : source.sensors.isKnown() ? any
                                                          : 4;
  addNarrow(triangles, known, most_of_faces, rasters);
  const SightRays rays(known.points, sensors);
  addFreeRays(known, rays, rasters);
  Creases creases = creasesOf(known, rasters);
  if (sharpenRims(source, creases, rasters))
    creases = creasesOf(known, rasters);
  std::vector<Boundary> boundaries =
      planeBoundaries(creases, sensors.isKnown(), rasters);
  const std::vector<Outline> found =
      soundOutlines(creases, rasters, known.spacing, boundaries);
  const EdgeJudge judge(boundaries, found, creases, rasters, sensors.isKnown());
  std::vector<std::vector<std::size_t>> of_planes(rasters.size());
  std::size_t unstraightened = 0;
  for (std::size_t i = 0; i < boundaries.size(); ++i) {
    of_planes[boundaries[i].plane].push_back(i);
    unstraightened += boundaries[i].straightening == Straightening::None ? 1 : 0;
  }
  std::vector<bool> is_missing(rasters.size());
  for (std::size_t p = 0; p < rasters.size(); ++p) {
    PlanePatch& patch = known.planes[p].patch;
    setOutlines(of_planes[p], found, judge, p, rasters[p], patch);
    is_missing[p] = patch.polygons.empty();
  }
  const MeshOutlines mesh(triangles, is_missing, known, most_of_faces);
  for (std::size_t p = 0; p < rasters.size(); ++p)
    if (is_missing[p])
      mesh.outline(p, known.planes[p].patch);
  proposeSurfaces(rays, rasters, known);
  return unstraightened;
}

} // namespace pcl::acmap
