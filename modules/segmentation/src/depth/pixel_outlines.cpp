#include "depth/pixel_outlines.h"

#include "outlines/crease_snap.h"
#include "outlines/face_loops.h"
#include "outlines/loop.h"
#include "outlines/patch_outlines.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::depth {

namespace {

using Edges = std::vector<std::pair<std::int32_t, std::int32_t>>;

/** The corners of a view's pixels, y up, so that outer rims run counter-clockwise. */
class PixelCorners {
public:
  explicit PixelCorners(const DepthView& view)
  : view_(view)
  , columns_(view.width() + 1)
  {
    places_.reserve(columns_ * (view.height() + 1));
    for (std::size_t row = 0; row <= view.height(); ++row)
      for (std::size_t column = 0; column <= view.width(); ++column)
        places_.emplace_back(std::copysign(column, view.focal().x()),
                             -std::copysign(row, view.focal().y()));
  }

  /** For each plane the pixel edges that have its pixels on their left, sorted. */
  std::vector<Edges>
  rims(const std::vector<std::int32_t>& labels, std::size_t planes) const
  {
    std::vector<Edges> rims(planes);
    const bool is_mirrored = view_.focal().x() * view_.focal().y() < 0;
    const auto add = [&](std::int32_t plane, std::size_t from, std::size_t to) {
      const auto a = static_cast<std::int32_t>(from);
      const auto b = static_cast<std::int32_t>(to);
      if (plane >= 0)
        rims[static_cast<std::size_t>(plane)].emplace_back(is_mirrored ? b : a,
                                                           is_mirrored ? a : b);
    };
    const std::size_t width = view_.width(), height = view_.height();
    const auto labelAt = [&](std::size_t row, std::size_t column) {
      return row < height && column < width ? labels[row * width + column] : -1;
    };
    // At row or column 0 the index of the neighbour wraps around, so that it is
    // outside.
    for (std::size_t row = 0; row <= height; ++row)
      for (std::size_t column = 0; column <= width; ++column) {
        const std::int32_t own = labelAt(row, column);
        const std::size_t corner = row * columns_ + column;
        const std::int32_t above = labelAt(row - 1, column);
        if (own != above) {
          add(own, corner + 1, corner);
          add(above, corner, corner + 1);
        }
        const std::int32_t before = labelAt(row, column - 1);
        if (own != before) {
          add(own, corner, corner + columns_);
          add(before, corner + columns_, corner);
        }
      }
    for (Edges& edges : rims)
      std::sort(edges.begin(), edges.end());
    return rims;
  }

  const std::vector<Eigen::Vector2d>&
  places() const
  {
    return places_;
  }

  /** Viewing ray through a position of the image, in pixels. */
  Eigen::Vector3d
  ray(const Eigen::Vector2d& place) const
  {
    return view_.ray(std::abs(place.x()) - 0.5, std::abs(place.y()) - 0.5);
  }

private:
  const DepthView& view_;
  std::size_t columns_;
  std::vector<Eigen::Vector2d> places_;
};

std::vector<outlines::Loop>
loopsOf(const Edges& edges,
        const PixelCorners& corners,
        const outlines::PatchFrame& frame)
{
  constexpr double tolerance = 1.5, min_area = 25; // pixels, square pixels
  std::vector<outlines::Loop> loops;
  for (const std::vector<std::int32_t>& rim :
       outlines::edgeLoops(edges, corners.places())) {
    outlines::Loop in_picture;
    for (const std::int32_t corner : rim)
      in_picture.push_back(corners.places()[static_cast<std::size_t>(corner)]);
    if (std::abs(outlines::signedArea(in_picture)) < min_area)
      continue;
    outlines::Loop loop;
    for (const Eigen::Vector2d& place :
         outlines::uncrossed(outlines::simplified(in_picture, tolerance)))
      loop.push_back(frame.flat(meet(corners.ray(place), frame.patch.coefficients)));
    if (loop.size() >= 3)
      loops.push_back(std::move(loop));
  }
  return loops;
}

} // namespace

Eigen::Vector3d
meet(const Eigen::Vector3d& ray, const Eigen::Vector4d& coefficients)
{
  // A ray half a pixel beyond the rim of a plane seen at a grazing angle may miss it.
  constexpr double farthest = 1000; // times the plane's distance
  const Eigen::Vector3d inverse = -coefficients.head<3>() / coefficients[3];
  return ray / std::max(inverse.dot(ray), inverse.norm() / farthest);
}

void
outlinePixels(const DepthView& view,
              const std::vector<std::int32_t>& labels,
              std::vector<KnownPlane>& planes)
{
  const PixelCorners corners(view);
  const std::vector<Edges> rims = corners.rims(labels, planes.size());
  for (std::size_t p = 0; p < planes.size(); ++p) {
    PlanePatch& patch = planes[p].patch;
    const double footprint = patch.center.norm() / std::abs(view.focal().x());
    patch.area = 0;
    outlines::setPolygons(loopsOf(rims[p], corners, outlines::PatchFrame{patch}),
                          footprint * footprint,
                          footprint,
                          patch);
  }
}

} // namespace pcl::acmap::depth
