#include "texturing/view_alignment.h"

#include "texturing/block_image.h"
#include "texturing/sheet_plane.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/rotation_vector.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>

namespace pcl::acmap::texturing {

namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/** A camera and how it was moved. */
struct MovedCamera {
  Eigen::Vector3d eye; ///< before
  Eigen::Isometry3d move = Eigen::Isometry3d::Identity();
};

/** Normal equations of the motion of a camera, and the robust mean square of what is left. */
struct Equations {
  Matrix6d matrix = Matrix6d::Zero(); ///< its upper half
  Vector6d right = Vector6d::Zero();
  double cost = 0, count = 0;

  /** \param[in] row derivatives of the brightness by the motion
   * \param[in] rest brightness that is missing */
  void
  add(const Vector6d& row, double rest, double weight)
  {
    for (Eigen::Index i = 0; i < 6; ++i) {
      const double weighted = weight * row[i];
      for (Eigen::Index j = i; j < 6; ++j)
        matrix(i, j) += weighted * row[j];
      right[i] -= weighted * rest;
    }
  }

  void
  add(const Equations& other)
  {
    matrix += other.matrix;
    right += other.right;
    cost += other.cost;
    count += other.count;
  }
};

/** What a view shows of a sheet. */
struct SheetView {
  std::size_t sheet; ///< number among those of the level
  std::size_t view;
  BlockImage image; ///< as it was painted
  BlockImage moved; ///< after its camera was moved
  Equations equations;

  SheetView(std::size_t sheet, std::size_t view)
  : sheet(sheet)
  , view(view)
  {}
};

/** The sum over all views of a sheet. */
struct SheetSum {
  SheetPlane surface;
  BlockImage sum, count;
};

/** All planes in blocks of so many texels. */
struct Level {
  std::int32_t block;
  std::vector<SheetSum> sheets;
  std::vector<SheetView> views; ///< those of a sheet follow each other
};

/** Counts a value of a block. */
void
addTo(float& sum, float& count, float value)
{
  sum = std::isnan(sum) ? value : sum + value;
  count = std::isnan(count) ? 1 : count + 1;
}

/** Calls a function with the block and each sample of a sheet. */
template <typename Function>
void
forSamples(const Sheet& sheet, std::int32_t block, const Function& function)
{
  for (std::int32_t row = 0; row < sheet.height(); ++row)
    for (std::int32_t column = 0; column < sheet.width(); ++column)
      for (const Sample& sample : sheet.samplesOf(sheet.placeOf(column, row))) {
        if (!(sample.weight > 0))
          break;
        function(column / block, row / block, sample);
      }
}

/** The images of the views of a sheet. */
std::vector<SheetView>
viewsOf(std::size_t number,
        const Sheet& sheet,
        std::int32_t block,
        const std::vector<double>& gains)
{
  std::vector<Eigen::AlignedBox2i> boxes(gains.size());
  forSamples(sheet, block, [&](std::int32_t c, std::int32_t r, const Sample& sample) {
    boxes[static_cast<std::size_t>(sample.view)].extend(Eigen::Vector2i(c, r));
  });
  std::vector<SheetView> views;
  std::vector<std::size_t> places(gains.size());
  for (std::size_t view = 0; view < boxes.size(); ++view)
    if (!boxes[view].isEmpty()) {
      places[view] = views.size();
      views.emplace_back(number, view);
      views.back().image.cover(boxes[view]);
      views.back().moved.cover(boxes[view]); // counts, until it is moved
    }
  forSamples(sheet, block, [&](std::int32_t c, std::int32_t r, const Sample& sample) {
    const auto view = static_cast<std::size_t>(sample.view);
    const auto value = static_cast<float>(
        gains[view] * (sample.color[0] + sample.color[1] + sample.color[2]) / 3);
    addTo(views[places[view]].image(c, r), views[places[view]].moved(c, r), value);
  });
  for (SheetView& view : views)
    for (std::size_t i = 0; i < view.image.values.size(); ++i)
      view.image.values[i] /= view.moved.values[i];
  return views;
}

/** The finest level. */
Level
levelOf(const std::vector<Canvas>& canvases,
        const std::vector<Sheet>& sheets,
        std::int32_t block,
        const std::vector<double>& gains)
{
  Level level{block, {}, {}};
  std::vector<const Sheet*> planes;
  for (const Sheet& sheet : sheets)
    if (canvases[sheet.begin()].surface.plane()) {
      planes.push_back(&sheet);
      level.sheets.push_back({{canvases[sheet.begin()], sheet}, {}, {}});
    }
  std::vector<std::vector<SheetView>> views(planes.size());
  oneapi::tbb::parallel_for(std::size_t{0}, planes.size(), [&](std::size_t s) {
    views[s] = viewsOf(s, *planes[s], block, gains);
  });
  for (std::vector<SheetView>& of_sheet : views)
    std::move(of_sheet.begin(), of_sheet.end(), std::back_inserter(level.views));
  return level;
}

Level
halved(const Level& fine)
{
  Level coarse{2 * fine.block, fine.sheets, {}};
  for (const SheetView& view : fine.views) {
    coarse.views.emplace_back(view.sheet, view.view);
    coarse.views.back().image = halved(view.image);
  }
  return coarse;
}

/** Moves an image as its camera is. */
void
moveImage(const Level& level, const MovedCamera& camera, SheetView& view)
{
  constexpr std::int32_t border = 2; // blocks that a motion may add
  const SheetPlane& surface = level.sheets[view.sheet].surface;
  const BlockImage& image = view.image;
  BlockImage& moved = view.moved;
  const Eigen::Vector2i last((surface.chart.colors.width - 1) / level.block,
                             (surface.chart.colors.height - 1) / level.block);
  moved.cover({Eigen::Vector2i(std::max(image.left - border, 0),
                               std::max(image.top - border, 0)),
               Eigen::Vector2i(std::min(image.left + image.width + border, last.x()),
                               std::min(image.top + image.height + border, last.y()))});
  const Eigen::Matrix3d source =
      surface.sourceOf(camera.eye, camera.move.inverse(), level.block);
  for (std::int32_t row = moved.top; row < moved.top + moved.height; ++row) {
    const Eigen::Vector3d start =
        (row + 0.5) * source.col(1) + 0.5 * source.col(0) + source.col(2);
    for (std::int32_t column = moved.left; column < moved.left + moved.width;
         ++column) {
      const Eigen::Vector3d place = start + column * source.col(0);
      moved(column, row) = image.between(place.x() / place.z(), place.y() / place.z());
    }
  }
}

void
sumViews(Level& level, std::size_t number, std::size_t begin, std::size_t end)
{
  SheetSum& sheet = level.sheets[number];
  const RgbImage& size = sheet.surface.chart.colors;
  sheet.sum.cover({Eigen::Vector2i(0, 0),
                   Eigen::Vector2i((size.width - 1) / level.block,
                                   (size.height - 1) / level.block)});
  sheet.count = sheet.sum;
  for (std::size_t v = begin; v < end; ++v) {
    const BlockImage& image = level.views[v].moved;
    std::size_t i = 0;
    for (std::int32_t row = image.top; row < image.top + image.height; ++row)
      for (std::int32_t column = image.left; column < image.left + image.width;
           ++column, ++i) {
        const float value = image.values[i];
        if (!std::isnan(value))
          addTo(sheet.sum(column, row), sheet.count(column, row), value);
      }
  }
}

/** What a view says about its camera, as far as others show the same places. */
void
setEquations(const Level& level, const MovedCamera& camera, SheetView& view)
{
  constexpr double robust = 12; // levels
  const SheetSum& sheet = level.sheets[view.sheet];
  const TextureChart& chart = sheet.surface.chart;
  const Eigen::Vector3d normal = sheet.surface.plane.head<3>();
  const Eigen::Vector3d eye = camera.move * camera.eye;
  const Eigen::Vector3d lifted = normal / -(normal.dot(eye) + sheet.surface.plane[3]);
  const Eigen::Vector3d u = chart.texel_u / (level.block * chart.texel_u.squaredNorm());
  const Eigen::Vector3d v = chart.texel_v / (level.block * chart.texel_v.squaredNorm());
  const auto mean = [&](std::int32_t column, std::int32_t row) {
    return sheet.sum.at(column, row) / sheet.count.at(column, row);
  };
  view.equations = {};
  Equations& own = view.equations;
  const BlockImage& image = view.moved;
  std::size_t i = 0;
  for (std::int32_t row = image.top; row < image.top + image.height; ++row)
    for (std::int32_t column = image.left; column < image.left + image.width;
         ++column, ++i) {
      const float value = image.values[i];
      const float count = sheet.count.at(column, row);
      if (std::isnan(value) || !(count > 1))
        continue;
      const double right =
          static_cast<double>((mean(column + 1, row) - mean(column - 1, row)) / 2);
      const double down =
          static_cast<double>((mean(column, row + 1) - mean(column, row - 1)) / 2);
      if (std::isnan(right + down))
        continue;
      const double rest = static_cast<double>(
          (sheet.sum.at(column, row) - value) / (count - 1) - value);
      const Eigen::Vector3d ray = chart.origin +
                                  (column + 0.5) * level.block * chart.texel_u +
                                  (row + 0.5) * level.block * chart.texel_v - eye;
      // levels that a motion of the place in space changes here
      Eigen::Vector3d slope = right * u + down * v;
      slope -= slope.dot(ray) * lifted;
      Vector6d of_motion;
      of_motion << ray.cross(slope), slope;
      own.add(of_motion, rest, std::min(1.0, robust / std::max(std::abs(rest), 1e-9)));
      own.cost += std::min(rest * rest, 4 * robust * robust);
      ++own.count;
    }
}

/** Sets what a level says about the cameras. */
void
setEquations(const std::vector<MovedCamera>& cameras, Level& level)
{
  const std::size_t views = level.views.size();
  oneapi::tbb::parallel_for(std::size_t{0}, views, [&](std::size_t v) {
    SheetView& view = level.views[v];
    moveImage(level, cameras[view.view], view);
    pollRun();
  });
  std::vector<std::size_t> begins(level.sheets.size() + 1);
  for (const SheetView& view : level.views)
    ++begins[view.sheet + 1];
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  oneapi::tbb::parallel_for(std::size_t{0}, level.sheets.size(), [&](std::size_t s) {
    sumViews(level, s, begins[s], begins[s + 1]);
  });
  oneapi::tbb::parallel_for(std::size_t{0}, views, [&](std::size_t v) {
    SheetView& view = level.views[v];
    setEquations(level, cameras[view.view], view);
    pollRun();
  });
}

/** \return mean square of what is left */
double
costOf(const Level& level)
{
  double cost = 0, count = 0;
  for (const SheetView& view : level.views) {
    cost += view.equations.cost;
    count += view.equations.count;
  }
  return count > 0 ? cost / count : 0;
}

/** Moves a camera by a step of Gauss-Newton. */
void
moveCamera(Equations equations, MovedCamera& camera)
{
  constexpr double damping = 0.8;           // the others move too
  constexpr double prior_rest = 100;        // levels of brightness
  constexpr double far = 0.05, much = 0.02; // metres, radians
  Vector6d prior;
  prior.head<3>().setConstant(prior_rest * prior_rest / (much * much));
  prior.tail<3>().setConstant(prior_rest * prior_rest / (far * far));
  const Eigen::AngleAxisd turned(camera.move.linear());
  const Eigen::Vector3d eye = camera.move * camera.eye;
  Vector6d total;
  total << turned.angle() * turned.axis(), eye - camera.eye;
  equations.matrix.diagonal() += prior;
  equations.right -= prior.cwiseProduct(total);
  const Matrix6d matrix = equations.matrix.selfadjointView<Eigen::Upper>();
  const Vector6d motion = damping * matrix.ldlt().solve(equations.right);
  if (!motion.allFinite())
    return;
  const Eigen::Isometry3d turn(rotationOf(motion.head<3>()));
  camera.move = Eigen::Translation3d(eye + motion.tail<3>()) * turn *
                Eigen::Translation3d(-eye) * camera.move;
}

/** Moves all cameras until what is left hardly falls any more.
 * \return its mean square */
double
settle(Level& level, std::vector<MovedCamera>& cameras)
{
  constexpr int max_steps = 6;
  constexpr double hardly = 0.99;
  std::vector<MovedCamera> best = cameras;
  double least = std::numeric_limits<double>::infinity();
  for (int steps = 0;; ++steps) {
    setEquations(cameras, level);
    const double cost = costOf(level);
    const bool is_settled = !(cost < hardly * least) || steps == max_steps;
    if (cost < least) {
      least = cost;
      best = cameras;
    }
    if (is_settled)
      break;
    std::map<std::size_t, Equations> of_cameras;
    for (const SheetView& view : level.views)
      of_cameras[view.view].add(view.equations);
    for (const auto& [view, equations] : of_cameras)
      moveCamera(equations, cameras[view]);
  }
  cameras = std::move(best);
  return least;
}

} // namespace

std::vector<Eigen::Isometry3d>
alignedMoves(const std::vector<Canvas>& canvases,
             const std::vector<Sheet>& sheets,
             const std::vector<Eigen::Vector3d>& eyes,
             const std::vector<double>& gains)
{
  constexpr std::int32_t finest = 2, coarsest = 16; // texels of a block
  constexpr double clearly = 0.95;
  std::vector<Level> levels{levelOf(canvases, sheets, finest, gains)};
  while (levels.back().block < coarsest)
    levels.push_back(halved(levels.back()));
  std::vector<MovedCamera> cameras;
  for (const Eigen::Vector3d& eye : eyes)
    cameras.push_back({eye});
  setEquations(cameras, levels.front());
  const double before = costOf(levels.front());
  double after = before;
  for (auto level = levels.rbegin(); level != levels.rend(); ++level)
    after = settle(*level, cameras);
  std::vector<Eigen::Isometry3d> moves;
  if (after < clearly * before)
    for (const MovedCamera& camera : cameras)
      moves.push_back(camera.move);
  return moves;
}

} // namespace pcl::acmap::texturing
