#include "fingerprint.h"
#include "temporary_folder.h"

#include <pcl/core/random.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<double>
someNumbers()
{
  Random random(3);
  std::vector<double> numbers(5000);
  for (double& number : numbers)
    number = random.uniform(-2, 3);
  return numbers;
}

bool
isNoticed(const std::vector<double>& changed)
{
  return !NumberSummary(NumberSummary(changed).json())
              .agreesWith(NumberSummary(NumberSummary(someNumbers()).json()));
}

TEST(Fingerprint, AnotherDecisionIsNoticed)
{
  EXPECT_FALSE(isNoticed(someNumbers()));
  auto one_other = someNumbers();
  one_other[1234] += 1;
  EXPECT_TRUE(isNoticed(one_other));
  auto one_less = someNumbers();
  one_less.pop_back();
  EXPECT_TRUE(isNoticed(one_less));
  auto one_unknown = someNumbers();
  one_unknown[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(isNoticed(one_unknown));
  auto moved = someNumbers();
  std::rotate(moved.begin(), moved.begin() + 1, moved.end());
  EXPECT_TRUE(isNoticed(moved)) << "the same numbers in another order";
}

TEST(Fingerprint, LastBitsAreNot)
{
  Random random(5);
  auto numbers = someNumbers();
  for (double& number : numbers)
    number *= 1 + random.uniform(-2e-7, 2e-7);
  EXPECT_FALSE(isNoticed(numbers));
  const std::vector<double> same(10, 4.2);
  auto nearly = same;
  nearly[3] = std::nextafter(4.2, 5.0);
  EXPECT_TRUE(NumberSummary(nearly).agreesWith(NumberSummary(same)));
}

TEST(Fingerprint, DifferencesAreTold)
{
  const FileNumbers before = {{"a.pcd x", {1, 2}}, {"b.json /n", {1}}};
  const FileNumbers after = {{"a.pcd x", {1, 3}}, {"c.txt numbers", {}}};
  const auto stored = fingerprintOf(before);
  EXPECT_THAT(differencesOf(stored, stored), IsEmpty());
  EXPECT_THAT(differencesOf(fingerprintOf(after), stored),
              ElementsAre(HasSubstr("a.pcd x: [2,0,2.0,"),
                          "b.json /n: is not there",
                          HasSubstr("c.txt numbers: [0,0,0.0,0.0,0.0], not stored")));
}

TEST(FileNumbers, AreThoseOfEachKind)
{
  const TemporaryFolder folder;
  folder.write("points_07.xyz.txt", "1 2.5 nan\nhead: [4]\n");
  folder.write("planes.json", R"({"n": [1, [2, 3]], "on": true, "name": "4"})");
  folder.write("report.json", R"({"seconds": 3})");
  folder.write("box.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const FileNumbers numbers = numbersIn(folder.path(""));
  ASSERT_EQ(numbers.size(), 8U);
  EXPECT_THAT(numbers.at("points_#.xyz.txt numbers"),
              ElementsAre(1, 2.5, testing::IsNan(), 4));
  EXPECT_THAT(numbers.at("planes.json /n/#"), ElementsAre(1));
  EXPECT_THAT(numbers.at("planes.json /n/#/#"), ElementsAre(2, 3));
  EXPECT_THAT(numbers.at("planes.json /on"), ElementsAre(1));
  EXPECT_THAT(numbers.at("box.obj x"), ElementsAre(0, 1, 0));
  EXPECT_THAT(numbers.at("box.obj faces"), ElementsAre(0, 1, 2));
  folder.write("what.bin", "?");
  EXPECT_THROW(numbersIn(folder.path("")), std::runtime_error);
}

} // namespace
} // namespace pcl::acmap::test
