#include "stereo_bag.h"

#include "test_data.h"

namespace pcl::acmap::bench {

namespace {

constexpr char shots_folder[] = "B_active/bag_random_lines_N10/";
constexpr char code_folder[] = "B_active/graycode_bag_rect_half/";
constexpr char truth_file[] = "B_active/graycode_bag_rect_half/gt_disp_left.pfm";

TrinocularFrame::ConstPtr
loadPair(const std::string& folder, const std::string& number, std::int32_t pattern)
{
  return frameOf(loadGreyImage(folder + "L_" + number + ".png"),
                 loadGreyImage(folder + "R_" + number + ".png"),
                 pattern);
}

} // namespace

bool
hasBag(const char* section)
{
  return hasAllData(section,
                    {std::string(shots_folder) + "R_09.png",
                     std::string(code_folder) + "R_44.png",
                     truth_file});
}

StereoShots
loadBag()
{
  constexpr int width = 1024, height = 750, patterns = 10;
  constexpr double focal_length = 1851.6711, baseline = 0.0399255; // from its calib.txt
  StereoShots bag = binocularShots(width, height, focal_length, baseline);
  for (int i = 0; i < patterns; ++i)
    bag.frames.push_back(loadPair(shots_folder, "0" + std::to_string(i), i));
  bag.truth = loadPfm(test::testDataPath(truth_file).string());
  return bag;
}

TrinocularFrame::ConstPtr
loadPassiveBag()
{
  return loadPair(code_folder, "44", 0);
}

TrinocularMatching
bagMatching()
{
  TrinocularMatching matching;
  matching.setXOffset(bag_minimum);
  matching.setMaxDisparity(bag_disparities);
  return matching;
}

} // namespace pcl::acmap::bench
