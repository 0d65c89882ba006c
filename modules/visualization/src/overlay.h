#pragma once

#include "scale_bar.h"
#include "vtk_pieces.h"

#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief A row of the panel of layers. */
struct LayerRow {
  char key = 0;
  std::string name;
  std::string count;
  Color color;
  bool is_shown = false;
};

/** \brief Text over the scene of a window: the panel of layers, one line of hints, the
 * help, a card, a scale bar. */
class Overlay {
public:
  /** \param[in] window gets a second layer */
  explicit Overlay(vtkRenderWindow& window);

  ~Overlay();

  Overlay(const Overlay&) = delete;
  Overlay&
  operator=(const Overlay&) = delete;

  /** \brief The camera whose focus the scale bar refers to; null: no bar. */
  void
  setCamera(vtkRenderer* scene);

  void
  setRows(const std::vector<LayerRow>& rows);

  /** \brief The row at a pixel, counted from the lower left. */
  std::optional<std::size_t>
  rowAt(int column, int row) const;

  /** \brief Sets the line at the lower border. */
  void
  setHint(const std::string& text);

  /** \brief Sets the text at the upper right; an empty one hides it. */
  void
  setCard(const std::string& text);

  /** \brief Sets the text in the middle; an empty one hides it. */
  void
  setNotice(const std::string& text);

  bool
  hasNotice() const
  {
    return notice_->GetVisibility() != 0;
  }

private:
  struct Row {
    vtkSmartPointer<vtkTextActor> name, count;
    vtkSmartPointer<vtkActor2D> swatch;
  };

  /** \brief Lays everything out for the size of the window. */
  void
  layOut();

  vtkRenderWindow& window_;
  vtkNew<vtkRenderer> renderer_;
  vtkRenderer* scene_ = nullptr;
  unsigned long observer_ = 0;
  ScaleBar bar_;
  vtkSmartPointer<vtkActor2D> panel_;
  std::vector<Row> rows_;
  vtkNew<vtkTextActor> hint_, card_, notice_;
};

} // namespace pcl::acmap
