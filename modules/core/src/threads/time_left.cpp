#include <pcl/core/time_left.h>

#include <algorithm>
#include <iterator>

namespace pcl {

namespace {

constexpr double between_knots = 0.004;

/** Seconds at which a run reached a fraction. */
double
secondsReached(const RunTimes& times, double fraction)
{
  const auto after = std::lower_bound(
      times.begin(), times.end(), fraction, [](const auto& knot, double wanted) {
        return knot.first < wanted;
      });
  if (after == times.begin())
    return 0;
  if (after == times.end())
    return times.back().second;
  const auto before = std::prev(after);
  const double share = (fraction - before->first) / (after->first - before->first);
  return before->second + share * (after->second - before->second);
}

/** Seconds at which a run went beyond a fraction. */
double
secondsLeft(const RunTimes& times, double fraction)
{
  const auto after = std::upper_bound(
      times.begin(),
      times.end(),
      fraction + between_knots / 2,
      [](double wanted, const auto& knot) { return wanted < knot.first; });
  return after == times.end() ? times.back().second : after->second;
}

} // namespace

void
TimeLeft::tell(double fraction, double elapsed)
{
  // A stage that was finished by an earlier run is passed in no time.
  constexpr double passed = 0.1, noticed = 0.3, jump = 0.03;
  const auto& [last, since] = told_.back();
  if (fraction < last + between_knots)
    return;
  const double took = elapsed - since, step = fraction - last;
  const double takes =
      secondsReached(earlier_, fraction) - secondsReached(earlier_, last);
  if (!earlier_.empty() && (takes < noticed || took > passed * takes)) {
    compared_ += took;
    expected_ += takes;
  }
  if (step < jump || took > noticed) {
    work_ += step;
    worked_ += took;
  }
  told_.emplace_back(fraction, elapsed);
}

std::optional<double>
TimeLeft::bySpeed(double elapsed) const
{
  constexpr double min_work = 0.03, min_seconds = 1;
  const double worked = worked_ + elapsed - told_.back().second;
  if (work_ < min_work || worked < min_seconds)
    return {};
  return worked / work_ * (1 - told_.back().first);
}

double
TimeLeft::byEarlier(double elapsed) const
{
  constexpr double trust = 0.1; // in the earlier run's speed, as a part of its time
  const auto& [fraction, since] = told_.back();
  const double whole = earlier_.back().second;
  const double speed = (compared_ + trust * whole) / (expected_ + trust * whole);
  const double most = whole - secondsReached(earlier_, fraction);
  const double least = whole - secondsLeft(earlier_, fraction);
  return std::max(speed * most - (elapsed - since), speed * least);
}

std::optional<double>
TimeLeft::at(double elapsed) const
{
  return earlier_.empty() ? bySpeed(elapsed) : byEarlier(elapsed);
}

RunTimes
TimeLeft::times(double elapsed) const
{
  RunTimes all = told_;
  if (all.back().first < 1)
    all.emplace_back(1, elapsed);
  all.back().second = elapsed;
  return all;
}

} // namespace pcl
