// Whether the drawing of a run of a recording can be what it says: in metres, with y up.
#pragma once

#include <QObject>
#include <memory>
#include <stop_token>

#include "app/gui/shell/shell.h"
#include "core/plausibility/doubt.h"
#include "widgets/background/background.h"

namespace handmap {

class MapDocument;
class RunController;
class SourceActions;

class DrawingWatch : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(DrawingWatch)
 public:
  /// All must outlive it.
  DrawingWatch(const Shell& shell, MapDocument& document, RunController& run,
               const SourceActions& sources, QObject* parent = nullptr);
  ~DrawingWatch() override;

 private:
  void look();
  void tell(const Doubts& doubts);
  void offerRemedy(const Doubt& doubt);

  const Shell& shell_;
  MapDocument& document_;
  RunController& run_;
  const SourceActions& sources_;
  std::stop_source stop_;                         ///< of the latest look
  std::shared_ptr<Lifeline<DrawingWatch>> self_;  ///< shared with the thread that looks
};

}  // namespace handmap
