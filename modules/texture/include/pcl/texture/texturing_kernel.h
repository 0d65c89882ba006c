#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>
#include <pcl/core/point_view.h>
#include <pcl/core/progress.h>
#include <pcl/core/voxel_moments.h>
#include <pcl/texture/texturing_types.h>

#include <memory>

namespace pcl::acmap {

/** \brief What PlaneTexturing is told. Metres. \ingroup texture */
struct TexturingSettings {
  double texel_size = 0.02;
  double maximum_distance = 0.3;   ///< from a point to the plane it colours
  int maximum_texture_size = 4096; ///< texels a side; larger polygons are tiled
  int fill_distance = 5;           ///< texels that holes are filled from their rim
  bool correct_exposure = true;
  unsigned threads = 0; ///< 0: all
};

/** \brief Points that were seen from one pose, with their colours. */
struct ColoredView {
  PointView points; ///< camera frame, metres; NaN where nothing was measured
  ColorView colors; ///< valid at every pixel; nothing for none
  int width = 0;    ///< px, of an organized cloud: rows one after the other; else 0
  Eigen::Isometry3d T_map_camera = Eigen::Isometry3d::Identity();

  /** \brief Were the points seen from the origin of their frame? Then planes that look
   * away from there get nothing. */
  bool has_eye = true;
};

/** \brief View of an observation, valid as long as its cloud is unchanged.
 * \throws InitFailedException if it has no coordinates \ingroup texture */
ACMAP_EXPORT ColoredView
viewOfObservation(const TexturedObservation& observation);

/** \brief Bytes that painting these planes will take, however many. */
ACMAP_EXPORT double
texturingMemory(const std::vector<PlanePatch>& planes,
                const TexturingSettings& settings);

/** \brief Paints planes view by view; keeps of each texel its best samples only, so that
 * the views need not be in memory together. */
class ACMAP_EXPORT TextureBuilder {
public:
  /** \param[in] planes in the map's frame; those without polygons get no chart
   * \throws BadArgumentException when all charts together have more than 2^28 texels */
  TextureBuilder(const std::vector<PlanePatch>& planes,
                 const TexturingSettings& settings);
  ~TextureBuilder();

  void
  add(const ColoredView& view);

  /** \brief Balances, blends and fills. The map's planes and charts are set, and which
   * observations saw which plane. */
  CompactMap
  finish(const Progress& progress, TexturingReport& report) const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace pcl::acmap
