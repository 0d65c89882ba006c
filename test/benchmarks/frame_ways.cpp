#include "frame_ways.h"

#include <pcl/acquisition/trinocular_file_grabber.h>
#include <pcl/acquisition/trinocular_recorder.h>
#include <pcl/core/image_file.h>
#include <pcl/core/output_file.h>

#include <filesystem>
#include <fstream>
#include <optional>

namespace pcl::acmap::bench {

namespace {

class FolderWay : public FrameWay {
public:
  explicit FolderWay(std::string folder)
  : folder_(std::move(folder))
  {}

  std::uintmax_t
  bytes() const override
  {
    std::uintmax_t bytes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
      bytes += entry.file_size();
    return bytes;
  }

protected:
  std::string folder_;
};

class SessionWay : public FolderWay {
public:
  SessionWay(const std::string& folder, const TrinocularRig& rig)
  : FolderWay(folder)
  , recorder_(folder, rig)
  {}

  std::string
  name() const override
  {
    return "session";
  }

  void
  write(const TrinocularFrame& frame) override
  {
    recorder_.record(frame);
  }

  void
  finish() override
  {
    recorder_.finish();
    grabber_.emplace(folder_);
  }

  std::array<CameraImage, 3>
  read(std::size_t number) const override
  {
    return std::move(grabber_->frame(number)->images);
  }

private:
  TrinocularRecorder recorder_;
  std::optional<TrinocularFileGrabber> grabber_;
};

/** Stores the images of each camera in numbered files. */
class ImageWay : public FolderWay {
public:
  ImageWay(std::string folder, std::string ending)
  : FolderWay(std::move(folder))
  , ending_(std::move(ending))
  {
    std::filesystem::create_directory(folder_);
  }

  void
  write(const TrinocularFrame& frame) override
  {
    for (std::size_t camera = 0; camera < frame.images.size(); ++camera) {
      OutputFile file(path(frames_, camera));
      writeImage(frame.images[camera], file);
      file.commit();
    }
    shape_ = frame.images;
    for (CameraImage& image : shape_)
      image.values.clear();
    ++frames_;
  }

  void
  finish() override
  {}

  std::array<CameraImage, 3>
  read(std::size_t number) const override
  {
    std::array<CameraImage, 3> images = shape_;
    for (std::size_t camera = 0; camera < images.size(); ++camera)
      readImage(path(number, camera), images[camera]);
    return images;
  }

private:
  virtual void
  writeImage(const CameraImage& image, OutputFile& file) const = 0;

  /** \param[in,out] image has the correct size */
  virtual void
  readImage(const std::string& path, CameraImage& image) const = 0;

  std::string
  path(std::size_t frame, std::size_t camera) const
  {
    return folder_ + "/" + std::to_string(frame) + "_" + std::to_string(camera) +
           ending_;
  }

  std::string ending_;
  std::size_t frames_ = 0;
  std::array<CameraImage, 3> shape_;
};

class PlainWay : public ImageWay {
public:
  explicit PlainWay(const std::string& folder)
  : ImageWay(folder, ".raw")
  {}

  std::string
  name() const override
  {
    return "plain files";
  }

private:
  void
  writeImage(const CameraImage& image, OutputFile& file) const override
  {
    file.write(image.values.data(), image.values.size());
  }

  void
  readImage(const std::string& path, CameraImage& image) const override
  {
    image.values.resize(static_cast<std::size_t>(image.channels) *
                        static_cast<std::size_t>(image.width) *
                        static_cast<std::size_t>(image.height));
    std::ifstream file(path, std::ios::binary);
    file.read(reinterpret_cast<char*>(image.values.data()),
              static_cast<std::streamsize>(image.values.size()));
  }
};

class PngWay : public ImageWay {
public:
  explicit PngWay(const std::string& folder)
  : ImageWay(folder, ".png")
  {}

  std::string
  name() const override
  {
    return "PNG";
  }

private:
  void
  writeImage(const CameraImage& image, OutputFile& file) const override
  {
    const std::vector<std::uint8_t> bytes =
        image.channels == 1
            ? encodePng(image.width, image.height, image.values)
            : encodePng(RgbImage{image.width, image.height, image.values});
    file.write(bytes.data(), bytes.size());
  }

  void
  readImage(const std::string& path, CameraImage& image) const override
  {
    if (image.channels == 3) {
      image.values = loadRgbImage(path).values;
      return;
    }
    const GrayImage16 gray = loadGrayImage16(path);
    image.values.assign(gray.values.begin(), gray.values.end());
  }
};

} // namespace

std::vector<std::unique_ptr<FrameWay>>
waysToKeepFrames(const std::string& folder, const TrinocularRig& rig)
{
  std::vector<std::unique_ptr<FrameWay>> ways;
  ways.push_back(std::make_unique<PlainWay>(folder + "/plain"));
  ways.push_back(std::make_unique<SessionWay>(folder + "/session", rig));
  ways.push_back(std::make_unique<PngWay>(folder + "/png"));
  return ways;
}

} // namespace pcl::acmap::bench
