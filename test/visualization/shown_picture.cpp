#include "shown_picture.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace pcl::acmap::test {

ShownPicture::ShownPicture(const std::string& path)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  int size[3];
  reader->GetOutput()->GetDimensions(size);
  width = size[0];
  height = size[1];
  const auto* bytes =
      static_cast<const unsigned char*>(reader->GetOutput()->GetScalarPointer());
  for (int i = 0; i < width * height; ++i)
    pixels.push_back({bytes[3 * i], bytes[3 * i + 1], bytes[3 * i + 2]});
}

double
ShownPicture::covered() const
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto& border = pixels[i - i % static_cast<std::size_t>(width)];
    for (std::size_t c = 0; c < 3; ++c)
      if (std::abs(pixels[i][c] - border[c]) > 8) {
        ++count;
        break;
      }
  }
  return static_cast<double>(count) / static_cast<double>(pixels.size());
}

std::size_t
ShownPicture::differentColors() const
{
  return std::set<Pixel>(pixels.begin(), pixels.end()).size();
}

double
ShownPicture::share(const std::function<bool(const Pixel&)>& is_meant) const
{
  return static_cast<double>(std::count_if(pixels.begin(), pixels.end(), is_meant)) /
         static_cast<double>(pixels.size());
}

std::array<double, 2>
ShownPicture::middle(const std::function<bool(const Pixel&)>& is_meant) const
{
  double x = 0, y = 0, count = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i)
    if (is_meant(pixels[i])) {
      x += static_cast<double>(i % static_cast<std::size_t>(width));
      y += static_cast<double>(i / static_cast<std::size_t>(width));
      ++count;
    }
  return {x / count / width, 1 - y / count / height};
}

} // namespace pcl::acmap::test
