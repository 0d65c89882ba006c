#include "synthetic_shots.h"

#include <pcl/core/random.h>
#include <pcl/core/rig_cameras.h>
#include <pcl/stereo/matched_disparity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl::acmap::test {

namespace {

/** Uniform random value in [-1, 1) for a knot and a shot. */
double
knot(int shot, std::int64_t i, std::int64_t j)
{
  const auto mix = static_cast<std::uint64_t>((i * 8191 + j) * 1031 + shot);
  return Random(mix).uniform(-1, 1);
}

/** Weights of the four knots around a position, for a cubic spline. */
std::array<double, 4>
splineWeights(double t)
{
  const double u = 1 - t;
  return {u * u * u / 6,
          (4 - 6 * t * t + 3 * t * t * t) / 6,
          (4 - 6 * u * u + 3 * u * u * u) / 6,
          t * t * t / 6};
}

double
signOf(double baseline)
{
  return baseline < 0 ? -1 : 1;
}

/** Displacement in a camera, relative to the reference, for a disparity of 1 px. */
std::array<double, 2>
motionIn(RigCamera camera, const TrinocularRig& rig)
{
  if (camera == RigCamera::Horizontal)
    return {-signOf(rig.baseline_horizontal), 0};
  if (camera == RigCamera::Vertical)
    return {0, -rig.baseline_vertical / disparityBaseline(rig)};
  return {0, 0};
}

bool
covers(const SyntheticSheet& sheet, double x, double y)
{
  return !sheet.covers || sheet.covers(x, y);
}

/** The sheet and the position on it that a camera sees at a pixel. */
struct ShotPixel {
  std::size_t sheet;
  double x;
  double y;
};

ShotPixel
seenAt(const SyntheticScene& scene, RigCamera camera, double column, double row)
{
  const auto [u, v] = motionIn(camera, scene.rig);
  for (std::size_t i = 0;; ++i) {
    const SyntheticSheet& sheet = scene.sheets[i];
    double x = column, y = row;
    for (int step = 0; step < 40; ++step) { // fixed-point iteration
      const double disparity = sheet.disparity(x, y);
      x = column - u * disparity;
      y = row - v * disparity;
    }
    if (i + 1 == scene.sheets.size() || covers(sheet, x, y))
      return {i, x, y};
  }
}

CameraImage
imageOf(const SyntheticScene& scene, RigCamera camera, int shot)
{
  CameraImage image{scene.rig.width, scene.rig.height, 1, {}};
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column) {
      const ShotPixel seen = seenAt(scene, camera, column, row);
      const double level = scene.sheets[seen.sheet].level(shot, seen.x, seen.y);
      image.values.push_back(
          static_cast<std::uint8_t>(std::lround(std::clamp(level, 0.0, 255.0))));
    }
  return image;
}

constexpr std::array<RigCamera, 3> cameras = {
    RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical};

} // namespace

TrinocularRig
syntheticRig(double horizontal, double vertical)
{
  TrinocularRig rig;
  rig.width = 120;
  rig.height = 90;
  rig.focal_length = 100;
  rig.center_x = 59.5;
  rig.center_y = 44.5;
  rig.baseline_horizontal = horizontal;
  rig.baseline_vertical = vertical;
  return rig;
}

double
noiseLevel(int shot, double x, double y)
{
  constexpr double spacing = 2;
  const double i = std::floor(x / spacing), j = std::floor(y / spacing);
  const auto along = splineWeights(x / spacing - i);
  const auto down = splineWeights(y / spacing - j);
  double sum = 0;
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = 0; b < 4; ++b)
      sum += along[a] * down[b] *
             knot(shot,
                  static_cast<std::int64_t>(i) + static_cast<std::int64_t>(a),
                  static_cast<std::int64_t>(j) + static_cast<std::int64_t>(b));
  return 128 + 120 * sum;
}

SyntheticScene
flatScene(const TrinocularRig& rig, double disparity)
{
  return {rig, {{[disparity](double, double) { return disparity; }, noiseLevel}}};
}

std::vector<TrinocularFrame::Ptr>
shotsOf(const SyntheticScene& scene, int shots)
{
  std::vector<TrinocularFrame::Ptr> frames;
  for (int shot = 0; shot < shots; ++shot) {
    frames.push_back(std::make_shared<TrinocularFrame>());
    frames.back()->pattern = shot;
    for (const RigCamera camera : cameras)
      if (hasCamera(scene.rig, camera))
        frames.back()->image(camera) = imageOf(scene, camera, shot);
  }
  return frames;
}

bool
isSeenBy(RigCamera neighbour, const SyntheticScene& scene, int column, int row)
{
  const ShotPixel here = seenAt(scene, RigCamera::Reference, column, row);
  const auto [u, v] = motionIn(neighbour, scene.rig);
  const double disparity = scene.sheets[here.sheet].disparity(here.x, here.y);
  const double x = column + u * disparity, y = row + v * disparity;
  return hasCamera(scene.rig, neighbour) && x >= 0 && x <= scene.rig.width - 1 &&
         y >= 0 && y <= scene.rig.height - 1 &&
         seenAt(scene, neighbour, x, y).sheet == here.sheet;
}

DisparityImage
trueDisparities(const SyntheticScene& scene,
                const std::function<bool(int column, int row)>& asked)
{
  DisparityImage truth{scene.rig.width, scene.rig.height, {}};
  for (int row = 0; row < truth.height; ++row)
    for (int column = 0; column < truth.width; ++column) {
      const ShotPixel seen = seenAt(scene, RigCamera::Reference, column, row);
      const double disparity = scene.sheets[seen.sheet].disparity(column, row);
      truth.values.push_back(asked(column, row)
                                 ? static_cast<float>(disparity)
                                 : std::numeric_limits<float>::quiet_NaN());
    }
  return truth;
}

DisparityImage
trueDisparities(const SyntheticScene& scene)
{
  return trueDisparities(scene, [&](int column, int row) {
    return std::all_of(cameras.begin() + 1, cameras.end(), [&](RigCamera camera) {
      return !hasCamera(scene.rig, camera) || isSeenBy(camera, scene, column, row);
    });
  });
}

} // namespace pcl::acmap::test
