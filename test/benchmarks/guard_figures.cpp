#include "guard_buildings.h"
#include "guard_runs.h"
#include "markdown_row.h"
#include "statistics.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <set>
#include <sstream>
#include <string>

namespace pcl::acmap::bench {
namespace {

constexpr char usage[] =
    "Usage: acmap_bench_guard_figures [tuning] [held_out] [logs] [--runs N] [--jobs "
    "N]\n"
    "       acmap_bench_guard_figures --only KIND SEED\n"
    "Prints how often rectification accepts a map that is worse than the given one, "
    "as\n"
    "Markdown tables; without a name for all groups. --runs: per kind of building or\n"
    "log, 40; --jobs: processes, 2. Laser logs are read from the folder named by the\n"
    "environment variable ACMAP_TEST_DATA.\n";

using Results = std::vector<GuardResult>;

/** The command line. */
struct Request {
  std::set<std::string> groups;
  std::size_t runs = 40, jobs = 2;
  std::string only; ///< kind of the only run
  std::uint64_t seed = 1;
};

bool
readRequest(int argc, char** argv, Request& request)
{
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "tuning" || word == "held_out" || word == "logs")
      request.groups.insert(word);
    else if (word == "--runs" && i + 1 < argc)
      request.runs = std::strtoul(argv[++i], nullptr, 10);
    else if (word == "--jobs" && i + 1 < argc)
      request.jobs = std::max(1UL, std::strtoul(argv[++i], nullptr, 10));
    else if (word == "--only" && i + 2 < argc) {
      request.only = argv[++i];
      request.seed = std::strtoull(argv[++i], nullptr, 10);
    }
    else
      return false;
  }
  return true;
}

std::vector<std::string>
kindsOf(const std::string& group)
{
  std::vector<std::string> names;
  if (group == "logs")
    for (const RectificationMap& log : makeLogMaps())
      names.push_back(log.name);
  else
    for (const BuildingKind& kind : buildingKinds())
      if (kind.is_held_out == (group == "held_out"))
        names.push_back(kind.name);
  return names;
}

std::size_t
countOf(const Results& results, const std::function<bool(const GuardResult&)>& is)
{
  return static_cast<std::size_t>(std::count_if(results.begin(), results.end(), is));
}

void
printResults(const std::string& name, const Results& results)
{
  std::vector<double> ratios, accepted, seconds;
  const auto wasAccepted = [](const GuardResult& one) {
    return one.outcome == RectificationOutcome::Rectified;
  };
  for (const GuardResult& one : results) {
    ratios.push_back(one.ratio());
    seconds.push_back(one.seconds);
    if (wasAccepted(one))
      accepted.push_back(one.ratio());
  }
  const auto refused = countOf(results, [](const GuardResult& one) {
    return one.outcome == RectificationOutcome::Refused;
  });
  const auto kept = countOf(results, [](const GuardResult& one) {
    return one.outcome == RectificationOutcome::Kept;
  });
  MarkdownRow()
      .text(name)
      .count(results.size())
      .atMost(static_cast<double>(countOf(
                  results, [](const GuardResult& one) { return one.isWorse(); })),
              0,
              0)
      .count(countOf(results, [](const GuardResult& one) { return one.isWorse(1.05); }))
      .count(refused)
      .number(percent(refused, results.size()), 1)
      .count(kept)
      .number(median(ratios), 3)
      .number(quantile(ratios, 0.9), 3)
      .number(accepted.empty() ? no_reach : quantile(accepted, 1), 3)
      .number(median(seconds), 1)
      .number(quantile(seconds, 1), 1)
      .print();
}

/** One row for each value of a property of the runs. */
template <typename Value>
void
printBy(const Results& results,
        const std::function<Value(const GuardResult&)>& property,
        const std::function<std::string(const Value&)>& nameOfValue)
{
  std::vector<Value> values;
  for (const GuardResult& one : results)
    if (std::find(values.begin(), values.end(), property(one)) == values.end())
      values.push_back(property(one));
  std::sort(values.begin(), values.end());
  for (const Value& value : values) {
    Results some;
    std::copy_if(results.begin(),
                 results.end(),
                 std::back_inserter(some),
                 [&](const GuardResult& one) { return property(one) == value; });
    printResults(nameOfValue(value), some);
  }
}

void
printRunsThat(const char* title,
              const Results& results,
              const std::function<bool(const GuardResult&)>& are)
{
  std::cout << "\n" << title << "\n\n";
  for (const GuardResult& one : results)
    if (are(one))
      std::cout << "- " << one.kind << ' ' << one.seed << ": drift x " << one.level
                << ", " << nameOf(one.variant) << ", " << one.before.unaligned
                << " m before, " << one.after.unaligned << " m after, aligned "
                << one.before.aligned << " and " << one.after.aligned << " m\n";
}

void
printGroup(const std::string& group, const Request& request)
{
  std::vector<GuardJob> jobs;
  for (std::uint64_t seed = 1; seed <= request.runs; ++seed)
    for (const std::string& kind : kindsOf(group))
      jobs.push_back({kind, seed});
  if (jobs.empty())
    return;
  const Results results = runGuardJobs(jobs, request.jobs);
  std::cout << "\n### " << group << "\n\n";
  printHead({"runs with",
             "runs",
             "accepted, worse than before",
             "by 5 %",
             "refused",
             "%",
             "kept",
             "ratio, median",
             "90 %",
             "worst accepted",
             "CPU s, median",
             "most"});
  printResults("all", results);
  printBy<std::string>(
      results,
      [](const GuardResult& one) { return one.kind; },
      [](const std::string& name) { return name; });
  printBy<double>(
      results,
      [](const GuardResult& one) { return one.level; },
      [](double level) {
        std::ostringstream name;
        name << "drift x " << level;
        return name.str();
      });
  printBy<GuardVariant>(
      results,
      [](const GuardResult& one) { return one.variant; },
      [](const GuardVariant& variant) { return nameOf(variant); });
  printRunsThat("Accepted and worse than before:", results, [](const GuardResult& one) {
    return one.isWorse();
  });
  printRunsThat("Refused:", results, [](const GuardResult& one) {
    return one.outcome == RectificationOutcome::Refused;
  });
  std::cout << std::flush;
}

int
printOne(const Request& request)
{
  const RectificationRun run = runGuardCase(makeGuardCase(request.only, request.seed));
  std::cout << nameOf(run.report.outcome) << ": " << run.report.reason << "\n"
            << run.before.unaligned << " m before, " << run.after.unaligned
            << " m after; aligned " << run.before.aligned << " and "
            << run.after.aligned << " m; " << run.seconds << " s\n";
  return 0;
}

} // namespace
} // namespace pcl::acmap::bench

int
main(int argc, char** argv)
{
  using namespace pcl::acmap::bench;
  Request request;
  if (!readRequest(argc, argv, request)) {
    std::cerr << usage;
    return argc == 2 && std::string(argv[1]) == "--help" ? 0 : 2;
  }
  if (!request.only.empty())
    return printOne(request);
  for (const char* const group : {"tuning", "held_out", "logs"})
    if (request.groups.empty() || request.groups.count(group) > 0)
      printGroup(group, request);
  return 0;
}
