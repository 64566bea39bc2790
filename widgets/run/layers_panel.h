// The switches of the layers, each with the sample of how it is drawn: the legend too.
#pragma once

#include <QWidget>
#include <array>

#include "widgets/run/layers.h"

class QCheckBox;

namespace handmap {

class LayersPanel : public QWidget {
  Q_OBJECT
 public:
  explicit LayersPanel(QWidget* parent = nullptr);

  bool isOn(Layer layer) const;
  void setOn(Layer layer, bool on);
  /// Greyed out where there is nothing of this layer to show.
  void setAvailable(Layer layer, bool available);

 Q_SIGNALS:
  void toggled(handmap::Layer layer, bool on);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void paintSamples();
  QCheckBox* box(Layer layer) const { return boxes_[static_cast<std::size_t>(layer)]; }

  std::array<QCheckBox*, static_cast<std::size_t>(Layer::Count)> boxes_{};
};

}  // namespace handmap
