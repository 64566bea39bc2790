#include "app/gui/window/application.h"

#include <new>

#include <fmt/format.h>

#include "core/base/error.h"

namespace handmap {

namespace {

constexpr qint64 kSameAgainMs = 2'000;

QString leftUndone() { return Application::tr("It was left undone; the program goes on."); }

}  // namespace

Application& Application::instance() {
  return *qobject_cast<Application*>(QCoreApplication::instance());
}

bool Application::notify(QObject* receiver, QEvent* event) {
  try {
    return QApplication::notify(receiver, event);
  } catch (const Error& error) {
    tell(QString::fromStdString(error.what()), QString::fromStdString(error.hint()));
  } catch (const std::bad_alloc&) {
    tell(tr("There is not enough memory for this."), leftUndone());
  } catch (const std::exception& error) {
    tell(tr("Something unexpected went wrong: %1").arg(QString::fromUtf8(error.what())),
         leftUndone());
  } catch (...) {
    tell(tr("Something unexpected went wrong."), leftUndone());
  }
  return true;
}

void Application::tell(const QString& message, const QString& hint) noexcept {
  try {
    const bool again = message == told_ && since_.isValid() && since_.elapsed() < kSameAgainMs;
    since_.start();
    if (again) return;
    told_ = message;
    fmt::print(stderr, "handmap: {}\n", message.toStdString());
    QMetaObject::invokeMethod(
        this, [this, message, hint] { Q_EMIT failed(message, hint); }, Qt::QueuedConnection);
  } catch (...) {
    // No memory even for that: the next failure will be told.
    told_.clear();
  }
}

}  // namespace handmap
