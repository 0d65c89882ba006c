#include "rgbd/image_folder.h"

#include "rgbd/camera_path.h"
#include "rgbd/foreign_layouts.h"
#include "rgbd/stamp_matching.h"
#include <pcl/core/impl/file_ending.h>

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/folder_entries.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>; // depth, colour

bool
isDigit(char c)
{
  return c >= '0' && c <= '9';
}

std::string
lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return text;
}

std::vector<fs::path>
filesOf(const fs::path& folder,
        const std::string& prefix,
        const std::vector<std::string>& endings)
{
  std::vector<fs::path> files;
  for (const fs::path& entry : folderEntries(folder.string())) {
    const std::string name = entry.filename().string();
    if (name.rfind('.', 0) != 0 && name.rfind(prefix, 0) == 0 &&
        std::count(endings.begin(), endings.end(), endingOf(entry)) > 0)
      files.push_back(entry);
  }
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return isBeforeByNumbers(a.filename().string(), b.filename().string());
  });
  return files;
}

/** \brief The numbers of all names; empty if one has none. */
std::vector<double>
numbersOf(const std::vector<fs::path>& images)
{
  std::vector<double> numbers;
  for (const fs::path& image : images) {
    const std::optional<double> number = numberInName(image);
    if (!number)
      return {};
    numbers.push_back(*number);
  }
  return numbers;
}

/** \brief Seconds in a unit of times, by their size: a time of this century is 1e9 s; 0 for
 * numbers that count frames. */
double
unitOfTimes(const std::vector<double>& numbers)
{
  const double largest = *std::max_element(numbers.begin(), numbers.end());
  for (const double unit : {1.0, 1e-3, 1e-6, 1e-9})
    if (largest * unit >= 1e8 && largest * unit < 1e10)
      return unit;
  const bool has_fractions =
      std::any_of(numbers.begin(), numbers.end(), [](double number) {
        return number != std::floor(number);
      });
  return has_fractions ? 1.0 : 0.0;
}

/** \brief Pairs of equal keys. */
template <typename Key>
Pairs
equalPairs(const std::vector<Key>& depths, const std::vector<Key>& colors)
{
  std::map<Key, std::size_t> places;
  for (std::size_t i = 0; i < colors.size(); ++i)
    places[colors[i]] = i;
  Pairs pairs;
  for (std::size_t i = 0; i < depths.size(); ++i)
    if (const auto found = places.find(depths[i]); found != places.end())
      pairs.emplace_back(i, found->second);
  return pairs;
}

std::vector<std::string>
stemsOf(const std::vector<fs::path>& images)
{
  std::vector<std::string> stems;
  for (const fs::path& image : images)
    stems.push_back(image.stem().string());
  return stems;
}

Pairs
nearestPairs(std::vector<double> depths,
             std::vector<double> colors,
             double unit,
             double gap)
{
  for (double& number : depths)
    number *= unit;
  for (double& number : colors)
    number *= unit;
  const std::vector<std::size_t> depth_order = risingOrder(depths);
  const std::vector<std::size_t> color_order = risingOrder(colors);
  std::sort(depths.begin(), depths.end());
  std::sort(colors.begin(), colors.end());
  Pairs pairs;
  for (const auto& [depth, color] : matchStamps(depths, colors, gap))
    pairs.emplace_back(depth_order[depth], color_order[color]);
  return pairs;
}

/** \brief Pairs in the order of both lists.
 * \throws InputFileException if the lists differ in length */
Pairs
orderedPairs(std::size_t depths, std::size_t colors, const std::string& place)
{
  if (depths != colors)
    throw InputFileException(place + ": has " + std::to_string(depths) +
                             " depth images and " + std::to_string(colors) +
                             " colour images, whose names differ; lists rgb.txt and "
                             "depth.txt with a time and "
                             "a file a row, as TUM's, tell which belong together");
  Pairs pairs;
  for (std::size_t i = 0; i < depths; ++i)
    pairs.emplace_back(i, i);
  return pairs;
}

} // namespace

fs::path
findEntry(const fs::path& folder, const std::vector<std::string>& names)
{
  std::map<std::string, fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    fs::path& known = entries[lowerCase(name)];
    if (known.empty() || name == lowerCase(name))
      known = entry->path();
  }
  for (const std::string& name : names)
    if (const auto found = entries.find(name); found != entries.end())
      return folder / found->second.filename();
  return {};
}

std::vector<fs::path>
colorImagesIn(const fs::path& folder, const std::string& prefix)
{
  return filesOf(folder, prefix, {".png", ".jpg", ".jpeg", ".ppm", ".pgm"});
}

std::vector<fs::path>
depthImagesIn(const fs::path& folder, const std::string& prefix)
{
  std::vector<fs::path> images = filesOf(folder, prefix, {".png", ".pgm"});
  if (images.empty())
    refuseForeignDepths(folder.string());
  return images;
}

bool
isBeforeByNumbers(const std::string& a, const std::string& b)
{
  std::size_t i = 0, k = 0;
  while (i < a.size() && k < b.size()) {
    if (!isDigit(a[i]) || !isDigit(b[k])) {
      if (a[i] != b[k])
        return a[i] < b[k];
      ++i;
      ++k;
      continue;
    }
    const auto number = [&](const std::string& text, std::size_t& at) {
      while (at < text.size() && text[at] == '0')
        ++at;
      const std::size_t begin = at;
      while (at < text.size() && isDigit(text[at]))
        ++at;
      return text.substr(begin, at - begin);
    };
    const std::string left = number(a, i), right = number(b, k);
    if (left.size() != right.size() || left != right)
      return std::pair(left.size(), left) < std::pair(right.size(), right);
  }
  return std::pair(a.size() - i, a) < std::pair(b.size() - k, b);
}

std::optional<double>
numberInName(const fs::path& image)
{
  const std::string stem = image.stem().string();
  std::size_t begin = stem.size();
  bool has_point = false;
  while (begin > 0 && (isDigit(stem[begin - 1]) ||
                       (stem[begin - 1] == '.' && !has_point && begin < stem.size()))) {
    --begin;
    has_point = has_point || stem[begin] == '.';
  }
  if (begin < stem.size() && stem[begin] == '.')
    ++begin;
  double number = 0;
  const char* const end = stem.data() + stem.size();
  const auto result = std::from_chars(stem.data() + begin, end, number);
  if (result.ec != std::errc() || result.ptr != end)
    return std::nullopt;
  return number;
}

NamedFrames
joinedImages(const std::vector<fs::path>& depths,
             const std::vector<fs::path>& colors,
             double gap,
             const std::string& place)
{
  NamedFrames joined;
  joined.depths = depths.size();
  const std::vector<double> depth_numbers = numbersOf(depths),
                            color_numbers = numbersOf(colors);
  const bool have_numbers = !depth_numbers.empty() && !color_numbers.empty();
  const double unit = have_numbers ? unitOfTimes(depth_numbers) : 0;
  const auto isEnough = [&](const Pairs& pairs) {
    return !pairs.empty() && 2 * pairs.size() >= std::min(depths.size(), colors.size());
  };
  Pairs pairs = equalPairs(stemsOf(depths), stemsOf(colors));
  if (!isEnough(pairs) && have_numbers)
    if (Pairs equal = equalPairs(depth_numbers, color_numbers); isEnough(equal))
      pairs = std::move(equal);
  if (!isEnough(pairs) && unit > 0)
    if (Pairs nearest = nearestPairs(depth_numbers, color_numbers, unit, gap);
        isEnough(nearest))
      pairs = std::move(nearest);
  if (pairs.empty() && !depths.empty()) {
    pairs = orderedPairs(depths.size(), colors.size(), place);
    joined.remark =
        "the names of depth and colour images do not tell which belong "
        "together: took them in their order; lists rgb.txt and depth.txt, as "
        "TUM's, state others";
  }
  if (pairs.empty())
    throw EmptyInputException(place + ": has no depth image with a colour image");
  joined.are_times = unit > 0;
  for (const auto& [depth, color] : pairs) {
    NamedFrame named;
    named.index = depth;
    if (!depth_numbers.empty())
      named.number = depth_numbers[depth] * (unit > 0 ? unit : 1);
    named.frame.depth = depths[depth].string();
    named.frame.color = colors[color].string();
    named.frame.stamp = unit > 0 ? *named.number : static_cast<double>(depth);
    joined.frames.push_back(std::move(named));
  }
  joined.unmatched = depths.size() - joined.frames.size();
  return joined;
}

NamedFrames
depthsAlone(const std::vector<fs::path>& depths)
{
  NamedFrames alone;
  alone.depths = depths.size();
  for (std::size_t i = 0; i < depths.size(); ++i) {
    NamedFrame named;
    named.index = i;
    named.number = numberInName(depths[i]);
    named.frame.depth = depths[i].string();
    named.frame.stamp = static_cast<double>(i);
    alone.frames.push_back(std::move(named));
  }
  return alone;
}

} // namespace pcl::acmap
