#include "outlines/sightings.h"

#include <pcl/core/impl/parallel.h>

#include <cmath>

namespace pcl::acmap::outlines {

namespace {

constexpr double rim_reach = 4; // cells beside the rims of faces
constexpr double ray_gap = 3,
                 face_gap = 8; // cells between rays, without and with faces
constexpr int at_rim = 3;      // cells
constexpr std::size_t rays_a_cell = 16;

/** A ray of a point, where it meets the point's plane. */
struct Sighting {
  std::int32_t plane;
  Eigen::Vector2f place; ///< in the raster of the plane
  float off;             ///< of the point, metres in front of the plane
};

/** Places in the raster of a plane, in the precision of points. */
class RayPlane {
public:
  explicit RayPlane(const PlaneRaster& raster)
  : normal_(raster.normal.cast<float>())
  , offset_(static_cast<float>(raster.normal.dot(raster.origin) + raster.offset))
  , origin_(raster.origin.cast<float>())
  , along_u_((raster.axis_u / raster.cell).cast<float>())
  , along_v_((raster.axis_v / raster.cell).cast<float>())
  {}

  /** \return false if the point is too far from the plane along its ray */
  bool
  meet(const Eigen::Vector3f& sensor,
       const Eigen::Vector3f& point,
       Sighting& sighting) const
  {
    constexpr float max_shift = 0.2F; // of the range
    const Eigen::Vector3f from = sensor - origin_, way = point - sensor;
    const float front = normal_.dot(from) + offset_, fall = -normal_.dot(way);
    if (!(front > 0 && std::abs(front - fall) <= max_shift * fall))
      return false;
    const Eigen::Vector3f at = from + front / fall * way;
    sighting.place = Eigen::Vector2f(at.dot(along_u_), at.dot(along_v_));
    sighting.off = front - fall;
    return true;
  }

private:
  Eigen::Vector3f normal_;
  float offset_;
  Eigen::Vector3f origin_, along_u_, along_v_;
};

std::int64_t
sizeOf(const CellSet& cells)
{
  std::int64_t count = 0;
  for (int y = 0; y < cells.height(); ++y)
    for (std::size_t i = 0; i < cells.wordsOfRow(); ++i)
      count += __builtin_popcountll(cells.row(y)[i]);
  return count;
}

/** Cells that are near the rims of what was seen. */
struct RimBand {
  CellSet inside; ///< seen, and farther from the rims
  CellSet band;
  std::int64_t seen = 0; ///< cells of the band
};

/** Removes the cells along joint creases: beyond them, where faces have shown that the
 * plane ends, and on the plane, but for those near the ends of creases. */
void
removeCreases(std::size_t plane, const Creases& creases, CellSet& band)
{
  constexpr double near_ends = 16, across = rim_reach + 2, step = 0.7; // cells
  for (const std::size_t number : creases.of_planes[plane]) {
    const Crease& crease = creases.creases[number];
    const std::size_t k = crease.sideOf(plane);
    const CreaseLine& line = crease.lines[k];
    for (const CreaseSpan& span : crease.spans[k]) {
      const double from = span.from * line.cells_per_metre;
      const double to = span.to * line.cells_per_metre;
      for (double along = from; span.joint && along < to; along += step) {
        const bool is_near_end = along < from + near_ends || along > to - near_ends;
        for (double off = -across; off <= (is_near_end ? 0 : across); off += step) {
          const Eigen::Vector2d place =
              line.origin + along * line.direction + span.side * off * line.normal;
          band.remove(static_cast<int>(place.x()), static_cast<int>(place.y()));
        }
      }
    }
  }
}

RimBand
bandOf(std::size_t plane, const CellSet& seen, const Creases& creases)
{
  RimBand rims;
  rims.band = seen.dilated(rim_reach);
  rims.band -= seen.eroded(rim_reach);
  removeCreases(plane, creases, rims.band);
  rims.inside = seen;
  rims.inside -= rims.band;
  CellSet covered = rims.band;
  covered &= seen;
  rims.seen = sizeOf(covered);
  return rims;
}

using Sightings = LargeVector<Sighting>;

/** \brief Finds the rays of points that meet their planes near rims. */
class RimRays {
public:
  RimRays(const LabeledSource& source,
          const std::vector<PlaneRaster>& rasters,
          const std::vector<RimBand>& rims)
  : source_(source)
  , rims_(rims)
  , planes_(rasters.begin(), rasters.end())
  {}

  /** Appends the sightings of points that follow one another. Those between two points
   * inside of one plane are not looked at: they are neighbours in an image, or else
   * others are near the rims as well. */
  void
  add(std::size_t first, std::size_t last, Sightings& sightings) const
  {
    Sighting begin, end;
    if (meet(first, begin) && isInside(begin) && meet(last - 1, end) &&
        end.plane == begin.plane && isInside(end))
      return;
    Sighting sighting;
    for (std::size_t i = first; i < last; ++i)
      if (meet(i, sighting) && rimOf(sighting).band.has(sighting.place.cast<double>()))
        sightings.push_back(sighting);
  }

private:
  const RimBand&
  rimOf(const Sighting& sighting) const
  {
    return rims_[static_cast<std::size_t>(sighting.plane)];
  }

  bool
  isInside(const Sighting& sighting) const
  {
    return rimOf(sighting).inside.has(sighting.place.cast<double>());
  }

  bool
  meet(std::size_t i, Sighting& sighting) const
  {
    sighting.plane = source_.labels[i];
    const Eigen::Vector3f* const sensor =
        sighting.plane < 0 ? nullptr : source_.sensors[i];
    return sensor && planes_[static_cast<std::size_t>(sighting.plane)].meet(
                         *sensor, source_.points[i], sighting);
  }

  const LabeledSource& source_;
  const std::vector<RimBand>& rims_;
  std::vector<RayPlane> planes_;
};

/** The sightings near rims from a share of the points, evenly over all of them; each
 * plane's in the order of the points. */
std::vector<Sightings>
sightingsOf(const LabeledSource& source,
            std::size_t share,
            const std::vector<PlaneRaster>& rasters,
            const std::vector<RimBand>& rims)
{
  constexpr std::size_t run = 16, runs_a_block = 1024; // points that follow one another
  const RimRays rays(source, rasters, rims);
  const std::size_t block = run * runs_a_block * share;
  std::vector<Sightings> sightings(source.points.size() / block + 1);
  oneapi::tbb::parallel_for(std::size_t{0}, sightings.size(), [&](std::size_t b) {
    const std::size_t end = std::min((b + 1) * block, source.points.size());
    for (std::size_t first = b * block; first < end; first += run * share)
      rays.add(first, std::min(first + run, end), sightings[b]);
  });
  std::vector<Sightings> of_planes(rasters.size());
  for (Sightings& of_block : sightings)
    for (const Sighting& sighting : std::exchange(of_block, {}))
      of_planes[static_cast<std::size_t>(sighting.plane)].push_back(sighting);
  return of_planes;
}

/** Is the mean of the points' distances to a plane zero but for chance?
 * \param[in] numbers of sightings, at least 3 */
bool
areOnPlane(const Sightings& sightings, const std::size_t* begin, const std::size_t* end)
{
  constexpr double max_deviations = 3; // of the mean
  double sum = 0, squares = 0;
  for (const std::size_t* i = begin; i != end; ++i) {
    const double off = sightings[*i].off;
    sum += off;
    squares += off * off;
  }
  const auto count = static_cast<double>(end - begin);
  const double scatter = squares - sum * sum / count;
  return sum * sum * (count - 1) <= max_deviations * max_deviations * scatter * count;
}

/** Removes the sightings where there are no faces and the points are on one side of the
 * plane: they belong to another surface, such as a reveal that is no plane of its own.
 * That is told for blocks of cells; where rays are few, for larger ones. */
void
dropForeign(const CellSet& seen, Sightings& sightings)
{
  constexpr double sides[] = {2, 8}; // cells, of a block
  constexpr std::ptrdiff_t min_count = 3;
  std::vector<std::uint8_t> is_kept(sightings.size(), 1);
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < sightings.size(); ++i)
    if (!seen.has(sightings[i].place.cast<double>())) {
      is_kept[i] = 0;
      open.push_back(i);
    }
  std::vector<std::pair<std::int64_t, std::size_t>> blocks;
  std::vector<std::size_t> numbers;
  for (const double side : sides) {
    blocks.clear();
    numbers.clear();
    for (const std::size_t i : open) {
      const Eigen::Vector2d place = sightings[i].place.cast<double>() / side;
      blocks.emplace_back(static_cast<std::int64_t>(place.y()) * seen.width() +
                              static_cast<std::int64_t>(place.x()),
                          i);
    }
    std::sort(blocks.begin(), blocks.end());
    for (const auto& [block, i] : blocks)
      numbers.push_back(i);
    open.clear();
    for (std::size_t first = 0, last = 0; first < blocks.size(); first = last) {
      while (last < blocks.size() && blocks[last].first == blocks[first].first)
        ++last;
      const std::size_t *const begin = numbers.data() + first, *const end =
                                                                   numbers.data() +
                                                                   last;
      if (end - begin < min_count)
        open.insert(open.end(), begin, end);
      else if (areOnPlane(sightings, begin, end))
        for (const std::size_t* i = begin; i != end; ++i)
          is_kept[*i] = 1;
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < sightings.size(); ++i)
    if (is_kept[i])
      sightings[kept++] = sightings[i];
  sightings.resize(kept);
}

} // namespace

bool
sharpenRims(const LabeledSource& source,
            const Creases& creases,
            std::vector<PlaneRaster>& rasters)
{
  if (!source.sensors.isKnown() || source.points.size() == 0 ||
      source.labels.size() != source.points.size())
    return false;
  std::vector<RimBand> rims(rasters.size());
  oneapi::tbb::parallel_for(std::size_t{0}, rasters.size(), [&](std::size_t p) {
    rims[p] = bandOf(p, rasters[p].seen, creases);
  });
  std::int64_t cells = 0;
  for (std::size_t p = 0; p < rasters.size(); ++p)
    cells += rims[p].seen + sizeOf(rims[p].inside);
  const std::size_t share = std::max<std::size_t>(
      1,
      source.points.size() /
          (rays_a_cell * static_cast<std::size_t>(std::max<std::int64_t>(cells, 1))));
  std::vector<Sightings> sightings = sightingsOf(source, share, rasters, rims);
  oneapi::tbb::parallel_for(std::size_t{0}, rasters.size(), [&](std::size_t p) {
    PlaneRaster& raster = rasters[p];
    if (static_cast<std::int64_t>(sightings[p].size()) < 2 * rims[p].seen)
      return;
    dropForeign(raster.seen, sightings[p]);
    CellSet seen = rims[p].inside;
    for (const Sighting& sighting : sightings[p])
      seen.add(static_cast<int>(sighting.place.x()),
               static_cast<int>(sighting.place.y()));
    raster.seen &= seen.dilated(face_gap).eroded(face_gap);
    CellSet closed = seen.dilated(ray_gap).eroded(ray_gap);
    closed -= raster.free;
    raster.seen |= closed;
    raster.rim_points.clear();
    raster.are_rays = true;
    for (const Sighting& sighting : sightings[p])
      if (!raster.seen.hasAround(sighting.place.cast<double>(), at_rim))
        raster.rim_points.push_back(sighting.place.cast<double>());
  });
  return true;
}

} // namespace pcl::acmap::outlines
