#include "frame_findings.h"

#include "fault_text.h"
#include "frame_codec.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::acmap {

namespace {

constexpr std::uint8_t full_value = 255;
constexpr double min_saturated = 0.1;
constexpr std::uint8_t highest_black = 4;
constexpr double min_black = 0.99;

template <typename Predicate>
double
shareOf(const CameraImage& image, const Predicate& predicate)
{
  const auto count = std::count_if(image.values.begin(), image.values.end(), predicate);
  return static_cast<double>(count) / static_cast<double>(image.values.size());
}

/** \brief A remark that names the cameras whose fraction of values that fulfil the
 * predicate is at least \a minimum; empty if there are none. */
template <typename Predicate>
std::string
remarkOn(const TrinocularFrame& frame,
         const Predicate& predicate,
         double minimum,
         const std::string& what)
{
  std::string cameras;
  for (std::size_t camera = 0; camera < frame.images.size(); ++camera) {
    if (frame.images[camera].empty())
      continue;
    const double share = shareOf(frame.images[camera], predicate);
    if (share >= minimum)
      cameras += (cameras.empty() ? "" : ", ") +
                 std::string(nameOf(static_cast<RigCamera>(camera))) +
                 " camera: " + std::to_string(std::lround(100.0 * share)) +
                 " % of its values are " + what;
  }
  return cameras.empty() ? ""
                         : "frame " + std::to_string(frame.number) + ": " + cameras;
}

} // namespace

FrameFindings::FrameFindings(TrinocularFileReport report)
: report_(std::move(report))
{}

void
FrameFindings::addBroken(std::uint64_t number, const std::string& fault)
{
  add(&TrinocularFileReport::broken, number, faultText(fault));
}

void
FrameFindings::addRead(const TrinocularFrame& frame)
{
  add(&TrinocularFileReport::saturated,
      frame.number,
      remarkOn(
          frame,
          [](std::uint8_t value) { return value == full_value; },
          min_saturated,
          "saturated"));
  add(&TrinocularFileReport::black,
      frame.number,
      remarkOn(
          frame,
          [](std::uint8_t value) { return value <= highest_black; },
          min_black,
          "black"));
}

TrinocularFileReport
FrameFindings::report() const
{
  const std::lock_guard lock(mutex_);
  return report_;
}

void
FrameFindings::add(std::vector<std::uint64_t> TrinocularFileReport::*list,
                   std::uint64_t number,
                   const std::string& remark)
{
  if (remark.empty())
    return;
  const std::lock_guard lock(mutex_);
  std::vector<std::uint64_t>& numbers = report_.*list;
  if (std::find(numbers.begin(), numbers.end(), number) != numbers.end())
    return;
  numbers.push_back(number);
  report_.remarks.push_back(remark);
}

} // namespace pcl::acmap
