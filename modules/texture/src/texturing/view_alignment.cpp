#include "texturing/view_alignment.h"

#include <pcl/core/impl/parallel.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace pcl::acmap::texturing {

namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

/** Brightness of a part of a sheet, in blocks of texels; NaN where it is unknown. */
struct BlockImage {
  std::int32_t left = 0, top = 0, width = 0, height = 0; ///< blocks
  std::vector<float> values;

  float
  at(std::int32_t column, std::int32_t row) const
  {
    const std::int32_t c = column - left, r = row - top;
    return c < 0 || r < 0 || c >= width || r >= height
               ? unknown
               : values[static_cast<std::size_t>(r) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(c)];
  }

  float&
  operator()(std::int32_t column, std::int32_t row)
  {
    return values[static_cast<std::size_t>(row - top) *
                      static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(column - left)];
  }

  /** Bilinear between the middles of blocks; NaN where one of them is unknown. */
  float
  between(const Eigen::Vector2d& place) const
  {
    const Eigen::Vector2d at_middle = place.array() - 0.5;
    const auto c = static_cast<std::int32_t>(std::floor(at_middle.x()));
    const auto r = static_cast<std::int32_t>(std::floor(at_middle.y()));
    const auto x = static_cast<float>(at_middle.x() - c);
    const auto y = static_cast<float>(at_middle.y() - r);
    return (1 - y) * ((1 - x) * at(c, r) + x * at(c + 1, r)) +
           y * ((1 - x) * at(c, r + 1) + x * at(c + 1, r + 1));
  }

  void
  cover(const Eigen::AlignedBox2i& box)
  {
    left = box.min().x();
    top = box.min().y();
    width = box.sizes().x() + 1;
    height = box.sizes().y() + 1;
    values.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                  unknown);
  }
};

/** The same in blocks of twice the side. */
BlockImage
halved(const BlockImage& fine)
{
  BlockImage coarse;
  coarse.cover({Eigen::Vector2i(fine.left / 2, fine.top / 2),
                Eigen::Vector2i((fine.left + fine.width - 1) / 2,
                                (fine.top + fine.height - 1) / 2)});
  for (std::int32_t row = coarse.top; row < coarse.top + coarse.height; ++row)
    for (std::int32_t column = coarse.left; column < coarse.left + coarse.width;
         ++column) {
      float sum = 0;
      int count = 0;
      for (const std::int32_t r : {2 * row, 2 * row + 1})
        for (const std::int32_t c : {2 * column, 2 * column + 1})
          if (const float value = fine.at(c, r); !std::isnan(value)) {
            sum += value;
            ++count;
          }
      if (count > 1)
        coarse(column, row) = sum / static_cast<float>(count);
    }
  return coarse;
}

/** A plane of a sheet, and where its texels are. */
struct SheetPlane {
  TextureChart chart; ///< of the whole sheet, without colours
  Eigen::Vector4d plane;

  /** The place that the camera, before it was moved, shows where \p place is afterwards. */
  Eigen::Vector2d
  sourceOf(const Eigen::Vector3d& place,
           const Eigen::Vector3d& eye,
           const Eigen::Isometry3d& inverse_move) const
  {
    const Eigen::Vector3d ray = inverse_move * place - eye;
    const double along = plane.head<3>().dot(ray);
    const double from = plane.head<3>().dot(eye) + plane[3];
    return placeOn(chart, eye - from / along * ray);
  }
};

/** What the views show of a sheet. */
struct SheetImages {
  SheetPlane surface;
  std::map<std::int32_t, BlockImage> views;
};

SheetPlane
planeOf(const Canvas& first, const Sheet& sheet)
{
  SheetPlane plane{first.chart, *first.surface.plane()};
  plane.chart.colors.width = sheet.width();
  plane.chart.colors.height = sheet.height();
  return plane;
}

/** Images in blocks of two texels. */
SheetImages
imagesOf(const Canvas& first, const Sheet& sheet, const std::vector<double>& gains)
{
  constexpr std::int32_t block = 2;
  SheetImages images{planeOf(first, sheet), {}};
  std::map<std::int32_t, Eigen::AlignedBox2i> boxes;
  const auto forSamples = [&](const auto& function) {
    for (std::int32_t row = 0; row < sheet.height(); ++row)
      for (std::int32_t column = 0; column < sheet.width(); ++column)
        for (const Sample& sample : sheet.samplesOf(sheet.placeOf(column, row)))
          if (sample.weight > 0)
            function(Eigen::Vector2i(column / block, row / block), sample);
  };
  forSamples([&](const Eigen::Vector2i& place, const Sample& sample) {
    boxes[sample.view].extend(place);
  });
  std::map<std::int32_t, BlockImage> counts;
  for (const auto& [view, box] : boxes) {
    images.views[view].cover(box);
    counts[view].cover(box);
  }
  forSamples([&](const Eigen::Vector2i& place, const Sample& sample) {
    float& sum = images.views[sample.view](place.x(), place.y());
    float& count = counts[sample.view](place.x(), place.y());
    const auto value =
        static_cast<float>(gains[static_cast<std::size_t>(sample.view)] *
                           (sample.color[0] + sample.color[1] + sample.color[2]) / 3);
    sum = std::isnan(sum) ? value : sum + value;
    count = std::isnan(count) ? 1 : count + 1;
  });
  for (auto& [view, image] : images.views)
    for (std::size_t i = 0; i < image.values.size(); ++i)
      image.values[i] /= counts[view].values[i];
  return images;
}

/** Normal equations of the motion of a camera, and the robust mean square of what is left. */
struct Equations {
  Matrix6d matrix = Matrix6d::Zero();
  Vector6d right = Vector6d::Zero();
  double cost = 0, count = 0;

  void
  add(const Equations& other)
  {
    matrix += other.matrix;
    right += other.right;
    cost += other.cost;
    count += other.count;
  }
};

/** A camera and how it was moved. */
struct MovedCamera {
  Eigen::Vector3d eye; ///< before
  Eigen::Isometry3d move = Eigen::Isometry3d::Identity();
};

/** What the views show of a sheet after their cameras were moved, over the whole sheet. */
struct MovedImages {
  std::map<std::int32_t, BlockImage> views;
  BlockImage sum, count;
};

MovedImages
moved(const SheetImages& images,
      std::int32_t block,
      const std::vector<MovedCamera>& cameras)
{
  constexpr std::int32_t border = 2; // blocks that a motion may add
  const TextureChart& chart = images.surface.chart;
  const Eigen::Vector2i last((chart.colors.width - 1) / block,
                             (chart.colors.height - 1) / block);
  MovedImages result;
  result.sum.cover({Eigen::Vector2i(0, 0), last});
  result.count = result.sum;
  for (const auto& [view, image] : images.views) {
    const MovedCamera& camera = cameras[static_cast<std::size_t>(view)];
    const Eigen::Isometry3d inverse = camera.move.inverse();
    BlockImage& here = result.views[view];
    here.cover(
        {Eigen::Vector2i(std::max(image.left - border, 0),
                         std::max(image.top - border, 0)),
         Eigen::Vector2i(std::min(image.left + image.width + border, last.x()),
                         std::min(image.top + image.height + border, last.y()))});
    for (std::int32_t row = here.top; row < here.top + here.height; ++row)
      for (std::int32_t column = here.left; column < here.left + here.width; ++column) {
        const Eigen::Vector3d place =
            middleOf(chart, (column + 0.5) * block - 0.5, (row + 0.5) * block - 0.5);
        const float value =
            image.between(images.surface.sourceOf(place, camera.eye, inverse) / block);
        if (std::isnan(value))
          continue;
        here(column, row) = value;
        float& sum = result.sum(column, row);
        float& count = result.count(column, row);
        sum = std::isnan(sum) ? value : sum + value;
        count = std::isnan(count) ? 1 : count + 1;
      }
  }
  return result;
}

/** Adds what a sheet says about the cameras. */
void
addEquations(const SheetImages& images,
             std::int32_t block,
             const std::vector<MovedCamera>& cameras,
             std::map<std::int32_t, Equations>& equations)
{
  constexpr double robust = 12; // levels
  const MovedImages now = moved(images, block, cameras);
  const TextureChart& chart = images.surface.chart;
  const Eigen::Vector3d normal = images.surface.plane.head<3>();
  const auto mean = [&](std::int32_t column, std::int32_t row) {
    return now.sum.at(column, row) / now.count.at(column, row);
  };
  for (const auto& [view, image] : now.views) {
    const MovedCamera& camera = cameras[static_cast<std::size_t>(view)];
    const Eigen::Vector3d eye = camera.move * camera.eye;
    Equations& own = equations[view];
    for (std::int32_t row = image.top; row < image.top + image.height; ++row)
      for (std::int32_t column = image.left; column < image.left + image.width;
           ++column) {
        const float value = image.at(column, row);
        const float count = now.count.at(column, row);
        if (std::isnan(value) || !(count > 1))
          continue;
        const double right =
            static_cast<double>((mean(column + 1, row) - mean(column - 1, row)) / 2);
        const double down =
            static_cast<double>((mean(column, row + 1) - mean(column, row - 1)) / 2);
        if (std::isnan(right + down))
          continue;
        const double rest = static_cast<double>(
            (now.sum.at(column, row) - value) / (count - 1) - value);
        const Eigen::Vector3d place =
            middleOf(chart, (column + 0.5) * block - 0.5, (row + 0.5) * block - 0.5);
        const Eigen::Vector3d ray = place - eye;
        // levels that a motion of the place in space changes here
        Eigen::Vector3d slope = (right * chart.texel_u + down * chart.texel_v) /
                                (block * chart.texel_u.squaredNorm());
        slope -= slope.dot(ray) / normal.dot(ray) * normal;
        Vector6d row_of_motion;
        row_of_motion << ray.cross(slope), slope;
        const double weight = std::min(1.0, robust / std::max(std::abs(rest), 1e-9));
        own.matrix += weight * row_of_motion * row_of_motion.transpose();
        own.right -= weight * rest * row_of_motion;
        own.cost += std::min(rest * rest, 4 * robust * robust);
        ++own.count;
      }
  }
}

/** Moves each camera by a step of Gauss-Newton.
 * \return mean of what was left before */
double
step(const std::vector<SheetImages>& sheets,
     std::int32_t block,
     bool moves,
     std::vector<MovedCamera>& cameras)
{
  std::vector<std::map<std::int32_t, Equations>> of_sheets(sheets.size());
  oneapi::tbb::parallel_for(std::size_t{0}, sheets.size(), [&](std::size_t s) {
    addEquations(sheets[s], block, cameras, of_sheets[s]);
    pollRun();
  });
  std::map<std::int32_t, Equations> all;
  for (const auto& of_sheet : of_sheets)
    for (const auto& [view, equations] : of_sheet)
      all[view].add(equations);
  constexpr double damping = 0.8; // the others move too
  constexpr double level = 100, far = 0.05,
                   much = 0.02; // prior: levels, metres, radians
  Vector6d prior;
  prior.head<3>().setConstant(level * level / (much * much));
  prior.tail<3>().setConstant(level * level / (far * far));
  double cost = 0, count = 0;
  for (auto& [view, own] : all) {
    cost += own.cost;
    count += own.count;
    if (!moves)
      continue;
    MovedCamera& camera = cameras[static_cast<std::size_t>(view)];
    const Eigen::AngleAxisd turned(camera.move.linear());
    const Eigen::Vector3d eye = camera.move * camera.eye;
    Vector6d total;
    total << turned.angle() * turned.axis(), eye - camera.eye;
    own.matrix.diagonal() += prior;
    own.right -= prior.cwiseProduct(total);
    const Vector6d motion = damping * own.matrix.ldlt().solve(own.right);
    const double angle = motion.head<3>().norm();
    if (!motion.allFinite())
      continue;
    Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
    if (angle > 0)
      turn.linear() =
          Eigen::AngleAxisd(angle, motion.head<3>() / angle).toRotationMatrix();
    camera.move = Eigen::Translation3d(eye + motion.tail<3>()) * turn *
                  Eigen::Translation3d(-eye) * camera.move;
  }
  return count > 0 ? cost / count : 0;
}

} // namespace

std::vector<Eigen::Isometry3d>
alignedMoves(const std::vector<Canvas>& canvases,
             const std::vector<Sheet>& sheets,
             const std::vector<Eigen::Vector3d>& eyes,
             const std::vector<double>& gains)
{
  constexpr std::int32_t finest = 2, coarsest = 16; // texels of a block
  constexpr int rounds = 6;
  constexpr double clearly = 0.95;
  std::vector<std::size_t> planes;
  for (std::size_t s = 0; s < sheets.size(); ++s)
    if (canvases[sheets[s].begin()].surface.plane())
      planes.push_back(s);
  std::vector<std::vector<SheetImages>> levels(1);
  levels.front().resize(planes.size());
  oneapi::tbb::parallel_for(std::size_t{0}, planes.size(), [&](std::size_t p) {
    const Sheet& sheet = sheets[planes[p]];
    levels.front()[p] = imagesOf(canvases[sheet.begin()], sheet, gains);
  });
  for (std::int32_t block = 2 * finest; block <= coarsest; block *= 2) {
    std::vector<SheetImages> coarse = levels.back();
    for (SheetImages& images : coarse)
      for (auto& [view, image] : images.views)
        image = halved(image);
    levels.push_back(std::move(coarse));
  }
  std::vector<MovedCamera> cameras;
  for (const Eigen::Vector3d& eye : eyes)
    cameras.push_back({eye});
  const double before = step(levels.front(), finest, false, cameras);
  std::int32_t block = coarsest;
  for (auto level = levels.rbegin(); level != levels.rend(); ++level, block /= 2)
    for (int round = 0; round < rounds; ++round)
      step(*level, block, true, cameras);
  const double after = step(levels.front(), finest, false, cameras);
  std::vector<Eigen::Isometry3d> moves;
  if (after < clearly * before)
    for (const MovedCamera& camera : cameras)
      moves.push_back(camera.move);
  return moves;
}

namespace {

const Sample*
seenBy(std::int32_t view, const Canvas::Samples& samples)
{
  for (const Sample& sample : samples)
    if (sample.weight > 0 && sample.view == view)
      return &sample;
  return nullptr;
}

/** Bilinear between the samples of a view; nothing if it has not seen the texel there. */
std::optional<std::array<std::uint8_t, 3>>
colorBetween(const Sheet& sheet, std::int32_t view, const Eigen::Vector2d& place)
{
  const Eigen::Vector2d middle = place.array() - 0.5;
  const Eigen::Vector2d corner = middle.array().floor();
  const Eigen::Vector2d share = middle - corner;
  std::array<double, 3> sums{};
  double shares = 0;
  for (const int r : {0, 1})
    for (const int c : {0, 1}) {
      const double column = corner.x() + c, row = corner.y() + r;
      if (!(column >= 0 && row >= 0 && column < sheet.width() && row < sheet.height()))
        continue;
      const Sample* const sample =
          seenBy(view,
                 sheet.samplesOf(sheet.placeOf(static_cast<std::int32_t>(column),
                                               static_cast<std::int32_t>(row))));
      if (!sample)
        continue;
      const double own =
          (c ? share.x() : 1 - share.x()) * (r ? share.y() : 1 - share.y());
      shares += own;
      for (std::size_t k = 0; k < 3; ++k)
        sums[k] += own * sample->color[k];
    }
  if (!(shares > 0.5))
    return std::nullopt;
  std::array<std::uint8_t, 3> color;
  for (std::size_t k = 0; k < 3; ++k)
    color[k] = static_cast<std::uint8_t>(std::lround(sums[k] / shares));
  return color;
}

/** The samples of a texel after the cameras were moved. */
Canvas::Samples
movedSamples(const Sheet& sheet,
             const SheetPlane& surface,
             const Eigen::Vector2i& texel,
             const std::vector<Eigen::Isometry3d>& inverse_moves,
             const std::vector<Eigen::Vector3d>& eyes)
{
  Canvas::Samples result{};
  std::size_t count = 0;
  const Eigen::Vector3d place = middleOf(surface.chart, texel.x(), texel.y());
  for (const Sample& sample : sheet.samplesOf(sheet.placeOf(texel.x(), texel.y()))) {
    if (!(sample.weight > 0))
      break;
    const auto view = static_cast<std::size_t>(sample.view);
    const auto color = colorBetween(
        sheet, sample.view, surface.sourceOf(place, eyes[view], inverse_moves[view]));
    if (color)
      result[count++] = {sample.weight, sample.view, *color};
  }
  return result;
}

} // namespace

void
moveSamples(const std::vector<Eigen::Isometry3d>& moves,
            const std::vector<Eigen::Vector3d>& eyes,
            const std::vector<Sheet>& sheets,
            std::vector<Canvas>& canvases)
{
  std::vector<Eigen::Isometry3d> inverse_moves;
  for (const Eigen::Isometry3d& move : moves)
    inverse_moves.push_back(move.inverse());
  for (const Sheet& sheet : sheets) {
    if (!canvases[sheet.begin()].surface.plane())
      continue;
    const SheetPlane surface = planeOf(canvases[sheet.begin()], sheet);
    std::vector<LargeVector<Canvas::Samples>> moved;
    for (std::size_t c = sheet.begin(); c < sheet.end(); ++c)
      moved.emplace_back(canvases[c].samples.size());
    oneapi::tbb::parallel_for(std::int32_t{0}, sheet.height(), [&](std::int32_t row) {
      for (std::int32_t column = 0; column < sheet.width(); ++column) {
        const Sheet::Place at = sheet.placeOf(column, row);
        moved[at.canvas - sheet.begin()][at.texel] =
            movedSamples(sheet, surface, {column, row}, inverse_moves, eyes);
      }
    });
    for (std::size_t c = sheet.begin(); c < sheet.end(); ++c)
      canvases[c].samples = std::move(moved[c - sheet.begin()]);
  }
}

} // namespace pcl::acmap::texturing
