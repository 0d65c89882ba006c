#pragma once

#include <cstddef>
#include <initializer_list>
#include <limits>
#include <sstream>
#include <string>

namespace pcl::acmap::bench {

/** \brief Target of a figure that is only reported. */
inline constexpr double no_reach = std::numeric_limits<double>::quiet_NaN();

/** \brief Prints the head of a Markdown table. */
void
printHead(std::initializer_list<const char*> titles);

/** \brief The ratio of \a whole to \a part, such as "2.25 x". */
std::string
timesOf(double whole, double part);

/** \brief A row of a Markdown table. Figures are shown with their targets; those that
 * miss the target are marked in bold. */
class MarkdownRow {
public:
  MarkdownRow&
  text(const std::string& cell);

  MarkdownRow&
  count(std::size_t number);

  /** \brief Adds a number, or a dash for NaN. */
  MarkdownRow&
  number(double value, int digits);

  /** \param[in] reach target, or \ref no_reach, here and below */
  MarkdownRow&
  atMost(double value, double reach, int digits);

  MarkdownRow&
  atLeast(double value, double reach, int digits);

  /** \brief Adds a deviation whose absolute value should not exceed \a reach. */
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
