#pragma once

#include "texturing/sheet.h"

#include <pcl/core/compact_map.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::acmap::texturing {

/** A view that may colour a tile. */
struct Candidate {
  std::int32_t view = -1;
  std::int32_t texels = 0;         ///< that it has seen
  Eigen::Array3f to_mean{0, 0, 0}; ///< mean of all views less this one's, levels of 255
  std::int64_t cost = 0;           ///< of its texels, and of those that it has not seen
};

/** The tiles of a sheet, each of which is coloured by one view. */
class TileViews {
public:
  static constexpr std::int32_t side = 16; ///< texels

  /** \brief Chooses a view for each tile: near, frontal and sharp ones that agree with what the
   * others see, and such that what the views of neighbouring tiles show at their common border
   * is alike. The sum of both is minimised by alpha expansion, each step of which is a minimum
   * cut (Boykov, Veksler, Zabih 2001).
   * \param[in] means the pictures of all canvases, with the mean of all views
   * \param[in] gains of the views */
  TileViews(const Sheet& sheet,
            const std::vector<TexturePicture*>& means,
            const std::vector<double>& gains);

  /** \brief Colours the texels that were seen: each has the colour of its tile's view, moved by
   * the difference of this view from the mean of all over a distance of some tiles, so that
   * there is no step between views. A texel that its tile's view has not seen has that of a
   * neighbouring tile's, or else keeps the mean.
   * \param[in,out] pictures of all canvases, with the mean of all views */
  void
  paint(const std::vector<TexturePicture*>& pictures) const;

private:
  struct Tile {
    std::vector<Candidate> candidates; ///< by ascending view
    std::int32_t chosen = -1;          ///< index of a candidate
  };

  /** Calls function (column, row) for each texel of a tile. */
  template <typename Function>
  void
  forTexels(std::int32_t tile_column, std::int32_t tile_row, Function&& function) const;

  void
  measure(std::int32_t tile_column,
          std::int32_t tile_row,
          const std::vector<TexturePicture*>& means);

  const Candidate*
  find(const Tile& tile, std::int32_t view) const;

  std::int32_t
  chosenView(const Tile& tile) const
  {
    return tile.chosen < 0
               ? -1
               : tile.candidates[static_cast<std::size_t>(tile.chosen)].view;
  }

  /** Difference between what two views show beside the border of two tiles, in costs. */
  std::int64_t
  seamCost(std::size_t first, std::size_t second, std::int32_t a, std::int32_t b) const;

  /** Lets each tile change to a view, if that makes the sum of costs smaller.
   * \return did any? */
  bool
  expand(std::int32_t view, const std::vector<std::size_t>& tiles);

  Eigen::Array3f
  offsetAt(std::int32_t column, std::int32_t row, std::int32_t view) const;

  std::size_t
  tileAt(std::int32_t tile_column, std::int32_t tile_row) const
  {
    return static_cast<std::size_t>(tile_row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(tile_column);
  }

  const Sheet& sheet_;
  const std::vector<double>& gains_;
  std::int32_t columns_, rows_;
  std::vector<Tile> tiles_; ///< row by row
};

} // namespace pcl::acmap::texturing
