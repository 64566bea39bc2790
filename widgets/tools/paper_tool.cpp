#include "widgets/tools/paper_tool.h"

#include <QPainter>
#include <algorithm>

#include "widgets/canvas/building_handles.h"
#include "widgets/tools/tool_painting.h"

namespace handmap {

namespace {

constexpr double kPageOpacity = 0.8;

}  // namespace

QString PaperTool::hint() const {
  if (!isBusy()) return tr("Choose “From Paper…” to open a photo of a drawing");
  return tr(
      "Click a shape to take or leave it · Tab and Del do so by keys · Enter: take the %n "
      "ticked · Esc: none",
      nullptr, takenCount());
}

int PaperTool::takenCount() const {
  return static_cast<int>(std::ranges::count_if(review_.proposals, &PaperReview::Proposal::taken));
}

void PaperTool::setReview(PaperReview review) {
  review_ = std::move(review);
  current_.reset();
  Q_EMIT changed();
}

void PaperTool::renewReview(PaperReview review) {
  const int current = current_ ? review_.proposals[*current_].number : 0;
  current_.reset();
  for (std::size_t i = 0; i < review.proposals.size(); ++i) {
    PaperReview::Proposal& proposal = review.proposals[i];
    if (proposal.number == current && current != 0) current_ = i;
    const auto before =
        std::ranges::find(review_.proposals, proposal.number, &PaperReview::Proposal::number);
    if (before != review_.proposals.end()) proposal.taken = before->taken;
  }
  review_ = std::move(review);
  Q_EMIT changed();
}

bool PaperTool::cancel() {
  if (!isBusy()) return false;
  setReview({});
  Q_EMIT abandoned();
  return true;
}

/// The smallest, where shapes lie in each other.
std::optional<std::size_t> PaperTool::at(const Vec2& position) const {
  std::optional<std::size_t> found;
  double least = 0.0;
  for (std::size_t i = 0; i < review_.proposals.size(); ++i) {
    const Polygon outline = review_.proposals[i].building.footprint();
    const double area = std::abs(signedArea(outline));
    if (!contains(outline, position) || (found && area >= least)) continue;
    found = i;
    least = area;
  }
  return found;
}

void PaperTool::toggle(std::size_t index) {
  review_.proposals[index].taken = !review_.proposals[index].taken;
  current_ = index;
  Q_EMIT changed();
}

void PaperTool::step(int by) {
  if (review_.proposals.empty()) return;
  const auto count = static_cast<int>(review_.proposals.size());
  const int from = current_ ? static_cast<int>(*current_) : (by > 0 ? -1 : 0);
  current_ = static_cast<std::size_t>((from + by + count) % count);
  Q_EMIT changed();
}

void PaperTool::press(const ToolEvent& event) {
  if (const auto index = at(event.position)) toggle(*index);
}

void PaperTool::move(const ToolEvent& event) {
  const auto index = at(event.position);
  if (!index || index == current_) return;
  current_ = index;
  Q_EMIT changed();
}

bool PaperTool::removeChosen() {
  if (!isBusy()) return false;
  if (current_) toggle(*current_);
  return true;
}

bool PaperTool::key(const ToolKey& key) {
  if (!isBusy()) return false;
  switch (key.key) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (canFinish()) finish();
      return true;
    case Qt::Key_Tab:
    case Qt::Key_Down:
    case Qt::Key_Right:
      step(1);
      return true;
    case Qt::Key_Backtab:
    case Qt::Key_Up:
    case Qt::Key_Left:
      step(-1);
      return true;
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      return removeChosen();
    default:
      return false;
  }
}

void PaperTool::finish() {
  std::vector<std::size_t> ticked;
  for (std::size_t i = 0; i < review_.proposals.size(); ++i)
    if (review_.proposals[i].taken) ticked.push_back(i);
  Q_EMIT taken(ticked);
}

void PaperTool::endReview() {
  setReview({});
  Q_EMIT finished();
}

void PaperTool::paintPage(ToolPaint& canvas) const {
  QPainter& painter = canvas.painter;
  painter.save();
  QTransform to_map;
  to_map.translate(review_.place.x, review_.place.y);
  to_map.scale(review_.place.metres_per_pixel, -review_.place.metres_per_pixel);
  painter.setTransform(to_map * canvas.to_device * painter.transform());
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.setOpacity(kPageOpacity);
  painter.drawImage(0, 0, review_.page);
  painter.setOpacity(1.0);
  if (current_) {
    const PaperReview::Proposal& proposal = review_.proposals[*current_];
    QImage ink = proposal.ink.convertToFormat(QImage::Format_ARGB32_Premultiplied);
    QPainter tint(&ink);
    tint.setCompositionMode(QPainter::CompositionMode_SourceIn);
    tint.fillRect(ink.rect(), canvas.colours[Role::Selection]);
    tint.end();
    painter.drawImage(proposal.ink_at, ink);
  }
  painter.restore();
}

void PaperTool::paint(ToolPaint& canvas) const {
  if (!isBusy()) return;
  paintPage(canvas);
  for (std::size_t i = 0; i < review_.proposals.size(); ++i) {
    const PaperReview::Proposal& proposal = review_.proposals[i];
    const Polygon outline = proposal.building.footprint();
    const Role role = i == current_    ? Role::Selection
                      : proposal.taken ? Role::Preview
                                       : Role::Odometry;
    paintOutline(canvas, outline, true, role);
    const QString mark = !proposal.taken     ? QStringLiteral("–")
                         : proposal.replaces ? tr("✓ changes one")
                                             : QStringLiteral("✓");
    paintNote(canvas, canvas.toDevice(centroid(outline)), mark);
  }
}

}  // namespace handmap
