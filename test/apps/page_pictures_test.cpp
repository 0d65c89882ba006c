#include "compact_mapping/report_page.h"
#include "html_checker.h"
#include "temporary_folder.h"

#include <pcl/core/image_file.h>

#include <gmock/gmock.h>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string
base64Of(const std::string& text)
{
  return base64({text.begin(), text.end()});
}

TEST(Base64, IsThatOfTheStandard)
{
  EXPECT_EQ(base64Of(""), "");
  EXPECT_EQ(base64Of("f"), "Zg==");
  EXPECT_EQ(base64Of("fo"), "Zm8=");
  EXPECT_EQ(base64Of("foo"), "Zm9v");
  EXPECT_EQ(base64Of("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64({0xFB, 0xEF, 0xFF, 0x00}), "++//AA==");
}

TEST(PictureFigure, HoldsThePicture)
{
  const TemporaryFolder folder;
  const RgbImage image = {4, 3, std::vector<std::uint8_t>(36, 200)};
  savePng(folder.path("a.png"), image);
  const std::string figure = pictureFigure(folder.path("a.png"), "a.png", "a \"b\"");
  EXPECT_EQ(htmlFault(figure), "");
  EXPECT_THAT(figure, HasSubstr("width=\"4\" height=\"3\" alt=\"a &quot;b&quot;\""));
  EXPECT_THAT(
      figure,
      HasSubstr("src=\"data:image/png;base64," + base64(encodePng(image)) + "\""));
  EXPECT_THAT(figure, HasSubstr("<figcaption>a &quot;b&quot;</figcaption>"));
  EXPECT_THAT(pictureFigure(folder.path("a.png"), "a.png", ""),
              HasSubstr("<figcaption>a.png</figcaption>"));
}

TEST(PictureFigure, SaysWhatIsMissingOrDamaged)
{
  const TemporaryFolder folder;
  const RgbImage image = {40, 30, std::vector<std::uint8_t>(3600, 200)};
  savePng(folder.path("whole.png"), image);
  const std::string bytes = contentOf(folder.path("whole.png"));
  folder.write("cut.png", bytes.substr(0, bytes.size() / 2));
  folder.write("text.png", "no picture");
  // a picture, but not in a format for browsers
  folder.write("grey.png", "P5 1 1 255\n7");
  for (const char* name : {"none.png", "cut.png", "text.png", "grey.png", ""}) {
    const std::string figure = pictureFigure(folder.path(name), "<n>", "It");
    EXPECT_EQ(htmlFault(figure), "") << name;
    EXPECT_THAT(figure, HasSubstr("&lt;n&gt; is missing or damaged")) << name;
    EXPECT_THAT(figure, Not(HasSubstr("<img"))) << name;
  }
}

} // namespace
} // namespace pcl::acmap::test
