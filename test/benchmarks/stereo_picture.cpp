#include "bench.h"
#include "picture_sheet.h"
#include "stereo_methods.h"

#include <pcl/simulation/standard_scenes.h>

#include <opencv2/imgproc.hpp>

namespace pcl::acmap::bench {
namespace {

/** Points drawn as small squares; the nearest one is visible. */
class PointPicture {
public:
  explicit PointPicture(const TrinocularRig& rig)
  : rig_(rig)
  , depths_(static_cast<std::size_t>(rig.width) * static_cast<std::size_t>(rig.height),
            std::numeric_limits<double>::infinity())
  {
    constexpr std::uint8_t paper = 255;
    image_ = {rig.width, rig.height, 3, {}};
    image_.values.assign(3 * depths_.size(), paper);
  }

  /** \param[in] point in the frame of the virtual camera */
  void
  draw(const Eigen::Vector3d& point, const std::array<std::uint8_t, 3>& color)
  {
    if (point.z() <= 0)
      return;
    constexpr int reach = 1; // px
    const auto column = static_cast<int>(
        std::lround(rig_.focal_length * point.x() / point.z() + rig_.center_x));
    const auto row = static_cast<int>(
        std::lround(rig_.focal_length * point.y() / point.z() + rig_.center_y));
    for (int y = std::max(row - reach, 0); y <= std::min(row + reach, rig_.height - 1);
         ++y)
      for (int x = std::max(column - reach, 0);
           x <= std::min(column + reach, rig_.width - 1);
           ++x)
        fill(static_cast<std::size_t>(y * rig_.width + x), point.z(), color);
  }

  const CameraImage&
  image() const
  {
    return image_;
  }

private:
  void
  fill(std::size_t pixel, double depth, const std::array<std::uint8_t, 3>& color)
  {
    if (depth >= depths_[pixel])
      return;
    depths_[pixel] = depth;
    std::copy(color.begin(),
              color.end(),
              image_.values.begin() + static_cast<std::ptrdiff_t>(3 * pixel));
  }

  TrinocularRig rig_;
  std::vector<double> depths_;
  CameraImage image_;
};

std::array<std::uint8_t, 3>
colorAt(const CameraImage& image, std::size_t pixel)
{
  const auto channels = static_cast<std::size_t>(image.channels);
  const std::uint8_t* const first = &image.values[channels * pixel];
  return {first[0], first[channels / 2], first[channels - 1]};
}

/** Centre of the depth range: 90 % of the points are closer than twice this depth. */
double
middleDepth(const DisparityImage& disparity, const TrinocularRig& rig)
{
  constexpr double maximum = 0.9;
  std::vector<double> depths;
  for (std::size_t i = 0; i < disparity.values.size(); ++i)
    if (disparity.values[i] > 0)
      depths.push_back(pointOf(rig, i, disparity.values[i]).z());
  return std::max(median(depths), quantile(depths, maximum) / 2);
}

/** \brief Disparities as colours, from blue (minimum) to red; black for invalid ones.
 * \param[in] minimum px
 * \param[in] maximum px */
CameraImage
coloredDisparity(const DisparityImage& image, float minimum, float maximum)
{
  constexpr float brightest = 255.0f;
  cv::Mat_<uchar> levels(image.height, image.width);
  std::transform(
      image.values.begin(), image.values.end(), levels.begin(), [&](float disparity) {
        const float share = (disparity - minimum) / (maximum - minimum);
        return cv::saturate_cast<uchar>(std::isnan(share) ? 0.0f : brightest * share);
      });
  cv::Mat colors;
  cv::applyColorMap(levels, colors, cv::COLORMAP_TURBO);
  cv::cvtColor(colors, colors, cv::COLOR_BGR2RGB);
  CameraImage colored{image.width, image.height, 3, {}};
  colored.values.assign(colors.datastart, colors.dataend);
  for (std::size_t i = 0; i < image.values.size(); ++i)
    if (std::isnan(image.values[i]))
      std::fill_n(colored.values.begin() + static_cast<std::ptrdiff_t>(3 * i),
                  3,
                  std::uint8_t{0});
  return colored;
}

/** \brief Renders the points of a view from a position beside and above it, looking at
 * their centre; the picture has the same size.
 * \param[in] color of the reference view, grey or in colour
 * \param[in] yaw rotation of the position about the centre, rad, positive to the
 * left */
CameraImage
viewFromBeside(const DisparityImage& disparity,
               const CameraImage& color,
               const TrinocularRig& rig,
               double yaw)
{
  constexpr double pitch = 0.3; // rad, from above
  constexpr double back = 0.25; // of the centre's depth
  const double depth = middleDepth(disparity, rig);
  const Eigen::Vector3d middle(0, 0, depth);
  const Eigen::Isometry3d T_beside_camera =
      Eigen::Translation3d((1 + back) * middle) *
      Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitX()) *
      Eigen::AngleAxisd(-yaw, Eigen::Vector3d::UnitY()) * Eigen::Translation3d(-middle);
  PointPicture picture(rig);
  for (std::size_t i = 0; i < disparity.values.size(); ++i)
    if (disparity.values[i] > 0)
      picture.draw(T_beside_camera * pointOf(rig, i, disparity.values[i]),
                   colorAt(color, i));
  return picture.image();
}

/** A view of the simulated corridor. */
struct Showing {
  SimulatedShots taken;

  explicit Showing(std::size_t view)
  : taken(takeShots(standardScene("corridor"), view))
  {}

  static CameraImage
  colored(const DisparityImage& disparity)
  {
    constexpr float maximum = 42.0f; // px: 1.2 m
    return coloredDisparity(disparity, 0, maximum);
  }

  DisparityImage
  fused(DisparityFusion::Method method) const
  {
    return fusedDisparity(taken.shots, method).disparity;
  }

  CameraImage
  fromBeside(const DisparityImage& disparity, double yaw) const
  {
    return viewFromBeside(
        disparity, taken.off->image(RigCamera::Reference), taken.shots.rig, yaw);
  }
};

constexpr int columns = 4, rows = 4, smaller = 3;
constexpr double from_right = -0.45, from_left = 0.15; // rad

/** Fig. 2: the reference without a pattern and with three, the disparities of each,
 * their median and space-time result, and the points of these from beside. */
void
putFusion(PictureSheet& sheet, const Showing& showing)
{
  const StereoShots& shots = showing.taken.shots;
  TrinocularMatching matching;
  matching.setInputRig(shots.rig);
  for (int column = 0; column < columns; ++column) {
    const TrinocularFrame& shot =
        column == 0 ? *showing.taken.off
                    : *shots.frames[static_cast<std::size_t>(column - 1)];
    MatchedDisparity matched;
    matching.match(shot, matched);
    sheet.put(column, 0, shot.image(RigCamera::Reference));
    sheet.put(column, 1, Showing::colored(matched.disparity));
  }
  const DisparityImage together = showing.fused(DisparityFusion::Method::SpaceTime);
  sheet.put(0, 2, Showing::colored(showing.fused(DisparityFusion::Method::Median)));
  sheet.put(1, 2, Showing::colored(together));
  sheet.put(2, 2, showing.fromBeside(together, from_right));
  sheet.put(3, 2, showing.fromBeside(together, from_left));
}

/** Fig. 3: the reference, the disparities, the true disparities, and the points. */
void
putPlace(PictureSheet& sheet, int row, const Showing& showing)
{
  const DisparityImage together = showing.fused(DisparityFusion::Method::SpaceTime);
  sheet.put(0, row, showing.taken.off->image(RigCamera::Reference));
  sheet.put(1, row, Showing::colored(together));
  sheet.put(2, row, Showing::colored(showing.taken.shots.truth));
  sheet.put(3, row, showing.fromBeside(together, -from_right));
}

const Section picture_section(
    "picture",
    [] {
      constexpr std::size_t place = 8, other_place = 21;
      const Showing here(place);
      const TrinocularRig& rig = here.taken.shots.rig;
      PictureSheet sheet(columns, rows, rig.width, rig.height, smaller);
      putFusion(sheet, here);
      putPlace(sheet, 3, Showing(other_place));
      sheet.save("stereo_disparities.png");
    },
    SectionUse::WhenNamed);

} // namespace
} // namespace pcl::acmap::bench
