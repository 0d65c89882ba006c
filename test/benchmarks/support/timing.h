#pragma once

#include "cpu_time.h"
#include "statistics.h"

#include <chrono>
#include <cstddef>
#include <vector>

namespace pcl::acmap::bench {

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
  std::vector<double> cpu, wall;
  for (const Cost& cost : costs) {
    cpu.push_back(cost.cpu);
    wall.push_back(cost.wall);
  }
  return {median(cpu), median(wall)};
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
