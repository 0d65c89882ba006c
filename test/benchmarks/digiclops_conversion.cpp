#include "digiclops_tables.h"
#include "images/frame_unpacking.h"
#include "markdown_row.h"
#include "timing.h"
#include "units.h"

#include <pcl/core/random.h>
#include <pcl/stereo/trinocular_rectification.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <stdexcept>

namespace pcl::acmap::bench {

namespace {

constexpr std::size_t rounds = 100;

/** Rectification of a camera with OpenCV. */
class CameraRemap {
public:
  CameraRemap(const TrinocularRectification& rectification,
              const CameraCalibration& camera,
              RigCamera which)
  {
    const TrinocularRig& rig = rectification.getRig();
    const Eigen::Matrix3d R_camera_common =
        rectification.getRotation(which).transpose();
    cv::Mat_<float> columns(rig.height, rig.width), rows(rig.height, rig.width);
    for (int y = 0; y < rig.height; ++y)
      for (int x = 0; x < rig.width; ++x) {
        const Eigen::Vector3d ray((x - rig.center_x) / rig.focal_length,
                                  (y - rig.center_y) / rig.focal_length,
                                  1.0);
        const Eigen::Vector2d from = projectPoint(camera, R_camera_common * ray);
        columns(y, x) = static_cast<float>(from.x());
        rows(y, x) = static_cast<float>(from.y());
      }
    cv::convertMaps(columns, rows, places_, weights_, CV_16SC2);
  }

  void
  run(CameraImage& image, cv::Mat& remapped) const
  {
    const cv::Mat from(
        image.height, image.width, CV_8UC(image.channels), image.values.data());
    cv::remap(
        from, remapped, places_, weights_, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  }

private:
  cv::Mat places_;
  cv::Mat weights_;
};

/** Checks that both methods give the same images. */
void
requireAlike(const CameraImage& ours, const cv::Mat& theirs)
{
  constexpr double maximum =
      4; // mean difference on noise, in grey levels: cv::remap has
         // steps of 1/32 px
  double sum = 0;
  for (std::size_t i = 0; i < ours.values.size(); ++i)
    sum += std::abs(int{ours.values[i]} - int{theirs.data[i]});
  if (sum > maximum * static_cast<double>(ours.values.size()))
    throw std::runtime_error("cv::remap gives other images");
}

struct ConversionCosts {
  std::vector<double> unpack, rectify, both, remap_grey, remap_color;
};

class Conversion {
public:
  Conversion()
  : cameras_(loadRigCalibration(ACMAP_BUILT_RIG))
  , bytes_(std::size_t{3} * 640 * 480)
  {
    Random random(1);
    for (std::uint8_t& byte : bytes_)
      byte = static_cast<std::uint8_t>(random.bits());
    rectification_.setNumberOfThreads(1);
    rectification_.setInputCalibration(cameras_);
    for (std::size_t i = 0; i < 3; ++i)
      remaps_.emplace_back(
          rectification_, cameras_.cameras[i], static_cast<RigCamera>(i));
    for (const BayerPattern bayer : {BayerPattern::None, BayerPattern::Gbrg})
      unpackFrame(
          bytes_, layoutOf(bayer), bayer == BayerPattern::None ? grey_ : color_);
  }

  ConversionCosts
  measure(BayerPattern bayer)
  {
    ConversionCosts costs;
    TrinocularFrame frame, rectified;
    for (std::size_t round = 0; round < rounds; ++round) {
      costs.unpack.push_back(
          measureThread([&] { unpackFrame(bytes_, layoutOf(bayer), frame); }));
      costs.rectify.push_back(
          measureThread([&] { rectification_.rectify(frame, rectified); }));
      costs.both.push_back(costs.unpack.back() + costs.rectify.back());
      costs.remap_grey.push_back(measureThread([&] { remap(grey_); }));
      costs.remap_color.push_back(measureThread([&] { remap(color_); }));
    }
    remap(frame);
    for (std::size_t i = 0; i < 3; ++i)
      requireAlike(rectified.images[i], remapped_[i]);
    return costs;
  }

private:
  static PlaneLayout
  layoutOf(BayerPattern bayer)
  {
    PlaneLayout layout;
    layout.width = 640;
    layout.height = 480;
    layout.bayer = bayer;
    return layout;
  }

  void
  remap(TrinocularFrame& frame)
  {
    for (std::size_t i = 0; i < 3; ++i)
      remaps_[i].run(frame.images[i], remapped_[i]);
  }

  RigCalibration cameras_;
  std::vector<std::uint8_t> bytes_;
  TrinocularRectification rectification_;
  std::vector<CameraRemap> remaps_;
  TrinocularFrame grey_, color_;
  std::array<cv::Mat, 3> remapped_;
};

void
printCosts(const std::string& name, const ConversionCosts& costs)
{
  constexpr double reach = 4; // multiple of three grey images
  const auto minimum = [](const std::vector<double>& values) {
    return *std::min_element(values.begin(), values.end());
  };
  const auto row = [&](const std::string& kind, const auto& of) {
    MarkdownRow()
        .text(name + ", " + kind)
        .number(milli * of(costs.unpack), 2)
        .number(milli * of(costs.rectify), 2)
        .number(milli * of(costs.both), 2)
        .number(milli * of(costs.remap_grey), 2)
        .atMost(of(costs.both) / of(costs.remap_grey), reach, 2)
        .number(milli * of(costs.remap_color), 2)
        .number(of(costs.both) / of(costs.remap_color), 2)
        .print();
  };
  row("median", median);
  row("least", minimum);
}

} // namespace

void
printConversion()
{
  printHead({"three planes of 640 × 480",
             "take apart, ms",
             "rectify, ms",
             "both, ms",
             "remap of three grey images, ms",
             "of it",
             "remap of three colour images, ms",
             "of it"});
  const int before = cv::getNumThreads();
  cv::setNumThreads(1);
  Conversion conversion;
  printCosts("grey", conversion.measure(BayerPattern::None));
  printCosts("Bayer GBRG", conversion.measure(BayerPattern::Gbrg));
  cv::setNumThreads(before);
}

} // namespace pcl::acmap::bench
