#include "bench.h"
#include "bench_data.h"
#include "primitive_scenes.h"

#include <pcl/segmentation/cylinder_hypothesis_clustering.h>

#include <filesystem>
#include <map>
#include <set>

namespace pcl::acmap::bench {
namespace {

constexpr double min_share = 0.02;       // of the points, for recall
constexpr double reported_share = 0.018; // of the points, for precision

struct TrueCylinder {
  Eigen::Vector3d point, axis;
  double radius = 0;
  std::set<std::int32_t> points;
};

struct Model {
  PointCloud<PointXYZ>::Ptr cloud{new PointCloud<PointXYZ>};
  std::vector<TrueCylinder> cylinders;
  double extent = 0; ///< diagonal of its box
};

/** The numbers of a text, whatever is between them. */
std::vector<double>
numbersOf(std::string text)
{
  for (char& letter : text)
    if (letter == ',' || letter == '[' || letter == ']' || letter == ';')
      letter = ' ';
  std::istringstream stream(text);
  std::vector<double> numbers;
  for (double number; stream >> number;)
    numbers.push_back(number);
  return numbers;
}

/** Calls visit (primitive, text in brackets) for each line "Primitive3:=[...". */
template <typename Visit>
void
visitPrimitives(const std::string& text, const Visit& visit)
{
  const std::string word = "Primitive", sign = ":=[";
  for (std::size_t at = text.find(word); at != std::string::npos;) {
    const std::size_t next = text.find(word, at + 1);
    const std::size_t begin = text.find(sign, at) + sign.size();
    visit(std::stoi(text.substr(at + word.size())), text.substr(begin, next - begin));
    at = next;
  }
}

/** \param[in] stem path of the three files without their endings */
Model
readModel(const std::string& stem)
{
  Model model;
  const std::string points = contentOf(stem + ".txt.xz");
  const std::vector<double> numbers = numbersOf(points.substr(points.find('[')));
  Eigen::Vector3d low(1e30, 1e30, 1e30), high = -low;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    const Eigen::Vector3d place(numbers[i], numbers[i + 1], numbers[i + 2]);
    model.cloud->emplace_back(static_cast<float>(place.x()),
                              static_cast<float>(place.y()),
                              static_cast<float>(place.z()));
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  model.extent = (high - low).norm();
  std::map<int, TrueCylinder> cylinders;
  const std::string kind = "Cylinder, ";
  visitPrimitives(contentOf(stem + "_parametric.txt"),
                  [&](int number, const std::string& text) {
                    if (text.compare(0, kind.size(), kind) != 0)
                      return;
                    const std::vector<double> p = numbersOf(text.substr(kind.size()));
                    if (p.size() != 12)
                      return;
                    TrueCylinder& cylinder = cylinders[number];
                    cylinder.radius = Eigen::Vector3d(p[0], p[1], p[2]).norm();
                    cylinder.axis = Eigen::Vector3d(p[6], p[7], p[8]).normalized();
                    cylinder.point = Eigen::Vector3d(p[9], p[10], p[11]);
                  });
  visitPrimitives(contentOf(stem + "_primitives.txt.xz"),
                  [&](int number, const std::string& text) {
                    const auto found = cylinders.find(number);
                    if (found == cylinders.end())
                      return;
                    for (const double index : numbersOf(text))
                      found->second.points.insert(static_cast<std::int32_t>(index) - 1);
                  });
  for (const auto& [number, cylinder] : cylinders)
    model.cylinders.push_back(cylinder);
  return model;
}

/** Do the annotated points of each cylinder lie on it? In some files the numbers of
 * both annotations differ. */
bool
isConsistent(const Model& model)
{
  constexpr double tolerance = 1e-3; // of the radius
  return std::all_of(
      model.cylinders.begin(), model.cylinders.end(), [&](const TrueCylinder& truth) {
        const auto offs = valuesOf(truth.points, [&](std::int32_t i) {
          const Eigen::Vector3d place =
              (*model.cloud)[i].getVector3fMap().cast<double>();
          return std::abs(distanceToAxis(place, truth.point, truth.axis) -
                          truth.radius);
        });
        return !(median(offs) > tolerance * truth.radius);
      });
}

/** Are both on one axis, with one radius? */
bool
areSame(const TrueCylinder& truth, const CylinderPatch& patch, double extent)
{
  constexpr double parallel = 0.9986; // 3 degrees
  const double tolerance = 0.03 * truth.radius;
  return std::abs(truth.axis.dot(patch.axis_direction)) > parallel &&
         std::abs(truth.radius - patch.radius) < tolerance &&
         distanceToAxis(patch.axis_point, truth.point, truth.axis) <
             tolerance + 0.002 * extent;
}

/** Sums over several models. */
struct Score {
  std::size_t true_cylinders = 0, found = 0, reported = 0, right = 0;
  std::vector<double> errors; ///< of radii, percent
  double seconds = 0;

  void
  add(const Model& model)
  {
    CylinderHypothesisClustering<PointXYZ> clustering;
    clustering.setInputCloud(model.cloud);
    std::vector<CylinderPatch> patches;
    seconds += measureCost([&] { clustering.segment(patches); }).cpu;
    const PointLabels& labels = clustering.getLabels();
    const auto size = static_cast<double>(model.cloud->size());
    const auto common = [&](const TrueCylinder& truth, std::size_t patch) {
      const auto is_on = [&](std::int32_t point) {
        return labels[static_cast<std::size_t>(point)] ==
               static_cast<std::int32_t>(patch);
      };
      return static_cast<double>(
          std::count_if(truth.points.begin(), truth.points.end(), is_on));
    };
    for (const TrueCylinder& truth : model.cylinders) {
      const auto points = static_cast<double>(truth.points.size());
      if (points < min_share * size)
        continue;
      ++true_cylinders;
      for (std::size_t p = 0; p < patches.size(); ++p)
        if (areSame(truth, patches[p], model.extent) &&
            2 * common(truth, p) >= points) {
          ++found;
          errors.push_back(100 * std::abs(patches[p].radius / truth.radius - 1));
          break;
        }
    }
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const auto points = static_cast<double>(patches[p].support);
      if (points < reported_share * size)
        continue;
      ++reported;
      double shared = 0;
      for (const TrueCylinder& truth : model.cylinders)
        shared += areSame(truth, patches[p], model.extent) ? common(truth, p) : 0;
      right += 2 * shared >= points ? 1 : 0;
    }
  }
};

void
printModels(int parity, double reach)
{
  const auto probe = pathOfData("F_primitives/fit4cad_training/PC1.txt.xz");
  if (!probe)
    return;
  const std::filesystem::path folder = std::filesystem::path(*probe).parent_path();
  std::set<int> numbers;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.find("_parametric") != std::string::npos &&
        std::stoi(name.substr(2)) % 2 == parity)
      numbers.insert(std::stoi(name.substr(2)));
  }
  Score all;
  for (const int number : numbers) {
    const std::string name = "PC" + std::to_string(number);
    const Model model = readModel((folder / name).string());
    if (isConsistent(model))
      all.add(model);
    else
      std::cerr << name << " is left out: its points are not on its cylinders\n";
  }
  const auto ratio = [](std::size_t part, std::size_t whole) {
    return percent(part, whole) / 100;
  };
  printHead("cylinders | found | reported | right | recall | precision | median radius "
            "error % | CPU s");
  Row() << all.true_cylinders << all.found << all.reported << all.right
        << atLeast(ratio(all.found, all.true_cylinders), reach, 3)
        << atLeast(ratio(all.right, all.reported), reach, 3)
        << figure(median(all.errors), 3) << figure(all.seconds, 1);
}

const Section fit4cad_section("fit4cad", [] { printModels(0, 0.92); });

const Section fit4cad_tuned_section("fit4cad_tuned", [] { printModels(1, no_reach); });

} // namespace
} // namespace pcl::acmap::bench
