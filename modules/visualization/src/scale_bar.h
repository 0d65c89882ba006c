#pragma once

#include "camera.h"

#include <vtkActor2D.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>

#include <string>

namespace pcl::acmap {

/** \brief The largest of 1, 2, 5 times a power of ten that does not exceed a length. */
double
roundLength(double maximum);

/** \brief A length as text: "5 m", "20 cm", "2 km". */
std::string
lengthText(double metres);

/** \brief A bar of a round length with its text at the lower left of a picture. */
class ScaleBar {
public:
  ScaleBar();

  void
  addTo(vtkRenderer* renderer);

  /** \param[in] metres that a pixel has
   * \param[in] width, height of the picture, pixels */
  void
  set(double metres, int width, int height);

private:
  vtkNew<vtkPoints> corners_;
  vtkNew<vtkActor2D> bar_;
  vtkNew<vtkTextActor> text_;
};

/** \brief Adds a scale bar to a still picture.
 * \param[in] camera an orthographic one */
void
addScaleBar(const Camera& camera, const SceneView& view, vtkRenderer* renderer);

} // namespace pcl::acmap
