#include "widgets/actions/command_palette.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <vector>

#include "widgets/actions/action_set.h"
#include "widgets/actions/fuzzy.h"

namespace handmap {

namespace {

constexpr QSize kLargest(560, 380);
constexpr int kBelowTop = 40;
constexpr int kDisabled = -1;  // after those that can be done and match as well

constexpr int kKeysRole = Qt::UserRole + 1;

/// The keys stand in a column of their own, at the right.
class KeysAtTheRight : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    constexpr int kGap = 8;  // pixels
    const QString keys = index.data(kKeysRole).toString();
    const int width = option.fontMetrics.horizontalAdvance(keys);
    QStyledItemDelegate::paint(painter, option, index);
    painter->setPen(option.palette.color(
        option.state & QStyle::State_Enabled ? QPalette::Active : QPalette::Disabled,
        option.state & QStyle::State_Selected ? QPalette::HighlightedText : QPalette::Text));
    painter->drawText(option.rect.adjusted(option.rect.width() - width - kGap, 0, -kGap, 0),
                      Qt::AlignVCenter | Qt::AlignRight, keys);
  }
};

struct Match {
  const ActionSpec* spec;
  int score;
};

/// The English name counts too, and less.
std::optional<int> scoreOf(const QString& pattern, const ActionSpec& spec) {
  const auto here = fuzzyScore(pattern, plainTextOf(spec));
  const auto with_menu = fuzzyScore(pattern, plainTitleOf(spec.menu) + u' ' + plainTextOf(spec));
  const auto english = fuzzyScore(pattern, QString::fromUtf8(spec.text).remove(u'&'));
  std::optional<int> best = here;
  for (const auto& other : {with_menu, english})
    if (other && (!best || *other - 2 > *best)) best = *other - 2;
  return best;
}

}  // namespace

CommandPalette::CommandPalette(const ActionSet& actions, QWidget& window)
    : QFrame(&window), actions_(actions), typed_(new QLineEdit), list_(new QListWidget) {
  setObjectName(QStringLiteral("command_palette"));
  setAccessibleName(tr("Commands"));
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  typed_->setObjectName(QStringLiteral("command"));
  typed_->setAccessibleName(tr("Command"));
  typed_->setPlaceholderText(tr("What do you want to do?"));
  list_->setAccessibleName(tr("Commands that match"));
  list_->setFocusPolicy(Qt::NoFocus);
  list_->setUniformItemSizes(true);
  list_->setItemDelegate(new KeysAtTheRight(list_));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(typed_);
  layout->addWidget(list_);
  typed_->installEventFilter(this);
  window.installEventFilter(this);
  connect(typed_, &QLineEdit::textChanged, this, &CommandPalette::fill);
  connect(typed_, &QLineEdit::returnPressed, this, [this] { run(list_->currentItem()); });
  connect(list_, &QListWidget::itemClicked, this, &CommandPalette::run);
  hide();
}

void CommandPalette::open() {
  focus_before_ = QApplication::focusWidget();
  const QSize room = parentWidget()->size();
  resize(kLargest.boundedTo(room - QSize(20, 2 * kBelowTop)));
  move((room.width() - width()) / 2, kBelowTop);
  typed_->clear();
  fill();
  show();
  raise();
  typed_->setFocus(Qt::ShortcutFocusReason);
}

void CommandPalette::fill() {
  std::vector<Match> matches;
  for (const ActionSpec& spec : actionTable()) {
    const auto score = scoreOf(typed_->text(), spec);
    if (!score) continue;
    matches.push_back(
        {&spec, *score + (actions_[QLatin1String(spec.id)].isEnabled() ? 0 : kDisabled)});
  }
  std::ranges::stable_sort(matches, std::greater{}, &Match::score);
  list_->clear();
  QPixmap blank(list_->style()->pixelMetric(QStyle::PM_SmallIconSize), 1);  // texts begin alike
  blank.fill(Qt::transparent);
  for (const Match& match : matches) {
    const QString id = QLatin1String(match.spec->id);
    const QAction& action = actions_[id];
    QString text =
        QStringLiteral("%1: %2").arg(plainTitleOf(match.spec->menu), plainTextOf(*match.spec));
    const QString keys = action.shortcut().toString(QKeySequence::NativeText);
    if (const QString why = actions_.whyNot(id); !why.isEmpty())
      text += QStringLiteral(" — %1").arg(why);
    auto* item =
        new QListWidgetItem(action.icon().isNull() ? QIcon(blank) : action.icon(), text, list_);
    item->setData(Qt::UserRole, id);
    item->setData(kKeysRole, keys);
    item->setToolTip(action.toolTip());
    if (!action.isEnabled()) item->setFlags(item->flags() & ~Qt::ItemIsEnabled);
  }
  if (matches.empty()) {
    auto* item = new QListWidgetItem(tr("No command is called “%1”.").arg(typed_->text()), list_);
    item->setFlags(Qt::NoItemFlags);
  }
  list_->setCurrentRow(0);
}

void CommandPalette::run(const QListWidgetItem* item) {
  if (!item || !(item->flags() & Qt::ItemIsEnabled)) return;
  QAction* action = &actions_[item->data(Qt::UserRole).toString()];
  close();
  // What is done may need the focus, and may take away what is painted now.
  QTimer::singleShot(0, action, [action] { action->trigger(); });
}

void CommandPalette::close() {
  hide();
  if (focus_before_ && focus_before_->isVisible()) focus_before_->setFocus();
  focus_before_ = nullptr;
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget()) {
    // A window that lays out its panels anew puts what is in its middle on top.
    if (event->type() == QEvent::LayoutRequest && isVisible())
      QMetaObject::invokeMethod(this, &QWidget::raise, Qt::QueuedConnection);
  } else if (event->type() == QEvent::FocusOut && isVisible() &&
             static_cast<QFocusEvent*>(event)->reason() != Qt::ActiveWindowFocusReason) {
    hide();
  } else if (event->type() == QEvent::KeyPress) {
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const int step = (key.key() == Qt::Key_Down) - (key.key() == Qt::Key_Up) +
                     10 * ((key.key() == Qt::Key_PageDown) - (key.key() == Qt::Key_PageUp));
    if (key.key() == Qt::Key_Escape) {
      close();
      return true;
    }
    if (step != 0) {
      list_->setCurrentRow(
          std::clamp(list_->currentRow() + step, 0, std::max(0, list_->count() - 1)));
      return true;
    }
  }
  return QFrame::eventFilter(watched, event);
}

}  // namespace handmap
