#include <pcl/core/exceptions.h>
#include <pcl/simulation/simulated_observation.h>

#include "light/pinhole_scene.h"
#include "random_streams.h"
#include "surface_normal.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/simulation/surface_color.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl::acmap {

namespace {

constexpr float not_measured = std::numeric_limits<float>::quiet_NaN();

// Disparities in a window that differ by more are beyond a depth discontinuity.
constexpr double largest_fold = 1.0; // px
// Minimum lit fraction of a window for a match.
constexpr double min_lit_share = 1.0 / 3.0;
constexpr double grazing_begin = 75.0 * M_PI / 180.0;
constexpr double grazing_end = 85.0 * M_PI / 180.0;

/** \brief Linear ramp: 0 up to begin, 1 from end on. */
double
ramp(double value, double begin, double end)
{
  return value <= begin ? 0.0 : std::min((value - begin) / (end - begin), 1.0);
}

/** \brief The window around a pixel, clipped at the image border. */
struct PixelWindow {
  int first_row, last_row;
  int first_column, last_column;

  int
  size() const
  {
    return (last_row - first_row + 1) * (last_column - first_column + 1);
  }
};

/** \brief Result of the correlation of a window. */
struct Match {
  double disparity = std::numeric_limits<double>::quiet_NaN(); ///< px, NaN for nothing
  std::size_t pixel = 0;    ///< pixel whose surface was measured
  double foreign_share = 0; ///< fraction of lit pixels beyond a depth discontinuity
};

/** \brief Measurement of one view by a depth camera. */
class DepthMeasurement {
public:
  DepthMeasurement(const SimulatedScene& scene,
                   const SurfaceImage& image,
                   std::size_t view,
                   std::uint64_t seed)
  : scene_(scene)
  , camera_(*scene.depth_camera)
  , image_(image)
  , T_scene_camera_(scene.views[view])
  , stream_(mixedBits(seed, view))
  , half_(camera_.window / 2)
  {}

  SimulatedObservation
  run()
  {
    findTrueDisparities();
    const std::vector<double> noise = windowNoise(0);
    const std::vector<double> luck = windowNoise(1);
    SimulatedObservation observation;
    observation.width = image_.width;
    observation.height = image_.height;
    observation.has_sigma = false;
    observation.pixels.resize(image_.distance.size());
    forEachRow([&](int row) {
      for (int column = 0; column < image_.width; ++column) {
        const std::size_t i = indexOf(row, column);
        observation.pixels[i] = measure(row, column, noise[i], luck[i]);
      }
    });
    for (std::size_t i = 0; i < observation.pixels.size(); ++i) {
      const double depth = depthOf(i);
      observation.in_reach += depth >= camera_.nearest && depth <= camera_.farthest;
      observation.points += std::isfinite(observation.pixels[i].z);
    }
    return observation;
  }

private:
  template <typename Body>
  void
  forEachRow(const Body& body) const
  {
    oneapi::tbb::parallel_for(0, image_.height, body);
  }

  std::size_t
  indexOf(int row, int column) const
  {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(image_.width) +
           static_cast<std::size_t>(column);
  }

  Eigen::Vector3d
  rayOf(std::size_t pixel) const
  {
    const auto width = static_cast<std::size_t>(image_.width);
    return pixelRay(
        scene_.rig, static_cast<int>(pixel % width), static_cast<int>(pixel / width));
  }

  /** \brief Depth of a pixel, metres; NaN if nothing is seen. */
  double
  depthOf(std::size_t pixel) const
  {
    return image_.distance[pixel] * rayOf(pixel).z();
  }

  const SimulatedSurface&
  surfaceOf(std::size_t pixel) const
  {
    return scene_.geometry.surfaces()[static_cast<std::size_t>(image_.surface[pixel])];
  }

  /** \brief Factor in px * m: a disparity is this factor divided by a depth. */
  double
  disparityTimesDepth() const
  {
    return scene_.rig.focal_length * std::abs(scene_.rig.baseline_horizontal);
  }

  /** \brief A pinhole at the projector whose image contains all points that the camera
   * sees at the minimum depth or beyond. */
  TrinocularRig
  projectorPinhole() const
  {
    const double margin = std::ceil(disparityTimesDepth() / camera_.nearest) + 1.0;
    TrinocularRig pinhole = scene_.rig;
    pinhole.width += 2 * static_cast<int>(margin);
    pinhole.center_x += margin;
    return pinhole;
  }

  /** \brief Computes disparity and incidence of each pixel that is lit by the
   * projector. */
  void
  findTrueDisparities()
  {
    const Eigen::Vector3d projector(scene_.rig.baseline_horizontal, 0, 0);
    const PinholeScene lit(scene_.geometry,
                           projectorPinhole(),
                           T_scene_camera_ * Eigen::Translation3d(projector));
    const Eigen::Matrix3d R_camera_scene = T_scene_camera_.linear().transpose();
    disparity_.assign(image_.distance.size(), std::numeric_limits<double>::quiet_NaN());
    cosine_.assign(image_.distance.size(), 0.0);
    forEachRow([&](int row) {
      for (int column = 0; column < image_.width; ++column) {
        const std::size_t i = indexOf(row, column);
        if (image_.surface[i] < 0 || !(depthOf(i) >= camera_.nearest))
          continue;
        const Eigen::Vector3d ray = rayOf(i);
        const Eigen::Vector3d point = image_.distance[i] * ray;
        const Eigen::Vector3d normal =
            R_camera_scene * surfaceNormal(surfaceOf(i), T_scene_camera_ * point);
        const double cosine = normal.dot(ray);
        const bool is_lit_from_this_side = cosine * normal.dot(point - projector) > 0.0;
        if (!is_lit_from_this_side || !lit.sees(point - projector))
          continue;
        disparity_[i] = disparityTimesDepth() / point.z();
        cosine_[i] = std::abs(cosine);
      }
    });
  }

  /** \brief Normal noise of mean 0 and variance 1. The noise of neighbouring pixels is
   * correlated according to the overlap of their windows, which contain the same
   * speckles. */
  std::vector<double>
  windowNoise(std::uint64_t number) const
  {
    const std::uint64_t stream = mixedBits(stream_, number);
    std::vector<double> white(image_.distance.size());
    parallelForChunks(white.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        white[i] = Random(mixedBits(stream, i)).normal();
    });
    std::vector<double> along_rows(white.size());
    forEachRow([&](int row) {
      for (int column = 0; column < image_.width; ++column) {
        const PixelWindow window = windowAt(row, column);
        double sum = 0.0;
        for (int c = window.first_column; c <= window.last_column; ++c)
          sum += white[indexOf(row, c)];
        along_rows[indexOf(row, column)] = sum;
      }
    });
    forEachRow([&](int row) {
      for (int column = 0; column < image_.width; ++column) {
        const PixelWindow window = windowAt(row, column);
        double sum = 0.0;
        for (int r = window.first_row; r <= window.last_row; ++r)
          sum += along_rows[indexOf(r, column)];
        white[indexOf(row, column)] = sum / std::sqrt(window.size());
      }
    });
    return white;
  }

  PixelWindow
  windowAt(int row, int column) const
  {
    return {std::max(row - half_, 0),
            std::min(row + half_, image_.height - 1),
            std::max(column - half_, 0),
            std::min(column + half_, image_.width - 1)};
  }

  /** \brief The median of the true disparities in a window, which is that of its
   * largest part. */
  Match
  match(int row, int column) const
  {
    const PixelWindow window = windowAt(row, column);
    std::vector<std::pair<double, std::size_t>> lit;
    lit.reserve(static_cast<std::size_t>(window.size()));
    for (int r = window.first_row; r <= window.last_row; ++r)
      for (int c = window.first_column; c <= window.last_column; ++c)
        if (const std::size_t i = indexOf(r, c); std::isfinite(disparity_[i]))
          lit.emplace_back(disparity_[i], i);
    if (static_cast<double>(lit.size()) < min_lit_share * window.size())
      return {};
    const auto middle = lit.begin() + static_cast<std::ptrdiff_t>(lit.size() / 2);
    std::nth_element(lit.begin(), middle, lit.end());
    Match found{middle->first, middle->second, 0.0};
    const auto is_foreign = [&](const auto& other) {
      return std::abs(other.first - found.disparity) > largest_fold;
    };
    found.foreign_share =
        static_cast<double>(std::count_if(lit.begin(), lit.end(), is_foreign)) /
        static_cast<double>(lit.size());
    const std::size_t own = indexOf(row, column);
    if (std::abs(disparity_[own] - found.disparity) <= largest_fold) // false for NaN
      found.pixel = own;
    return found;
  }

  /** \brief Standard deviation of a disparity, px. It grows towards grazing incidence
   * as measured by Nguyen et al. (2012). */
  double
  sigmaOf(double depth, double incidence) const
  {
    constexpr double growth = 1e-4; // m^1.5
    const double steepness = incidence / (0.5 * M_PI - incidence);
    const double depth_sigma = growth / std::sqrt(depth) * steepness * steepness;
    return scene_.rig.disparity_sigma +
           disparityTimesDepth() / (depth * depth) * depth_sigma;
  }

  /** \brief Probability that a pixel is not measured. */
  double
  shareMissing(const Match& found, double depth, double incidence) const
  {
    return 1.0 - (1.0 - found.foreign_share) *
                     (1.0 - ramp(depth, camera_.fading, camera_.farthest)) *
                     (1.0 - ramp(incidence, grazing_begin, grazing_end));
  }

  /** \brief Depth as reported by the camera, metres; 0 for none. */
  double
  measuredDepth(const Match& found, double noise, double luck) const
  {
    if (std::isnan(found.disparity))
      return 0.0;
    const double true_depth = disparityTimesDepth() / found.disparity;
    const double incidence = std::acos(std::min(cosine_[found.pixel], 1.0));
    const double uniform = 0.5 * std::erfc(-luck * std::sqrt(0.5));
    if (uniform < shareMissing(found, true_depth, incidence))
      return 0.0;
    const double disparity = found.disparity + sigmaOf(true_depth, incidence) * noise;
    const double steps = std::round(disparity / camera_.disparity_step);
    if (!(steps > 0.0))
      return 0.0;
    const double depth = disparityTimesDepth() / (steps * camera_.disparity_step);
    if (!(depth >= camera_.nearest && depth <= camera_.farthest))
      return 0.0;
    return std::round(depth / camera_.depth_step) * camera_.depth_step;
  }

  ObservationPixel
  measure(int row, int column, double noise, double luck) const
  {
    ObservationPixel measured{
        not_measured, not_measured, not_measured, 0, not_measured, 0};
    const std::size_t pixel = indexOf(row, column);
    if (image_.surface[pixel] >= 0) {
      const auto color =
          surfaceColor(surfaceOf(pixel),
                       static_cast<std::size_t>(image_.surface[pixel]),
                       T_scene_camera_ * (image_.distance[pixel] * rayOf(pixel)));
      measured.rgb = std::uint32_t{color[0]} << 16 | std::uint32_t{color[1]} << 8 |
                     std::uint32_t{color[2]};
    }
    if (column >= image_.width - camera_.blind_columns)
      return measured;
    const Match found = match(row, column);
    const double depth = measuredDepth(found, noise, luck);
    if (depth == 0.0)
      return measured;
    const Eigen::Vector3d ray = rayOf(pixel);
    const Eigen::Vector3f point = (depth / ray.z() * ray).cast<float>();
    measured.x = point.x();
    measured.y = point.y();
    measured.z = static_cast<float>(depth);
    measured.label = static_cast<std::uint32_t>(surfaceOf(found.pixel).plane + 1);
    return measured;
  }

  const SimulatedScene& scene_;
  const DepthCamera& camera_;
  const SurfaceImage& image_;
  const Eigen::Isometry3d& T_scene_camera_;
  std::uint64_t stream_;
  int half_;                      ///< half the window size, px
  std::vector<double> disparity_; ///< px; NaN where the projector gives no light
  std::vector<double> cosine_;    ///< cosine of the incidence angle of the camera's ray
};

/** \brief Measures a view with the scene's depth camera.
 * \param[in] image of this view, already checked
 * \throws BadArgumentException when the depth camera is invalid */
SimulatedObservation
measureDepths(const SimulatedScene& scene,
              const SurfaceImage& image,
              std::size_t view,
              std::uint64_t seed)
{
  requireSoundDepthCamera(*scene.depth_camera, scene.rig);
  return DepthMeasurement(scene, image, view, seed).run();
}

} // namespace

} // namespace pcl::acmap

namespace pcl {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint64_t not_in_reach = std::numeric_limits<std::uint64_t>::max();

/** \brief Measurement of one view. */
class Measurement {
public:
  Measurement(const SimulatedScene& scene,
              const SurfaceImage& image,
              std::size_t view,
              std::uint64_t seed)
  : scene_(scene)
  , image_(image)
  , T_scene_camera_(scene.views[view])
  , points_(scene.sensor.pointsOfView(view))
  , stream_(acmap::mixedBits(seed, view))
  {}

  SimulatedObservation
  run() const
  {
    SimulatedObservation observation;
    observation.width = image_.width;
    observation.height = image_.height;
    observation.pixels.resize(image_.distance.size());
    const std::vector<std::uint64_t> keys = drawKeys();
    const std::uint64_t bound = boundOfKept(keys, observation);
    acmap::parallelForChunks(keys.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t pixel = begin; pixel < end; ++pixel)
        observation.pixels[pixel] = measure(pixel, keys[pixel] < bound);
    });
    return observation;
  }

private:
  acmap::Random
  streamOf(std::size_t pixel) const
  {
    return acmap::Random(acmap::mixedBits(stream_, pixel));
  }

  Eigen::Vector3d
  rayOf(std::size_t pixel) const
  {
    const auto width = static_cast<std::size_t>(image_.width);
    return pixelRay(
        scene_.rig, static_cast<int>(pixel % width), static_cast<int>(pixel / width));
  }

  /** \brief A random key for each pixel in reach, with the pixel index in the lower
   * bits, so that all keys are different. The pixels with the smallest keys are
   * chosen. */
  std::vector<std::uint64_t>
  drawKeys() const
  {
    constexpr std::uint64_t low_half = 0xffffffffu;
    std::vector<std::uint64_t> keys(image_.distance.size(), not_in_reach);
    acmap::parallelForChunks(keys.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t pixel = begin; pixel < end; ++pixel)
        if (image_.distance[pixel] * rayOf(pixel).z() <= scene_.sensor.reach)
          keys[pixel] = (streamOf(pixel).bits() & ~low_half) | pixel;
    });
    return keys;
  }

  /** \brief Upper bound of the keys of the chosen pixels, exclusive. */
  std::uint64_t
  boundOfKept(const std::vector<std::uint64_t>& keys,
              SimulatedObservation& observation) const
  {
    std::vector<std::uint64_t> in_reach;
    in_reach.reserve(keys.size());
    std::copy_if(keys.begin(),
                 keys.end(),
                 std::back_inserter(in_reach),
                 [](std::uint64_t key) { return key != not_in_reach; });
    observation.in_reach = in_reach.size();
    observation.points = std::min(points_, in_reach.size());
    if (observation.points == in_reach.size())
      return not_in_reach;
    if (observation.points == 0)
      return 0;
    const auto last =
        in_reach.begin() + static_cast<std::ptrdiff_t>(observation.points) - 1;
    std::nth_element(in_reach.begin(), last, in_reach.end());
    return *last + 1;
  }

  ObservationPixel
  measure(std::size_t pixel, bool kept) const
  {
    ObservationPixel measured{nan, nan, nan, 0, nan, 0};
    const std::int32_t index = image_.surface[pixel];
    if (index < 0)
      return measured;
    const auto& surface = scene_.geometry.surfaces()[static_cast<std::size_t>(index)];
    const double distance = image_.distance[pixel];
    const Eigen::Vector3d ray = rayOf(pixel);
    const auto color = surfaceColor(
        surface, static_cast<std::size_t>(index), T_scene_camera_ * (distance * ray));
    measured.rgb = std::uint32_t{color[0]} << 16 | std::uint32_t{color[1]} << 8 |
                   std::uint32_t{color[2]};
    if (!kept)
      return measured;
    acmap::Random random = streamOf(pixel);
    random.bits(); // these bits were used for the key
    const double sigma = scene_.sensor.sigma(distance * ray.z());
    const Eigen::Vector3f point =
        ((distance + sigma * random.normal()) * ray).cast<float>();
    measured.x = point.x();
    measured.y = point.y();
    measured.z = point.z();
    measured.sigma = static_cast<float>(sigma);
    measured.label = static_cast<std::uint32_t>(surface.plane + 1);
    return measured;
  }

  const SimulatedScene& scene_;
  const SurfaceImage& image_;
  const Eigen::Isometry3d& T_scene_camera_;
  std::size_t points_;
  std::uint64_t stream_;
};

} // namespace

SimulatedObservation
observe(const SimulatedScene& scene,
        const SurfaceImage& image,
        std::size_t view,
        std::uint64_t seed)
{
  const std::size_t pixels =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (view >= scene.views.size() || image.width != scene.rig.width ||
      image.height != scene.rig.height || image.distance.size() != pixels ||
      image.surface.size() != pixels)
    throw acmap::BadArgument("the image is none of view " + std::to_string(view) +
                             " of scene '" + scene.name + "'");
  if (scene.depth_camera)
    return acmap::measureDepths(scene, image, view, seed);
  return Measurement(scene, image, view, seed).run();
}

SimulatedObservation
observe(const SimulatedScene& scene, std::size_t view, std::uint64_t seed)
{
  if (view >= scene.views.size())
    throw acmap::BadArgument("scene '" + scene.name + "' has no view " +
                             std::to_string(view));
  const SurfaceImage image = castView(scene.geometry, scene.rig, scene.views[view]);
  return observe(scene, image, view, seed);
}

} // namespace pcl
