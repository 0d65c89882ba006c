#pragma once

#include <cstddef>
#include <initializer_list>
#include <limits>
#include <sstream>
#include <string>

namespace pcl::acmap::bench {

/** \brief A figure that is only told. */
inline constexpr double no_reach = std::numeric_limits<double>::quiet_NaN();

/** \brief Prints the head of a Markdown table. */
void
printHead(std::initializer_list<const char*> titles);

/** \brief How many times \a part goes into \a whole: "2.25 x". */
std::string
timesOf(double whole, double part);

/** \brief A row of a Markdown table. Figures stand beside what they should reach; those
 * that miss it are set in bold and say so. */
class MarkdownRow {
public:
  MarkdownRow&
  text(const std::string& cell);

  MarkdownRow&
  count(std::size_t number);

  /** \brief A dash for NaN. */
  MarkdownRow&
  number(double value, int digits);

  /** \param[in] reach \ref no_reach for a figure without one, here and below */
  MarkdownRow&
  atMost(double value, double reach, int digits);

  MarkdownRow&
  atLeast(double value, double reach, int digits);

  /** \brief A deviation that should lie within plus and minus \a reach. */
  MarkdownRow&
  within(double value, double reach, int digits);

  void
  print() const;

private:
  MarkdownRow&
  judged(double value, bool reached, const char* sign, double reach, int digits);

  std::ostringstream line_;
};

} // namespace pcl::acmap::bench
