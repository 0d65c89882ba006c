#include "mesh_speed_tables.h"

#include "markdown_row.h"
#include "temporary_folder.h"
#include "timing.h"

#include <pcl/conversions.h>
#include <pcl/core/mesh_file.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_cloud_writer.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdio>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <stdexcept>

namespace pcl::acmap::bench {
namespace {

using Action = std::function<void()>;

/** An open file for plain reads or writes. */
class PlainFile {
public:
  PlainFile(const std::string& path, const char* mode)
  : file_(std::fopen(path.c_str(), mode))
  {
    if (!file_)
      throw std::runtime_error("cannot open " + path);
  }

  ~PlainFile()
  {
    std::fclose(file_);
  }

  PlainFile(const PlainFile&) = delete;
  PlainFile&
  operator=(const PlainFile&) = delete;

  void
  read(char* data, std::size_t bytes)
  {
    if (std::fread(data, 1, bytes, file_) != bytes)
      throw std::runtime_error("short read");
  }

  void
  write(const char* data, std::size_t bytes)
  {
    if (std::fwrite(data, 1, bytes, file_) != bytes)
      throw std::runtime_error("short write");
  }

private:
  std::FILE* file_;
};

void
readPlain(const std::string& path)
{
  const std::size_t bytes = std::filesystem::file_size(path);
  const std::unique_ptr<char[]> data(new char[bytes]); // not initialized
  PlainFile(path, "rb").read(data.get(), bytes);
}

void
writePlain(const std::string& path, const std::vector<char>& data)
{
  PlainFile(path, "wb").write(data.data(), data.size());
}

/** Prints a row; both methods are timed in interleaved rounds. */
void
printRow(const std::string& name,
         std::size_t points,
         const std::string& path,
         std::size_t rounds,
         const Action& ours,
         const Action& plain)
{
  std::vector<Cost> our_costs, plain_costs;
  for (std::size_t round = 0; round < rounds; ++round) {
    our_costs.push_back(measureCost(ours));
    plain_costs.push_back(measureCost(plain));
  }
  const Cost our = medianCost(our_costs);
  const Cost bound = medianCost(plain_costs);
  const double each = 1e9 / static_cast<double>(points);
  MarkdownRow()
      .text(name)
      .count(points)
      .number(1e-6 * static_cast<double>(std::filesystem::file_size(path)), 1)
      .number(each * our.wall, 1)
      .number(each * bound.wall, 1)
      .text(timesOf(our.wall, bound.wall))
      .number(each * our.cpu, 1)
      .text(timesOf(our.cpu, bound.cpu))
      .print();
}

void
printLoadRow(const std::string& name,
             std::size_t points,
             const std::string& path,
             std::size_t rounds)
{
  printRow(
      "load " + name,
      points,
      path,
      rounds,
      [&] { loadPointCloud(path); },
      [&] { readPlain(path); });
}

/** Saves once to get the size, then prints the row. */
void
printSaveRow(const std::string& name,
             std::size_t points,
             const std::string& path,
             std::size_t rounds,
             const Action& save)
{
  save();
  const std::string plain_path = path + ".plain";
  const std::vector<char> bytes(std::filesystem::file_size(path), 'x');
  printRow("save " + name, points, path, rounds, save, [&] {
    writePlain(plain_path, bytes);
  });
  std::filesystem::remove(plain_path);
}

void
printCloudRows(const PCLPointCloud2& cloud,
               const test::TemporaryFolder& folder,
               std::size_t rounds)
{
  const std::size_t points = std::size_t{cloud.width} * cloud.height;
  const std::string pcd = folder.path("cloud.pcd");
  const std::string ply = folder.path("cloud.ply");
  printSaveRow("PCD", points, pcd, rounds, [&] { savePointCloud(pcd, cloud); });
  printLoadRow("PCD", points, pcd, rounds);
  std::filesystem::remove(pcd);
  saveTriangleMesh(ply, cloud, TriangleMesh());
  printLoadRow("PLY cloud", points, ply, rounds);
  std::filesystem::remove(ply);
}

/** A square grid with two triangles per cell. */
void
makeGridMesh(std::int32_t cells, PCLPointCloud2& cloud, TriangleMesh& mesh)
{
  PointCloud<PointXYZ> points;
  for (std::int32_t row = 0; row <= cells; ++row)
    for (std::int32_t column = 0; column <= cells; ++column) {
      points.emplace_back(static_cast<float>(column), static_cast<float>(row), 0.0F);
      if (row == cells || column == cells)
        continue;
      const std::int32_t corner = row * (cells + 1) + column;
      const std::int32_t above = corner + cells + 1;
      mesh.triangles.push_back({corner, corner + 1, above});
      mesh.triangles.push_back({corner + 1, above + 1, above});
    }
  toPCLPointCloud2(points, cloud);
}

void
printMeshRows(const test::TemporaryFolder& folder, std::size_t rounds)
{
  PCLPointCloud2 cloud;
  TriangleMesh mesh;
  makeGridMesh(1000, cloud, mesh);
  const std::string ply = folder.path("mesh.ply");
  const std::size_t points = std::size_t{cloud.width} * cloud.height;
  printSaveRow("PLY mesh, two faces a point", points, ply, rounds, [&] {
    saveTriangleMesh(ply, cloud, mesh);
  });
  printLoadRow("points of the PLY mesh", points, ply, rounds);
  printRow(
      "load faces of the PLY mesh",
      points,
      ply,
      rounds,
      [&] { loadTriangleMesh(ply); },
      [&] { readPlain(ply); });
}

} // namespace

void
printFileSpeed(SceneData& corridor, std::size_t rounds)
{
  std::cout << "\n### Files\n";
  printHead({"what",
             "points",
             "file, MB",
             "wall ns a point",
             "plain fread or fwrite",
             "takes",
             "CPU ns a point",
             "takes, CPU"});
  const test::TemporaryFolder folder;
  printCloudRows(cloudOf(makeCrop(corridor.whole(), 5000000).merged), folder, rounds);
  printMeshRows(folder, rounds);
}

} // namespace pcl::acmap::bench
