#include "texturing/canvas_painting.h"
#include "texturing/intensity_greys.h"
#include "texturing/moved_samples.h"
#include "texturing/sheet.h"
#include "texturing/texel_size.h"
#include "texturing/view_alignment.h"
#include "texturing/view_selection.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/texture/impl/texturing_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

namespace pcl::acmap {

using namespace texturing;

namespace {

/** Numbers of views and points. */
struct Counts {
  std::size_t observations = 0, views = 0; // each station of a cloud is a view
  std::size_t pinholes = 0, splatted = 0, colorless = 0;
  std::size_t invalid_points = 0, colored_points = 0, far_points = 0;

  void
  add(const Counts& other)
  {
    observations += other.observations;
    views += other.views;
    pinholes += other.pinholes;
    splatted += other.splatted;
    colorless += other.colorless;
    invalid_points += other.invalid_points;
    colored_points += other.colored_points;
    far_points += other.far_points;
  }
};

/** First value of a message of \ref TextureBuilder::sendTo. */
enum class PaintedPart : std::uint8_t { Counts, Samples, Points, Views };

bool
isPainted(const Canvas::Samples& samples)
{
  return samples.front().weight > 0;
}

bool
isPainted(const PointColors& points)
{
  return points.count > 0;
}

/** Sends the painted texels of a canvas, each with its number. */
template <typename Texels>
void
sendTexels(PaintedPart part,
           std::size_t canvas,
           const Texels& texels,
           const std::function<void(const ByteParcel&)>& send)
{
  constexpr std::size_t texels_of_part = std::size_t{1} << 17;
  for (std::size_t begin = 0; begin < texels.size(); begin += texels_of_part) {
    ByteParcel parcel;
    parcel.put(part);
    parcel.put(canvas);
    const std::size_t end = std::min(begin + texels_of_part, texels.size());
    for (std::size_t t = begin; t < end; ++t)
      if (isPainted(texels[t])) {
        parcel.put(t);
        parcel.put(texels[t]);
      }
    send(parcel);
  }
}

void
sendViews(std::size_t canvas,
          const std::vector<std::int32_t>& views,
          const std::function<void(const ByteParcel&)>& send)
{
  if (views.empty())
    return;
  ByteParcel parcel;
  parcel.put(PaintedPart::Views);
  parcel.put(canvas);
  parcel.putAll(views.data(), views.size());
  send(parcel);
}

/** Offers samples, best first, of views that follow those of the canvas: with the same weight,
 * those that are there stay before them, as if the views had been painted one after the
 * other. */
void
joinSamples(const Canvas::Samples& samples,
            std::int32_t first_view,
            std::size_t texel,
            Canvas& canvas)
{
  for (Sample sample : samples)
    if (sample.weight > 0) {
      sample.view += first_view;
      canvas.offer(texel, sample);
    }
}

} // namespace

struct TextureBuilder::State {
  std::vector<PlanePatch> planes;
  std::vector<CylinderPatch> cylinders;
  TexturingSettings settings;
  double wanted_texel_size = 0; ///< metres; 0: there are no canvases yet
  double texel_size = 0;        ///< metres; the wanted one, or a larger one
  std::vector<Canvas> canvases;
  IntensityGreys greys;
  Counts counts;
  std::vector<Eigen::Vector3d> eyes; ///< of each view, metres in the frame of the map
  std::size_t first_joined = 0; ///< number of the first view of what is being joined
  std::size_t left_out = 0;
};

TextureBuilder::TextureBuilder(const std::vector<PlanePatch>& planes,
                               const std::vector<CylinderPatch>& cylinders,
                               const TexturingSettings& settings)
: state_(std::make_unique<State>())
{
  state_->planes = planes;
  state_->cylinders = cylinders;
  state_->settings = settings;
  if (settings.texel_size > 0)
    prepare(settings.texel_size);
}

void
TextureBuilder::prepare(double automatic_texel_size) const
{
  State& state = *state_;
  if (state.wanted_texel_size > 0)
    return;
  state.wanted_texel_size = automatic_texel_size;
  state.texel_size =
      legalTexelSize(state.planes, state.cylinders, state.wanted_texel_size);
  state.canvases = canvasesOf(state.planes,
                              state.cylinders,
                              state.texel_size,
                              state.settings.maximum_texture_size,
                              state.left_out);
  for (Canvas& canvas : state.canvases)
    if (state.settings.paper)
      canvas.points.resize(canvas.mask.size());
    else
      canvas.samples.resize(canvas.mask.size());
}

double
texturingMemory(const std::vector<PlanePatch>& planes,
                const std::vector<CylinderPatch>& cylinders,
                const TexturingSettings& settings)
{
  constexpr std::size_t finished = 4; // bytes of colour and kind
  const bool is_in_files = ScratchMemory::getResidentInEffect() > 0;
  constexpr std::size_t of_images = 16; // of the alignment, and a copy of the samples
  const std::size_t of_work =
      settings.paper ? sizeof(PointColors) : 2 * sizeof(Canvas::Samples) + of_images;
  const std::size_t in_work = is_in_files ? 0 : of_work + sizeof(TexelPlace);
  const double automatic =
      settings.paper ? paper_texel_size : finestTexelSize(planes, cylinders);
  const double wanted = settings.texel_size > 0 ? settings.texel_size : automatic;
  const double texels =
      canvasTexels(planes, cylinders, legalTexelSize(planes, cylinders, wanted));
  return texels * static_cast<double>(in_work + finished);
}

TextureBuilder::~TextureBuilder() = default;

void
TextureBuilder::add(const ColoredView& given)
{
  State& state = *state_;
  ColoredView view = given;
  if (state.settings.paper) { // only the points count, from wherever they were seen
    view.width = 0;
    view.has_eye = false;
  }
  if (state.wanted_texel_size == 0)
    prepare(state.settings.paper
                ? paper_texel_size
                : automaticTexelSize(state.planes, state.cylinders, view));
  const auto number = static_cast<std::int32_t>(state.counts.views);
  const Stations stations = view.has_eye ? Stations() : Stations(view);
  ++state.counts.observations;
  state.counts.views += stations.count();
  state.eyes.resize(state.counts.views, view.T_map_camera.translation());
  std::size_t finite = 0;
  for (std::size_t i = 0; i < view.points.size(); ++i)
    finite += view.points[i].allFinite() ? 1 : 0;
  state.counts.invalid_points += view.points.size() - finite;
  LargeVector<std::uint32_t> greys;
  if (!view.colors && view.intensities) {
    greys = state.greys.packed(view.intensities, view.points.size());
    view.colors = {greys.data(), sizeof(std::uint32_t)};
  }
  if (!view.colors && view.points.size() > 0) {
    ++state.counts.colorless;
    return;
  }
  withThreads(state.settings.threads, [&] {
    const PointLabels nearest =
        nearestCanvases(view,
                        state.canvases,
                        state.settings.maximum_distance,
                        state.settings.paper ? TexelPlace::Inside : TexelPlace::Rim);
    const auto near = static_cast<std::size_t>(
        std::count_if(nearest.begin(), nearest.end(), [](std::int32_t canvas) {
          return canvas >= 0;
        }));
    state.counts.colored_points += near;
    state.counts.far_points += finite - near;
    if (state.settings.paper) {
      ++state.counts.splatted;
      addPoints(view, number, nearest, state.canvases);
    }
    else if (const std::optional<Pinhole> camera =
                 fitUprightPinhole(view.points, static_cast<std::size_t>(view.width))) {
      ++state.counts.pinholes;
      paintPinhole(view, *camera, number, nearest, state.canvases);
    }
    else {
      ++state.counts.splatted;
      splat(view, number, stations, nearest, state.canvases);
    }
  });
}

void
TextureBuilder::sendTo(const Trajectory& trajectory,
                       const std::function<void(const ByteParcel&)>& send) const
{
  prepare(paper_texel_size);
  ByteParcel head;
  head.put(PaintedPart::Counts);
  head.put(state_->counts);
  head.put(trajectory.poses.size());
  for (std::size_t i = 0; i < trajectory.poses.size(); ++i) {
    head.put(trajectory.stamps[i]);
    head.putAll(trajectory.poses[i].matrix().data(), 16);
  }
  send(head);
  for (std::size_t c = 0; c < state_->canvases.size(); ++c) {
    sendTexels(PaintedPart::Samples, c, state_->canvases[c].samples, send);
    sendTexels(PaintedPart::Points, c, state_->canvases[c].points, send);
    sendViews(c, state_->canvases[c].views, send);
  }
}

void
TextureBuilder::join(ByteParcel& parcel, Trajectory& trajectory)
{
  prepare(paper_texel_size);
  State& state = *state_;
  const auto part = parcel.take<PaintedPart>();
  if (part == PaintedPart::Counts) {
    state.first_joined = state.counts.views;
    state.counts.add(parcel.take<Counts>());
    for (auto left = parcel.take<std::size_t>(); left > 0; --left) {
      trajectory.stamps.push_back(parcel.take<double>());
      parcel.takeAll(trajectory.poses.emplace_back().matrix().data(), 16);
      state.eyes.push_back(trajectory.poses.back().translation());
    }
    state.eyes.resize(state.counts.views, Eigen::Vector3d::Zero());
    return;
  }
  const auto c = parcel.take<std::size_t>();
  if (c >= state.canvases.size())
    throw acmap::IoFault("what another process has painted is of other surfaces");
  Canvas& canvas = state.canvases[c];
  const auto first = static_cast<std::int32_t>(state.first_joined);
  while (part == PaintedPart::Views && parcel.left() > 0)
    canvas.views.push_back(first + parcel.take<std::int32_t>());
  while (parcel.left() > 0) {
    const auto texel = parcel.take<std::size_t>();
    if (texel >= canvas.mask.size())
      throw acmap::IoFault("what another process has painted is of other surfaces");
    if (part == PaintedPart::Samples)
      joinSamples(parcel.take<Canvas::Samples>(), first, texel, canvas);
    else
      canvas.points[texel].add(parcel.take<PointColors>());
  }
}

namespace {

/** For each plane, the views that contributed samples to its texels. */
std::vector<std::vector<std::int32_t>>
observationsOf(const std::vector<Canvas>& canvases, std::size_t planes)
{
  std::vector<std::set<std::int32_t>> seen(planes);
  for (const Canvas& canvas : canvases) {
    if (canvas.number >= planes)
      break; // the cylinders follow
    std::set<std::int32_t>& views = seen[canvas.number];
    views.insert(canvas.views.begin(), canvas.views.end());
    std::int32_t last = -1;
    for (const auto& samples : canvas.samples)
      for (const Sample& sample : samples)
        if (sample.weight > 0 && sample.view != last) {
          views.insert(sample.view);
          last = sample.view;
        }
  }
  std::vector<std::vector<std::int32_t>> observations;
  for (const std::set<std::int32_t>& views : seen)
    observations.emplace_back(views.begin(), views.end());
  return observations;
}

void
count(const Canvas& canvas, const TexturePicture& picture, TexturingReport& report)
{
  for (std::size_t t = 0; t < canvas.mask.size(); ++t) {
    if (canvas.mask[t] != TexelPlace::Inside)
      continue;
    ++report.texels;
    report.seen += picture.kinds[t] == TexelKind::Seen ? 1 : 0;
    report.filled += picture.kinds[t] == TexelKind::Filled ? 1 : 0;
  }
}

/** Appends charts and pictures without colours to a map with planes and cylinders.
 * \return the picture of each canvas */
std::vector<TexturePicture*>
takePictures(const std::vector<Canvas>& canvases, CompactMap& map)
{
  map.cylinder_pictures.resize(map.cylinders.size());
  for (const Canvas& canvas : canvases)
    if (canvas.number < map.planes.size())
      map.charts.push_back(canvas.chart);
  std::vector<TexturePicture*> pictures;
  for (const Canvas& canvas : canvases)
    if (canvas.number < map.planes.size())
      pictures.push_back(&map.charts[pictures.size()]);
    else {
      pictures.push_back(&map.cylinder_pictures[canvas.number - map.planes.size()]);
      *pictures.back() = canvas.chart;
    }
  return pictures;
}

/** \param[in] texel_size that was wanted, metres */
void
remark(std::size_t left_out, double texel_size, TexturingReport& report)
{
  if (report.texel_size > texel_size) {
    char text[128];
    std::snprintf(text,
                  sizeof text,
                  "texels of %.3g mm would be more than the pages of a map hold: they "
                  "have %.3g mm",
                  1000 * texel_size,
                  1000 * report.texel_size);
    report.remarks.emplace_back(text);
  }
  if (left_out > 0)
    report.remarks.push_back(
        "polygons and cylinders left out: " + std::to_string(left_out) +
        "; they have no area, or are not finite");
  if (report.charts == 0)
    report.remarks.emplace_back(
        "nothing to paint: no plane has a polygon, and there is no cylinder");
  else if (report.observations == 0)
    report.remarks.emplace_back("no observation was given: all texels are grey");
  else if (report.colorless == report.observations)
    report.remarks.emplace_back("no observation has colour: all texels are grey");
  else if (report.colorless > 0)
    report.remarks.push_back(std::to_string(report.colorless) +
                             " observations have no colour");
  if (report.charts > 0 && report.observations > report.colorless && report.seen == 0)
    report.remarks.emplace_back("no observation saw a plane: do the poses belong to "
                                "these planes?");
}

} // namespace

/** Brings what the views show onto each other, as far as their poses are not exact. */
void
TextureBuilder::alignViews(const std::vector<double>& gains) const
{
  State& state = *state_;
  const std::vector<Sheet> sheets =
      sheetsOf(state.canvases, state.settings.maximum_texture_size);
  const std::vector<Eigen::Isometry3d> moves =
      alignedMoves(state.canvases, sheets, state.eyes, gains);
  if (!moves.empty())
    moveSamples(moves, state.eyes, sheets, state.canvases);
}

/** Paints each region with one of the images, where there are any. */
void
TextureBuilder::showViews(const std::vector<double>& gains,
                          const std::vector<TexturePicture*>& pictures) const
{
  const std::vector<Sheet> sheets =
      sheetsOf(state_->canvases, state_->settings.maximum_texture_size);
  oneapi::tbb::parallel_for(std::size_t{0}, sheets.size(), [&](std::size_t i) {
    TileViews(sheets[i], pictures, gains).paint(pictures);
  });
}

/** How far holes are filled, texels. */
int
TextureBuilder::fillDistance() const
{
  constexpr double usual = 0.1; // metres
  const TexturingSettings& settings = state_->settings;
  if (settings.paper)
    return 0;
  if (settings.fill_distance >= 0)
    return settings.fill_distance;
  return std::clamp(static_cast<int>(std::lround(usual / state_->texel_size)), 5, 100);
}

CompactMap
TextureBuilder::finish(const Progress& progress, TexturingReport& report) const
{
  prepare(paper_texel_size);
  const State& state = *state_;
  return withThreads(state.settings.threads, [&] {
    report = {};
    StepTimer timer(report);
    report.observations = state.counts.observations;
    report.pinholes = state.counts.pinholes;
    report.splatted = state.counts.splatted;
    report.colorless = state.counts.colorless;
    report.invalid_points = state.counts.invalid_points;
    report.colored_points = state.counts.colored_points;
    report.far_points = state.counts.far_points;
    report.charts = state.canvases.size();
    report.texel_size = state.texel_size;
    progress.tell(0.0, "exposure");
    const bool is_paper = state.settings.paper;
    report.gains = state.settings.correct_exposure && !is_paper
                       ? exposureGains(state.canvases, state.counts.views)
                       : std::vector<double>(state.counts.views, 1.0);
    timer.finish("exposure");

    if (!is_paper && state.counts.pinholes > 1 && state.counts.splatted == 0) {
      progress.tell(0.2, "alignment");
      alignViews(report.gains);
      timer.finish("alignment");
    }

    progress.tell(0.3, "blending");
    CompactMap map;
    map.planes = state.planes;
    map.cylinders = state.cylinders;
    map.observations = observationsOf(state.canvases, state.planes.size());
    const std::vector<TexturePicture*> pictures = takePictures(state.canvases, map);
    oneapi::tbb::parallel_for(std::size_t{0}, pictures.size(), [&](std::size_t c) {
      if (is_paper)
        average(state.canvases[c], *pictures[c]);
      else
        blend(report.gains, state.canvases[c], *pictures[c]);
    });
    if (!is_paper && state.counts.pinholes > 0)
      showViews(report.gains, pictures);
    const int fill_distance = fillDistance();
    oneapi::tbb::parallel_for(std::size_t{0}, pictures.size(), [&](std::size_t c) {
      fillHoles(fill_distance, state.canvases[c].mask, *pictures[c]);
    });
    for (std::size_t c = 0; c < pictures.size(); ++c)
      count(state.canvases[c], *pictures[c], report);
    map.exposure = displayExposure(map);
    timer.finish("blending");
    remark(state.left_out, state.wanted_texel_size, report);
    progress.tell(1.0, "done");
    return map;
  });
}

} // namespace pcl::acmap
