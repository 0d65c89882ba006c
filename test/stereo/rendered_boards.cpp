#include "rendered_boards.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/core/random.h>

#include <cmath>

namespace pcl::acmap::test {

namespace {

constexpr double degree = M_PI / 180.0;

CameraCalibration
builtCamera(double focal, double center_x, double center_y, double k1)
{
  CameraCalibration camera;
  camera.focal_x = focal;
  camera.focal_y = focal * 1.001;
  camera.center_x = center_x;
  camera.center_y = center_y;
  camera.distortion = {k1, 0.08, 5e-4, -4e-4, 0};
  camera.is_there = true;
  return camera;
}

Eigen::Matrix3d
turned(double x, double y, double z)
{
  using Eigen::Vector3d;
  return (Eigen::AngleAxisd(x * degree, Vector3d::UnitX()) *
          Eigen::AngleAxisd(y * degree, Vector3d::UnitY()) *
          Eigen::AngleAxisd(z * degree, Vector3d::UnitZ()))
      .toRotationMatrix();
}

std::uint8_t
grey(double value)
{
  return static_cast<std::uint8_t>(std::lround(std::min(255.0, std::max(0.0, value))));
}

/** \brief One pass of a Gaussian filter along rows or columns. */
std::vector<double>
blurred(const std::vector<double>& values, int length, int stride, double sigma)
{
  const int reach = static_cast<int>(std::ceil(3 * sigma));
  std::vector<double> weights;
  for (int d = -reach; d <= reach; ++d)
    weights.push_back(std::exp(-0.5 * d * d / (sigma * sigma)));
  std::vector<double> result(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const int at = static_cast<int>(i) / stride % length;
    double sum = 0;
    double total = 0;
    for (int d = std::max(-reach, -at); d <= std::min(reach, length - 1 - at); ++d) {
      const double weight = weights[static_cast<std::size_t>(d + reach)];
      sum +=
          weight * values[static_cast<std::size_t>(static_cast<int>(i) + d * stride)];
      total += weight;
    }
    result[i] = sum / total;
  }
  return result;
}

} // namespace

RigCalibration
builtRig(double scale)
{
  RigCalibration rig;
  rig.camera(RigCamera::Reference) = builtCamera(520, 323, 236, -0.25);
  auto& horizontal = rig.camera(RigCamera::Horizontal) =
      builtCamera(524, 316, 243, -0.24);
  auto& vertical = rig.camera(RigCamera::Vertical) = builtCamera(517, 321, 239, -0.26);
  horizontal.T_reference_camera.linear() = turned(1.2, -1.6, 0.9);
  horizontal.T_reference_camera.translation() << -0.1, 0.0008, -0.0006;
  vertical.T_reference_camera.linear() = turned(-1.4, 1.1, -1.3);
  vertical.T_reference_camera.translation() << -0.000803, -0.1, 0.0005;
  rig.width = static_cast<int>(std::lround(scale * rig.width));
  rig.height = static_cast<int>(std::lround(scale * rig.height));
  for (CameraCalibration& camera : rig.cameras) {
    for (double* const focal : {&camera.focal_x, &camera.focal_y})
      *focal *= scale;
    for (double* const center : {&camera.center_x, &camera.center_y})
      *center = scale * (*center + 0.5) - 0.5;
  }
  return rig;
}

RigRenderer::RigRenderer(const RigCalibration& rig)
: rig_(rig)
{
  const auto columns = static_cast<std::size_t>(rig.width) + 1;
  const std::size_t corners = columns * (static_cast<std::size_t>(rig.height) + 1);
  for (std::size_t camera = 0; camera < rays_.size(); ++camera) {
    rays_[camera].resize(corners);
    parallelForChunks(corners, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Eigen::Vector2d pixel(static_cast<double>(i % columns) - 0.5,
                                    static_cast<double>(i / columns) - 0.5);
        rays_[camera][i] = pixelRay(rig.cameras[camera], pixel).hnormalized();
      }
    });
  }
}

CameraImage
RigRenderer::imageOf(RigCamera camera,
                     const Eigen::Isometry3d& T_camera_plane,
                     Brightness brightness) const
{
  constexpr int side = 4; // rays per pixel in each direction
  const auto width = static_cast<std::size_t>(rig_.width);
  const auto& rays = rays_[static_cast<std::size_t>(camera)];
  const Eigen::Isometry3d T_plane_camera = T_camera_plane.inverse();
  const Eigen::Vector3d from = T_plane_camera.translation();
  CameraImage image;
  image.width = rig_.width;
  image.height = rig_.height;
  image.values.resize(width * static_cast<std::size_t>(rig_.height));
  const Eigen::Matrix3d turn = T_plane_camera.linear();
  parallelForChunks(image.values.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t corner = i / width * (width + 1) + i % width;
      // directions of rays in the frame of the plane, linear within a pixel
      const Eigen::Vector3d first = turn * rays[corner].homogeneous();
      const Eigen::Vector3d across =
          turn.leftCols<2>() * (rays[corner + 1] - rays[corner]) / side;
      const Eigen::Vector3d down =
          turn.leftCols<2>() * (rays[corner + width + 1] - rays[corner]) / side;
      double sum = 0;
      for (int k = 0; k < side * side; ++k) {
        const double u = k % side + 0.5, v = k / side + 0.5;
        const double depth = -from.z() / (first.z() + u * across.z() + v * down.z());
        if (depth > 0)
          sum += brightness(
              from.x() + depth * (first.x() + u * across.x() + v * down.x()),
              from.y() + depth * (first.y() + u * across.y() + v * down.y()));
      }
      image.values[i] = grey(sum / (side * side));
    }
  });
  return image;
}

TrinocularFrame
RigRenderer::frameOf(const Eigen::Isometry3d& T_reference_plane,
                     Brightness brightness) const
{
  TrinocularFrame frame;
  for (const RigCamera camera :
       {RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical}) {
    const CameraCalibration& built = rig_.camera(camera);
    if (built.is_there)
      frame.image(camera) = imageOf(
          camera, built.T_reference_camera.inverse() * T_reference_plane, brightness);
  }
  return frame;
}

double
boardBrightness(double x, double y)
{
  const double column = x / 0.03;
  const double row = y / 0.03;
  const bool is_on_paper = column > -1.6 && column < 9.6 && row > -1.6 && row < 6.6;
  if (!is_on_paper)
    return 120 + 40 * x - 30 * y;
  const bool has_square = column > -1 && column < 9 && row > -1 && row < 6;
  const auto square = static_cast<int>(std::floor(column) + std::floor(row) + 4);
  return has_square && square % 2 == 0 ? 30 : 215;
}

std::vector<Eigen::Isometry3d>
boardPoses(std::size_t count)
{
  Random random(11);
  const auto within = [&](double minimum, double maximum) {
    return random.uniform(minimum, maximum);
  };
  std::vector<Eigen::Isometry3d> poses;
  for (std::size_t i = 0; i < count; ++i) {
    const double depth = within(0.5, 0.85);
    // The common field of view is reduced by the baselines.
    const double reach = depth - 0.42;
    // in separate statements: the evaluation order of arguments is unspecified
    const double y = within(-0.38, 0.38) * reach, x = within(-0.5, 0.5) * reach;
    const Eigen::Vector3d middle(x - 0.05, y - 0.05, depth);
    const double c = within(-25, 25), b = within(-35, 35), a = within(-35, 35);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = turned(a, b, c);
    pose.translation() = middle - pose.linear() * Eigen::Vector3d(0.12, 0.075, 0);
    poses.push_back(pose);
  }
  return poses;
}

void
spoil(CameraImage& image, double blur, double noise, unsigned seed)
{
  std::vector<double> values(image.values.begin(), image.values.end());
  values = blurred(values, image.width, 1, blur);
  values = blurred(values, image.height, image.width, blur);
  Random random(seed);
  for (std::size_t i = 0; i < values.size(); ++i)
    image.values[i] = grey(values[i] + noise * random.normal());
}

std::vector<TrinocularFrame>
boardShots(const RigCalibration& rig, std::size_t count)
{
  const RigRenderer renderer(rig);
  std::vector<TrinocularFrame> shots;
  unsigned seed = 0;
  for (const Eigen::Isometry3d& pose : boardPoses(count)) {
    shots.push_back(renderer.frameOf(pose, boardBrightness));
    for (CameraImage& image : shots.back().images)
      if (!image.empty())
        spoil(image, 0.7, 2.0, seed++);
  }
  return shots;
}

std::array<std::string, 3>
shotNames(std::size_t shot)
{
  const std::string number = (shot < 10 ? "_0" : "_") + std::to_string(shot) + ".png";
  return {"reference" + number, "horizontal" + number, "vertical" + number};
}

} // namespace pcl::acmap::test
