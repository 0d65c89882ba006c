#include "fingerprint.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl::acmap::test {
namespace {

/** Pseudo-random weight within half of 1, different for each index, but
 * reproducible. */
double
weightOf(std::size_t place)
{
  const std::uint64_t turned = (place + 1) * std::uint64_t{0x9e3779b97f4a7c15};
  return static_cast<double>((turned ^ (turned >> 31)) >> 11) * 0x1p-53 - 0.5;
}

} // namespace

NumberSummary::NumberSummary(const std::vector<double>& numbers)
: count(numbers.size())
{
  for (const double number : numbers)
    if (std::isfinite(number))
      mean += number;
    else
      ++missing;
  const auto finite = static_cast<double>(std::max<std::size_t>(count - missing, 1));
  mean /= finite;
  double squares = 0;
  for (std::size_t i = 0; i < count; ++i)
    if (const double off = numbers[i] - mean; std::isfinite(off)) {
      squares += off * off;
      order += weightOf(i) * off;
    }
  spread = std::sqrt(squares / finite);
  order /= finite;
}

NumberSummary::NumberSummary(const nlohmann::json& stored)
: count(stored.at(0))
, missing(stored.at(1))
, mean(stored.at(2))
, spread(stored.at(3))
, order(stored.at(4))
{}

double
NumberSummary::unit() const
{
  return std::max(1e-5 * std::max(std::abs(mean), spread), 1e-9);
}

nlohmann::json
NumberSummary::json() const
{
  const double step = unit() / 10;
  const auto rounded = [&](double value) {
    char text[32] = "";
    std::snprintf(text,
                  sizeof text,
                  "%.*f",
                  std::clamp(static_cast<int>(std::ceil(-std::log10(step))), 0, 12),
                  value);
    return std::strtod(text, nullptr) + 0.0; // avoids -0
  };
  return {count, missing, rounded(mean), rounded(spread), rounded(order)};
}

bool
NumberSummary::agreesWith(const NumberSummary& stored) const
{
  const double maximum = stored.unit();
  return count == stored.count && missing == stored.missing &&
         std::abs(mean - stored.mean) <= maximum &&
         std::abs(spread - stored.spread) <= maximum &&
         std::abs(order - stored.order) <= maximum;
}

nlohmann::json
fingerprintOf(const FileNumbers& numbers)
{
  nlohmann::json fingerprint = nlohmann::json::object();
  for (const auto& [name, values] : numbers)
    fingerprint[name] = NumberSummary(values).json();
  return fingerprint;
}

std::vector<std::string>
differencesOf(const nlohmann::json& found, const nlohmann::json& stored)
{
  std::vector<std::string> lines;
  for (const auto& [name, summary] : stored.items())
    if (!found.contains(name))
      lines.push_back(name + ": is not there");
    else if (!NumberSummary(found.at(name)).agreesWith(NumberSummary(summary)))
      lines.push_back(name + ": " + found.at(name).dump() + ", stored " +
                      summary.dump());
  for (const auto& [name, summary] : found.items())
    if (!stored.contains(name))
      lines.push_back(name + ": " + summary.dump() + ", not stored");
  return lines;
}

} // namespace pcl::acmap::test
