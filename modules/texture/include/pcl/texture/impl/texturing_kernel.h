#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>
#include <pcl/core/impl/byte_parcel.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/core/impl/voxel_moments.h>
#include <pcl/core/progress.h>
#include <pcl/core/trajectory.h>
#include <pcl/texture/texturing_types.h>

#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <vector>

namespace pcl::acmap {

/** \brief Settings of PlaneTexturing. Lengths in metres. \ingroup texture */
struct TexturingSettings {
  double texel_size = 0;           ///< 0: automatic, see \ref automaticTexelSize
  double maximum_distance = 0.3;   ///< from a point to the plane it colours
  int maximum_texture_size = 4088; ///< texels per side; larger polygons are tiled
  int fill_distance = -1; ///< texels, how far holes are filled; -1: 0.1 m, at least 5
  bool correct_exposure = true;
  bool paper = false;   ///< each point colours its closest plane, and nothing else does
  unsigned threads = 0; ///< 0: all
};

/** \brief Intensities of the points of a cloud, of any numeric type of
 * PCLPointField. */
struct IntensityView {
  const void* first = nullptr; ///< the value of the first point
  std::size_t stride = 0;      ///< bytes
  std::uint8_t datatype = 0;   ///< of PCLPointField

  explicit operator bool() const
  {
    return first != nullptr;
  }
};

/** \brief The stations from which the points of a merged cloud were seen, as its field `view`
 * numbers them. */
struct StationView {
  const void* first = nullptr; ///< an std::int32_t, of the first point
  std::size_t stride = 0;      ///< bytes

  explicit operator bool() const
  {
    return first != nullptr;
  }

  std::int32_t
  operator[](std::size_t i) const
  {
    std::int32_t station;
    std::memcpy(&station, static_cast<const char*>(first) + i * stride, sizeof station);
    return station;
  }
};

/** \brief Coloured points that were observed from one pose. */
struct ColoredView {
  PointView points;          ///< camera frame, metres; NaN where nothing was measured
  ColorView colors;          ///< valid at every pixel; empty if there are none
  IntensityView intensities; ///< taken as grey if there are no colours
  StationView stations;      ///< empty: all points have been seen from one station
  int width = 0; ///< pixels, of an organized cloud in row-major order; else 0
  Eigen::Isometry3d T_map_camera = Eigen::Isometry3d::Identity();

  /** \brief Were the points observed from the origin of their frame? If so, planes that
   * face away from there get no colour. */
  bool has_eye = true;
};

/** \brief View of an observation, valid as long as its cloud is unchanged.
 * \throws InitFailedException if it has no coordinates \ingroup texture */
ACMAP_EXPORT ColoredView
viewOfObservation(const TexturedObservation& observation);

/** \brief The edge of a texel where none is set, metres.
 *
 * In an image, a texel is as large as a pixel on what is near, at the lower quartile of the depths,
 * within 3 and 30 mm: each texel gets the colour of a pixel, however far apart the points are that
 * have a depth. Of other points, it is half their spacing, that of the points from which the planes
 * were fitted, on the average of all planes, and at least 3 mm: of finer ones, most would get no
 * colour. It is larger where the charts would have more than 8 million texels, half a page
 * of 4096 x 4096.
 * \param[in] view the first one that colours them */
ACMAP_EXPORT double
automaticTexelSize(const std::vector<PlanePatch>& planes,
                   const std::vector<CylinderPatch>& cylinders,
                   const ColoredView& view);

/** \brief Estimates the memory in bytes for texturing these surfaces with any number of
 * views. */
ACMAP_EXPORT double
texturingMemory(const std::vector<PlanePatch>& planes,
                const std::vector<CylinderPatch>& cylinders,
                const TexturingSettings& settings);

/** \brief Textures planes and cylinders view by view. Keeps only the best samples of each texel, so
 * that the views need not be in memory at the same time. */
class ACMAP_EXPORT TextureBuilder {
public:
  /** \param[in] planes in the map's frame; those without polygons get no chart
   * \throws BadArgumentException when all charts together have more than 50 million texels
   * of sixteen times the size */
  TextureBuilder(const std::vector<PlanePatch>& planes,
                 const std::vector<CylinderPatch>& cylinders,
                 const TexturingSettings& settings);
  ~TextureBuilder();

  void
  add(const ColoredView& view);

  /** \brief Sends what was painted so far, in several messages for \ref join.
   * \param[in] trajectory of the views */
  void
  sendTo(const Trajectory& trajectory,
         const std::function<void(const ByteParcel&)>& send) const;

  /** \brief Adds what another object has painted on the same surfaces, as if its views had been
   * added here.
   * \param[in] parcel next message of \ref sendTo
   * \param[in,out] trajectory the poses of its views are appended
   * \throws IOException if it ends early or is for other surfaces */
  void
  join(ByteParcel& parcel, Trajectory& trajectory);

  /** \brief Corrects the exposure, aligns the views, chooses one for each region and fills holes. Sets the planes and
   * cylinders of the map with their pictures, and the observations that saw each plane. */
  CompactMap
  finish(const Progress& progress, TexturingReport& report) const;

private:
  struct State;

  /** \brief Makes the canvases, whose texels may have the size for a first view. */
  void
  prepare(double automatic_texel_size) const;

  void
  alignViews(const std::vector<double>& gains) const;

  void
  showViews(const std::vector<double>& gains,
            const std::vector<TexturePicture*>& pictures) const;

  int
  fillDistance() const;

  std::unique_ptr<State> state_;
};

/** \brief Puts the shapes of surfaces into a message: all that painting needs of them. */
ACMAP_EXPORT void
putShapes(const std::vector<PlanePatch>& planes,
          const std::vector<CylinderPatch>& cylinders,
          ByteParcel& parcel);

/** \brief Takes the shapes out of a message of \ref putShapes.
 * \throws IOException if it ends early */
ACMAP_EXPORT void
takeShapes(ByteParcel& parcel,
           std::vector<PlanePatch>& planes,
           std::vector<CylinderPatch>& cylinders);

/** \brief Paints with some observations for another process
 * (PlaneTexturing::addPaintedObservations).
 * \param[in] send is called with each of several messages
 * \throws what the loaders and \a send throw */
ACMAP_EXPORT void
sendPainted(const std::vector<PlanePatch>& planes,
            const std::vector<CylinderPatch>& cylinders,
            const TexturingSettings& settings,
            const std::vector<TexturedObservationLoader>& observations,
            const std::function<void(const ByteParcel&)>& send);

} // namespace pcl::acmap
