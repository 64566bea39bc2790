// The switches of the layers, each with the sample of how it is drawn, the legend too, and with how
// strongly it is drawn.
#pragma once

#include <QPixmap>
#include <QWidget>
#include <array>

#include "widgets/run/overlays/layers.h"

class QCheckBox;
class QLabel;
class QSettings;
class QSlider;

namespace handmap {

class LayersPanel : public QWidget {
  Q_OBJECT
 public:
  explicit LayersPanel(QWidget* parent = nullptr);

  bool isOn(Layer layer) const;
  void setOn(Layer layer, bool on);
  /// Whether there is anything of this layer to show: else it is not listed.
  bool isAvailable(Layer layer) const;
  void setAvailable(Layer layer, bool available);
  /// What there is nothing of is not listed: without a run its layers, and particles where the
  /// method has none.
  void setRun(bool exists, bool has_particles);
  /// Sample and name of each layer that is there and shown.
  QList<std::pair<QPixmap, QString>> legend() const;
  /// What is shown, and how strongly.
  void save(QSettings& settings) const;
  void restore(const QSettings& settings);

 Q_SIGNALS:
  void toggled(handmap::Layer layer, bool on);
  void opacityChanged(handmap::Layer layer, double share);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QSlider* makeSlider(const LayerSpec& spec);
  void paintSamples();
  QCheckBox* box(Layer layer) const { return boxes_[static_cast<std::size_t>(layer)]; }

  std::array<QCheckBox*, static_cast<std::size_t>(Layer::Count)> boxes_{};
  QLabel* unseen_sample_;      ///< of a wall that nobody saw
  QWidget* legend_ = nullptr;  ///< of the corrected map
  QLabel* doubtful_sample_;    ///< of a doubtful building
  std::array<bool, static_cast<std::size_t>(Layer::Count)> available_{};
  std::array<QSlider*, static_cast<std::size_t>(Layer::Count)> sliders_{};
};

}  // namespace handmap
