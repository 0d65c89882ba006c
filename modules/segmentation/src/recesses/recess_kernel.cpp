#include "recesses/recess_kernel.h"

#include "boxes/box_templates.h"
#include "recesses/recess_bits.h"
#include "recesses/recess_search.h"
#include "recesses/recess_sides.h"

#include <pcl/core/map_up.h>

#include <algorithm>

namespace pcl::acmap::recesses {

namespace {

using boxes::Box;
using boxes::Piece;

Eigen::Vector3d
upOf(const std::vector<PlanePatch>& planes)
{
  CompactMap map;
  map.planes = planes;
  return upDirection(map);
}

/** Number of different leaves. */
std::size_t
leavesOf(const std::vector<LeafBehindWall>& pairs)
{
  std::size_t leaves = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) // in the order of the leaves
    leaves += i == 0 || pairs[i].leaf != pairs[i - 1].leaf ? 1 : 0;
  return leaves;
}

/** Are two recesses at one place? */
bool
overlap(const Box& a, const Box& b)
{
  const Eigen::Vector3d between = a.axes.transpose() * (b.center() - a.center());
  return (between.cwiseAbs() - (a.size() + b.size()) / 2).maxCoeff() < 0;
}

/** Recesses at different places, those that save most bits first. */
std::vector<Box>
chooseRecesses(const std::vector<PlanePatch>& planes,
               const std::vector<Piece>& pieces,
               const RecessSearch& search,
               const boxes::MapScale& scale,
               const Progress& progress)
{
  std::vector<Box> candidates, chosen;
  const std::vector<LeafBehindWall>& pairs = search.pairs();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    progress.tell(0.3 +
                      0.7 * static_cast<double>(i) / static_cast<double>(pairs.size()),
                  "recesses");
    if (std::optional<Box> recess = search.fit(pairs[i])) {
      measureRecessBits(planes, pieces, scale, 0, false, *recess);
      if (recess->saved_bits > 0)
        candidates.push_back(std::move(*recess));
    }
  }
  std::stable_sort(
      candidates.begin(), candidates.end(), [](const Box& a, const Box& b) {
        return a.saved_bits > b.saved_bits;
      });
  for (const Box& candidate : candidates)
    if (std::none_of(chosen.begin(), chosen.end(), [&](const Box& other) {
          return overlap(candidate, other);
        }))
      chosen.push_back(candidate);
  return chosen;
}

/** From shifts of the middle of a recess to those of the middle of its opening. */
Eigen::Matrix<double, 9, 9>
toOpening(double depth)
{
  Eigen::Matrix<double, 9, 9> change = Eigen::Matrix<double, 9, 9>::Identity();
  change(3, 1) = depth / 2;
  change(4, 0) = -depth / 2;
  change(5, 8) = 0.5;
  return change;
}

RecessPatch
patchOf(const Box& recess)
{
  RecessPatch patch;
  patch.axes = recess.axes;
  patch.size = recess.size();
  patch.center = recess.center() + patch.size.z() / 2 * patch.axes.col(2);
  patch.wall = recess.sides[wall_side].plane;
  patch.leaf = recess.sides[leaf_side].plane;
  patch.reaches_floor = recess.sides[foot_side].kind == BoxFaceKind::Snapped;
  const Eigen::Matrix<double, 9, 9> change = toOpening(patch.size.z());
  patch.covariance = change * recess.covariance * change.transpose();
  patch.template_id = recess.template_id;
  patch.saved_bits = recess.saved_bits;
  return patch;
}

/** Why there are no recesses. */
const char*
reasonOfNone(const std::vector<Piece>& pieces, const RecessFittingReport& report)
{
  if (pieces.empty())
    return "no recesses: no plane has a polygon";
  return report.leaves == 0 ? "no recesses: no plane is behind a parallel wall"
                            : "no recesses: no plane closes a rectangular opening of a "
                              "wall";
}

} // namespace

std::vector<RecessPatch>
fitRecesses(const std::vector<PlanePatch>& planes,
            const Progress& progress,
            RecessFittingReport& report)
{
  report = RecessFittingReport();
  StepTimer timer(report);
  progress.tell(0, "leaves");
  report.planes = planes.size();
  const std::vector<Piece> pieces = boxes::piecesOf(planes, report.invalid_planes);
  const boxes::MapScale scale(planes, pieces);
  report.sigma = scale.sigma;
  const RecessSearch search(planes, pieces, upOf(planes));
  report.leaves = leavesOf(search.pairs());
  timer.finish("leaves");

  std::vector<Box> recesses = chooseRecesses(planes, pieces, search, scale, progress);
  report.templates = boxes::shareSizes(recesses, boxes::SizeOrder::Given);
  std::vector<RecessPatch> patches;
  const auto measure = [&](Box& recess, std::size_t described, bool is_instance) {
    measureRecessBits(planes, pieces, scale, described, is_instance, recess);
  };
  boxes::measureInstances(report.templates, measure, recesses);
  for (const Box& recess : recesses) {
    report.bits_before += recess.bits_of_planes;
    report.bits_after += recess.bits_of_planes - recess.saved_bits;
    patches.push_back(patchOf(recess));
  }
  report.recesses = patches.size();
  if (patches.empty())
    report.remarks.emplace_back(reasonOfNone(pieces, report));
  timer.finish("recesses");
  progress.tell(1, "done");
  return patches;
}

} // namespace pcl::acmap::recesses
