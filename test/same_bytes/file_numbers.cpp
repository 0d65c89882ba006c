#include "file_numbers.h"

#include "json_file.h"
#include "temporary_folder.h"

#include <pcl/acquisition/frame_file.h>
#include <pcl/core/disparity_image.h>
#include <pcl/core/image_file.h>
#include <pcl/core/mesh_file.h>
#include <pcl/core/point_cloud_file.h>

#include <nlohmann/json.hpp>

#include <cctype>
#include <cstring>
#include <filesystem>
#include <set>
#include <sstream>
#include <stdexcept>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;

/** Collects the numbers of one file. */
class Reader {
public:
  Reader(FileNumbers& numbers, const std::string& path, const std::string& name)
  : numbers_(numbers)
  , path_(path)
  , name_(name)
  {}

  void
  readPoints()
  {
    const PCLPointCloud2 cloud = loadPointCloud(path_).cloud;
    for (const PCLPointField& field : cloud.fields)
      for (std::size_t at = 0; at < cloud.data.size(); at += cloud.point_step)
        addField(field, &cloud.data[at + field.offset]);
  }

  void
  readFaces()
  {
    for (const auto& triangle : loadTriangleMesh(path_).triangles)
      for (const auto corner : triangle)
        add("faces", static_cast<double>(corner));
  }

  void
  readImage()
  {
    addAll("levels", loadRgbImage(path_).values);
  }

  void
  readDisparity()
  {
    addAll("disparity", loadPfm(path_).values);
  }

  void
  readFrame()
  {
    for (const CameraImage& image : loadTrinocularFrame(path_).images)
      addAll("levels", image.values);
  }

  void
  readJson()
  {
    flatten("", jsonOfFile(path_));
  }

  void
  readText()
  {
    std::string text = contentOf(path_);
    for (char& letter : text)
      letter = std::strchr("[]{},:;=", letter) ? ' ' : letter;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
      char* end = nullptr;
      const double value = std::strtod(word.c_str(), &end);
      if (*end == '\0')
        add("numbers", value);
    }
  }

private:
  void
  add(const std::string& field, double value)
  {
    numbers_[name_ + " " + field].push_back(value);
  }

  template <typename Values>
  void
  addAll(const std::string& field, const Values& values)
  {
    auto& all = numbers_[name_ + " " + field];
    all.insert(all.end(), values.begin(), values.end());
  }

  template <typename Value>
  static double
  numberAt(const std::uint8_t* bytes)
  {
    Value value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
  }

  /** A packed colour is split into its three bytes. */
  void
  addField(const PCLPointField& field, const std::uint8_t* bytes)
  {
    if (field.name == "rgb" || field.name == "rgba")
      for (int channel = 0; channel < 3; ++channel)
        add(field.name, bytes[channel]);
    else
      add(field.name, valueOf(field.datatype, bytes));
  }

  static double
  valueOf(std::uint8_t type, const std::uint8_t* bytes)
  {
    switch (type) {
    case PCLPointField::INT8:
      return numberAt<std::int8_t>(bytes);
    case PCLPointField::UINT8:
      return numberAt<std::uint8_t>(bytes);
    case PCLPointField::INT16:
      return numberAt<std::int16_t>(bytes);
    case PCLPointField::UINT16:
      return numberAt<std::uint16_t>(bytes);
    case PCLPointField::INT32:
      return numberAt<std::int32_t>(bytes);
    case PCLPointField::UINT32:
      return numberAt<std::uint32_t>(bytes);
    case PCLPointField::FLOAT64:
      return numberAt<double>(bytes);
    default:
      return numberAt<float>(bytes);
    }
  }

  void
  flatten(const std::string& place, const nlohmann::json& value)
  {
    if (value.is_number())
      add(place, value.get<double>());
    else if (value.is_boolean())
      add(place, value.get<bool>() ? 1 : 0);
    else if (value.is_array())
      for (const auto& one : value)
        flatten(place + "/#", one);
    else if (value.is_object())
      for (const auto& [key, one] : value.items())
        flatten(place + "/" + key, one);
  }

  FileNumbers& numbers_;
  std::string path_, name_;
};

std::string
withoutDigits(const std::string& name)
{
  std::string shortened;
  for (const char letter : name)
    if (!std::isdigit(static_cast<unsigned char>(letter)))
      shortened += letter;
    else if (shortened.empty() || shortened.back() != '#')
      shortened += '#';
  return shortened;
}

void
readFile(const fs::path& path, Reader reader)
{
  const std::string kind = path.extension().string();
  if (kind == ".pcd" || kind == ".ply" || kind == ".obj")
    reader.readPoints();
  if (kind == ".ply" || kind == ".obj")
    reader.readFaces();
  else if (kind == ".png")
    reader.readImage();
  else if (kind == ".pfm")
    reader.readDisparity();
  else if (kind == ".acf")
    reader.readFrame();
  else if (kind == ".json")
    reader.readJson();
  else if (kind == ".txt" || kind == ".yaml" || kind == ".mtl")
    reader.readText();
  else if (kind != ".pcd")
    throw std::runtime_error(path.string() + " is of no known kind");
}

} // namespace

FileNumbers
numbersIn(const std::string& folder)
{
  static const std::set<std::string> left_out = {"report.json",
                                                 "report.html",
                                                 "stage.json",
                                                 "observations.txt",
                                                 "map.glb",
                                                 "map.html",
                                                 "map.ifc",
                                                 "floor_plan.svg",
                                                 "floor_plan.dxf",
                                                 "floor_plan.geojson"};
  std::set<fs::path> paths;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && left_out.count(entry.path().filename()) == 0)
      paths.insert(entry.path());
  FileNumbers numbers;
  for (const fs::path& path : paths)
    readFile(
        path,
        {numbers, path.string(), withoutDigits(fs::relative(path, folder).string())});
  return numbers;
}

} // namespace pcl::acmap::test
