#include "disparity_errors.h"

#include "statistics.h"

#include <cmath>

namespace pcl::acmap::bench {

namespace {

/** Calls a function with index and signed error of each pixel of a mask with a
 * disparity. */
template <typename Function>
void
forEachError(const DisparityImage& found,
             const DisparityImage& truth,
             const PixelMask& mask,
             const Function& function)
{
  for (std::size_t i = 0; i < mask.size(); ++i)
    if (mask[i] != 0 && !std::isnan(found.values[i]))
      function(i, static_cast<double>(found.values[i]) - truth.values[i]);
}

bool
isBad(double error)
{
  return std::abs(error) > DisparityErrors::bad_error;
}

double
mean(const std::vector<double>& values)
{
  double sum = 0;
  for (const double value : values)
    sum += value;
  return sum / static_cast<double>(values.size());
}

double
deviation(const std::vector<double>& values)
{
  const double middle = mean(values);
  double squares = 0;
  for (const double value : values)
    squares += (value - middle) * (value - middle);
  return std::sqrt(squares / static_cast<double>(values.size()));
}

} // namespace

void
DisparityErrors::add(const DisparityImage& found,
                     const DisparityImage& truth,
                     const PixelMask& mask)
{
  for (const std::uint8_t flag : mask)
    judged_ += flag != 0 ? 1 : 0;
  forEachError(found, truth, mask, [&](std::size_t, double error) {
    errors_.push_back(std::abs(error));
    wrong_ += isBad(error) ? 1 : 0;
  });
}

double
DisparityErrors::bad() const
{
  return percent(judged_ - errors_.size() + wrong_, judged_);
}

double
DisparityErrors::present() const
{
  return percent(errors_.size(), judged_);
}

double
DisparityErrors::wrong() const
{
  return percent(wrong_, judged_);
}

double
DisparityErrors::medianError() const
{
  return median(errors_);
}

double
DisparityErrors::rms() const
{
  double squares = 0;
  for (const double error : errors_)
    squares += isBad(error) ? 0 : error * error;
  return std::sqrt(squares / static_cast<double>(errors_.size() - wrong_));
}

void
FractionErrors::add(const DisparityImage& found,
                    const DisparityImage& truth,
                    const PixelMask& mask)
{
  forEachError(found, truth, mask, [&](std::size_t i, double error) {
    if (isBad(error))
      return;
    const double disparity = truth.values[i];
    const double fraction = disparity - std::floor(disparity);
    errors_[static_cast<std::size_t>(fraction * bins) % bins].push_back(error);
  });
}

double
FractionErrors::meanOf(std::size_t bin) const
{
  return mean(errors_[bin]);
}

double
FractionErrors::medianOf(std::size_t bin) const
{
  return median(errors_[bin]);
}

double
FractionErrors::lockingOfMeans() const
{
  std::vector<double> means;
  for (std::size_t bin = 0; bin < bins; ++bin)
    means.push_back(meanOf(bin));
  return deviation(means);
}

double
FractionErrors::lockingOfMedians() const
{
  std::vector<double> medians;
  for (std::size_t bin = 0; bin < bins; ++bin)
    medians.push_back(medianOf(bin));
  return deviation(medians);
}

void
SigmaErrors::add(const DisparityImage& found,
                 const std::vector<float>& sigma,
                 const DisparityImage& truth,
                 const PixelMask& mask)
{
  forEachError(found, truth, mask, [&](std::size_t i, double error) {
    if (isBad(error))
      return;
    ++count_;
    sigmas_ += sigma[i];
    squares_ += error * error / (static_cast<double>(sigma[i]) * sigma[i]);
  });
}

double
SigmaErrors::ratio() const
{
  return std::sqrt(squares_ / static_cast<double>(count_));
}

double
SigmaErrors::meanSigma() const
{
  return sigmas_ / static_cast<double>(count_);
}

} // namespace pcl::acmap::bench
