#include "markdown_row.h"

#include <cmath>
#include <iomanip>
#include <iostream>

namespace pcl::acmap::bench {

void
printHead(std::initializer_list<const char*> titles)
{
  std::cout << "\n|";
  for (const char* title : titles)
    std::cout << " " << title << " |";
  std::cout << "\n|";
  for (std::size_t i = 0; i < titles.size(); ++i)
    std::cout << "---|";
  std::cout << std::endl;
}

std::string
timesOf(double whole, double part)
{
  std::ostringstream times;
  times << std::fixed << std::setprecision(2) << whole / part << " x";
  return times.str();
}

MarkdownRow&
MarkdownRow::text(const std::string& cell)
{
  line_ << " " << cell << " |";
  return *this;
}

MarkdownRow&
MarkdownRow::count(std::size_t number)
{
  return text(std::to_string(number));
}

MarkdownRow&
MarkdownRow::number(double value, int digits)
{
  if (std::isnan(value))
    return text("–");
  std::ostringstream cell;
  cell << std::fixed << std::setprecision(digits) << value;
  return text(cell.str());
}

MarkdownRow&
MarkdownRow::atMost(double value, double reach, int digits)
{
  return judged(value, value <= reach, "≤", reach, digits);
}

MarkdownRow&
MarkdownRow::atLeast(double value, double reach, int digits)
{
  return judged(value, value >= reach, "≥", reach, digits);
}

MarkdownRow&
MarkdownRow::within(double value, double reach, int digits)
{
  return judged(value, std::abs(value) <= reach, "±", reach, digits);
}

MarkdownRow&
MarkdownRow::judged(
    double value, bool reached, const char* sign, double reach, int digits)
{
  if (std::isnan(reach))
    return number(value, digits);
  std::ostringstream cell;
  cell << std::fixed << std::setprecision(digits);
  if (reached)
    cell << value << " (" << sign << " ";
  else
    cell << "**" << value << "** (missed: " << sign << " ";
  cell << std::defaultfloat << std::setprecision(4) << reach << ")";
  return text(cell.str());
}

void
MarkdownRow::print() const
{
  std::cout << "|" << line_.str() << std::endl;
}

} // namespace pcl::acmap::bench
