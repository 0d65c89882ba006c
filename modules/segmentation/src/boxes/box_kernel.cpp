#include "boxes/box_kernel.h"

#include "boxes/box_bits.h"
#include "boxes/box_growth.h"
#include "boxes/box_templates.h"

#include <algorithm>

namespace pcl::acmap::boxes {

namespace {

bool
hasAny(const Box& box, const std::vector<bool>& is_used)
{
  for (const Side& side : box.sides)
    for (const std::size_t piece : side.pieces)
      if (is_used[piece])
        return true;
  return false;
}

/** All boxes that have no piece in common, those that save most bits first. */
std::vector<Box>
chooseBoxes(const std::vector<PlanePatch>& planes,
            const std::vector<Piece>& pieces,
            const BoxSearch& search,
            const MapScale& scale,
            const Progress& progress)
{
  std::vector<Box> chosen;
  std::vector<bool> is_used(pieces.size(), false);
  const std::vector<ConvexEdge>& edges = search.edges();
  std::vector<std::optional<Box>> candidates(edges.size());
  std::vector<bool> is_grown(edges.size(), false);
  while (true) {
    const Box* best = nullptr;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      progress.tell(0.3 + 0.6 * static_cast<double>(chosen.size()) /
                              static_cast<double>(chosen.size() + 2),
                    "boxes");
      if (is_used[edges[e].a] || is_used[edges[e].b])
        continue;
      const bool is_stale =
          !is_grown[e] || (candidates[e] && hasAny(*candidates[e], is_used));
      if (is_stale) {
        candidates[e].reset();
        is_grown[e] = true;
        for (Box& box : search.grow(edges[e], is_used)) {
          measureBits(planes, pieces, scale, 0, false, box);
          if (!candidates[e] || box.saved_bits > candidates[e]->saved_bits)
            candidates[e] = std::move(box);
        }
      }
      if (candidates[e] && candidates[e]->saved_bits > (best ? best->saved_bits : 0))
        best = &*candidates[e];
    }
    if (!best)
      return chosen;
    for (const Side& side : best->sides)
      for (const std::size_t piece : side.pieces)
        is_used[piece] = true;
    chosen.push_back(*best);
  }
}

BoxPatch
patchOf(const Box& box)
{
  BoxPatch patch;
  patch.center = box.center();
  patch.axes = box.axes;
  patch.size = box.size();
  for (std::size_t side = 0; side < box.sides.size(); ++side)
    patch.faces[side] = {box.sides[side].kind, box.sides[side].plane};
  patch.slant = box.slant;
  patch.covariance = box.covariance;
  patch.template_id = box.template_id;
  patch.saved_bits = box.saved_bits;
  return patch;
}

} // namespace

std::vector<BoxPatch>
fitBoxes(const std::vector<PlanePatch>& planes,
         const Progress& progress,
         BoxFittingReport& report)
{
  report = BoxFittingReport();
  StepTimer timer(report);
  progress.tell(0, "edges");
  report.planes = planes.size();
  const std::vector<Piece> pieces = piecesOf(planes, report.invalid_planes);
  const MapScale scale(planes, pieces);
  report.sigma = scale.sigma;
  const BoxSearch search(planes, pieces);
  report.edges = search.edges().size();
  timer.finish("edges");

  std::vector<Box> boxes = chooseBoxes(planes, pieces, search, scale, progress);
  report.templates = shareSizes(boxes, SizeOrder::Any);
  std::vector<BoxPatch> patches;
  const auto measure = [&](Box& box, std::size_t described, bool is_instance) {
    measureBits(planes, pieces, scale, described, is_instance, box);
  };
  measureInstances(report.templates, measure, boxes);
  for (const Box& box : boxes) {
    report.bits_before += box.bits_of_planes;
    report.bits_after += box.bits_of_planes - box.saved_bits;
    report.faces += box.count(BoxFaceKind::Seen) + box.count(BoxFaceKind::Slanted);
    patches.push_back(patchOf(box));
  }
  report.boxes = patches.size();
  if (pieces.empty())
    report.remarks.emplace_back("no boxes: no plane has a polygon");
  else if (patches.empty())
    report.remarks.emplace_back(
        report.edges == 0 ? "no boxes: no two planes meet in a convex edge"
                          : "no boxes: nothing that begins at a convex edge is closed");
  timer.finish("boxes");
  progress.tell(1, "done");
  return patches;
}

} // namespace pcl::acmap::boxes
