#include "temporary_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/pipeline/stage_store.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>
#include <optional>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

StageKey
keyOf(const std::string& value)
{
  StageKey key;
  key.add("option", value);
  return key;
}

const StageNotes notes = {R"({"points":7})", {"a remark"}};

class StageStores : public testing::Test {
protected:
  StageStore
  store() const
  {
    return StageStore(folder_.path("stages"));
  }

  std::optional<StageNotes>
  found(const std::string& value = "1") const
  {
    return store().find("a", keyOf(value));
  }

  OpenStage
  begin(const std::string& value = "1") const
  {
    return store().begin("a", keyOf(value));
  }

  /** \brief A stage whose results are outside of the store. */
  OpenStage
  beginOuter(const std::string& value = "1") const
  {
    return store().begin("a", keyOf(value), folder_.path(""));
  }

  bool
  isOuterFound(const std::string& value = "1") const
  {
    return store().find("a", keyOf(value), folder_.path("")).has_value();
  }

  void
  makeStage() const
  {
    OpenStage stage = begin();
    folder_.write("stages/a/result.txt", "whole");
    stage.finish(notes);
  }

  TemporaryFolder folder_;
};

TEST_F(StageStores, WhatIsFinishedIsTaken)
{
  EXPECT_FALSE(found());
  OpenStage stage = begin();
  EXPECT_FALSE(found());
  folder_.write("stages/a/result.txt", "whole");
  stage.finish(notes);
  ASSERT_TRUE(found());
  EXPECT_EQ(found()->told, notes.told);
  EXPECT_EQ(found()->remarks, notes.remarks);
  EXPECT_FALSE(found("2"));
  StageKey more = keyOf("1");
  more.add("more", "0");
  EXPECT_FALSE(store().find("a", more));
}

TEST_F(StageStores, ChangedResultsAreNot)
{
  makeStage();
  const fs::path result = folder_.path("stages/a/result.txt");
  const auto time = fs::last_write_time(result);
  fs::last_write_time(result, time + std::chrono::nanoseconds(1));
  EXPECT_FALSE(found());
  fs::last_write_time(result, time);
  EXPECT_TRUE(found());
  folder_.write("stages/a/result.txt", "longer than before");
  fs::last_write_time(result, time);
  EXPECT_FALSE(found());
  fs::remove(result);
  EXPECT_FALSE(found());
}

TEST_F(StageStores, NamesThatAreNoTextDoNoHarm)
{
  begin("caf\xe9").finish(notes);
  EXPECT_TRUE(found("caf\xe9"));
}

TEST_F(StageStores, AnInterruptedRunGoesOn)
{
  begin().keepParts();
  folder_.write("stages/a/part.txt", "finished part");
  begin().keepParts();
  EXPECT_TRUE(fs::exists(folder_.path("stages/a/part.txt")));
  begin("2").keepParts();
  EXPECT_FALSE(fs::exists(folder_.path("stages/a/part.txt")));
}

TEST_F(StageStores, FilesOfOthersAreNotDeleted)
{
  makeStage();
  folder_.write("stages/a/mine.txt", "mine");
  EXPECT_TRUE(found());
  EXPECT_THROW(begin("2"), OutputFileException);
  EXPECT_TRUE(fs::exists(folder_.path("stages/a/mine.txt")));
  EXPECT_TRUE(found());
  fs::remove(folder_.path("stages/a/stage.json"));
  EXPECT_THROW(begin(), OutputFileException);
  EXPECT_TRUE(fs::exists(folder_.path("stages/a/mine.txt")));
  EXPECT_TRUE(fs::exists(folder_.path("stages/a/result.txt")));
}

TEST_F(StageStores, OneThatIsNotFinishedIsGone)
{
  begin();
  EXPECT_FALSE(fs::exists(folder_.path("stages")));
  {
    const OpenStage stage = begin();
    fs::create_directory(folder_.path("stages/b"));
  }
  EXPECT_FALSE(fs::exists(folder_.path("stages/a")));
  EXPECT_TRUE(fs::exists(folder_.path("stages/b")));
}

TEST_F(StageStores, ResultsElsewhereWithoutSuccessorAreRemoved)
{
  OpenStage first = beginOuter();
  for (const char* name : {"map", "old", "changed"})
    folder_.write(name, "first");
  folder_.write("mine", "mine");
  first.setResults({"map", "old", "changed"});
  first.finish(notes);
  ASSERT_TRUE(isOuterFound());

  beginOuter("2"); // interrupted, and started again
  OpenStage second = beginOuter("2");
  EXPECT_TRUE(fs::exists(folder_.path("old")));
  folder_.write("map", "second");
  folder_.write("changed", "by somebody");
  second.setResults({"map"});
  EXPECT_EQ(second.finish(notes), std::vector<std::string>{"old"});
  EXPECT_TRUE(isOuterFound("2"));
  EXPECT_FALSE(fs::exists(folder_.path("old")));
  for (const char* name : {"map", "changed", "mine"})
    EXPECT_TRUE(fs::exists(folder_.path(name))) << name;
}

TEST_F(StageStores, DamagedNotesAreThoseOfNoRun)
{
  makeStage();
  const std::string whole = contentOf(folder_.path("stages/a/stage.json"));
  for (std::size_t size = 0; size < whole.size() - 2; size += 5) {
    folder_.write("stages/a/stage.json", whole.substr(0, size));
    EXPECT_FALSE(found()) << size;
  }
  for (const char* name : {"made_of", "finished", "results", "told", "remarks"})
    for (const Json& value : {Json(), Json("x"), Json(3), Json::array({3})}) {
      Json json = Json::parse(whole);
      json[name] = value;
      folder_.write("stages/a/stage.json", json.dump());
      EXPECT_FALSE(found()) << name << value;
      EXPECT_NO_THROW(begin()) << name << value;
      EXPECT_FALSE(fs::exists(folder_.path("stages/a/result.txt"))) << name << value;
      makeStage();
    }
}

TEST_F(StageStores, WhatIsToldIsAnObject)
{
  for (const char* told : {"7", "[]", "{", "text"})
    EXPECT_THROW(begin().finish({told, {}}), BadArgumentException) << told;
  begin().finish({"", {}});
  EXPECT_EQ(found()->told, "{}");
}

/** \brief Poses whose rotations have more digits than a file keeps. */
EstimatedPoses
unroundedPoses()
{
  EstimatedPoses poses;
  for (std::size_t i = 0; i < 50; ++i) {
    const double angle = 0.1 + 0.37 * static_cast<double>(i);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.rotate(Eigen::AngleAxisd(angle, Eigen::Vector3d(0.3, 1, -0.2).normalized()));
    pose.translation() << angle / 3, 1 / angle, -angle;
    poses.places.push_back(i);
    poses.trajectory.stamps.push_back(angle);
    poses.trajectory.poses.push_back(pose);
  }
  return poses;
}

void
expectSame(const Trajectory& a, const Trajectory& b)
{
  ASSERT_EQ(a.poses.size(), b.poses.size());
  for (std::size_t i = 0; i < a.poses.size(); ++i)
    EXPECT_EQ(a.poses[i].matrix(), b.poses[i].matrix()) << i;
}

TEST_F(StageStores, PosesHaveTheSameBitsInMemoryAndInFiles)
{
  const EstimatedPoses poses = unroundedPoses();
  OpenStage in_memory = StageStore().begin("a", keyOf("1"));
  OpenStage in_files = begin();
  const EstimatedPoses kept = in_memory.put(poses);
  expectSame(kept.trajectory, in_files.put(poses).trajectory);
  const Trajectory before = in_files.put("before.txt", poses.trajectory);
  in_files.finish(notes);
  expectSame(kept.trajectory, store().poses("a").trajectory);
  expectSame(before, loadTrajectory(store().path("a", "before.txt")));
  EXPECT_THROW(store().poses("b"), InputFileException);
}

TEST(FilesState, ChangesWithSizeAndTime)
{
  const TemporaryFolder folder;
  folder.write("b", "12345");
  folder.write("a", "");
  folder.write(".hidden", "");
  fs::create_directory(folder.path("c"));
  EXPECT_EQ(filesIn(folder.path("")), (std::vector<std::string>{"a", "b"}));
  EXPECT_THROW(filesIn(folder.path("none")), InputFileException);
  const std::string state = stateOf(folder.path(""), {"a", "b"});
  EXPECT_EQ(stateOf(folder.path(""), {"a", "b"}), state);
  EXPECT_NE(stateOf(folder.path(""), {"b"}), state);
  EXPECT_NE(stateOf(folder.path(""), {"a", "none"}), state);
  const auto time = fs::last_write_time(folder.path("b"));
  folder.write("b", "1234567");
  fs::last_write_time(folder.path("b"), time);
  EXPECT_NE(stateOf(folder.path(""), {"a", "b"}), state);
}

TEST(Keys, DifferByNameAndValue)
{
  StageKey other;
  other.add("opt", "ion1");
  EXPECT_EQ(keyOf("1").fingerprint(), keyOf("1").fingerprint());
  EXPECT_NE(keyOf("1").fingerprint(), keyOf("2").fingerprint());
  EXPECT_NE(keyOf("1").fingerprint(), other.fingerprint());
  EXPECT_EQ(other.fingerprint().size(), 16U);
}

} // namespace
} // namespace pcl::acmap::test
