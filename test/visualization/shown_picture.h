#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief A rendered picture; rows from the bottom. */
struct ShownPicture {
  using Pixel = std::array<int, 3>;

  explicit ShownPicture(const std::string& path);

  /** \brief Fraction of the pixels that differ from the background at the left
   * border. */
  double
  covered() const;

  std::size_t
  differentColors() const;

  /** \brief Fraction of the pixels for which a predicate is true. */
  double
  share(const std::function<bool(const Pixel&)>& is_meant) const;

  /** \brief Centroid of such pixels, 0 to 1 from the left and from the top.
   * \return meaningless if there are none */
  std::array<double, 2>
  middle(const std::function<bool(const Pixel&)>& is_meant) const;

  int width = 0;
  int height = 0;
  std::vector<Pixel> pixels;
};

} // namespace pcl::acmap::test
