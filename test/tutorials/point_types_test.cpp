#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

// The tutorial lists the point types for which each class is instantiated; this test
// compares the list with the instantiations in the modules.

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using Types = std::map<std::string, std::set<std::string>>; // by class

std::set<std::string>
allMatches(const std::string& text, const std::regex& expression)
{
  std::set<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end;
       ++at)
    found.insert((*at)[1]);
  return found;
}

Types
listedTypes()
{
  static const std::regex row(R"(\| \[`(\w+)`\]\([^)]*\) \| (.*))");
  static const std::regex type("`(Point\\w+|PCL_XYZ_POINT_TYPES)`");
  std::istringstream page(contentOf(ACMAP_TUTORIALS "/use_acmap_in_cmake.md"));
  Types types;
  std::smatch found;
  for (std::string line; std::getline(page, line);)
    if (std::regex_match(line, found, row))
      types[found[1]] = allMatches(found[2], type);
  return types;
}

/** Replaces the names of type lists by the lists. If a list has two definitions, the
 * second one is for builds without sanitizers. */
std::string
withLists(std::string text)
{
  static const std::regex definition(R"(#define (ACMAP_\w+_TYPES)((?:.*\\\n)*.*))");
  const std::string header =
      contentOf(ACMAP_MODULES "/core/include/pcl/core/impl/compiled_point_types.h");
  std::map<std::string, std::string> lists;
  for (std::sregex_iterator at(header.begin(), header.end(), definition), end;
       at != end;
       ++at)
    lists[(*at)[1]] = (*at)[2];
  for (const std::string& name :
       {std::string("ACMAP_ALL_POINT_TYPES"), std::string("ACMAP_VIEW_POINT_TYPES")})
    text = std::regex_replace(text, std::regex(name), lists.at(name));
  return text;
}

Types
compiledTypes()
{
  static const std::regex name(
      R"((?:PCL_INSTANTIATE\(\s*|PCL_INSTANTIATE_|ACMAP_EXPORT (?=Trans))(\w+))");
  static const std::regex type(
      R"(\b(Point(?!Cloud|T\b|View\b)\w+|PCL_XYZ_POINT_TYPES))");
  Types types;
  for (const auto& module : fs::directory_iterator(ACMAP_MODULES))
    for (const auto& source : fs::directory_iterator(module.path() / "src")) {
      const std::string text =
          source.is_regular_file() ? withLists(contentOf(source.path().string())) : "";
      // the types of an instantiation follow its name, up to the next name
      for (std::sregex_iterator at(text.begin(), text.end(), name), end; at != end;) {
        const std::string class_name = (*at)[1];
        const auto begin = static_cast<std::size_t>(at->position());
        const std::size_t next =
            ++at == end ? text.size() : static_cast<std::size_t>(at->position());
        types[class_name].merge(allMatches(text.substr(begin, next - begin), type));
      }
    }
  return types;
}

TEST(PointTypes, OfTheTutorialAreThoseThatClassesAreCompiledFor)
{
  const Types compiled = compiledTypes();
  EXPECT_GE(compiled.size(), 11u);
  EXPECT_EQ(listedTypes(), compiled);
}

/** What the changelog says: each class of clouds takes every type with x, y, z. */
TEST(PointTypes, AreAllButForClassesThatNeedColours)
{
  const std::set<std::string> all{
      "PCL_XYZ_POINT_TYPES", "PointXYZRGBNormalView", "PointXYZRGBSigma"};
  const std::set<std::string> egomotion{"VisualEgomotion",
                                        "RevisitDetection",
                                        "GradientMaximumKeypoint",
                                        "CorrespondenceEstimationLogPolar",
                                        "TransformationEstimationPlanar"};
  for (const auto& [name, types] : compiledTypes())
    EXPECT_EQ(types == all, egomotion.count(name) == 0) << name;
}

} // namespace
} // namespace pcl::acmap::test
