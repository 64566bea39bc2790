#include "app/gui/window/narrator.h"

#include <QTimer>

#include <fmt/format.h>

#include "app/gui/run/source_actions.h"
#include "app/gui/run/transport_actions.h"
#include "app/gui/window/main_window.h"
#include "widgets/messages/message_bar.h"

namespace handmap {

Narrator::Narrator(MainWindow& window) : QObject(&window) {
  const auto drawing = [this, &window] {
    const MapDocument& document = window.document();
    sayChange("drawing", QStringLiteral("%1 buildings, %2")
                             .arg(document.map().buildings.size())
                             .arg(document.isModified() ? "modified" : "saved"));
  };
  connect(&window.document(), &MapDocument::mapChanged, this, drawing);
  connect(&window.document(), &MapDocument::fileChanged, this, drawing);
  const auto run = [this, &window] { sayChange("run", window.runs().stateInWords()); };
  connect(&window.runs(), &TransportActions::stateChanged, this, run);
  connect(&window.sources(), &SourceActions::robotChanged, this, run);
  connect(&window.sources(), &SourceActions::failed, this,
          [this](const Failure& failure) { sayChange("failed", failure.message); });
  connect(&window.messages(), &MessageBar::shown, this,
          [this](const QString& text) { sayChange("message", text); });
  QTimer::singleShot(0, this, [this] { sayChange("window", "ready"); });
}

void Narrator::sayChange(const QString& subject, const QString& state) {
  QString& said = said_[subject];
  if (said == state) return;
  said = state;
  fmt::print(stderr, "{}: {}\n", subject.toStdString(), state.toStdString());
}

}  // namespace handmap
