#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

// What all benchmarks share: sections, tables, statistics, times.

namespace pcl::acmap::bench {

constexpr double degree = M_PI / 180, ///< radians
    centi = 100, milli = 1000;        ///< centimetres and millimetres of a metre

/** \brief A part of a benchmark. The objects in a program's sources are its sections:
 * the command line selects some by their names, otherwise all run, in the order of the
 * sources. */
class Section {
public:
  Section(const char* name, void (*print)());
};

/** \brief Target of a figure that is only reported. */
inline constexpr double no_reach = std::numeric_limits<double>::quiet_NaN();

inline constexpr char no_value[] = "–";

/** \brief A cell with a number, and its target, if it has one; NaN is a dash. */
struct Figure {
  double value;
  int digits;
  const char* sign = nullptr;
  double reach = no_reach;
  bool is_reached = true;
};

/** \brief Also a count, here and below. */
template <typename Number>
Figure
figure(Number value, int digits)
{
  return {static_cast<double>(value), digits};
}

/** \param[in] reach target, or \ref no_reach, here and below */
template <typename Number, typename Reach>
Figure
atMost(Number value, Reach reach, int digits)
{
  const auto limit = static_cast<double>(reach);
  return {static_cast<double>(value),
          digits,
          "≤",
          limit,
          static_cast<double>(value) <= limit};
}

template <typename Number, typename Reach>
Figure
atLeast(Number value, Reach reach, int digits)
{
  const auto limit = static_cast<double>(reach);
  return {static_cast<double>(value),
          digits,
          "≥",
          limit,
          static_cast<double>(value) >= limit};
}

/** \brief A deviation whose absolute value should not exceed \a reach. */
inline Figure
within(double value, double reach, int digits)
{
  return {value, digits, "±", reach, std::abs(value) <= reach};
}

/** \brief Prints the head of a Markdown table. \param[in] titles as on the page */
void
printHead(const std::string& titles);

/** \brief A row of a Markdown table, which is printed at its end. Figures that miss
 * their target are marked in bold. */
class Row {
public:
  Row() = default;
  Row(const Row&) = delete;
  Row&
  operator=(const Row&) = delete;

  ~Row()
  {
    std::cout << "|" << line_.str() << std::endl;
  }

  Row&
  operator<<(const Figure& figure);

  /** \brief A text, or a whole number. */
  template <typename Cell>
  Row&
  operator<<(const Cell& cell)
  {
    if constexpr (std::is_floating_point_v<Cell>)
      static_assert(!std::is_floating_point_v<Cell>, "it is a figure, with digits");
    line_ << " " << cell << " |";
    return *this;
  }

private:
  std::ostringstream line_;
};

/** \brief The ratio of \a whole to \a part, such as "2.25 x". */
std::string
timesOf(double whole, double part);

/** \brief The value that a fraction \a share of all values do not exceed; NaN if there
 * are none. */
double
quantile(std::vector<double> values, double share);

inline double
median(const std::vector<double>& values)
{
  return quantile(values, 0.5);
}

/** \brief NaN if there are no values, here and below. */
double
meanOf(const std::vector<double>& values);

inline double
largest(const std::vector<double>& values)
{
  return quantile(values, 1);
}

inline double
percent(std::size_t part, std::size_t whole)
{
  return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0;
}

/** \brief A property of each of some results. */
template <typename Results, typename Property>
std::vector<double>
valuesOf(const Results& results, const Property& property)
{
  std::vector<double> values;
  for (const auto& result : results)
    values.push_back(static_cast<double>(property(result)));
  return values;
}

/** \brief CPU seconds of a clock; unlike wall time, other load of the machine hardly
 * affects them. */
inline double
clockSeconds(clockid_t clock)
{
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/** \brief CPU seconds of the calling thread. */
inline double
threadSeconds()
{
  return clockSeconds(CLOCK_THREAD_CPUTIME_ID);
}

/** \brief CPU seconds used by all threads of the process. */
inline double
processSeconds()
{
  return clockSeconds(CLOCK_PROCESS_CPUTIME_ID);
}

/** \brief Elapsed times in seconds. */
struct Cost {
  double cpu = 0; ///< of all threads of the process
  double wall = 0;
};

template <typename Function>
Cost
measureCost(const Function& function)
{
  const double begin_cpu = processSeconds();
  const auto begin = std::chrono::steady_clock::now();
  function();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  return {processSeconds() - begin_cpu, wall.count()};
}

/** \brief The medians of both times. */
inline Cost
medianCost(const std::vector<Cost>& costs)
{
  return {median(valuesOf(costs, [](const Cost& cost) { return cost.cpu; })),
          median(valuesOf(costs, [](const Cost& cost) { return cost.wall; }))};
}

/** \brief CPU seconds of the calling thread. */
template <typename Function>
double
measureThread(const Function& function)
{
  const double begin = threadSeconds();
  function();
  return threadSeconds() - begin;
}

/** \brief Median CPU seconds of the calling thread over some rounds. */
template <typename Function>
double
medianThread(std::size_t rounds, const Function& function)
{
  std::vector<double> seconds;
  for (std::size_t round = 0; round < rounds; ++round)
    seconds.push_back(measureThread(function));
  return median(seconds);
}

} // namespace pcl::acmap::bench
