#include "surface_picture.h"

#include <pcl/core/image_file.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl::acmap::python {

namespace {

constexpr std::int32_t width = 640, height = 480, margin = 12; // pixels

using Corners = std::array<Eigen::Vector3d, 3>;

Corners
cornersOf(const PictureMesh& mesh, const TriangleMesh::Triangle& triangle)
{
  Corners corners;
  for (std::size_t i = 0; i < 3; ++i)
    corners[i] = mesh.point(static_cast<std::size_t>(triangle[i])).cast<double>();
  return corners;
}

Eigen::Vector3d
areaOf(const Corners& at)
{
  return 0.5 * (at[1] - at[0]).cross(at[2] - at[0]);
}

bool
isFinite(const Corners& at)
{
  return at[0].allFinite() && at[1].allFinite() && at[2].allFinite();
}

/** Rows: right, up and towards the viewer. What most of the surface faces is in front of it, but
 * for a turn and a tilt. A view of a camera, whose z axis points forward, has y downwards; else z
 * is up. */
Eigen::Matrix3d
viewOf(const PictureMesh& mesh)
{
  constexpr double one_sided = 0.3, along = 0.45, turn = 0.45, tilt = 0.3;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double all = 0;
  for (const TriangleMesh::Triangle& triangle : mesh.triangles)
    if (const Corners at = cornersOf(mesh, triangle); isFinite(at)) {
      sum += areaOf(at);
      all += areaOf(at).norm();
    }
  Eigen::Vector3d towards(1, -1, 0.5);
  if (sum.norm() > one_sided * all)
    towards = sum;
  towards.normalize();
  const Eigen::Vector3d up_axis =
      towards.z() < -along  ? -Eigen::Vector3d::UnitY().eval()
      : towards.z() > along ? Eigen::Vector3d::UnitY().eval()
                            : Eigen::Vector3d::UnitZ().eval();
  towards += turn * up_axis.cross(towards).normalized() + tilt * up_axis;
  towards.normalize();
  Eigen::Matrix3d view;
  view.row(0) = up_axis.cross(towards).normalized();
  view.row(2) = towards;
  view.row(1) = towards.cross(view.row(0).transpose());
  return view;
}

/** A picture that is drawn with the nearest surface in front. */
class Canvas {
public:
  /** \param[in] low, high extent along right and up, metres */
  Canvas(const Eigen::Vector2d& low, const Eigen::Vector2d& high)
  : scale_(std::min((width - 2 * margin) / std::max(high.x() - low.x(), 1e-9),
                    (height - 2 * margin) / std::max(high.y() - low.y(), 1e-9)))
  , middle_((low + high) / 2)
  , depths_(std::size_t{width} * height, -std::numeric_limits<double>::infinity())
  {
    image_.width = width;
    image_.height = height;
    image_.values.assign(3 * depths_.size(), 255);
  }

  /** \param[in] at right, up and towards the viewer */
  void
  draw(Corners at, const std::array<std::uint8_t, 3>& color)
  {
    for (Eigen::Vector3d& corner : at)
      corner.head<2>() =
          Eigen::Vector2d(width / 2.0 + scale_ * (corner.x() - middle_.x()),
                          height / 2.0 - scale_ * (corner.y() - middle_.y()));
    const double doubled = areaOf({flat(at[0]), flat(at[1]), flat(at[2])}).z() * 2;
    if (doubled == 0)
      return;
    const auto least = [&](int axis) {
      return std::min({at[0][axis], at[1][axis], at[2][axis]});
    };
    const auto most = [&](int axis) {
      return std::max({at[0][axis], at[1][axis], at[2][axis]});
    };
    const auto first = [](double place) {
      return static_cast<std::int32_t>(std::max(0.0, std::floor(place)));
    };
    const auto last = [](double place, std::int32_t size) {
      return static_cast<std::int32_t>(std::min(size - 1.0, std::ceil(place)));
    };
    for (std::int32_t row = first(least(1)); row <= last(most(1), height); ++row)
      for (std::int32_t column = first(least(0)); column <= last(most(0), width);
           ++column)
        drawPixel(at, doubled, column, row, color);
  }

  const RgbImage&
  image() const
  {
    return image_;
  }

private:
  static Eigen::Vector3d
  flat(const Eigen::Vector3d& place)
  {
    return {place.x(), place.y(), 0};
  }

  void
  drawPixel(const Corners& at,
            double doubled,
            std::int32_t column,
            std::int32_t row,
            const std::array<std::uint8_t, 3>& color)
  {
    const Eigen::Vector3d pixel(column, row, 0);
    double depth = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3d &b = at[(i + 1) % 3], &c = at[(i + 2) % 3];
      const double share = 2 * areaOf({pixel, flat(b), flat(c)}).z() / doubled;
      if (share < 0)
        return;
      depth += share * at[i].z();
    }
    double& nearest = depths_[static_cast<std::size_t>(row) * width +
                              static_cast<std::size_t>(column)];
    if (depth <= nearest)
      return;
    nearest = depth;
    std::copy(color.begin(), color.end(), image_.at(column, row));
  }

  double scale_; ///< pixels a metre
  Eigen::Vector2d middle_;
  std::vector<double> depths_; ///< towards the viewer
  RgbImage image_;
};

std::array<std::uint8_t, 3>
shaded(const std::array<std::uint8_t, 3>& color, double facing)
{
  constexpr double ambient = 0.45;
  std::array<std::uint8_t, 3> shade{};
  for (std::size_t i = 0; i < 3; ++i)
    shade[i] = static_cast<std::uint8_t>((ambient + (1 - ambient) * facing) * color[i]);
  return shade;
}

} // namespace

std::string
pictureOf(const PictureMesh& mesh)
{
  const Eigen::Matrix3d view = viewOf(mesh);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Eigen::Vector2d low(infinite, infinite), high = -low;
  const auto seen = [&](const TriangleMesh::Triangle& triangle) {
    Corners at = cornersOf(mesh, triangle);
    for (Eigen::Vector3d& corner : at)
      corner = view * corner;
    return at;
  };
  for (const TriangleMesh::Triangle& triangle : mesh.triangles)
    if (const Corners at = seen(triangle); isFinite(at))
      for (const Eigen::Vector3d& corner : at) {
        low = low.cwiseMin(corner.head<2>());
        high = high.cwiseMax(corner.head<2>());
      }
  if (!(low.x() <= high.x()))
    return {};
  Canvas canvas(low, high);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (const Corners at = seen(mesh.triangles[i]); isFinite(at)) {
      const double facing = std::abs(areaOf(at).normalized().z());
      canvas.draw(at, shaded(mesh.colors[mesh.colors.size() > 1 ? i : 0], facing));
    }
  const std::vector<std::uint8_t> png = encodePng(canvas.image());
  return {png.begin(), png.end()};
}

} // namespace pcl::acmap::python
