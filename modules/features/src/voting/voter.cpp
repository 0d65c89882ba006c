#include "voting/voter.h"

#include <cmath>

namespace pcl::acmap::voting {

Voter::Voter(const Electorate& electorate,
             double radius,
             double nearest,
             const VotingSettings& settings)
: electorate_(electorate)
, settings_(settings)
, radius_(static_cast<float>(radius))
, squared_nearest_(settings.paper ? 0 : static_cast<float>(nearest * nearest))
, disc_(electorate.rings, electorate.points.size())
, shares_(electorate.points.size())
{}

VotedNormal
Voter::vote(std::int32_t vertex)
{
  // at a border, and for long edges, the disc may be too small: double the radius once
  const VotedNormal voted = voteWithin(vertex, radius_);
  return voted.vertex_class == VertexClass::Unknown && !settings_.paper
             ? voteWithin(vertex, 2 * radius_)
             : voted;
}

// The distance g of the centre of a triangle is the mean of those of its corners, and
// Page's sigma is g_max / 3. Therefore exp (-g / sigma) is the product of one factor
// per corner.
void
Voter::shareOut(float radius)
{
  for (const std::int32_t v : disc_.vertices())
    shares_[static_cast<std::size_t>(v)] = std::exp(-disc_.distance(v) / radius);
}

VotedNormal
Voter::voteWithin(std::int32_t vertex, float radius)
{
  disc_.fill(vertex, radius);
  shareOut(radius);
  const Eigen::Vector3f place = electorate_.points[static_cast<std::size_t>(vertex)];
  const auto share = [&](std::int32_t corner) {
    return shares_[static_cast<std::size_t>(corner)];
  };
  Ballot ballot;
  Eigen::Vector3f front = Eigen::Vector3f::Zero();
  for (const std::int32_t v : disc_.vertices()) {
    const Eigen::Vector3f corner =
        electorate_.points[static_cast<std::size_t>(v)] - place;
    for (const std::uint32_t t : electorate_.rings.triangles(v)) {
      const TriangleMesh::Triangle& corners = electorate_.triangles[t];
      if (!disc_.contains(corners[1]) || !disc_.contains(corners[2]))
        continue;
      const Face& face = electorate_.faces[t];
      const Eigen::Vector3f way = corner + face.center;
      const float square = way.squaredNorm();
      if (!(square > squared_nearest_))
        continue;
      const float along = face.normal.dot(way);
      const float frontal = settings_.paper ? 1 : 1 - along * along / square; // ours
      const float weight =
          face.area * share(v) * share(corners[1]) * share(corners[2]) * frontal;
      ballot.add(face.normal - (2 * along / square) * way, weight); // Eq. 6
      front += weight * face.normal;
    }
  }
  const std::size_t min_votes = settings_.paper ? 1 : 3;
  return ballot.votes() < min_votes ? noNormal() : ballot.count(front, settings_);
}

} // namespace pcl::acmap::voting
