#include "guard_runs.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <stdexcept>

namespace pcl::acmap::bench {
namespace {

/** What a process tells about a run. */
struct Message {
  std::size_t job;
  RectificationOutcome outcome;
  double before[2], after[2]; ///< unaligned, aligned
  double seconds;
};

/** Runs every Nth job and writes the figures to a pipe. */
void
runShare(const std::vector<GuardJob>& jobs,
         std::size_t first,
         std::size_t step,
         int pipe_end)
{
  for (std::size_t i = first; i < jobs.size(); i += step) {
    const RectificationRun run =
        runGuardCase(makeGuardCase(jobs[i].kind, jobs[i].seed));
    const Message message{i,
                          run.report.outcome,
                          {run.before.unaligned, run.before.aligned},
                          {run.after.unaligned, run.after.aligned},
                          run.seconds};
    if (write(pipe_end, &message, sizeof(message)) != sizeof(message))
      _exit(1);
  }
}

GuardResult
resultOf(const GuardJob& job, const Message& message)
{
  GuardResult result;
  result.kind = job.kind;
  result.seed = job.seed;
  result.level = driftLevelOf(job.seed);
  result.variant = variantOf(job.seed);
  result.outcome = message.outcome;
  result.before = {message.before[0], message.before[1]};
  result.after = {message.after[0], message.after[1]};
  result.seconds = message.seconds;
  return result;
}

} // namespace

RectificationRun
runGuardCase(const GuardCase& made)
{
  return rectifyMap(made.map, made.given, [&](Rectification& rectification) {
    rectification.setOdometryNoise(made.told);
  });
}

std::vector<GuardResult>
runGuardJobs(const std::vector<GuardJob>& jobs, std::size_t processes)
{
  int ends[2];
  if (pipe(ends) != 0)
    throw std::runtime_error("no pipe to the processes");
  for (std::size_t i = 0; i < processes; ++i)
    if (fork() == 0) {
      runShare(jobs, i, processes, ends[1]);
      _exit(0);
    }
  close(ends[1]);
  std::vector<GuardResult> results(jobs.size());
  std::size_t done = 0;
  for (Message message; read(ends[0], &message, sizeof(message)) == sizeof(message);) {
    results[message.job] = resultOf(jobs[message.job], message);
    const GuardResult& one = results[message.job];
    std::cerr << ++done << " of " << jobs.size() << ": " << one.kind << ' ' << one.seed
              << ' ' << one.level << ' ' << nameOf(one.variant) << ' '
              << nameOf(one.outcome) << ' ' << one.before.unaligned << ' '
              << one.after.unaligned << ' ' << one.seconds << '\n';
  }
  close(ends[0]);
  while (wait(nullptr) > 0) {
  }
  if (done != jobs.size())
    throw std::runtime_error("a process ended early");
  return results;
}

} // namespace pcl::acmap::bench
