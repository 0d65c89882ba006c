#include "recesses/recess_bits.h"

#include "description_length.h"
#include "recesses/recess_sides.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::recesses {

namespace {

/** The share of the bits of a plane that its pieces in a recess have: the equation is
 * told once for all of its pieces, an outline for each. */
double
bitsOfLeaf(const boxes::Side& leaf,
           const std::vector<boxes::Piece>& pieces,
           double bits_of_plane,
           double outline)
{
  const auto all = std::count_if(pieces.begin(), pieces.end(), [&](const auto& piece) {
    return static_cast<std::int32_t>(piece.plane) == leaf.plane;
  });
  const auto own = static_cast<double>(leaf.pieces.size());
  return own * ((bits_of_plane - outline) / static_cast<double>(all) + outline);
}

} // namespace

void
measureRecessBits(const std::vector<PlanePatch>& planes,
                  const std::vector<boxes::Piece>& pieces,
                  const boxes::MapScale& scale,
                  std::size_t templates,
                  bool is_instance,
                  boxes::Box& recess)
{
  constexpr double half_log2_of_e = 0.7213475204444817;
  const DescriptionLength length(scale.sigma, scale.sigma, scale.extent);
  const boxes::Side& leaf = recess.sides[leaf_side];
  const double points = boxes::pointsOn(planes[static_cast<std::size_t>(leaf.plane)]);
  const bool stands_on_floor = recess.sides[foot_side].kind == BoxFaceKind::Snapped;
  // the floor tells where the opening ends below
  const int edges = stands_on_floor ? 3 : 4, place = stands_on_floor ? 1 : 2;
  recess.bits_of_planes =
      bitsOfLeaf(leaf, pieces, length.plane(points), length.outline(4)) +
      length.outline(edges);
  const double size =
      is_instance ? std::log2(static_cast<double>(std::max<std::size_t>(1, templates)))
                  : length.outline(2) + length.parameter(points);
  const double names = 2 * std::log2(static_cast<double>(pieces.size())); // wall, leaf
  const double own = DescriptionLength::label + names + length.outline(place) + size +
                     half_log2_of_e * recess.misfit;
  recess.saved_bits = recess.bits_of_planes - own;
}

} // namespace pcl::acmap::recesses
