#include "disparity_errors.h"
#include "markdown_row.h"
#include "sgbm_disparity.h"
#include "statistics.h"
#include "stereo_tables.h"
#include "test_data.h"

#include <pcl/stereo/trinocular_matching.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace pcl::acmap::bench {
namespace {

constexpr char folder[] = "B_active/realsense_ir_on/";
constexpr char number[] = "_20200819_235924";
constexpr int width = 1280, height = 720;
constexpr double baseline = 0.05; // metres, from the camera's data sheet
constexpr int disparities = 128;

std::string
fileOf(const char* name, const char* ending)
{
  return std::string(folder) + name + number + ending;
}

/** Depths in millimetres, 0 for unknown; the file is a NumPy array of 16 bits. */
std::vector<std::uint16_t>
loadDepths()
{
  constexpr std::streamoff length_at = 8, header_at = 10; // format version 1
  std::ifstream file(test::testDataPath(fileOf("depth", ".npy")), std::ios::binary);
  file.seekg(length_at);
  const int low = file.get();
  const int high = file.get();
  constexpr int byte = 256;
  file.seekg(header_at + low + byte * high);
  std::vector<std::uint16_t> depths(static_cast<std::size_t>(width * height));
  file.read(reinterpret_cast<char*>(depths.data()),
            static_cast<std::streamsize>(depths.size() * sizeof(depths[0])));
  if (!file)
    throw std::runtime_error("the depths of the factory's camera are cut off");
  return depths;
}

/** Disparity times depth, px mm, which replaces the unknown focal length. */
double
scaleOf(const DisparityImage& found, const std::vector<std::uint16_t>& depths)
{
  std::vector<double> products;
  for (std::size_t i = 0; i < depths.size(); ++i)
    if (depths[i] > 0 && !std::isnan(found.values[i]))
      products.push_back(depths[i] * static_cast<double>(found.values[i]));
  return median(products);
}

DisparityImage
disparitiesOf(const std::vector<std::uint16_t>& depths, double scale)
{
  DisparityImage image{width, height, {}};
  for (const std::uint16_t depth : depths)
    image.values.push_back(depth > 0 ? static_cast<float>(scale / depth)
                                     : std::numeric_limits<float>::quiet_NaN());
  return image;
}

void
printAgainst(const std::string& name,
             const DisparityImage& found,
             const std::vector<std::uint16_t>& depths)
{
  constexpr double metres_per_millimetre = 1e-3;
  const double scale = scaleOf(found, depths);
  const DisparityImage truth = disparitiesOf(depths, scale);
  DisparityErrors errors;
  errors.add(found, truth, pixelsWithTruth(truth));
  DisparityErrors all;
  all.add(found, found, PixelMask(found.values.size(), 1));
  MarkdownRow()
      .text(name)
      .count(errors.judged())
      .number(scale * metres_per_millimetre / baseline, 1)
      .number(errors.present() - errors.wrong(), 2)
      .number(errors.wrong(), 2)
      .number(errors.medianError(), 3)
      .number(all.present(), 2)
      .print();
}

} // namespace

void
printRealsense()
{
  if (!hasAllData("realsense", {fileOf("depth", ".npy"), fileOf("left", ".png")}))
    return;
  const std::vector<std::uint16_t> depths = loadDepths();
  constexpr double some_focal_length = 640.0; // not used
  StereoShots shots = binocularShots(width, height, some_focal_length, baseline);
  shots.frames = {frameOf(loadGreyImage(fileOf("left", ".png")),
                          loadGreyImage(fileOf("right", ".png")),
                          0)};
  TrinocularMatching matching;
  matching.setMaxDisparity(disparities);
  matching.setInputRig(shots.rig);
  MatchedDisparity masked, open;
  matching.match(*shots.frames.front(), masked);
  matching.setPeakFilter(0);
  matching.setCorrelationThreshold(-1);
  matching.match(*shots.frames.front(), open);
  printHead({"dots of a factory's camera, against its own depth",
             "pixels with its depth",
             "focal length that fits, px",
             "within 1 px, %",
             "wrong, %",
             "median difference, px",
             "all pixels with a disparity, %"});
  printAgainst("OpenCV SGBM",
               sgbmDisparity(*shots.frames.front(), shots.rig, {0, disparities}),
               depths);
  printAgainst("acmap, one shot", masked.disparity, depths);
  printAgainst("acmap, one shot, no thresholds", open.disparity, depths);
}

} // namespace pcl::acmap::bench
