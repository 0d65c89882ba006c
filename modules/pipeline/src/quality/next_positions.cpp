#include <pcl/pipeline/next_positions.h>

#include "quality/plan_places.h"
#include "quality/position_words.h"
#include "quality/presumed_surfaces.h"
#include "quality/seen_faces.h"

#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/parallel.h>

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace pcl {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double pi = 3.14159265358979323846;
constexpr int yaws = 12;
constexpr std::array<double, 3> pitches = {-25 * pi / 180, 0, 25 * pi / 180};

/** \brief A place on the floor where one can stand. */
struct Stand {
  Vector3d eye;
  std::size_t room;
};

/** \brief A direction of view with its image axes. */
struct View {
  Vector3d ahead, right, above;
};

std::vector<View>
viewsOf(const FloorPlan& plan)
{
  std::vector<View> views;
  for (int yaw = 0; yaw < yaws; ++yaw)
    for (const double pitch : pitches) {
      const double angle = 2 * pi * yaw / yaws;
      const Vector3d level =
          std::cos(angle) * plan.x_axis + std::sin(angle) * plan.y_axis;
      View view;
      view.ahead = std::cos(pitch) * level + std::sin(pitch) * plan.up;
      view.right = level.cross(plan.up);
      view.above = std::cos(pitch) * plan.up - std::sin(pitch) * level;
      views.push_back(view);
    }
  return views;
}

std::size_t
nearestRoom(const FloorPlan& plan, const Vector2d& place)
{
  std::size_t nearest = 0;
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t room = 0; room < plan.rooms.size(); ++room) {
    const std::vector<Vector2d>& outline = plan.rooms[room].outline;
    const double its =
        acmap::isInside(outline, place) ? 0 : acmap::distanceToLoop(outline, place);
    if (its < distance) {
      nearest = room;
      distance = its;
    }
  }
  return nearest;
}

/** \brief The places on the free floor of the rooms, and those of the sensor. */
std::vector<Stand>
standsOn(const CompactMap& map, const FloorPlan& plan, double eye_height)
{
  if (plan.rooms.empty())
    return {};
  constexpr double finest = 0.5, from_walls = 0.35, from_furniture = 0.2; // metres
  constexpr std::size_t max_stands = 300;
  double area = 0;
  for (const PlanRoom& room : plan.rooms)
    area += room.area;
  const double step =
      std::max(finest, std::sqrt(area / static_cast<double>(max_stands)));
  const auto isFree = [&](const PlanRoom& room, const Vector2d& place) {
    return acmap::isInside(room.outline, place) &&
           std::none_of(plan.furniture.begin(),
                        plan.furniture.end(),
                        [&](const PlanFurniture& one) {
                          return acmap::isInside(one.outline, place) ||
                                 acmap::distanceToLoop(one.outline, place) <
                                     from_furniture;
                        }) &&
           std::none_of(plan.columns.begin(),
                        plan.columns.end(),
                        [&](const PlanColumn& one) {
                          return (place - one.center).norm() <
                                 one.radius + from_furniture;
                        }) &&
           std::none_of(
               plan.walls.begin(), plan.walls.end(), [&](const PlanWall& wall) {
                 return acmap::distanceToSegment(wall.from, wall.to, place) <
                        from_walls;
               });
  };
  std::vector<Stand> stands;
  const auto isNew = [&](const Vector3d& eye) {
    return std::none_of(stands.begin(), stands.end(), [&](const Stand& stand) {
      return (stand.eye - eye).norm() < step / 2;
    });
  };
  for (std::size_t number = 0; number < plan.rooms.size(); ++number) {
    const PlanRoom& room = plan.rooms[number];
    Eigen::AlignedBox2d box;
    for (const Vector2d& corner : room.outline)
      box.extend(corner);
    if (box.isEmpty())
      continue;
    for (double y = box.min().y() + step / 2; y < box.max().y(); y += step)
      for (double x = box.min().x() + step / 2; x < box.max().x(); x += step)
        if (isFree(room, {x, y}))
          stands.push_back({plan.pointAt({x, y}, eye_height), number});
  }
  // somebody was there, even if nobody saw the floor
  for (const Eigen::Isometry3d& pose : map.trajectory.poses) {
    const Vector2d place = plan.placeOf(pose.translation());
    const Vector3d eye = plan.pointAt(place, eye_height);
    if (stands.size() < 2 * max_stands && isNew(eye))
      stands.push_back({eye, nearestRoom(plan, place)});
  }
  return stands;
}

/** \brief Finds which patches views show. */
class PatchVisibility {
public:
  PatchVisibility(const CompactMap& map,
                  const FloorPlan& plan,
                  const std::vector<acmap::PresumedWall>& walls,
                  const std::vector<UnseenPatch>& patches)
  : patches_(patches)
  , plan_(plan)
  , walls_(walls)
  {
    constexpr double min_area = 0.1; // square metres
    for (const PlanePatch& plane : map.planes)
      if (plane.area >= min_area)
        faces_.emplace_back(plane);
    distances_.resize(static_cast<Eigen::Index>(patches.size()),
                      static_cast<Eigen::Index>(faces_.size()));
    for (std::size_t patch = 0; patch < patches.size(); ++patch)
      for (std::size_t face = 0; face < faces_.size(); ++face)
        distances_(static_cast<Eigen::Index>(patch), static_cast<Eigen::Index>(face)) =
            static_cast<float>(faces_[face].distanceTo(patches[patch].center));
  }

  /** \brief The patches that an eye sees when it looks around, ascending. */
  std::vector<std::size_t>
  seenFrom(const Vector3d& eye, double reach) const
  {
    constexpr double nearest = 0.3, min_cosine = 0.17; // metres; 80 degrees
    std::vector<float> before;
    before.reserve(faces_.size());
    for (const acmap::SeenFace& face : faces_)
      before.push_back(static_cast<float>(face.distanceTo(eye)));
    std::vector<std::size_t> seen;
    for (std::size_t patch = 0; patch < patches_.size(); ++patch) {
      const Vector3d ray = patches_[patch].center - eye;
      const double length = ray.norm();
      if (length >= nearest && length <= reach / min_cosine &&
          -ray.dot(patches_[patch].normal) >= min_cosine * length &&
          !isHidden(eye, patch, before) && !isBehindColumn(eye, patch) &&
          !acmap::isBehindPresumed(
              walls_, plan_.placeOf(eye), plan_.placeOf(patches_[patch].center)))
        seen.push_back(patch);
    }
    return seen;
  }

private:
  bool
  isHidden(const Vector3d& eye,
           std::size_t patch,
           const std::vector<float>& before) const
  {
    constexpr float margin = 0.1F; // metres
    for (std::size_t face = 0; face < faces_.size(); ++face) {
      const float after =
          distances_(static_cast<Eigen::Index>(patch), static_cast<Eigen::Index>(face));
      if (before[face] * after >= 0 || std::abs(after) < margin)
        continue;
      const double share = before[face] / (before[face] - after);
      if (faces_[face].covers(eye + share * (patches_[patch].center - eye)))
        return true;
    }
    return false;
  }

  /** \brief Columns reach from floor to ceiling. */
  bool
  isBehindColumn(const Vector3d& eye, std::size_t patch) const
  {
    const Vector2d from = plan_.placeOf(eye),
                   to = plan_.placeOf(patches_[patch].center);
    return std::any_of(
        plan_.columns.begin(), plan_.columns.end(), [&](const PlanColumn& column) {
          return acmap::distanceToSegment(from, to, column.center) < column.radius;
        });
  }

  const std::vector<UnseenPatch>& patches_;
  const FloorPlan& plan_;
  const std::vector<acmap::PresumedWall>& walls_;
  std::vector<acmap::SeenFace> faces_;
  Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> distances_;
};

/** \brief At most this many patches of about the same total area: of each group of successive ones
 * of a role the middle one stands for all. */
std::vector<UnseenPatch>
thinned(std::vector<UnseenPatch> patches)
{
  constexpr std::size_t max_patches = 3000;
  // floor and ceiling of a place follow each other
  std::stable_sort(
      patches.begin(), patches.end(), [](const UnseenPatch& a, const UnseenPatch& b) {
        return a.role < b.role;
      });
  const std::size_t every = patches.size() / max_patches + 1;
  std::vector<UnseenPatch> thin;
  for (std::size_t begin = 0; begin < patches.size(); begin += every) {
    const std::size_t end = std::min(begin + every, patches.size());
    thin.push_back(patches[(begin + end) / 2]);
    thin.back().area = 0;
    for (std::size_t k = begin; k < end; ++k)
      thin.back().area += patches[k].area;
  }
  return thin;
}

/** \brief A stand and one of its views, and the area that it uncovers, square metres. */
struct ChosenView {
  std::size_t stand, view;
  double area;
};

/** \brief What most of an uncovered area is, and its middle. */
struct LookedAt {
  SurfaceRole role;
  Vector3d middle;
};

/** \brief Chooses the view that uncovers most, one after another. */
class PositionChoice {
public:
  /** \param[in] seen the patches that each stand sees, ascending */
  PositionChoice(const std::vector<UnseenPatch>& patches,
                 const std::vector<Stand>& stands,
                 const std::vector<std::vector<std::size_t>>& seen,
                 const std::vector<View>& views)
  : patches_(patches)
  , stands_(stands)
  , seen_(seen)
  , views_(views)
  , is_covered_(patches.size(), 0)
  {}

  void
  setFieldOfView(double horizontal, double vertical, double reach)
  {
    right_ = std::tan(horizontal / 2);
    above_ = std::tan(vertical / 2);
    reach_ = reach;
  }

  /** \return nothing if no view uncovers enough */
  std::optional<ChosenView>
  best() const
  {
    constexpr double min_uncovered = 0.2; // square metres
    ChosenView best{0, 0, min_uncovered};
    for (std::size_t stand = 0; stand < stands_.size(); ++stand)
      for (std::size_t view = 0; view < views_.size(); ++view) {
        double area = 0;
        for (const std::size_t patch : seen_[stand])
          if (isUncoveredBy(stand, view, patch))
            area += patches_[patch].area;
        if (area > best.area)
          best = {stand, view, area};
      }
    return best.area > min_uncovered ? std::optional(best) : std::nullopt;
  }

  /** \brief Counts what a view shows as covered. */
  LookedAt
  take(const ChosenView& chosen)
  {
    std::map<SurfaceRole, std::pair<double, Vector3d>> parts; // area, its moment
    for (const std::size_t patch : seen_[chosen.stand])
      if (isUncoveredBy(chosen.stand, chosen.view, patch)) {
        is_covered_[patch] = 1;
        auto& [area, moment] =
            parts.emplace(patches_[patch].role, std::pair(0.0, Vector3d::Zero().eval()))
                .first->second;
        area += patches_[patch].area;
        moment += patches_[patch].area * patches_[patch].center;
      }
    const auto largest =
        std::max_element(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
          return a.second.first < b.second.first;
        });
    return {largest->first, largest->second.second / largest->second.first};
  }

private:
  bool
  isUncoveredBy(std::size_t stand, std::size_t view, std::size_t patch) const
  {
    if (is_covered_[patch] != 0)
      return false;
    const Vector3d ray = patches_[patch].center - stands_[stand].eye;
    const double depth = ray.dot(views_[view].ahead);
    return depth > 0 && depth <= reach_ &&
           std::abs(ray.dot(views_[view].right)) <= right_ * depth &&
           std::abs(ray.dot(views_[view].above)) <= above_ * depth;
  }

  const std::vector<UnseenPatch>& patches_;
  const std::vector<Stand>& stands_;
  const std::vector<std::vector<std::size_t>>& seen_;
  const std::vector<View>& views_;
  std::vector<char> is_covered_;
  double right_ = 0, above_ = 0, reach_ = 0; ///< tangents, metres
};

} // namespace

void
NextPositions::setNumberOfPositions(int number)
{
  acmap::requireInRange("number of positions", number, 1, 20, "");
  number_ = number;
}

void
NextPositions::setEyeHeight(double height)
{
  acmap::requireInRange("eye height", height, 0.1, 10, "m");
  eye_height_ = height;
}

void
NextPositions::setFieldOfView(double horizontal, double vertical)
{
  acmap::requireInRange("horizontal field of view", horizontal, 0.1, 3, "rad");
  acmap::requireInRange("vertical field of view", vertical, 0.1, 3, "rad");
  horizontal_ = horizontal;
  vertical_ = vertical;
}

void
NextPositions::setReach(double reach)
{
  acmap::requireInRange("reach", reach, 0.5, 100, "m");
  reach_ = reach;
}

void
NextPositions::compute(const CompactMap& map,
                       const FloorPlan& plan,
                       const UnseenSurfaces& unseen)
{
  report_ = NextPositionsReport();
  acmap::StepTimer timer(report_);
  report_.unseen_area = unseen.unseen_area;
  const acmap::PresumedSurfaces presumed = acmap::presumedSurfaces(plan, unseen);
  const std::vector<UnseenPatch> patches = thinned(presumed.patches);
  const std::vector<Stand> stands = standsOn(map, plan, eye_height_);
  const std::vector<View> views = viewsOf(plan);
  report_.candidates = stands.size();
  const PatchVisibility visibility(map, plan, presumed.walls, patches);
  std::vector<std::vector<std::size_t>> seen(stands.size());
  const acmap::Progress progress(progress_);
  progress.tell(0, "looking from candidates");
  acmap::withThreads(threads_, [&] {
    oneapi::tbb::parallel_for(std::size_t{0}, stands.size(), [&](std::size_t stand) {
      seen[stand] = visibility.seenFrom(stands[stand].eye, reach_);
    });
  });
  PositionChoice choice(patches, stands, seen, views);
  choice.setFieldOfView(horizontal_, vertical_, reach_);
  while (report_.positions.size() < static_cast<std::size_t>(number_)) {
    const std::optional<ChosenView> best = choice.best();
    if (!best)
      break;
    const Stand& stand = stands[best->stand];
    NextPosition position;
    position.eye = stand.eye;
    position.direction = views[best->view].ahead;
    position.uncovered = best->area;
    position.room = static_cast<std::int32_t>(stand.room);
    const LookedAt looked = choice.take(*best);
    position.words = acmap::wordsOf(position, looked.middle, looked.role, map, plan);
    report_.positions.push_back(std::move(position));
    progress.tell(static_cast<double>(report_.positions.size()) / number_,
                  "choosing positions");
  }
  timer.finish("next positions");
}

} // namespace pcl
