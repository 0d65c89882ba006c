#include "clouds/field_names.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pcl::acmap {

namespace {

std::string
inLowerCase(std::string_view name)
{
  std::string lower(name);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

bool
isNamed(const std::vector<SourceField>& fields, const std::string& name)
{
  return std::any_of(fields.begin(), fields.end(), [&](const SourceField& field) {
    return field.name == name;
  });
}

void
renameLetters(std::vector<SourceField>& fields)
{
  constexpr std::array<std::pair<const char*, const char*>, 3> letters = {
      {{"r", "red"}, {"g", "green"}, {"b", "blue"}}};
  std::vector<SourceField> renamed = fields;
  for (const auto& names : letters) {
    const char* const letter = names.first;
    const char* const color = names.second;
    if (isNamed(fields, color))
      return;
    const auto found =
        std::find_if(renamed.begin(), renamed.end(), [&](const SourceField& field) {
          return inLowerCase(field.name) == letter;
        });
    if (found == renamed.end())
      return;
    found->name = color;
  }
  fields = std::move(renamed);
}

} // namespace

std::string
standardName(std::string_view name)
{
  static constexpr std::pair<std::string_view, std::string_view> spellings[] = {
      {"x", "x"},
      {"y", "y"},
      {"z", "z"},
      {"nx", "normal_x"},
      {"ny", "normal_y"},
      {"nz", "normal_z"},
      {"normal_x", "normal_x"},
      {"normal_y", "normal_y"},
      {"normal_z", "normal_z"},
      {"red", "red"},
      {"green", "green"},
      {"blue", "blue"},
      {"alpha", "alpha"},
      {"diffuse_red", "red"},
      {"diffuse_green", "green"},
      {"diffuse_blue", "blue"},
      {"rgb", "rgb"},
      {"rgba", "rgba"}};
  const std::string lower = inLowerCase(name);
  for (const auto& [spelling, standard] : spellings)
    if (lower == spelling)
      return std::string(standard);
  return {};
}

void
renameFields(std::vector<SourceField>& fields)
{
  for (SourceField& field : fields) {
    const std::string name = standardName(field.name);
    if (!name.empty() && !isNamed(fields, name))
      field.name = name;
  }
  renameLetters(fields);
}

} // namespace pcl::acmap
