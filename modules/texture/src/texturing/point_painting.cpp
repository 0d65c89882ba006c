#include "texturing/canvas_painting.h"

#include <pcl/core/impl/parallel.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

namespace pcl::acmap::texturing {

namespace {

/** Some points of a view, by their numbers. */
struct PointRun {
  const std::uint32_t* first;
  const std::uint32_t* last;
};

/** The points of one station on one canvas, sorted into its texels. */
class PointGrid {
public:
  /** \param[in] reach texels around the points that they may colour */
  PointGrid(const ColoredView& view,
            const PointRun& run,
            const Canvas& canvas,
            std::int32_t reach);

  /** \return nothing if there are no points near the texel */
  Sample
  sampleAt(std::int32_t column, std::int32_t row) const;

  std::int32_t left = 0, top = 0, width = 0,
               height = 0; ///< of the texels it may colour

private:
  /** Adds the points of the texels whose distance is \p ring, in rows or columns. */
  void
  addRing(std::int32_t column,
          std::int32_t row,
          std::int32_t ring,
          std::vector<std::uint32_t>& near) const;

  std::array<std::uint8_t, 3>
  middleOf(std::vector<std::uint32_t>& near) const;

  const ColoredView& view_;
  std::vector<std::uint32_t> ends_;   ///< of the points of each texel, row by row
  std::vector<std::uint32_t> points_; ///< by texel, ascending in each
};

constexpr std::int32_t search_reach = 4; ///< texels, two of the points' spacings
constexpr std::int32_t seen_reach = 2;   ///< texels in which there must be a point
constexpr std::size_t wanted_points = 12;

PointGrid::PointGrid(const ColoredView& view,
                     const PointRun& run,
                     const Canvas& canvas,
                     std::int32_t reach)
: view_(view)
{
  std::vector<std::array<std::int32_t, 2>> places;
  std::int32_t right = -1, bottom = -1;
  left = canvas.chart.colors.width;
  top = canvas.chart.colors.height;
  for (const std::uint32_t* i = run.first; i != run.last; ++i) {
    if (places.size() % parallel_chunk == 0)
      pollRun();
    const Eigen::Vector2d place =
        canvas.surface.placeOf(view.T_map_camera * view.points[*i].cast<double>());
    const auto& [column, row] = places.emplace_back(std::array<std::int32_t, 2>{
        static_cast<std::int32_t>(place.x()), static_cast<std::int32_t>(place.y())});
    left = std::min(left, column - reach);
    top = std::min(top, row - reach);
    right = std::max(right, column + reach);
    bottom = std::max(bottom, row + reach);
  }
  left = std::max(left, 0);
  top = std::max(top, 0);
  width = std::min(right + 1, canvas.chart.colors.width) - left;
  height = std::min(bottom + 1, canvas.chart.colors.height) - top;
  const auto cellOf = [&](const std::array<std::int32_t, 2>& place) {
    return static_cast<std::size_t>(place[1] - top) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(place[0] - left);
  };
  ends_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) + 1,
               0);
  for (const auto& place : places)
    ++ends_[cellOf(place) + 1];
  std::partial_sum(ends_.begin(), ends_.end(), ends_.begin());
  std::vector<std::uint32_t> begins(ends_.begin(), ends_.end() - 1);
  points_.resize(places.size());
  for (std::size_t k = 0; k < places.size(); ++k)
    points_[begins[cellOf(places[k])]++] = run.first[k];
}

void
PointGrid::addRing(std::int32_t column,
                   std::int32_t row,
                   std::int32_t ring,
                   std::vector<std::uint32_t>& near) const
{
  const auto addCell = [&](std::int32_t c, std::int32_t r) {
    if (c < 0 || r < 0 || c >= width || r >= height)
      return;
    const std::size_t cell =
        static_cast<std::size_t>(r) * static_cast<std::size_t>(width) +
        static_cast<std::size_t>(c);
    near.insert(
        near.end(), points_.begin() + ends_[cell], points_.begin() + ends_[cell + 1]);
  };
  for (std::int32_t r = row - ring; r <= row + ring; ++r) {
    const bool is_whole = std::abs(r - row) == ring;
    for (std::int32_t c = column - ring; c <= column + ring;
         c += is_whole || ring == 0 ? 1 : 2 * ring)
      addCell(c, r);
  }
}

/** The mean of the middle half by brightness: half of the points may be of another exposure, of
 * what stands before the wall, or noise. */
std::array<std::uint8_t, 3>
PointGrid::middleOf(std::vector<std::uint32_t>& near) const
{
  const auto brightness = [&](std::uint32_t i) {
    const std::array<std::uint8_t, 3> color = colorOf(view_, i);
    return color[0] + color[1] + color[2];
  };
  std::sort(near.begin(), near.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(brightness(a), a) < std::pair(brightness(b), b);
  });
  const std::size_t cut = near.size() / 4;
  PointColors middle;
  for (std::size_t k = cut; k < near.size() - cut; ++k)
    middle.add(colorOf(view_, near[k]));
  return middle.mean();
}

Sample
PointGrid::sampleAt(std::int32_t column, std::int32_t row) const
{
  std::vector<std::uint32_t> near;
  std::int32_t ring = 0;
  for (; ring <= search_reach; ++ring) {
    addRing(column - left, row - top, ring, near);
    if (near.size() >= wanted_points || (near.empty() && ring >= seen_reach))
      break;
  }
  Sample sample;
  if (near.empty())
    return sample;
  const std::int32_t side = 2 * std::min(ring, search_reach) + 1;
  sample.weight = static_cast<float>(near.size()) / static_cast<float>(side * side);
  sample.color = middleOf(near);
  return sample;
}

void
splatOnto(const ColoredView& view,
          std::int32_t number,
          const PointRun& run,
          Canvas& canvas)
{
  const PointGrid grid(view, run, canvas, seen_reach);
  oneapi::tbb::parallel_for(grid.top, grid.top + grid.height, [&](std::int32_t row) {
    for (std::int32_t column = grid.left; column < grid.left + grid.width; ++column) {
      const std::size_t texel = canvas.index(column, row);
      if (canvas.mask[texel] != TexelPlace::Inside)
        continue;
      Sample sample = grid.sampleAt(column, row);
      sample.view = number;
      canvas.offer(texel, sample);
    }
  });
}

} // namespace

std::int32_t
Stations::stationOf(const ColoredView& view, std::size_t point)
{
  return view.stations[static_cast<std::size_t>(view.points.index(point))];
}

Stations::Stations(const ColoredView& view)
{
  constexpr std::size_t most = 1 << 16;
  if (!view.stations)
    return;
  std::set<std::int32_t> found;
  for (std::size_t i = 0; i < view.points.size() && found.size() <= most; ++i)
    found.insert(stationOf(view, i));
  if (found.size() > 1 && found.size() <= most)
    numbers_.assign(found.begin(), found.end());
}

std::int32_t
Stations::indexOf(const ColoredView& view, std::size_t point) const
{
  if (numbers_.empty())
    return 0;
  return static_cast<std::int32_t>(
      std::lower_bound(numbers_.begin(), numbers_.end(), stationOf(view, point)) -
      numbers_.begin());
}

void
splat(const ColoredView& view,
      std::int32_t number,
      const Stations& stations,
      const PointLabels& nearest,
      std::vector<Canvas>& canvases)
{
  std::vector<std::size_t> ends(canvases.size() + 1, 0); // of the points of each canvas
  for (const std::int32_t canvas : nearest)
    if (canvas >= 0)
      ++ends[static_cast<std::size_t>(canvas) + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  LargeVector<std::uint32_t> points(ends.back());
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    if (i % parallel_chunk == 0)
      pollRun();
    if (nearest[i] >= 0)
      points[ends[static_cast<std::size_t>(nearest[i])]++] =
          static_cast<std::uint32_t>(i);
  }
  for (std::size_t c = 0, begin = 0; c < canvases.size(); begin = ends[c++]) {
    std::uint32_t* first = points.data() + begin;
    std::uint32_t* const last = points.data() + ends[c];
    if (stations.count() > 1)
      std::stable_sort(first, last, [&](std::uint32_t a, std::uint32_t b) {
        return stations.indexOf(view, a) < stations.indexOf(view, b);
      });
    while (first != last) {
      const std::int32_t station = stations.indexOf(view, *first);
      std::uint32_t* const end = std::find_if(first, last, [&](std::uint32_t i) {
        return stations.indexOf(view, i) != station;
      });
      splatOnto(view, number + station, {first, end}, canvases[c]);
      first = end;
    }
  }
}

void
addPoints(const ColoredView& view,
          std::int32_t number,
          const PointLabels& nearest,
          std::vector<Canvas>& canvases)
{
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    if (nearest[i] < 0)
      continue;
    Canvas& canvas = canvases[static_cast<std::size_t>(nearest[i])];
    const Eigen::Vector3d point = view.T_map_camera * view.points[i].cast<double>();
    canvas.points[canvas.texelAt(canvas.surface.placeOf(point))].add(colorOf(view, i));
    if (canvas.views.empty() || canvas.views.back() != number)
      canvas.views.push_back(number);
  }
}

} // namespace pcl::acmap::texturing
