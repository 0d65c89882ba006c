#include "chain/egomotion_view.h"
#include "revisits/revisit_check.h"
#include "revisits/revisit_proposals.h"
#include "revisits/view_keypoints.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace pcl::acmap {

namespace {

/** What the check of a proposal finds. */
struct CheckedProposal {
  bool is_consistent = false;
  std::optional<Revisit> revisit;
};

CheckedProposal
check(const ProposedRevisit& proposal,
      const std::vector<ViewKeypoints>& views,
      const CameraViewReader& read)
{
  CheckedProposal checked;
  const std::vector<FeaturePair> alike =
      alikePairs(views[proposal.later], views[proposal.earlier]);
  checked.is_consistent = areConsistent(alike);
  if (!checked.is_consistent)
    return checked;
  checked.revisit = verifyRevisit(read(proposal.later), read(proposal.earlier), alike);
  if (checked.revisit) {
    checked.revisit->earlier = proposal.earlier;
    checked.revisit->later = proposal.later;
  }
  return checked;
}

/** Runs a part of the work for all numbers below \a count, in batches, between which
 * the progress is told. */
template <typename Work>
void
forAll(std::size_t count,
       const Progress& progress,
       double begin,
       double end,
       const char* step,
       const Work& work)
{
  constexpr std::size_t batch = 16;
  for (std::size_t first = 0; first < count; first += batch) {
    progress.tell(begin + (end - begin) * static_cast<double>(first) /
                              static_cast<double>(count),
                  step);
    oneapi::tbb::parallel_for(first, std::min(first + batch, count), work);
  }
}

} // namespace

std::vector<Revisit>
detectRevisits(const CameraViewReader& read,
               std::size_t views,
               const RevisitSettings& settings,
               const Progress& progress,
               RevisitReport& report)
{
  StepTimer timer(report);
  std::vector<ViewKeypoints> keypoints(views);
  std::vector<std::size_t> points(views), invalid(views);
  forAll(views, progress, 0, 0.3, "describe", [&](std::size_t i) {
    CameraView view = read(i);
    for (const Eigen::Vector3f& point : view.points)
      ++(point.allFinite() ? points : invalid)[i];
    completeSigmas(view);
    keypoints[i] = keypointsOf(view);
  });
  for (std::size_t i = 0; i < views; ++i) {
    report.points += points[i];
    report.invalid_points += invalid[i];
    report.keypoints += keypoints[i].keypoints.size();
  }
  report.views = views;
  timer.finish("describe");
  progress.tell(0.3, "propose");
  const std::vector<ProposedRevisit> proposals =
      proposeRevisits(keypoints, settings.min_separation);
  report.proposals = proposals.size();
  timer.finish("propose");
  std::vector<CheckedProposal> checked(proposals.size());
  forAll(proposals.size(), progress, 0.5, 1, "verify", [&](std::size_t i) {
    checked[i] = check(proposals[i], keypoints, read);
  });
  std::vector<Revisit> revisits;
  for (const CheckedProposal& proposal : checked) {
    report.consistent += proposal.is_consistent;
    if (proposal.revisit)
      revisits.push_back(*proposal.revisit);
  }
  report.verified = revisits.size();
  timer.finish("verify");
  return revisits;
}

} // namespace pcl::acmap
