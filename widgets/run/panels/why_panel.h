// Why a corrected wall stands where it stands, in words, with the observations that placed it, the
// strongest first.
#pragma once

#include <QWidget>
#include <optional>

#include "core/explain/wall_story.h"

class QComboBox;
class QLabel;
class QTableWidget;

namespace handmap {

class WhyPanel : public QWidget {
  Q_OBJECT
 public:
  static constexpr int kMostWitnesses = 50;

  explicit WhyPanel(QWidget* parent = nullptr);

  /// What can be asked about: the buildings of a run. Keeps what is chosen, where it is still
  /// there.
  void setMap(const Map& refined);
  void clear();
  /// Chooses a wall, as if it had been chosen here.
  void ask(std::size_t building, std::size_t wall);
  struct Wall {
    std::size_t building;
    std::size_t wall;
  };
  std::optional<Wall> asked() const;
  /// The answer. `kept`: what was seen is there to look at.
  void setStory(const WallStory& story, bool kept);
  QString words() const;

 Q_SIGNALS:
  /// The panel can be seen now, or no more.
  void shown(bool shown);
  void wallAsked(std::size_t building, std::size_t wall);
  void nothingAsked();
  /// One of the story's, as many rows as it has; nullopt: none.
  void witnessChosen(std::optional<std::size_t> witness);
  /// A row was clicked, or Enter pressed on it.
  void timeChosen(double time_s);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void fillWalls();
  void tellWall();
  void fillWitnesses(const WallStory& story);

  Map map_;
  QComboBox* buildings_;
  QComboBox* walls_;
  QLabel* words_;
  QTableWidget* witnesses_;
  std::vector<double> times_;  ///< of the witnesses
  bool filling_ = false;
};

}  // namespace handmap
