#include "fault_text.h"
#include "frame_source.h"
#include "session_folder.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/rig_cameras.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace pcl::acmap {

namespace {

using CameraLists = std::array<const std::vector<std::string>*, 3>;

CameraLists
byCamera(const TrinocularImageLists& lists)
{
  return {&lists.reference, &lists.horizontal, &lists.vertical};
}

std::string
placeOf(std::size_t frame, std::size_t camera)
{
  return "frame " + std::to_string(frame) + ": " +
         nameOf(static_cast<RigCamera>(camera)) + " camera";
}

CameraImage
loadImage(const std::string& path, const TrinocularRig& rig)
{
  CameraImage image = loadCameraImage(path);
  ImageRecord record;
  record.width = static_cast<std::uint32_t>(image.width);
  record.height = static_cast<std::uint32_t>(image.height);
  const std::string fault = faultOfSize(record, rig);
  if (!fault.empty())
    throw InputFileException(path + ": " + fault);
  return image;
}

class ImageListSource : public FrameSource {
public:
  ImageListSource(TrinocularImageLists lists, const TrinocularRig& rig)
  : lists_(std::move(lists))
  , rig_(rig)
  {}

  std::size_t
  size() const override
  {
    return lists_.reference.size();
  }

  std::uint64_t
  number(std::size_t index) const override
  {
    return index;
  }

  std::optional<std::int32_t>
  observation(std::size_t) const override
  {
    return 0;
  }

  std::string
  folder() const override
  {
    return {};
  }

  TrinocularFrame
  read(std::size_t index) const override
  {
    const CameraLists lists = byCamera(lists_);
    TrinocularFrame frame;
    frame.number = index;
    frame.pattern = static_cast<std::int32_t>(index);
    for (std::size_t camera = 0; camera < lists.size(); ++camera)
      try {
        if (!lists[camera]->empty())
          frame.images[camera] = loadImage((*lists[camera])[index], rig_);
      }
      catch (const InputFileException& exception) {
        throw InputFileException(placeOf(index, camera) + ": " +
                                 faultText(exception.what()));
      }
    return frame;
  }

  const TrinocularRig&
  rig() const override
  {
    return rig_;
  }

private:
  TrinocularImageLists lists_;
  TrinocularRig rig_;
};

/** Each camera of the rig needs one image per frame. */
void
requireComplete(const CameraLists& lists, const TrinocularRig& rig)
{
  for (std::size_t camera = 0; camera < lists.size(); ++camera) {
    const std::size_t has = lists[camera]->size();
    const std::size_t needed =
        hasCamera(rig, rig_cameras[camera]) ? lists.front()->size() : 0;
    if (has != needed)
      throw acmap::BadArgument(placeOf(std::min(has, needed), camera) + ": " +
                               std::to_string(has) + " images, " +
                               std::to_string(needed) + " are needed");
  }
}

/** Each image may be used for one frame and one camera only. */
void
requireDifferent(const CameraLists& lists)
{
  std::map<std::string, std::string> places;
  for (std::size_t camera = 0; camera < lists.size(); ++camera)
    for (std::size_t frame = 0; frame < lists[camera]->size(); ++frame) {
      const std::string& path = (*lists[camera])[frame];
      const std::string place = placeOf(frame, camera);
      const auto [known, is_new] = places.emplace(path, place);
      if (!is_new)
        throw acmap::BadArgument(place + ": " + path +
                                 " was there before: " + known->second);
    }
}

} // namespace

std::unique_ptr<FrameSource>
openImageLists(const TrinocularImageLists& lists, const TrinocularRig& rig)
{
  requireSoundRig(rig);
  requireComplete(byCamera(lists), rig);
  requireDifferent(byCamera(lists));
  return std::make_unique<ImageListSource>(lists, rig);
}

} // namespace pcl::acmap
