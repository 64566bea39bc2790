// From a photo of a drawing on paper to buildings: read in a thread of its own, looked through on
// the canvas, taken over in one step. And the sheets to draw on.
#pragma once

#include <QObject>
#include <QString>
#include <memory>

#include "app/gui/editing/sheet_camera.h"
#include "app/gui/shell/shell.h"
#include "core/paper/traced_map.h"
#include "widgets/background/background.h"
#include "widgets/messages/message_bar.h"

namespace handmap {

class FileActions;
class MapCanvas;
class MapDocument;
class PaperTool;
class ReferenceTrust;
struct PaperReview;
struct Failure;

class PaperActions : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(PaperActions)
 public:
  /// What it is given must outlive it.
  PaperActions(const Shell& shell, MapDocument& document, MapCanvas& canvas, PaperTool& tool,
               FileActions& files, ReferenceTrust& trust, QObject* parent);
  ~PaperActions() override;

  /// Of a photo. What goes wrong is told in the message bar.
  void read(const QString& path);

 private:
  void ask();
  void show(const std::shared_ptr<const PaperReading>& reading, const QString& path);
  void openCamera();
  void follow(const std::shared_ptr<const PaperReading>& reading);
  void tellSight(SheetSight sight);
  void tellOfCamera(MessageBar::Kind kind, const QString& words, const QString& hint = {});
  PaperReview reviewOf(const PaperReading& reading) const;
  void begin(const PaperReading& reading);
  void tell(const Failure& failure);
  /// Where the page lies; false: nobody says.
  bool findPlace();
  void take(const std::vector<std::size_t>& shapes);
  QString pictureFile() const;
  void printSheet();

  const Shell& shell_;
  MapDocument& document_;
  MapCanvas& canvas_;
  PaperTool& tool_;
  FileActions& files_;
  ReferenceTrust& trust_;
  SheetCamera camera_;
  std::shared_ptr<const PaperReading> reading_;
  QString photo_;
  PagePlace place_;
  std::optional<double> width_m_;                 ///< of what is drawn, as somebody said
  int request_ = 0;                               ///< an answer to an earlier one is dropped
  std::shared_ptr<Lifeline<PaperActions>> self_;  ///< shared with the threads that read
};

}  // namespace handmap
