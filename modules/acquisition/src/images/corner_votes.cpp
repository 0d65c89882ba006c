#include "corner_votes.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

constexpr double nearest = 0.3;         // minimum depth, metres
constexpr int max_beside = 2;           // px, maximum distance from the epipolar line
constexpr float min_agreement = 0.8F;   // correlation
constexpr float min_difference = 0.05F; // minimum lead of the best depth
constexpr int same_place = 3;           // depths within so many steps count as one
constexpr double min_shift = 5;         // px, minimum parallax

constexpr std::array neighbours{RigCamera::Horizontal, RigCamera::Vertical};

/** Number of steps of the inverse depth from infinity to the minimum depth; one step is
 * about a pixel in the neighbour with the longer baseline. */
int
stepsOf(const RigCalibration& calibration)
{
  double maximum = 1;
  for (const CameraCalibration& camera : calibration.cameras)
    maximum = std::max(maximum,
                       std::max(camera.focal_x, camera.focal_y) *
                           camera.T_reference_camera.translation().norm() / nearest);
  // With very long baselines, points at smaller depths are outside the image.
  const double farthest = 4.0 * std::max(calibration.width, calibration.height);
  return static_cast<int>(std::ceil(std::min(maximum, farthest)));
}

/** Positions of a reference corner in a neighbour image, by step of the inverse
 * depth. */
class CornerLine {
public:
  CornerLine(const CameraCalibration& reference,
             const CameraCalibration& neighbour,
             cv::Point corner,
             int steps)
  : neighbour_(neighbour)
  {
    const Eigen::Isometry3d& place = neighbour.T_reference_camera;
    const Eigen::Vector3d ray = pixelRay(reference, {corner.x, corner.y});
    at_infinity_ = place.linear().transpose() * (ray / ray.z());
    step_ = place.linear().transpose() * place.translation() / (nearest * steps);
    const Eigen::Vector2d along =
        step_.head<2>() - at_infinity_.hnormalized() * step_.z();
    is_flat_ = std::abs(along.x()) >= std::abs(along.y());
  }

  Eigen::Vector2d
  at(int step) const
  {
    return projectPoint(neighbour_, at_infinity_ - step * step_);
  }

  /** Returns true if the line is closer to the direction of rows than of columns. */
  bool
  isFlat() const
  {
    return is_flat_;
  }

private:
  const CameraCalibration& neighbour_;
  Eigen::Vector3d at_infinity_;
  Eigen::Vector3d step_;
  bool is_flat_;
};

/** The maximum correlation at a position of the line and beside it; -1 if there is
 * none. */
float
agreementAt(const SmoothImage& image,
            const SmoothImage::Patch& patch,
            const CornerLine& line,
            int step)
{
  constexpr double beyond_all = 1e6; // px
  float best = -1;
  const Eigen::Vector2d place = line.at(step);
  if (!(place.cwiseAbs().maxCoeff() < beyond_all)) // also true for NaN
    return best;
  const int x = static_cast<int>(std::lround(place.x()));
  const int y = static_cast<int>(std::lround(place.y()));
  for (int off = -max_beside; off <= max_beside; ++off) {
    const int u = line.isFlat() ? x : x + off;
    const int v = line.isFlat() ? y + off : y;
    if (image.hasPatch(u, v))
      best = std::max(best, image.correlate(patch, u, v));
  }
  return best;
}

/** Minimum of the correlations in both neighbours, by step of the inverse depth. */
using Agreements = std::vector<float>;

/** Returns true if no other depth is nearly as good. */
bool
isAlone(const Agreements& agreements, Agreements::const_iterator best)
{
  for (auto other = agreements.begin(); other != agreements.end(); ++other)
    if (std::abs(other - best) > same_place && *other > *best - min_difference)
      return false;
  return true;
}

bool
isFound(const std::array<const SmoothImage*, 3>& images,
        cv::Point corner,
        const RigCalibration& calibration,
        int steps)
{
  const auto lineIn = [&](RigCamera camera) {
    return CornerLine(calibration.camera(RigCamera::Reference),
                      calibration.camera(camera),
                      corner,
                      steps);
  };
  const SmoothImage::Patch patch = images[0]->patchAt(corner);
  Agreements agreements(static_cast<std::size_t>(steps) + 1, 1.0F);
  for (const RigCamera camera : neighbours) {
    const CornerLine line = lineIn(camera);
    const SmoothImage& image = *images[static_cast<std::size_t>(camera)];
    for (int step = 0; step <= steps; ++step) {
      float& joint = agreements[static_cast<std::size_t>(step)];
      if (joint >= min_agreement - min_difference) // else it is already rejected
        joint = std::min(joint, agreementAt(image, patch, line, step));
    }
  }
  const auto best = std::max_element(agreements.cbegin(), agreements.cend());
  if (*best < min_agreement || !isAlone(agreements, best))
    return false;
  const auto step = static_cast<int>(best - agreements.cbegin());
  return std::all_of(neighbours.begin(), neighbours.end(), [&](RigCamera camera) {
    const CornerLine line = lineIn(camera);
    return (line.at(step) - line.at(0)).norm() >= min_shift;
  });
}

} // namespace

CornerVotes
countVotes(const std::array<const SmoothImage*, 3>& images,
           const std::vector<cv::Point>& corners,
           const RigCalibration& calibration)
{
  const int steps = stepsOf(calibration);
  CornerVotes votes;
  votes.corners = corners.size();
  for (const cv::Point& corner : corners)
    votes.found += isFound(images, corner, calibration, steps) ? 1 : 0;
  return votes;
}

} // namespace pcl::acmap
