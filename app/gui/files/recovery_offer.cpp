#include "app/gui/files/recovery_offer.h"

#include <QFileInfo>
#include <QLocale>
#include <QWidget>
#include <algorithm>

#include "core/base/error.h"
#include "widgets/canvas/map_picture.h"
#include "widgets/messages/message_bar.h"
#include "widgets/style/colours.h"

namespace handmap {

namespace {

constexpr QSize kPictureSize(120, 80);
constexpr auto kRecoveryOfferTopic = "recovery";

QString counted(qsizetype count, const QString& one, const QString& many) {
  return count == 1 ? one : many.arg(count);
}

QString contentsOf(const UnsavedWork& work) {
  QString text = counted(static_cast<qsizetype>(work.map.buildings.size()),
                         QObject::tr("1 building"), QObject::tr("%1 buildings"));
  if (!work.teaching.isEmpty()) {
    text += QStringLiteral(", ") + counted(static_cast<qsizetype>(work.teaching.images.size()),
                                           QObject::tr("1 taught image"),
                                           QObject::tr("%1 taught images"));
  }
  const QString when =
      QLocale().toString(work.written.toLocalTime(), QStringLiteral("d MMMM yyyy, HH:mm"));
  return QObject::tr("%1, %2").arg(text, when) +
         (work.project.isEmpty() ? QString() : QLatin1Char('\n') + work.project);
}

}  // namespace

RecoveryOffer::RecoveryOffer(QWidget& window, MessageBar& messages, Recovery& recovery,
                             std::function<bool()> may_leave, QObject* parent)
    : QObject(parent),
      window_(window),
      messages_(messages),
      recovery_(recovery),
      may_leave_(std::move(may_leave)) {}

void RecoveryOffer::look() {
  if (!waiting_.empty()) return;
  waiting_ = recovery_.takeLeftBehind();
  std::ranges::sort(waiting_, {},
                    [](const LeftBehind& left) { return QFileInfo(left.file).lastModified(); });
  offerNext();
}

void RecoveryOffer::offerNext() {
  if (waiting_.empty()) return;
  const LeftBehind& left = waiting_.back();
  try {
    offer(left, readWork(left.file));
  } catch (const std::exception& error) {
    tellUnreadable(left, QString::fromUtf8(error.what()));
  }
}

void RecoveryOffer::answered() {
  waiting_.pop_back();
  offerNext();
}

void RecoveryOffer::offer(const LeftBehind& left, const UnsavedWork& work) {
  Message& message =
      messages_.ask(tr("An earlier session ended with unsaved changes to “%1”.").arg(work.name()),
                    contentsOf(work), kRecoveryOfferTopic);
  const qreal ratio = window_.devicePixelRatioF();
  QImage picture = pictureOf(work.map, kPictureSize * ratio, Colours::of(window_.palette()));
  picture.setDevicePixelRatio(ratio);
  message.setPicture(picture);
  message.addAction(tr("Re&cover"), [this, left, work] { recover(left, work); });
  message.addAction(tr("Disc&ard"), [this, left] {
    recovery_.forget(left);
    answered();
  });
  connect(&message, &Message::putOff, this, &RecoveryOffer::answered);
}

void RecoveryOffer::tellUnreadable(const LeftBehind& left, const QString& problem) {
  Message& message =
      messages_.ask(tr("What an earlier session left behind cannot be read: %1").arg(problem),
                    tr("Closing this message keeps the file."), kRecoveryOfferTopic);
  message.addAction(tr("Delete the file"), [this, left] {
    recovery_.forget(left);
    answered();
  });
  connect(&message, &Message::putOff, this, &RecoveryOffer::answered);
}

void RecoveryOffer::recover(const LeftBehind& left, const UnsavedWork& work) {
  if (!may_leave_()) return offerNext();
  try {
    recovery_.recover(left, work);
  } catch (const Error& error) {
    messages_.show(MessageBar::Kind::Error, QString::fromUtf8(error.what()),
                   QString::fromStdString(error.hint()));
    return offerNext();
  }
  Q_EMIT recovered(!work.teaching.isEmpty());
  answered();
}

}  // namespace handmap
