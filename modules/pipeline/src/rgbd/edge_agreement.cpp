#include "rgbd/edge_agreement.h"

#include <pcl/core/impl/cloud_fields.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace pcl::acmap {

namespace {

constexpr int max_gradient = 60;        // grey levels; brighter edges count the same
constexpr int edge_gap = 12;            // pixels without a depth that an edge may have
constexpr float edge_jump = 1.06F;      // ratio of depths at an edge
constexpr std::size_t max_edges = 4000; // per cloud

struct GreyAndDepth {
  std::vector<int> grey;
  std::vector<float> depth; // NaN without a point
};

GreyAndDepth
imagesOf(const PCLPointCloud2& cloud)
{
  GreyAndDepth images;
  const std::size_t z = findField(cloud, "z")->offset;
  const std::size_t rgb = findColor(cloud)->offset;
  for (std::size_t i = 0; i < rowsOf(cloud); ++i) {
    const std::uint8_t* const row = &cloud.data[i * cloud.point_step];
    float depth = 0;
    std::uint32_t color = 0;
    std::memcpy(&depth, row + z, sizeof depth);
    std::memcpy(&color, row + rgb, sizeof color);
    images.depth.push_back(depth);
    images.grey.push_back(
        static_cast<int>((color >> 16 & 255) + 2 * (color >> 8 & 255) + (color & 255)) /
        4);
  }
  return images;
}

/** \brief Differences of the grey values of neighbours, across and down. */
std::vector<int>
gradientsOf(const std::vector<int>& grey, int width, int height)
{
  std::vector<int> gradients(grey.size());
  for (int row = 1; row + 1 < height; ++row)
    for (int column = 1; column + 1 < width; ++column) {
      const int i = row * width + column;
      const auto at = [&](int offset) {
        return grey[static_cast<std::size_t>(i + offset)];
      };
      gradients[static_cast<std::size_t>(i)] = std::min(
          max_gradient, std::abs(at(1) - at(-1)) + std::abs(at(width) - at(-width)));
    }
  return gradients;
}

/** \brief Pixels where the depth jumps from one row or column to the next measured one, on the
 * near side. */
std::vector<Eigen::Vector2i>
edgesOf(const std::vector<float>& depth, int width, int height)
{
  std::vector<Eigen::Vector2i> edges;
  const auto search = [&](int lines, int length, const auto& pixelOf) {
    for (int line = 0; line < lines; ++line) {
      int last = -1;
      for (int place = 0; place < length; ++place) {
        const Eigen::Vector2i here = pixelOf(line, place);
        const auto index = [width](const Eigen::Vector2i& pixel) {
          return static_cast<std::size_t>(pixel.y() * width + pixel.x());
        };
        const float z = depth[index(here)];
        if (!(z > 0))
          continue;
        if (last >= 0 && place - last <= edge_gap) {
          const Eigen::Vector2i before = pixelOf(line, last);
          const float other = depth[index(before)];
          if (z > edge_jump * other)
            edges.push_back(before);
          else if (other > edge_jump * z)
            edges.push_back(here);
        }
        last = place;
      }
    }
  };
  search(
      height, width, [](int line, int place) { return Eigen::Vector2i(place, line); });
  search(
      width, height, [](int line, int place) { return Eigen::Vector2i(line, place); });
  return edges;
}

} // namespace

void
EdgeAgreement::add(const PCLPointCloud2& cloud)
{
  const auto width = static_cast<int>(cloud.width);
  const auto height = static_cast<int>(cloud.height);
  if (sums_.empty()) {
    constexpr int shifts = 20; // in each direction, of 6 % of the width
    width_ = width;
    height_ = height;
    step_ = std::max(1, width * 6 / (100 * shifts));
    reach_ = std::min(shifts, std::min(width, height) / (4 * step_));
    const auto side = static_cast<std::size_t>(2 * reach_ + 1);
    sums_.assign(side * side, 0.0);
  }
  if (width != width_ || height != height_)
    return;
  const GreyAndDepth images = imagesOf(cloud);
  const std::vector<int> gradients = gradientsOf(images.grey, width, height);
  const std::vector<Eigen::Vector2i> edges = edgesOf(images.depth, width, height);
  const std::size_t every = edges.size() / max_edges + 1;
  const int margin = reach_ * step_;
  for (std::size_t i = 0; i < edges.size(); i += every) {
    const Eigen::Vector2i& edge = edges[i];
    if (edge.x() < margin || edge.y() < margin || edge.x() + margin >= width ||
        edge.y() + margin >= height)
      continue;
    edges_ += 1;
    std::size_t shift = 0;
    for (int down = -reach_; down <= reach_; ++down)
      for (int across = -reach_; across <= reach_; ++across, ++shift)
        sums_[shift] += gradients[static_cast<std::size_t>(
            (edge.y() + down * step_) * width + edge.x() + across * step_)];
  }
}

std::optional<Eigen::Vector2d>
EdgeAgreement::bestShift() const
{
  constexpr double min_edges = 500, min_rise = 1.3;
  if (edges_ < min_edges || reach_ == 0)
    return std::nullopt;
  const auto best = std::max_element(sums_.begin(), sums_.end());
  const int side = 2 * reach_ + 1;
  const auto place = static_cast<int>(best - sums_.begin());
  const Eigen::Vector2i shift(place % side - reach_, place / side - reach_);
  std::vector<double> sorted = sums_;
  std::nth_element(sorted.begin(),
                   sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                   sorted.end());
  if (*best < min_rise * sorted[sorted.size() / 2])
    return std::nullopt;
  return step_ * shift.cast<double>();
}

} // namespace pcl::acmap
