#include "app/gui/run/drawing_watch.h"

#include <QDir>
#include <algorithm>
#include <iterator>

#include "app/gui/run/run_controller.h"
#include "app/gui/run/source_actions.h"
#include "core/plausibility/drawing.h"
#include "widgets/document/map_document.h"
#include "widgets/editing/arranging.h"
#include "widgets/messages/message_bar.h"

namespace handmap {

namespace {

const QString kDrawingDoubtTopic = QStringLiteral("drawing-doubt-");

}  // namespace

DrawingWatch::DrawingWatch(const Shell& shell, MapDocument& document, RunController& run,
                           const SourceActions& sources, QObject* parent)
    : QObject(parent),
      shell_(shell),
      document_(document),
      run_(run),
      sources_(sources),
      self_(std::make_shared<Lifeline<DrawingWatch>>(*this)) {
  connect(&run_, &RunController::begun, this, &DrawingWatch::look);
}

DrawingWatch::~DrawingWatch() {
  stop_.request_stop();
  self_->cut();
}

void DrawingWatch::look() {
  stop_.request_stop();
  stop_ = {};
  const auto& robot = sources_.robot();
  if (!robot || !robot->recording) return;
  const QString path = document_.filePath();
  startInBackground([self = self_, stop = stop_.get_token(), recording = robot->recording,
                     drawing = run_.drawing(),
                     name = (path.isEmpty() ? document_.displayName() : path).toStdString()] {
    Doubts doubts = doubtsOfDrawing(drawing, name);
    try {
      std::ranges::move(doubtsOfWay(*recording, drawing, name, stop), std::back_inserter(doubts));
    } catch (const std::exception&) {
      // stopped, or a file that the run tells of
    }
    self->post([stop, doubts](DrawingWatch& watch) {
      if (!stop.stop_requested()) watch.tell(doubts);
    });
  });
}

void DrawingWatch::tell(const Doubts& doubts) {
  for (const Doubt& doubt : doubts) {
    shell_.messages
        .show(doubt.certain ? MessageBar::Kind::Error : MessageBar::Kind::Warning,
              QString::fromStdString(doubt.message), QString::fromStdString(doubt.hint),
              kDrawingDoubtTopic + QString::fromStdString(doubt.code))
        .setQuestion();  // it stays over the run
    offerRemedy(doubt);
  }
}

/// The drawing changes, which can be undone; the run of what it was ends.
void DrawingWatch::offerRemedy(const Doubt& doubt) {
  const auto offer = [this](const QString& text, std::function<MapChange(const Map&)> change) {
    shell_.messages.addAction(text, [this, text, change = std::move(change)] {
      run_.stop();
      document_.apply(change(document_.map()), text);
    });
  };
  if (doubt.drawing_scale != 1.0) {
    offer(doubt.drawing_scale < 0.005 ? tr("Read the drawing as millimetres")
                                      : tr("Read the drawing as centimetres"),
          [scale = doubt.drawing_scale](const Map& map) { return scaled(map, scale); });
  } else if (doubt.code == "mirrored_drawing" || doubt.code == "way_through_buildings") {
    offer(tr("Mirror the drawing"),
          [](const Map& map) { return mirrored(map, allKeys(map), Along::Y); });
  }
}

}  // namespace handmap
