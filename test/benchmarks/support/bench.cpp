#include "bench.h"

#include <iomanip>
#include <numeric>

namespace pcl::acmap::bench {

void
printHead(const std::string& titles)
{
  std::cout << "\n| " << titles << " |\n|";
  for (auto column = std::count(titles.begin(), titles.end(), '|'); column >= 0;
       --column)
    std::cout << "---|";
  std::cout << std::endl;
}

Row&
Row::operator<<(const Figure& figure)
{
  std::ostringstream cell;
  cell << std::fixed << std::setprecision(figure.digits);
  const auto target = [&] {
    cell << figure.sign << " " << std::defaultfloat << std::setprecision(4)
         << figure.reach << ")";
  };
  const bool has_target = figure.sign && !std::isnan(figure.reach);
  if (!has_target && std::isnan(figure.value))
    cell << "–";
  else if (!has_target || figure.is_reached)
    cell << figure.value << (has_target ? " (" : "");
  else
    cell << "**" << figure.value << "** (missed: ";
  if (has_target)
    target();
  return *this << cell.str();
}

std::string
timesOf(double whole, double part)
{
  std::ostringstream times;
  times << std::fixed << std::setprecision(2) << whole / part << " x";
  return times.str();
}

double
quantile(std::vector<double> values, double share)
{
  if (values.empty())
    return std::numeric_limits<double>::quiet_NaN();
  const auto place =
      std::min(values.size() - 1,
               static_cast<std::size_t>(share * static_cast<double>(values.size())));
  const auto found = values.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(values.begin(), found, values.end());
  return *found;
}

double
meanOf(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) /
         static_cast<double>(values.size());
}

} // namespace pcl::acmap::bench
