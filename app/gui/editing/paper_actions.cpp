#include "app/gui/editing/paper_actions.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>
#include <variant>

#include "app/gui/files/file_actions.h"
#include "app/gui/files/reference_trust.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/map/references.h"
#include "core/recording/image_file.h"
#include "core/simulation/drawn_by_people.h"
#include "drivers/camera/image_devices.h"
#include "widgets/actions/action_set.h"
#include "widgets/background/failure.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/messages/dialogs.h"
#include "widgets/messages/message_bar.h"
#include "widgets/tools/paper_tool.h"

namespace handmap {

namespace {

constexpr auto kPaperFolderKey = "paper/folder";
constexpr auto kCameraKey = "paper/camera";
constexpr auto kPaperTopic = "paper";
constexpr double kPaperWidth_m = 200.0;
constexpr double kLargestSheet_m = 4800.0;
constexpr double kRoomForMessage = 0.3;  // below the page, of its height, in a small window

std::filesystem::path localFile(const QString& path) {
  return QFile::encodeName(path).toStdString();
}

/// Opaque where there is ink.
QImage inkImage(const cv::Mat& ink) {
  return QImage(ink.data, ink.cols, ink.rows, static_cast<qsizetype>(ink.step),
                QImage::Format_Alpha8)
      .copy();
}

}  // namespace

PaperActions::PaperActions(const Shell& shell, MapDocument& document, MapCanvas& canvas,
                           PaperTool& tool, FileActions& files, ReferenceTrust& trust,
                           QObject* parent)
    : QObject(parent),
      shell_(shell),
      document_(document),
      canvas_(canvas),
      tool_(tool),
      files_(files),
      trust_(trust),
      self_(std::make_shared<Lifeline<PaperActions>>(*this)) {
  shell_.actions.on("file.from_paper", this, [this] { ask(); });
  shell_.actions.on("file.print_sheet", this, [this] { printSheet(); });
  shell_.actions.on("file.open_camera", this, [this] { openCamera(); });
  connect(&tool_, &PaperTool::taken, this, &PaperActions::take);
  connect(&tool_, &PaperTool::abandoned, &camera_, &SheetCamera::stop);
  connect(&camera_, &SheetCamera::seen, this, &PaperActions::follow);
  connect(&camera_, &SheetCamera::sightChanged, this, &PaperActions::tellSight);
  connect(&camera_, &SheetCamera::troubled, this,
          [this](const QString& words) { tellOfCamera(MessageBar::Kind::Warning, words); });
}

PaperActions::~PaperActions() { self_->cut(); }

void PaperActions::ask() {
  const QString path = shell_.dialogs.fileToOpen({tr("Open a photo of a drawing"),
                                                  shell_.settings.value(kPaperFolderKey).toString(),
                                                  tr("Photos (*.png *.jpg *.jpeg)"),
                                                  {},
                                                  {}});
  if (path.isEmpty()) return;
  shell_.settings.setValue(kPaperFolderKey, QFileInfo(path).path());
  read(path);
}

void PaperActions::read(const QString& path) {
  camera_.stop();
  shell_.messages.show(MessageBar::Kind::Info,
                       tr("Reading the drawing on “%1”…").arg(QFileInfo(path).fileName()), {},
                       kPaperTopic);
  startInBackground([self = self_, request = ++request_, path] {
    std::variant<std::shared_ptr<const PaperReading>, Failure> answer;
    try {
      const cv::Mat photo = readPhoto(localFile(path), kPhotoSide_px);
      auto reading = std::make_shared<PaperReading>();
      reading->trace = traced(photo);
      if (reading->trace.shapes.empty()) reading->trouble = troubleWith(photo);
      reading->page = pngOf(imageOf(reading->trace.page.image));
      answer = std::shared_ptr<const PaperReading>(reading);
    } catch (const Error& error) {
      answer = failureOf(error);
    } catch (const std::exception& error) {
      answer = Failure{ErrorCode::RunFailed, QString::fromUtf8(error.what()), {}};
    }
    self->post([request, path, answer](PaperActions& actions) {
      if (request != actions.request_) return;
      if (const auto* failure = std::get_if<Failure>(&answer)) return actions.tell(*failure);
      actions.show(std::get<0>(answer), path);
    });
  });
}

void PaperActions::tell(const Failure& failure) {
  shell_.messages.show(MessageBar::Kind::Error, failure.message, failure.hint, kPaperTopic);
}

void PaperActions::show(const std::shared_ptr<const PaperReading>& reading, const QString& path) {
  const Trace& trace = reading->trace;
  if (trace.shapes.empty()) {
    shell_.messages.show(MessageBar::Kind::Warning,
                         tr("“%1” has no closed shapes.").arg(QFileInfo(path).fileName()),
                         reading->trouble.empty() ? tr("Draw each building as a closed outline, "
                                                       "with a pen, and take the photo from above.")
                                                  : QString::fromStdString(reading->trouble),
                         kPaperTopic);
    return;
  }
  reading_ = reading;
  photo_ = path;
  if (!findPlace()) return shell_.messages.withdraw(kPaperTopic);
  begin(*reading);
  shell_.messages.show(
      MessageBar::Kind::Info,
      tr("%n closed shape(s) are found.", nullptr, static_cast<int>(trace.shapes.size())),
      trace.covered ? tr("Something lies over the sheet: what it hides is not ticked.")
      : isPlaceUnread(trace)
          ? tr("The code on the sheet cannot be read: it lies where the drawing is printed now.")
          : tr("Click those that are no buildings, then press Enter."),
      kPaperTopic);
}

PaperReview PaperActions::reviewOf(const PaperReading& reading) const {
  const Trace& trace = reading.trace;
  PaperReview review;
  review.page = imageOf(trace.page.image);
  review.place = underlayOf(trace.page, place_, {});
  for (std::size_t i = 0; i < trace.shapes.size(); ++i) {
    const TracedShape& shape = trace.shapes[i];
    PaperReview::Proposal proposal;
    proposal.building = buildingOf(shape, trace.ink, place_);
    proposal.taken = shape.confidence >= kSureOfShape;
    proposal.ink = inkImage(shape.ink);
    proposal.ink_at = QPoint(shape.box.x, shape.box.y);
    proposal.replaces = buildingUnder(document_.map(), proposal.building) != nullptr;
    if (!reading.numbers.empty()) proposal.number = reading.numbers[i];
    review.proposals.push_back(std::move(proposal));
  }
  return review;
}

/// All of the page in the window, to be looked through.
void PaperActions::begin(const PaperReading& reading) {
  const cv::Mat& page = reading.trace.page.image;
  const QSizeF size = place_.metres_per_pixel * QSizeF(page.cols, page.rows);
  const double below = kRoomForMessage * size.height();
  canvas_.zoomToRect(
      {place_.corner.x(), place_.corner.y() - below, size.width(), size.height() + below});
  canvas_.setTool(ToolId::Paper);
  tool_.setReview(reviewOf(reading));
  canvas_.setFocus();
}

void PaperActions::openCamera() {
  QStringList known;
  const QString last = shell_.settings.value(kCameraKey).toString();
  if (!last.isEmpty()) known << last;
  for (const std::string& name : connectedCameras(CameraKind::Video))
    if (!known.contains(QString::fromStdString(name))) known << QString::fromStdString(name);
  const QString source =
      shell_.dialogs.typedOrKnown(tr("Open camera"), tr("Device, address or video"), known);
  if (source.isEmpty()) return;
  shell_.settings.setValue(kCameraKey, source);
  ++request_;
  tool_.cancel();
  reading_.reset();
  width_m_.reset();
  const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  const QDir folder(QDir(pictures).exists() ? pictures : QDir::homePath());
  photo_ = folder.filePath(QStringLiteral("camera.png"));
  camera_.watch(source);
  tellOfCamera(MessageBar::Kind::Info, tr("Looking through “%1”…").arg(source));
}

/// With the way to close it, while nothing is there yet to be left by Escape.
void PaperActions::tellOfCamera(MessageBar::Kind kind, const QString& words, const QString& hint) {
  shell_.messages.show(kind, words, hint, kPaperTopic);
  if (tool_.isBusy()) return;
  shell_.messages.addAction(tr("Close the camera"), [this] {
    camera_.stop();
    shell_.messages.withdraw(kPaperTopic);
  });
}

void PaperActions::follow(const std::shared_ptr<const PaperReading>& reading) {
  const bool first = reading_ == nullptr;
  // Another sheet may have been laid there.
  const bool other = !first && reading->trace.page.sheet != reading_->trace.page.sheet;
  reading_ = reading;
  if (first || other) place_ = placeOf(reading->trace.page, *sheetOf(*reading->trace.page.sheet));
  if (first) {
    begin(*reading);
  } else {
    tool_.renewReview(reviewOf(*reading));
  }
}

void PaperActions::tellSight(SheetSight sight) {
  constexpr auto kInfo = MessageBar::Kind::Info;
  if (sight == SheetSight::None) {
    tellOfCamera(kInfo, tr("No printed sheet is seen."),
                 tr("All four marks must be in the picture, and nothing over them."));
  } else if (sight == SheetSight::Seen) {
    tellOfCamera(kInfo, tr("What is drawn on the sheet is followed."),
                 tr("Enter takes what is ticked and closes the camera, Esc takes nothing."));
  } else if (sight == SheetSight::Covered && !reading_) {
    tellOfCamera(kInfo, tr("Something lies over the sheet."));
  }
}

bool PaperActions::findPlace() {
  const Trace& trace = reading_->trace;
  width_m_.reset();
  if (trace.page.sheet) {
    if (const auto told = sheetOf(*trace.page.sheet)) {
      place_ = placeOf(trace.page, *told);
      return true;
    }
    const Sheet sheet = sheetFor(document_.map());
    if (sheet.code.square_m == trace.page.sheet->square_m) {
      place_ = placeOf(trace.page, sheet);
      return true;
    }
    shell_.messages.show(MessageBar::Kind::Warning,
                         tr("Another drawing is printed on this sheet, or this one has changed."),
                         tr("Say how wide it is instead."), kPaperTopic);
  }
  const QList<double> width = shell_.dialogs.numbers(
      tr("How large is it?"),
      {{tr("From the leftmost building to the rightmost"), kPaperWidth_m, 1.0, 1e5, 0, tr(" m")}});
  if (width.isEmpty()) return false;
  width_m_ = width.front();
  place_ = placeOfDrawing(trace, sureShapes(trace), *width_m_);
  return true;
}

/// Beside the drawing, or beside the photo where the drawing has no file yet; a new one.
QString PaperActions::pictureFile() const {
  const QFileInfo beside(document_.origin().isEmpty() ? photo_ : document_.origin());
  const QString base = beside.absolutePath() + QLatin1Char('/') + beside.completeBaseName();
  QString path = base + QStringLiteral("-paper.png");
  for (int i = 2; QFile::exists(path); ++i)
    path = QStringLiteral("%1-paper-%2.png").arg(base).arg(i);
  return path;
}

void PaperActions::take(const std::vector<std::size_t>& shapes) {
  const QString picture = pictureFile();
  try {
    writeFileAtomically(localFile(picture), reading_->page);
  } catch (const Error& error) {
    return tell({error.code(), failureOf(error).message,
                 tr("The page is kept beside the drawing. Save the drawing where there is room, "
                    "then press Enter again.")});
  }
  camera_.stop();
  const Trace& trace = reading_->trace;
  if (width_m_) place_ = placeOfDrawing(trace, shapes, *width_m_);
  const QString origin = document_.origin();
  const std::string named = origin.isEmpty() ? picture.toStdString()
                                             : referenceFrom(localFile(origin), localFile(picture));
  const bool was_empty = document_.map().buildings.empty();
  MapChange changed, added;
  for (const std::size_t shape : shapes) {
    const Building building = buildingOf(trace.shapes[shape], trace.ink, place_);
    const Building* under = buildingUnder(document_.map(), building);
    if (!under) {
      added.buildings.push_back(building);
      continue;
    }
    changed.buildings.push_back(*under);
    changed.buildings.back().shape = building.shape;
  }
  const Page& page = trace.page;
  if (page.sheet && !page.sheet->of_map) added.start = emptySheet(*page.sheet).start;
  const bool was_trusted = trust_.allows();
  const QString text = tr("Take Over from Paper");
  document_.undoStack().beginMacro(text);
  document_.addUnderlay(underlayOf(page, place_, named));
  document_.apply(changed, text);
  const QStringList keys = document_.add(added, text);
  if (was_empty) document_.setUncertainty(uncertaintyOnPaper(document_.map()));
  document_.undoStack().endMacro();
  if (was_trusted) document_.setTrustsReferences(true);  // this one was chosen by hand
  document_.setSelection(keys);
  tool_.endReview();
  shell_.messages.show(
      MessageBar::Kind::Info,
      tr("%n building(s) are taken over; the page lies under the drawing.", nullptr,
         static_cast<int>(shapes.size())),
      document_.map().start ? QString() : tr("Say with the start tool (T) where the robot begins."),
      kPaperTopic);
}

void PaperActions::printSheet() {
  const QString title = tr("Print a sheet to draw on");
  int with_map = 0;
  if (!document_.map().buildings.empty()) {
    QStringList choices = {tr("Nothing"), tr("The drawing")};
    if (sheetUnder(document_.map())) choices.append(tr("The drawing alone, over the used sheet"));
    with_map = shell_.dialogs.choose({title, tr("What is to be on the sheet?"), choices});
    if (with_map < 0) return;
  }
  double width_m = kPaperWidth_m;
  if (with_map == 0) {
    const QList<double> width = shell_.dialogs.numbers(
        title, {{tr("Width of the place"), kPaperWidth_m, 1.0, kLargestSheet_m, 0, tr(" m")}});
    if (width.isEmpty()) return;
    width_m = width.front();
  }
  files_.exportAs({title, with_map == 0 ? tr("Sheet") : document_.displayName(), tr("PDF (*.pdf)"),
                   QStringLiteral("pdf"), tr("The sheet")},
                  [&](const QString& path) {
                    const Map& map = document_.map();
                    writeFileAtomically(localFile(path),
                                        with_map == 0   ? sheetPdf(emptySheet(width_m))
                                        : with_map == 1 ? sheetPdf(sheetFor(map), &map)
                                                        : overprintPdf(map));
                  });
}

}  // namespace handmap
