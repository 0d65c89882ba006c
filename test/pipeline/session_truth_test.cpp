#include "messages.h"
#include "truth_room.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <utility>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

/** Error message for an invalid truth; empty if it is accepted. */
std::string
faultOf(const RoomSession& session)
{
  return messageOf<InputFileException>([&] { session.load(); });
}

std::string
replaced(std::string text, const std::string& before, const std::string& after)
{
  text.replace(text.find(before), before.size(), after);
  return text;
}

TEST(SessionTruth, HasPlanesAndWay)
{
  const SessionTruth truth = RoomSession().load();
  ASSERT_EQ(truth.planes.size(), 6u);
  EXPECT_EQ(truth.planes[1].name, "left wall");
  EXPECT_EQ(truth.planes[1].coefficients, Eigen::Vector4d(1, 0, 0, 2));
  EXPECT_EQ(truth.planes[1].points, 3000u);
  EXPECT_EQ(truth.planes[1].rectangles.size(), 2u);
  EXPECT_EQ(truth.trajectory.poses.size(), 5u);
  EXPECT_EQ(truth.mainPlanes(), (std::vector<std::size_t>{0, 1, 2, 3}));
}

class UglyTruth : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(UglyTruth, IsRefusedWithItsPlace)
{
  const auto& [before, after] = GetParam();
  const RoomSession session(replaced(roomTruth(), before, after));
  EXPECT_THAT(faultOf(session), HasSubstr("truth.json: "));
}

INSTANTIATE_TEST_SUITE_P(
    SessionTruth,
    UglyTruth,
    testing::Values(std::pair{"\"planes\"", "\"plans\""},
                    std::pair{"\"points\": 3000,", ""},
                    std::pair{"\"points\": 3000", "\"points\": -1"},
                    std::pair{"\"points\": 3000", "\"points\": 1e300"},
                    std::pair{"\"points\": 3000", "\"points\": null"},
                    std::pair{"\"name\": \"floor\",", ""},
                    std::pair{"[0.0, -1.0, 0.0, 1.25]", "[0.0, -1.0, 0.0]"},
                    std::pair{"[0.0, -1.0, 0.0, 1.25]", "[0.0, -0.5, 0.0, 1.25]"},
                    std::pair{"[0.0, -1.0, 0.0, 1.25]", "[0.0, -1.0, 0.0, null]"},
                    std::pair{"[0.0, -1.0, 0.0, 1.25]", "[0.0, -1.0, 0.0, .nan]"},
                    std::pair{"[0.0, -1.0, 0.0, 1.25]", "{\"a\": 1}"},
                    std::pair{"[-2.0, 1.25, 0.0], [2.0, 1.25, 0.0]",
                              "[-2.0, 1.25, 0.0]"},
                    std::pair{"[-2.0, 1.25, 0.0], [2.0, 1.25, 0.0]",
                              "[-2.0, 1.25, 0.0], [-2.0, 1.25, 0.0]"},
                    std::pair{"[-2.0, 1.25, 0.0], [2.0, 1.25, 0.0]",
                              "[-2.0, 1.25, 0.0], [2.0, 1.25, 9.0]"},
                    std::pair{"[-2.0, 1.25, 0.0], [2.0, 1.25, 0.0]",
                              "[-2.0, 1.25, 0.0], [2.0, 1.25, 1e9]"},
                    std::pair{"]}\n]}", "]}\n"},
                    std::pair{"{\"version\"", "\"version\""}));

TEST(SessionTruth, WithoutFilesIsRefused)
{
  for (const char* name : {"truth.json", "trajectory.txt"}) {
    const RoomSession session;
    std::filesystem::remove(session.path(name));
    EXPECT_THAT(faultOf(session), HasSubstr(name));
    std::ofstream(session.path(name)).close();
    EXPECT_THAT(faultOf(session), HasSubstr(name)) << "empty";
    std::ofstream(session.path(name)) << std::string(100, '\0');
    EXPECT_THAT(faultOf(session), HasSubstr(name)) << "zeros";
    std::filesystem::remove(session.path(name));
    std::filesystem::create_directory(session.path(name));
    EXPECT_THAT(faultOf(session), HasSubstr(name)) << "a folder";
  }
}

TEST(SessionTruth, OfWhichNothingCanBeMeasuredIsRefused)
{
  std::string text = roomTruth();
  for (const char* points : {"3000", "3000", "3000", "100", "80"})
    text = replaced(text, "\"points\": " + std::string(points), "\"points\": 0");
  EXPECT_THAT(faultOf(RoomSession(text)), HasSubstr("none of its planes has points"));
  EXPECT_THAT(faultOf(RoomSession("{\"planes\": []}\n")), HasSubstr("truth.json: "));
}

} // namespace
} // namespace pcl::acmap::test
