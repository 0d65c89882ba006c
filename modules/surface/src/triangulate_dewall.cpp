#include "dewall/dewall_kernel.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/simd_choice.h>

#include <sstream>

namespace pcl::acmap {

namespace {

void
requireWithinLimit(std::size_t bytes, std::size_t limit)
{
  if (limit == 0 || bytes <= limit)
    return;
  std::ostringstream text;
  text.precision(3);
  text << "the triangulation needs about " << static_cast<double>(bytes) / 1e9
       << " GB beside its input, allowed are " << static_cast<double>(limit) / 1e9
       << " GB";
  throw MemoryLimitException(text.str());
}

/** \brief The variant for this processor, or the one that the environment variable
 * ACMAP_SIMD selects ("base"). */
DeWallKernel&
chooseKernel()
{
#ifdef ACMAP_SIMD_AVX2
  if (isAvx2Chosen())
    return dewall_avx2::triangulate;
#endif
  return dewall::triangulate;
}

} // namespace

void
takeSensor(std::size_t width, bool is_stated, DeWallInput& input)
{
  input.is_single_view = isSingleView(input.points, width, input.sensor_origin);
  if (input.is_single_view || input.normals.size() == 0) {
    input.sensor = assessSensor(input.points, width, input.sensor_origin);
    const bool is_proved = input.sensor.outcome == SensorOutcome::Proved;
    if (is_proved && !input.is_single_view)
      input.scan = input.points;
    input.is_single_view = is_proved;
  }
  if (!input.is_single_view && is_stated)
    input.sensor.outcome = SensorOutcome::Stated;
}

std::size_t
estimateDeWallMemory(std::size_t points, bool with_normals, DeWallRule rule)
{
  constexpr std::size_t bytes_a_normal = 12, rest = 1 << 20;
  const std::size_t in_files = ScratchMemory::getResidentInEffect();
  if (in_files > 0 && rule != DeWallRule::Strict) {
    constexpr std::size_t bytes_that_stay = 8;
    return rest + in_files + points * bytes_that_stay;
  }
  const std::size_t bytes_a_point = rule == DeWallRule::Strict ? 360 : 170;
  return rest + points * (bytes_a_point + (with_normals ? bytes_a_normal : 0));
}

TriangleMesh
triangulateDeWall(const DeWallInput& input,
                  const DeWallSettings& settings,
                  const Progress& progress,
                  DeWallReport& report)
{
  static DeWallKernel& kernel = chooseKernel();
  const bool with_facing =
      input.is_single_view || input.normals.size() > 0 || settings.up;
  requireWithinLimit(
      estimateDeWallMemory(input.points.size(), with_facing, settings.rule),
      settings.memory_limit);
  return withThreads(input.threads,
                     [&] { return kernel(input, settings, progress, report); });
}

} // namespace pcl::acmap
