#include "outlines/proposed_surfaces.h"

#include <pcl/core/impl/parallel.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl::acmap::outlines {

namespace {

// Lengths are in cells, of which two are a spacing.

/** An edge of an outline, in cells, beside which a gap may be. */
struct GapSide {
  Eigen::Vector2d from, to;
  EdgeKind kind;

  Eigen::Vector2d
  direction() const
  {
    return (to - from).normalized();
  }

  double
  length() const
  {
    return (to - from).norm();
  }

  bool
  isCrease() const
  {
    return kind == EdgeKind::Crease || kind == EdgeKind::Contact;
  }
};

using GapSides = std::vector<GapSide>;

/** A region beside an outline in which nothing was seen. */
struct Gap {
  Loop loop; ///< counter-clockwise
  double area = 0;
  std::size_t first = 0, count = 0; ///< sides of the outline that bound it
  std::vector<Loop> islands;        ///< surface inside, counter-clockwise
};

/** The sides of each loop of a polygon, the outer boundary first. */
std::vector<GapSides>
sidesOf(const PlanePolygon& polygon, const PlaneRaster& raster)
{
  std::vector<GapSides> all;
  std::size_t edge = 0;
  const auto add = [&](const std::vector<Eigen::Vector3f>& loop) {
    all.emplace_back();
    for (std::size_t i = 0; i < loop.size(); ++i)
      all.back().push_back({raster.placeOf(loop[i].cast<double>()),
                            raster.placeOf(loop[(i + 1) % loop.size()].cast<double>()),
                            polygon.edges[edge++].kind});
  };
  add(polygon.outer);
  for (const std::vector<Eigen::Vector3f>& hole : polygon.holes)
    add(hole);
  return all;
}

/** Can surface be proposed beyond a side? */
bool
isClosable(const GapSide& side)
{
  return side.kind == EdgeKind::Frontier || side.isCrease();
}

/** Where the boundary goes on from one side to another one beyond a bay: nothing if they
 * do not enclose it, otherwise the corner between them, or the end of the first one if
 * they are on one line.
 * \param[in] around length of the boundary between them */
std::optional<Eigen::Vector2d>
closingOf(const GapSide& before, const GapSide& after, double around)
{
  constexpr double min_cosine = 0.995, min_sine = 0.7, max_detour = 1.5;
  constexpr double min_flank = 4, min_mouth = 4, max_off_line = 2;
  const Eigen::Vector2d way = after.from - before.to;
  const Eigen::Vector2d out = before.direction(), in = after.direction();
  if (before.length() < min_flank || after.length() < min_flank)
    return {};
  if (out.dot(in) > min_cosine) {
    const double mouth = way.dot(out);
    const auto isStraight = [&](const GapSide& side) {
      return side.isCrease() || side.length() >= mouth / 2;
    };
    if (mouth < min_mouth || std::abs(cross(out, way)) > max_off_line ||
        std::abs(cross(in, way)) > max_off_line || !isStraight(before) ||
        !isStraight(after))
      return {};
    return before.to;
  }
  const double sine = cross(out, in);
  if (!before.isCrease() || !after.isCrease() || std::abs(sine) < min_sine)
    return {};
  const double to_corner = cross(way, in) / sine;
  const double from_corner = -cross(way, out) / sine;
  if (to_corner < 0 || from_corner < 0 || to_corner + from_corner > max_detour * around)
    return {};
  return before.to + to_corner * out;
}

/** The bays of the outer boundary of a polygon. */
std::vector<Gap>
baysOf(const GapSides& sides)
{
  constexpr std::size_t max_count = 64;
  std::vector<Gap> bays;
  const std::size_t size = sides.size();
  for (std::size_t before = 0; before < size; ++before) {
    double around = 0;
    for (std::size_t count = 1; count + 2 <= size && count <= max_count; ++count) {
      const GapSide& last = sides[(before + count) % size];
      if (!isClosable(last))
        break;
      around += last.length();
      const GapSide& after = sides[(before + count + 1) % size];
      const auto corner = closingOf(sides[before], after, around);
      if (!corner)
        continue;
      Gap bay;
      bay.first = before + 1;
      bay.count = count;
      bay.loop.push_back(after.from);
      for (std::size_t k = count; k > 0; --k)
        bay.loop.push_back(sides[(before + k) % size].from);
      if ((*corner - bay.loop.back()).norm() > 1 &&
          (*corner - bay.loop.front()).norm() > 1)
        bay.loop.push_back(*corner);
      bays.push_back(std::move(bay));
    }
  }
  return bays;
}

/** A hole whose sides are all closable. */
std::optional<Gap>
wholeOf(const GapSides& hole)
{
  if (!std::all_of(hole.begin(), hole.end(), isClosable))
    return {};
  Gap gap;
  gap.count = hole.size();
  for (auto side = hole.rbegin(); side != hole.rend(); ++side)
    gap.loop.push_back(side->to);
  return gap;
}

/** \brief The cells of a gap, without those beside its boundary, where neighbours leak over
 * the outline. */
class GapCells {
public:
  explicit GapCells(const Gap& gap)
  {
    constexpr double margin = 2;
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& place : gap.loop)
      box.extend(place);
    constexpr int border = 3; // cells around, which are no members
    first_ = box.min().array().floor().matrix().cast<int>().array() - border;
    const Eigen::Vector2i size = (box.max() - first_.cast<double>()).cast<int>();
    cells_ = CellSet(size.x() + 1 + border, size.y() + 1 + border);
    std::vector<Loop> loops = gap.islands;
    loops.push_back(gap.loop);
    for (Loop& loop : loops)
      for (Eigen::Vector2d& place : loop)
        place -= first_.cast<double>();
    fillLoops(loops, cells_);
    cells_ = cells_.eroded(margin);
  }

  /** No cells of the same gap. */
  GapCells
  none() const
  {
    GapCells cells = *this;
    cells.cells_ = CellSet(cells_.width(), cells_.height());
    return cells;
  }

  Eigen::AlignedBox2d
  box() const
  {
    const Eigen::Vector2i size(cells_.width(), cells_.height());
    return {first_.cast<double>(), (first_ + size).cast<double>()};
  }

  /** Adds the cell at a place if it is one of \a all. */
  void
  addOf(const GapCells& all, const Eigen::Vector2d& place)
  {
    const Eigen::Vector2d own = place - first_.cast<double>();
    if (all.cells_.has(own))
      cells_.add(static_cast<int>(own.x()), static_cast<int>(own.y()));
  }

  template <typename Visit>
  void
  forEach(const Visit& visit) const
  {
    for (int y = 0; y < cells_.height(); ++y)
      for (int x = 0; x < cells_.width(); ++x)
        if (cells_.has(x, y))
          visit(first_.x() + x, first_.y() + y);
  }

private:
  Eigen::Vector2i first_; ///< cell at (0, 0)
  CellSet cells_;
};

/** \brief Judges which regions beside the outlines of a plane are proposed. */
class GapJudge {
public:
  GapJudge(const SightRays& rays,
           const std::vector<PlaneRaster>& rasters,
           const KnownPlanes& known,
           std::size_t plane)
  : rays_(rays)
  , rasters_(rasters)
  , known_(known)
  , plane_(plane)
  , raster_(rasters[plane])
  {}

  /** Sets area and islands of a gap.
   * \param[in] sides of all loops of the plane
   * \return false if the gap is too small, or its closing crosses the outline */
  bool
  isSound(const std::vector<GapSides>& sides, Gap& gap) const
  {
    constexpr double min_area = 100, min_width = 4;
    gap.area = signedArea(gap.loop);
    double around = 0;
    for (std::size_t i = 0, k = gap.loop.size() - 1; i < gap.loop.size(); k = i++)
      around += (gap.loop[i] - gap.loop[k]).norm();
    if (gap.area < min_area || 2 * gap.area < min_width * around)
      return false;
    for (const GapSides& loop : sides)
      for (const GapSide& side : loop)
        for (std::size_t i = 0, k = gap.loop.size() - 1; i < gap.loop.size(); k = i++) {
          Eigen::Vector2d place;
          if (segmentsCross(gap.loop[k], gap.loop[i], side.from, side.to, place))
            return false;
        }
    for (const GapSides& loop : sides) {
      Loop places;
      Eigen::Vector2d middle = Eigen::Vector2d::Zero();
      for (const GapSide& side : loop) {
        places.push_back(side.from);
        middle += side.from / static_cast<double>(loop.size());
      }
      const bool is_inside =
          contains(gap.loop, places.front()) && contains(gap.loop, middle);
      const bool is_own =
          std::find(gap.loop.begin(), gap.loop.end(), places.front()) != gap.loop.end();
      if (is_inside && !is_own && signedArea(places) > 0)
        gap.islands.push_back(std::move(places));
    }
    return true;
  }

  /** \param[in] has_crease is a crease among its boundary? */
  bool
  isProposed(const Gap& gap, bool has_crease) const
  {
    constexpr double max_seen = 0.05, max_barrier = 0.15, min_covered = 0.7;
    const GapCells cells(gap);
    const Count count = countOf(cells);
    return count.all > 0 && count.seen <= max_seen * count.all &&
           ((!has_crease && count.barrier <= max_barrier * count.all) ||
            count.covered >= min_covered * count.all) &&
           !isLookedThrough(cells, count.all);
  }

private:
  struct Count {
    double all = 0, seen = 0, barrier = 0, covered = 0;
  };

  Count
  countOf(const GapCells& cells) const
  {
    const std::vector<std::size_t> in_front = planesInFront();
    Count count;
    cells.forEach([&](int x, int y) {
      ++count.all;
      count.seen += raster_.seen.has(x, y) ? 1 : 0;
      count.barrier += raster_.barrier.has(x, y) ? 1 : 0;
      const Eigen::Vector3d point = raster_.pointAt({x + 0.5, y + 0.5});
      count.covered +=
          std::any_of(in_front.begin(),
                      in_front.end(),
                      [&](std::size_t p) {
                        return rasters_[p].seen.has(rasters_[p].placeOf(point));
                      })
              ? 1
              : 0;
    });
    return count;
  }

  /** Planes that face the same way, in front of this one by at most a cupboard. */
  std::vector<std::size_t>
  planesInFront() const
  {
    constexpr double min_cosine = 0.98, max_depth = 1.2; // metres
    std::vector<std::size_t> found;
    for (std::size_t p = 0; p < rasters_.size(); ++p) {
      const double depth =
          raster_.normal.dot(known_.planes[p].patch.center) + raster_.offset;
      if (p != plane_ && raster_.normal.dot(rasters_[p].normal) > min_cosine &&
          depth > known_.spacing && depth < max_depth)
        found.push_back(p);
    }
    return found;
  }

  bool
  isLookedThrough(const GapCells& cells, double all) const
  {
    constexpr double spacings = 0.5, deviations = 4, max_share = 0.01;
    GapCells crossed = cells.none();
    rays_.forEachThrough(
        raster_,
        cells.box(),
        std::max(spacings * known_.spacing,
                 deviations * known_.planes[plane_].patch.rms),
        [&](const Eigen::Vector2d& place) { crossed.addOf(cells, place); });
    double count = 0;
    crossed.forEach([&](int, int) { ++count; });
    return count > max_share * all;
  }

  const SightRays& rays_;
  const std::vector<PlaneRaster>& rasters_;
  const KnownPlanes& known_;
  std::size_t plane_;
  const PlaneRaster& raster_;
};

bool
hasCrease(const GapSides& sides, const Gap& gap)
{
  constexpr double max_share = 0.1;
  double creases = 0, all = 0;
  for (std::size_t k = 0; k < gap.count; ++k) {
    const GapSide& side = sides[(gap.first + k) % sides.size()];
    all += side.length();
    creases += side.isCrease() ? side.length() : 0;
  }
  return creases > max_share * all;
}

PlanePolygon
polygonOf(const Gap& gap, const PlaneRaster& raster)
{
  PlanePolygon polygon;
  for (const Eigen::Vector2d& place : gap.loop)
    polygon.outer.push_back(raster.pointAt(place).cast<float>());
  for (const Loop& island : gap.islands) {
    polygon.holes.emplace_back();
    for (auto place = island.rbegin(); place != island.rend(); ++place)
      polygon.holes.back().push_back(raster.pointAt(*place).cast<float>());
  }
  return polygon;
}

std::vector<PlanePolygon>
proposalsOf(const GapJudge& judge, const PlanePatch& patch, const PlaneRaster& raster)
{
  std::vector<std::vector<GapSides>> polygons;
  std::vector<GapSides> all;
  for (const PlanePolygon& polygon : patch.polygons) {
    if (polygon.edges.empty())
      return {};
    polygons.push_back(sidesOf(polygon, raster));
    all.insert(all.end(), polygons.back().begin(), polygons.back().end());
  }
  std::vector<PlanePolygon> proposed;
  for (const std::vector<GapSides>& loops : polygons) {
    for (std::size_t k = 1; k < loops.size(); ++k)
      if (std::optional<Gap> hole = wholeOf(loops[k]);
          hole && judge.isSound(all, *hole) &&
          judge.isProposed(*hole, hasCrease(loops[k], *hole)))
        proposed.push_back(polygonOf(*hole, raster));
    std::vector<Gap> bays;
    for (Gap& bay : baysOf(loops.front()))
      if (judge.isSound(all, bay))
        bays.push_back(std::move(bay));
    std::stable_sort(bays.begin(), bays.end(), [](const Gap& a, const Gap& b) {
      return a.area > b.area;
    });
    std::vector<bool> is_taken(loops.front().size());
    for (const Gap& bay : bays) {
      const auto each = [&](const auto& visit) {
        for (std::size_t k = 0; k < bay.count; ++k)
          visit((bay.first + k) % is_taken.size());
      };
      bool is_free = true;
      each([&](std::size_t side) { is_free &= !is_taken[side]; });
      if (!is_free || !judge.isProposed(bay, hasCrease(loops.front(), bay)))
        continue;
      each([&](std::size_t side) { is_taken[side] = true; });
      proposed.push_back(polygonOf(bay, raster));
    }
  }
  return proposed;
}

} // namespace

void
proposeSurfaces(const SightRays& rays,
                const std::vector<PlaneRaster>& rasters,
                KnownPlanes& known)
{
  if (!rays.areKnown())
    return;
  oneapi::tbb::parallel_for(std::size_t{0}, rasters.size(), [&](std::size_t p) {
    const GapJudge judge(rays, rasters, known, p);
    PlanePatch& patch = known.planes[p].patch;
    if (rasters[p].seen.width() > 0)
      patch.proposed = proposalsOf(judge, patch, rasters[p]);
  });
}

} // namespace pcl::acmap::outlines
