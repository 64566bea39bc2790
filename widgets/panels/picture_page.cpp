#include "widgets/panels/picture_page.h"

#include <QCheckBox>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <utility>

#include "core/map/map_limits.h"
#include "widgets/tools/picture_tool.h"

namespace handmap {

namespace {
constexpr double kLeastScale = 1e-6;
}  // namespace

PicturePage::PicturePage(MapDocument& document) : PropertyPage(document, tr("Picture")) {
  file_ = new QLabel;
  addField("file", tr("File"), file_);
  const auto set = [this](double Underlay::*member, const QString& text, double unit = 1.0) {
    return [this, member, text, unit](double value) {
      edit(text, true, [&](Underlay& underlay) { underlay.*member = value * unit; });
    };
  };
  x_ = addCoordinate("x", tr("Left"), set(&Underlay::x, tr("Move Picture")));
  y_ = addCoordinate("y", tr("Top"), set(&Underlay::y, tr("Move Picture")));
  scale_ = addNumber("scale", tr("Scale"), kLeastScale, kMaxMetresPerPixel, tr(" m/px"),
                     set(&Underlay::metres_per_pixel, tr("Scale Picture")));
  scale_->setDecimals(6);
  scale_->setMinimum(kLeastScale);
  heading_ = addHeading(set(&Underlay::heading, tr("Turn Picture"), toRadians(1.0)));
  opacity_ = addNumber("opacity", tr("Opacity"), 0.0, kPercent, tr(" %"),
                       set(&Underlay::opacity, tr("Fade Picture"), 1.0 / kPercent));
  hidden_ = addFlag("hidden", tr("Hidden"), tr("Hide Picture"), &Flags::hidden);
  locked_ = addFlag("locked", tr("Locked: stays where it is"), tr("Lock Picture"), &Flags::locked);
  addTool();
}

void PicturePage::addTool() {
  by_length_ = new QPushButton(tr("Scale by a length"));
  by_length_->setToolTip(tr("Click two points whose distance you know, then say how far it is"));
  addField("by_length", {}, by_length_);
  length_ = addNumber("length", tr("Length"), 0.01, kMaxSize, tr(" m"),
                      [this](double length) { typed_length_ = length; });
  connect(length_, &QAbstractSpinBox::editingFinished, this, [this] {
    const auto length = std::exchange(typed_length_, std::nullopt);
    if (length && tool_ && !tool_->setLength(*length))
      Q_EMIT messageRaised(tr("The picture cannot be that large or small."));
  });
  by_points_ = new QPushButton(tr("Fit by points"));
  by_points_->setToolTip(tr("Click points of the picture and where they belong on the map"));
  addField("by_points", {}, by_points_);
  fit_ = new QPushButton(tr("Fit now"));
  addField("fit", {}, fit_);
  const auto begin = [this](PictureTool::Mode mode) {
    if (!tool_) return;
    Q_EMIT toolRequested();
    tool_->setMode(mode);
  };
  connect(by_length_, &QPushButton::clicked, this, [begin] { begin(PictureTool::Mode::Scale); });
  connect(by_points_, &QPushButton::clicked, this, [begin] { begin(PictureTool::Mode::Fit); });
  connect(fit_, &QPushButton::clicked, this, [this] {
    if (tool_ && !tool_->fit())
      Q_EMIT messageRaised(tr("The pairs of points lie all at one place, or too far apart."));
  });
}

void PicturePage::setTool(PictureTool& tool) {
  tool_ = &tool;
  connect(&tool, &Tool::changed, this, &PicturePage::refreshTool);
  refreshTool();
}

QCheckBox* PicturePage::addFlag(const char* name, const QString& text, const QString& step,
                                bool Flags::*flag) {
  auto* box = new QCheckBox(text);
  addField(name, {}, box);
  connect(box, &QCheckBox::clicked, this, [this, step, flag](bool on) {
    edit(step, false, [&](Underlay& underlay) { underlay.flags.*flag = on; });
  });
  return box;
}

std::optional<std::size_t> PicturePage::place() const {
  const auto place = pictureIndex(selectedId());
  return place && *place < document().map().underlays.size() ? place : std::nullopt;
}

template <typename Change>
void PicturePage::edit(const QString& text, bool mergeable, Change change) {
  const auto at = place();
  if (!at) return;
  std::vector<Underlay> list = document().map().underlays;
  change(list[*at]);
  document().setUnderlays(std::move(list), text, mergeable);
}

void PicturePage::refresh() {
  const auto at = place();
  if (!at) return;
  const Underlay& underlay = document().map().underlays[*at];
  const QString path = QString::fromStdString(underlay.image);
  file_->setText(QFileInfo(path).fileName());
  file_->setToolTip(path);
  x_->showValue(underlay.x);
  y_->showValue(underlay.y);
  scale_->showValue(underlay.metres_per_pixel);
  heading_->showValue(toDegrees(normalizedAngle(underlay.heading)));
  opacity_->showValue(kPercent * underlay.opacity);
  hidden_->setChecked(underlay.flags.hidden);
  locked_->setChecked(underlay.flags.locked);
  refreshTool();
}

void PicturePage::refreshTool() {
  const bool usable = tool_ && tool_->current();
  by_length_->setEnabled(usable);
  by_points_->setEnabled(usable);
  const auto measured = usable ? tool_->measured() : std::nullopt;
  length_->setEnabled(measured.has_value());
  length_->showValue(measured.value_or(length_->minimum()));
  fit_->setEnabled(usable && tool_->pairs() >= 2);
}

}  // namespace handmap
