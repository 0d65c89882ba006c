#include "messages.h"
#include "temporary_folder.h"

#include <pcl/core/trinocular_rig.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

TEST(TrinocularRig, SurvivesItsFile)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("rig.yaml");
  TrinocularRig rig;
  rig.width = 1024;
  rig.height = 768;
  rig.focal_length = 812.3456789012345;
  rig.center_x = 1.0 / 3.0;
  rig.baseline_horizontal = -0.1234567890123;
  rig.baseline_vertical = 0;
  saveTrinocularRig(path, rig);
  EXPECT_EQ(contentOf(path).rfind("%YAML:1.0\n---\nwidth: 1024\n", 0), 0u);
  const TrinocularRig read = loadTrinocularRig(path);
  EXPECT_EQ(read.width, rig.width);
  EXPECT_EQ(read.height, rig.height);
  EXPECT_EQ(read.focal_length, rig.focal_length);
  EXPECT_EQ(read.center_x, rig.center_x);
  EXPECT_EQ(read.center_y, rig.center_y);
  EXPECT_EQ(read.baseline_horizontal, rig.baseline_horizontal);
  EXPECT_EQ(read.baseline_vertical, rig.baseline_vertical);
  EXPECT_EQ(read.disparity_sigma, rig.disparity_sigma);
}

std::string
rigText(const std::string& focal_length, const std::string& more = "")
{
  return "%YAML:1.0\n---\nwidth: 640\nheight: 480\nfocal_length: " + focal_length +
         "\ncenter_x: 320.\ncenter_y: 240.\nbaseline_horizontal: -1.0e-01\n"
         "baseline_vertical: 0.\ndisparity_sigma: 0.13\n" +
         more;
}

TEST(TrinocularRig, ReadsWhatACalibrationWrites)
{
  const TemporaryFolder folder;
  const std::string matrix = "camera_right: !!opencv-matrix\n   rows: 3\n   cols: 3\n"
                             "   dt: d\n   data: [ 520., 0., 320., 0., 520., 240.,\n"
                             "       0., 0., 1. ]\n";
  const TrinocularRig rig =
      loadTrinocularRig(folder.write("rig.yaml", rigText("5.2e+02", matrix)));
  EXPECT_EQ(rig.focal_length, 520.0);
  EXPECT_EQ(rig.center_x, 320.0);
}

std::string
faultOfRig(const std::string& text)
{
  const TemporaryFolder folder;
  return messageOf<InputFileException>(
      [&] { loadTrinocularRig(folder.write("rig.yaml", text)); });
}

TEST(TrinocularRig, NonsenseIsRefusedByFileKeyAndValue)
{
  for (const char* value : {"-520", "0", ".nan", ".inf", "wide", "1e300", "[1]", "~"}) {
    const std::string fault = faultOfRig(rigText(value));
    EXPECT_THAT(fault, HasSubstr("rig.yaml: line 5"));
    EXPECT_THAT(fault, HasSubstr("focal_length: ")) << value;
  }
  EXPECT_THAT(faultOfRig(rigText("-520")), HasSubstr("'-520'"));
  EXPECT_THAT(faultOfRig("width: 640\n"), HasSubstr("'height' is missing"));
  EXPECT_THAT(faultOfRig("width: 1000000\n"), HasSubstr("width: '1000000'"));
  EXPECT_THAT(faultOfRig("width: 2.5\n"), HasSubstr("width: '2.5'"));
}

TEST(TrinocularRig, NonsenseIsNotWritten)
{
  const TemporaryFolder folder;
  TrinocularRig rig;
  rig.focal_length = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(saveTrinocularRig(folder.path("rig.yaml"), rig), BadArgumentException);
  rig = {};
  rig.height = 0;
  EXPECT_THROW(saveTrinocularRig(folder.path("rig.yaml"), rig), BadArgumentException);
  EXPECT_THROW(saveTrinocularRig(folder.path("none/rig.yaml"), {}),
               OutputFileException);
  EXPECT_EQ(folder.count(), 0);
}

} // namespace
} // namespace pcl::acmap::test
