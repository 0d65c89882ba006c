#include "compact_mapping/stage_folder.h"
#include "temporary_folder.h"

#include <pcl/core/exceptions.h>

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

class StageFolders : public testing::Test {
protected:
  StageFolder
  stage(const Json& made_of = {{"option", 1}}) const
  {
    return {folder_.path("stages/a"), made_of};
  }

  /** \brief A folder whose results are outside of it. */
  StageFolder
  outer(const Json& made_of = {{"option", 1}}) const
  {
    return {folder_.path("stages/a"), made_of, folder_.path("")};
  }

  StageLog
  told() const
  {
    StageLog told;
    told.lines = {{"points", "7"}};
    return told;
  }

  void
  makeStage() const
  {
    stage().begin();
    folder_.write("stages/a/result.txt", "whole");
    stage().finish(told());
  }

  TemporaryFolder folder_;
};

TEST_F(StageFolders, WhatIsFinishedIsTaken)
{
  EXPECT_FALSE(stage().finished());
  stage().begin();
  EXPECT_FALSE(stage().finished());
  folder_.write("stages/a/result.txt", "whole");
  stage().finish(told());
  ASSERT_TRUE(stage().finished());
  EXPECT_EQ(stage().finished()->lines, told().lines);
  EXPECT_FALSE(stage({{"option", 2}}).finished());
  EXPECT_FALSE(stage({{"option", 1}, {"more", 0}}).finished());
}

TEST_F(StageFolders, ChangedResultsAreNot)
{
  makeStage();
  const fs::path result = folder_.path("stages/a/result.txt");
  const auto time = fs::last_write_time(result);
  fs::last_write_time(result, time + std::chrono::nanoseconds(1));
  EXPECT_FALSE(stage().finished());
  fs::last_write_time(result, time);
  EXPECT_TRUE(stage().finished());
  folder_.write("stages/a/result.txt", "longer than before");
  fs::last_write_time(result, time);
  EXPECT_FALSE(stage().finished());
  fs::remove(result);
  EXPECT_FALSE(stage().finished());
}

TEST_F(StageFolders, NamesThatAreNoTextDoNoHarm)
{
  const Json odd = {{"input", "caf\xe9"}};
  stage(odd).begin();
  stage(odd).finish(told());
  EXPECT_TRUE(stage(odd).finished());
}

TEST_F(StageFolders, AnInterruptedRunGoesOn)
{
  stage().begin();
  folder_.write("stages/a/part.txt", "finished part");
  stage().begin();
  EXPECT_TRUE(fs::exists(folder_.path("stages/a/part.txt")));
  stage({{"option", 2}}).begin();
  EXPECT_FALSE(fs::exists(folder_.path("stages/a/part.txt")));
}

TEST_F(StageFolders, FilesOfOthersAreNotDeleted)
{
  makeStage();
  folder_.write("stages/a/mine.txt", "mine");
  EXPECT_TRUE(stage().finished());
  EXPECT_THROW(stage({{"option", 2}}).begin(), OutputFileException);
  EXPECT_TRUE(fs::exists(folder_.path("stages/a/mine.txt")));
  EXPECT_TRUE(stage().finished());
  fs::remove(folder_.path("stages/a/stage.json"));
  EXPECT_THROW(stage().begin(), OutputFileException);
  EXPECT_TRUE(fs::exists(folder_.path("stages/a/mine.txt")));
  EXPECT_TRUE(fs::exists(folder_.path("stages/a/result.txt")));
}

TEST_F(StageFolders, AnAbandonedOneIsGone)
{
  stage().begin();
  stage().abandon();
  EXPECT_FALSE(fs::exists(folder_.path("stages")));
  stage().begin();
  fs::create_directory(folder_.path("stages/b"));
  stage().abandon();
  EXPECT_FALSE(fs::exists(folder_.path("stages/a")));
  EXPECT_TRUE(fs::exists(folder_.path("stages/b")));
}

TEST_F(StageFolders, ResultsElsewhereWithoutSuccessorAreRemoved)
{
  outer().begin();
  for (const char* name : {"map", "old", "changed"})
    folder_.write(name, "first");
  folder_.write("mine", "mine");
  outer().finish(told(), {"map", "old", "changed"});
  ASSERT_TRUE(outer().finished());

  const Json other = {{"option", 2}};
  outer(other).begin();
  outer(other).abandon(); // interrupted, and started again
  outer(other).begin();
  EXPECT_TRUE(fs::exists(folder_.path("old")));
  folder_.write("map", "second");
  folder_.write("changed", "by somebody");
  outer(other).finish(told(), {"map"});
  EXPECT_TRUE(outer(other).finished());
  EXPECT_FALSE(fs::exists(folder_.path("old")));
  for (const char* name : {"map", "changed", "mine"})
    EXPECT_TRUE(fs::exists(folder_.path(name))) << name;
}

TEST_F(StageFolders, DamagedNotesAreThoseOfNoRun)
{
  makeStage();
  const std::string notes = folder_.path("stages/a/stage.json");
  const std::string whole = contentOf(notes);
  for (std::size_t size = 0; size < whole.size() - 2; size += 5) {
    folder_.write("stages/a/stage.json", whole.substr(0, size));
    EXPECT_FALSE(stage().finished()) << size;
  }
  for (const char* name : {"made_of", "finished", "results", "told"})
    for (const Json& value : {Json(), Json("x"), Json(3), Json::array({3})}) {
      Json json = Json::parse(whole);
      json[name] = value;
      folder_.write("stages/a/stage.json", json.dump());
      EXPECT_FALSE(stage().finished()) << name << value;
      EXPECT_NO_THROW(stage().begin()) << name << value;
      EXPECT_FALSE(fs::exists(folder_.path("stages/a/result.txt"))) << name << value;
      makeStage();
    }
}

TEST(FilesState, TellsNameSizeAndTime)
{
  const TemporaryFolder folder;
  folder.write("b", "12345");
  folder.write("a", "");
  folder.write(".hidden", "");
  fs::create_directory(folder.path("c"));
  EXPECT_EQ(filesIn(folder.path("")), (std::vector<std::string>{"a", "b"}));
  EXPECT_THROW(filesIn(folder.path("none")), InputFileException);
  const Json state = stateOf(folder.path(""), {"b", "none"});
  EXPECT_EQ(state[0][0], "b");
  EXPECT_EQ(state[0][1], 5);
  EXPECT_EQ(state[0].size(), 3u);
  EXPECT_EQ(state[1], Json::array({"none"}));
}

TEST(Fingerprint, DiffersAndStays)
{
  EXPECT_EQ(fingerprint(Json::object()), fingerprint(Json::object()));
  EXPECT_NE(fingerprint({{"a", 1}}), fingerprint({{"a", 2}}));
  EXPECT_EQ(fingerprint("a").size(), 16u);
}

} // namespace
} // namespace pcl::acmap::test
