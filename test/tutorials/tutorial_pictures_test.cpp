#include "temporary_folder.h"
#include "tutorial_run.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;

std::map<std::string, RgbImage>
committedPictures()
{
  std::map<std::string, RgbImage> pictures;
  for (const auto& entry : fs::directory_iterator(ACMAP_TUTORIAL_PICTURES))
    pictures.emplace(entry.path().filename(), loadRgbImage(entry.path()));
  return pictures;
}

/** \brief The picture as if nothing had been drawn: its most frequent colour. */
RgbImage
emptied(RgbImage picture)
{
  using Color = std::array<std::uint8_t, 3>;
  std::map<Color, std::size_t> counts;
  for (std::size_t i = 0; i < picture.values.size(); i += 3)
    ++counts[{picture.values[i], picture.values[i + 1], picture.values[i + 2]}];
  const Color background =
      std::max_element(counts.begin(), counts.end(), [](const auto& a, const auto& b) {
        return a.second < b.second;
      })->first;
  for (std::size_t i = 0; i < picture.values.size(); ++i)
    picture.values[i] = background[i % 3];
  return picture;
}

RgbImage
mirrored(const RgbImage& picture)
{
  RgbImage result = picture;
  for (std::int32_t row = 0; row < picture.height; ++row)
    for (std::int32_t column = 0; column < picture.width; ++column)
      std::copy_n(
          picture.at(picture.width - 1 - column, row), 3, result.at(column, row));
  return result;
}

/** A wrong picture must not be accepted in place of one that tutorials show. */
TEST(TutorialPictures, NoneIsLikeAnEmptyOrAnotherOne)
{
  const auto pictures = committedPictures();
  ASSERT_GE(pictures.size(), 7u);
  for (const auto& [name, picture] : pictures) {
    EXPECT_EQ(pictureDifference(picture, picture), 0) << name;
    EXPECT_GT(pictureDifference(picture, emptied(picture)), 2 * picture_tolerance)
        << name;
    EXPECT_GT(pictureDifference(picture, mirrored(picture)), 2 * picture_tolerance)
        << name;
    for (const auto& [other_name, other] : pictures) {
      if (other_name == name || other.values.size() != picture.values.size())
        continue;
      EXPECT_GT(pictureDifference(picture, other), 2 * picture_tolerance)
          << name << ", " << other_name;
    }
  }
}

TEST(TutorialPictures, EachIsShownByATutorial)
{
  std::set<std::string> shown, committed;
  for (const auto& entry : fs::directory_iterator(ACMAP_TUTORIALS))
    for (const auto& [name, picture] : committedPictures())
      if (contentOf(entry.path()).find("tutorials/" + name) != std::string::npos)
        shown.insert(name);
  for (const auto& [name, picture] : committedPictures())
    committed.insert(name);
  EXPECT_EQ(shown, committed);
}

TEST(TutorialPictures, WrongOrMissingOnesAreRefused)
{
  const TemporaryFolder made, committed;
  const TutorialPage page =
      parseTutorial("```sh\ntrue\n```\n![a](../pictures/tutorials/a.png)\n");
  const auto compare = [&] {
    comparePictures(page, made.path(""), committed.path(""));
  };
  const auto grey = [](std::uint8_t level, std::int32_t width) {
    return RgbImage{
        width,
        4,
        std::vector<std::uint8_t>(static_cast<std::size_t>(12 * width), level)};
  };
  savePng(committed.path("a.png"), grey(100, 8));
  EXPECT_THROW(compare(), InputFileException);
  savePng(made.path("a.png"), grey(101, 8));
  EXPECT_NO_THROW(compare());
  savePng(made.path("a.png"), grey(103, 8));
  EXPECT_THROW(compare(), std::runtime_error);
  savePng(made.path("a.png"), grey(100, 9));
  EXPECT_THROW(compare(), std::runtime_error);
}

} // namespace
} // namespace pcl::acmap::test
