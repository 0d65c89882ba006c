#include "plane_landmarks.h"

#include "map_cells.h"
#include "plane_frame.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>

namespace pcl::acmap {
namespace {

Eigen::Matrix3d
crossOf(const Eigen::Vector3d& v)
{
  Eigen::Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

/** A piece in the map. */
struct PlacedPiece {
  Eigen::Vector3d center, normal;
  const PlanePiece* piece;
  std::size_t view;
  double distance; ///< metres, from its sensor
};

constexpr double radius = 0.5; ///< metres, of a landmark along its plane

/** The free pieces near a place. */
class PieceTable {
public:
  explicit PieceTable(const std::vector<PlacedPiece>& pieces)
  : is_free_(pieces.size(), 1)
  , cells_(radius)
  {
    for (std::size_t i = 0; i < pieces.size(); ++i)
      cells_.add(pieces[i].center, i);
  }

  /** Collects the free pieces of the cells around a place, in order. */
  void
  collect(const Eigen::Vector3d& place, std::vector<std::size_t>& found)
  {
    found.clear();
    cells_.visitAround(place, [&](std::vector<std::size_t>& list) {
      list.erase(std::remove_if(list.begin(),
                                list.end(),
                                [this](std::size_t i) { return !is_free_[i]; }),
                 list.end());
      found.insert(found.end(), list.begin(), list.end());
    });
  }

  bool
  isFree(std::size_t i) const
  {
    return is_free_[i] != 0;
  }

  void
  take(std::size_t i)
  {
    is_free_[i] = 0;
  }

private:
  std::vector<char> is_free_;
  MapCells cells_;
};

/** A piece that may belong to a landmark. */
struct Member {
  std::size_t piece;
  double gate;           ///< metres, largest distance from the plane
  double variance;       ///< m^2, of its distance from the plane
  double weight = 1;     ///< robust weight
  std::size_t place = 0; ///< in the list of all candidates of its landmark
};

class Association {
public:
  Association(const PiecesOfViews& views,
              const Poses& poses,
              const RelativeCovariances& covariances,
              const AssociationGate& gate)
  : poses_(poses)
  , covariances_(covariances)
  , gate_(gate)
  , pieces_(placed(views, poses))
  , table_(pieces_)
  , slots_(poses.size(), no_slot)
  {}

  std::vector<Landmark>
  run()
  {
    std::vector<std::size_t> order(pieces_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
      return pieces_[a].piece->information() > pieces_[b].piece->information();
    });
    std::vector<Landmark> landmarks;
    Landmark landmark;
    for (const std::size_t seed : order)
      if (table_.isFree(seed) && grow(seed, landmark))
        landmarks.push_back(landmark);
    return landmarks;
  }

private:
  static constexpr std::size_t no_slot = static_cast<std::size_t>(-1);
  static constexpr std::size_t same_view = no_slot - 1;

  static std::vector<PlacedPiece>
  placed(const PiecesOfViews& views, const Poses& poses)
  {
    std::vector<PlacedPiece> pieces;
    for (std::size_t view = 0; view < views.size(); ++view)
      for (const PlanePiece& piece : views[view])
        pieces.push_back({poses[view] * piece.center,
                          poses[view].linear() * piece.normal,
                          &piece,
                          view,
                          piece.center.norm()});
    return pieces;
  }

  /** Lets \ref slots_ tell how the views are known relative to one. */
  void
  turnTo(std::size_t view)
  {
    if (view == current_)
      return;
    if (current_ != no_slot) {
      slots_[current_] = no_slot;
      for (const auto& entry : covariances_.of(current_))
        slots_[entry.other] = no_slot;
    }
    current_ = view;
    slots_[view] = same_view;
    for (const auto& entry : covariances_.of(view))
      slots_[entry.other] = entry.place;
  }

  void
  collectMembers(std::size_t seed)
  {
    const PlacedPiece& first = pieces_[seed];
    turnTo(first.view);
    table_.collect(first.center, near_);
    members_.clear();
    for (const std::size_t i : near_) {
      const PlacedPiece& piece = pieces_[i];
      const std::size_t slot = slots_[piece.view];
      if (slot == no_slot)
        continue;
      const Eigen::Vector3d way = piece.center - first.center;
      const double across = first.normal.dot(way);
      if (std::abs(across) > gate_.distance ||
          way.squaredNorm() - across * across > radius * radius)
        continue;
      const double cosine = first.normal.dot(piece.normal);
      if (cosine < 0.5)
        continue;
      double deviation = 0, turn = 0;
      if (slot != same_view) {
        const RelativeCovariance& relative = covariances_.at(slot);
        deviation = deviationAcross(relative,
                                    piece.center -
                                        poses_[covariances_.origin(slot)].translation(),
                                    first.normal);
        turn = relative.turn;
      }
      const double angle =
          std::min(0.5,
                   gate_.angle + 3 * turn +
                       2 * (first.piece->normal_sd + piece.piece->normal_sd));
      if (cosine < std::cos(angle) || 3 * deviation > gate_.distance)
        continue;
      constexpr double least = 0.03; // metres
      const double gate =
          std::min(gate_.distance, std::max(least, 3 * gate_.inner * deviation));
      const double relative = gate_.inner * deviation;
      if (std::abs(across) <= gate)
        members_.push_back({i,
                            gate,
                            1 / piece.piece->weight() + relative * relative +
                                gate_.floor.variance(piece.distance)});
    }
  }

  bool
  hasSeveralViews() const
  {
    for (const Member& member : members_)
      if (member.weight > 0 &&
          pieces_[member.piece].view != pieces_[members_.front().piece].view)
        return true;
    return false;
  }

  /** Fits the plane to the members, in the frame of the seed: height = u, v, 1 times
   * the result. */
  bool
  fit(Eigen::Vector3d& plane) const
  {
    Eigen::Matrix4d sums = Eigen::Matrix4d::Zero();
    for (const Member& member : members_) {
      if (!(member.weight > 0))
        continue;
      const Eigen::Matrix4d& cluster = clusters_[member.place];
      sums += member.weight / (cluster(3, 3) * member.variance) * cluster;
    }
    plane = HeightPlane(sums).plane;
    return plane.allFinite() && plane.head<2>().norm() < 1;
  }

  /** Is the normal known well enough? A surface that is small compared to the noise may
   * as well be the edge between two others, which moves with the view. */
  bool
  isNormalCertain() const
  {
    constexpr double max_sd = 0.025; // radians
    Eigen::Matrix4d sums = Eigen::Matrix4d::Zero();
    for (const Member& member : members_)
      sums += member.weight * clusters_[member.place];
    const Eigen::Matrix3d products = heightProducts(sums);
    const Eigen::Matrix2d spread =
        products.topLeftCorner<2, 2>() - products.topRightCorner<2, 1>() *
                                             products.bottomLeftCorner<1, 2>() /
                                             products(2, 2);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread,
                                                              Eigen::EigenvaluesOnly);
    return axes.eigenvalues()[0] * max_sd * max_sd > 1;
  }

  bool
  grow(std::size_t seed, Landmark& landmark)
  {
    collectMembers(seed);
    if (members_.size() < 2 || !hasSeveralViews())
      return false;
    const PlacedPiece& first = pieces_[seed];
    const PlaneFrame frame(first.normal, first.center);
    clusters_.clear();
    heights_.clear();
    for (std::size_t k = 0; k < members_.size(); ++k) {
      members_[k].place = k;
      const PlacedPiece& piece = pieces_[members_[k].piece];
      clusters_.push_back(frame.sumsOf(piece.piece->cluster, poses_[piece.view]));
      heights_.push_back(frame.axes * (piece.center - first.center));
    }
    constexpr int passes = 4;
    Eigen::Vector3d plane;
    for (int pass = 0; pass < passes; ++pass) {
      if (!fit(plane))
        return false;
      for (Member& member : members_) {
        const Eigen::Vector3d& place = heights_[member.place];
        const double height =
            place.z() - plane[0] * place.x() - plane[1] * place.y() - plane[2];
        const double scaled = height * height / (9 * member.variance);
        member.weight = std::abs(height) <= member.gate ? 1 / (1 + scaled) : 0;
      }
    }
    members_.erase(std::remove_if(members_.begin(),
                                  members_.end(),
                                  [](const Member& m) { return !(m.weight > 0); }),
                   members_.end());
    if (members_.size() < 2 || !hasSeveralViews() || !isNormalCertain())
      return false;
    finish(frame.axes, first.center, plane, landmark);
    return true;
  }

  void
  finish(const Eigen::Matrix3d& axes,
         const Eigen::Vector3d& origin,
         const Eigen::Vector3d& plane,
         Landmark& landmark)
  {
    landmark.center = origin + axes.row(2).transpose() * plane[2];
    landmark.normal =
        axes.transpose() * Eigen::Vector3d(-plane[0], -plane[1], 1).normalized();
    landmark.offset = 0;
    landmark.pieces = members_.size();
    landmark.views.clear();
    std::stable_sort(
        members_.begin(), members_.end(), [this](const auto& a, const auto& b) {
          return pieces_[a.piece].view < pieces_[b.piece].view;
        });
    for (const Member& member : members_) {
      const PlacedPiece& piece = pieces_[member.piece];
      table_.take(member.piece);
      if (landmark.views.empty() || landmark.views.back().view != piece.view)
        landmark.views.push_back({piece.view, Eigen::Matrix4d::Zero(), 0, 0});
      LandmarkView& view = landmark.views.back();
      view.cluster += member.weight * piece.piece->cluster;
      view.distance += member.weight * piece.piece->weight() * piece.distance;
    }
    for (LandmarkView& view : landmark.views) {
      const double weight = view.cluster(3, 3);
      view.distance /= weight;
      view.variance = 1 / weight;
      view.cluster /= 1 + weight * gate_.floor.variance(view.distance);
    }
  }

  const Poses& poses_;
  const RelativeCovariances& covariances_;
  const AssociationGate& gate_;
  std::vector<PlacedPiece> pieces_;
  PieceTable table_;
  std::vector<std::size_t> slots_; ///< place of the covariance of each view
  std::size_t current_ = no_slot;  ///< view to which they are relative
  std::vector<std::size_t> near_;
  std::vector<Member> members_;
  std::vector<Eigen::Matrix4d> clusters_; ///< of the members, frame of the seed
  std::vector<Eigen::Vector3d> heights_;  ///< centres of the members, likewise
};

} // namespace

double
deviationAcross(const RelativeCovariance& relative,
                const Eigen::Vector3d& from_origin,
                const Eigen::Vector3d& normal)
{
  Vector6 direction;
  direction << from_origin.cross(normal), normal;
  return std::sqrt(std::max(0.0, direction.dot(relative.matrix * direction)));
}

RelativeCovariances::RelativeCovariances(const PoseSystem& inverse,
                                         const Poses& poses,
                                         const std::vector<PoseSystem::Pair>& pairs)
: entries_(poses.size())
{
  for (const auto& [a, b] : pairs) {
    const Eigen::Matrix3d turn_b = poses[b].linear();
    Matrix6 from_b = Matrix6::Zero();
    from_b.topLeftCorner<3, 3>() = turn_b;
    from_b.bottomRightCorner<3, 3>() = turn_b;
    from_b.bottomLeftCorner<3, 3>() =
        -crossOf(poses[a].translation() - poses[b].translation()) * turn_b;
    RelativeCovariance relative;
    relative.matrix = from_b * inverse.inverse(b - 1, b - 1) * from_b.transpose();
    if (a > 0) {
      Matrix6 from_a = Matrix6::Zero();
      from_a.topLeftCorner<3, 3>() = poses[a].linear();
      from_a.bottomRightCorner<3, 3>() = poses[a].linear();
      const Matrix6 shared =
          from_a * inverse.inverse(a - 1, b - 1) * from_b.transpose();
      relative.matrix += from_a * inverse.inverse(a - 1, a - 1) * from_a.transpose() -
                         shared - shared.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> turn(
        Eigen::Matrix3d(relative.matrix.topLeftCorner<3, 3>()), Eigen::EigenvaluesOnly);
    relative.turn = std::sqrt(std::max(0.0, turn.eigenvalues()[2]));
    entries_[a].push_back({b, covariances_.size()});
    entries_[b].push_back({a, covariances_.size()});
    covariances_.push_back(relative);
    origins_.push_back(a);
  }
}

std::vector<Landmark>
findLandmarks(const PiecesOfViews& pieces,
              const Poses& poses,
              const RelativeCovariances& covariances,
              const AssociationGate& gate)
{
  return Association(pieces, poses, covariances, gate).run();
}

std::vector<PoseSystem::Pair>
overlappingViews(const PiecesOfViews& pieces, const Poses& poses)
{
  constexpr double edge = 1;            // metres
  constexpr std::size_t min_shared = 3; // cells
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells;
  for (std::size_t view = 0; view < pieces.size(); ++view)
    for (const PlanePiece& piece : pieces[view]) {
      std::vector<std::size_t>& views =
          cells[cellKey(poses[view] * piece.center, edge)];
      if (views.empty() || views.back() != view)
        views.push_back(view);
    }
  std::unordered_map<std::uint64_t, std::size_t> shared;
  for (const auto& cell : cells)
    for (const std::size_t a : cell.second)
      for (const std::size_t b : cell.second)
        if (a < b)
          ++shared[static_cast<std::uint64_t>(a) << 32 | b];
  std::vector<PoseSystem::Pair> pairs;
  for (std::size_t view = 0; view + 1 < pieces.size(); ++view)
    pairs.emplace_back(view, view + 1);
  for (const auto& [key, count] : shared)
    if (count >= min_shared)
      pairs.emplace_back(key >> 32, key & 0xffffffffU);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

} // namespace pcl::acmap
