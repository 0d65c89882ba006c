#include "temporary_folder.h"
#include "tool_cases.h"

#include <gtest/gtest.h>

#include <unistd.h>

namespace pcl::acmap::test {
namespace {

class OutputFault : public testing::Test {
protected:
  TemporaryFolder folder_;
  std::string input_ = folder_.write("in.pcd", planePcd());
};

TEST_F(OutputFault, FolderIsMissing)
{
  expectRefused(runSurface({input_, folder_.path("none/out.ply")}), 5, "none");
  expectRefused(
      runViewer({input_, "--screenshot", folder_.path("none/out.png")}), 5, "none");
  expectRefused(
      runSurface(
          {input_, folder_.path("out.ply"), "--report", folder_.path("none/r.json")}),
      5,
      "none");
  expectRefused(runPlanes({input_, folder_.path("none/out.json")}), 5, "none");
  for (const auto& [option, name] : {std::pair{"--labels", "none/out.pcd"},
                                     {"--normals", "none/out.ply"},
                                     {"--picture", "none/out.png"},
                                     {"--report", "none/r.json"}})
    expectRefused(
        runPlanes({input_, folder_.path("out.json"), option, folder_.path(name)}),
        5,
        "none");
  EXPECT_EQ(folder_.count(), 1);
}

TEST_F(OutputFault, EndingIsUnknown)
{
  expectRefused(runSurface({input_, folder_.path("out.stl")}), 5, ".ply or .vtk");
  expectRefused(
      runViewer({input_, "--screenshot", folder_.path("out.jpg")}), 5, ".png");
  expectRefused(runPlanes({input_, folder_.path("out.yaml")}), 5, ".json");
  for (const auto& [option, name, ending] : {std::tuple{"--labels", "out.ply", ".pcd"},
                                             {"--normals", "out.obj", ".ply"},
                                             {"--picture", "out.jpg", ".png"}})
    expectRefused(
        runPlanes({input_, folder_.path("out.json"), option, folder_.path(name)}),
        5,
        ending);
  EXPECT_EQ(folder_.count(), 1);
}

TEST_F(OutputFault, FolderIsReadOnly)
{
  if (geteuid() == 0)
    GTEST_SKIP() << "the superuser may write everywhere";
  const std::string closed = folder_.path("closed");
  std::filesystem::create_directory(closed);
  std::filesystem::permissions(closed, std::filesystem::perms::owner_read);
  expectRefused(runSurface({input_, closed + "/out.ply"}), 5, "permission");
}

TEST_F(OutputFault, OutputIsTheInput)
{
  const std::string mesh = folder_.path("mesh.ply");
  runSurface({input_, mesh}).succeeded();
  const std::string before = contentOf(mesh);
  expectRefused(runSurface({mesh, mesh}), 2, mesh);
  EXPECT_EQ(contentOf(mesh), before);
  expectRefused(
      runPlanes({mesh, folder_.path("out.json"), "--normals", mesh}), 2, mesh);
  expectRefused(
      runPlanes({input_, folder_.path("out.json"), "--labels", input_}), 2, input_);
  expectRefused(
      runPlanes({input_, folder_.path("r.json"), "--report", folder_.path("r.json")}),
      2,
      "r.json");
  EXPECT_EQ(contentOf(mesh), before);
  EXPECT_EQ(folder_.count(), 2);
}

TEST_F(OutputFault, DiskIsFullAndTheOldFileStays)
{
  RunSettings full;
  full.file_size_limit = 4096;
  for (const char* name : {"out.ply", "out.vtk"}) {
    expectRefused(runSurface({input_, folder_.path(name)}, full), 5, name);
    EXPECT_EQ(folder_.count(), 1);
  }
  const std::string old = folder_.write("out.ply", "what stood here before");
  expectRefused(runSurface({input_, old}, full), 5, old);
  EXPECT_EQ(contentOf(old), "what stood here before");
  EXPECT_EQ(folder_.count(), 2);
}

TEST_F(OutputFault, MemoryIsShort)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need address space of their own";
#endif
  const std::string large = folder_.write("large.pcd", planePcd(400));
  RunSettings small;
  small.memory_limit = std::size_t{48} << 20;
  const ToolRun run = runSurface({large, folder_.path("out.ply")}, small);
  if (run.exit_code == 127)
    GTEST_SKIP() << "the program does not even start in so little memory";
  expectRefused(run, 6, "memory");
  EXPECT_EQ(folder_.count(), 2);
}

} // namespace
} // namespace pcl::acmap::test
