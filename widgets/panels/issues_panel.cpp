#include "widgets/panels/issues_panel.h"

#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QStyle>
#include <QVBoxLayout>

#include "core/base/error.h"

namespace handmap {

namespace {
constexpr int kQuietMs = 400;
}  // namespace

IssuesPanel::IssuesPanel(MapDocument& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      list_(new QListWidget),
      summary_(new QLabel),
      lifeline_(std::make_shared<Lifeline<IssuesPanel>>(*this)) {
  list_->setObjectName(QStringLiteral("issues"));
  list_->setAccessibleName(tr("Issues of the drawing"));
  list_->setFrameShape(QFrame::NoFrame);
  list_->setWordWrap(true);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  summary_->setWordWrap(true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 0);
  layout->addWidget(summary_);
  layout->addWidget(list_);
  connect(list_, &QListWidget::itemClicked, this, &IssuesPanel::request);
  connect(list_, &QListWidget::itemActivated, this, &IssuesPanel::request);
  timer_.setSingleShot(true);
  timer_.setInterval(kQuietMs);
  connect(&timer_, &QTimer::timeout, this, &IssuesPanel::search);
  connect(&document_, &MapDocument::mapChanged, this, [this](const Touched& touched) {
    if (touched.anyBuilding() || touched.landmarks || touched.start || touched.route)
      timer_.start();
  });
  timer_.start();
}

IssuesPanel::~IssuesPanel() {
  lifeline_->cut();
  stop_.request_stop();
}

void IssuesPanel::search() {
  stop_.request_stop();
  stop_ = {};
  startInBackground(
      [map = document_.map(), stop = stop_.get_token(), number = ++search_, lifeline = lifeline_] {
        try {
          lifeline->post([issues = findIssues(map, stop), number](IssuesPanel& panel) {
            panel.take(issues, number);
          });
        } catch (const std::exception&) {  // stopped: another search is under way
        }
      });
}

void IssuesPanel::take(std::vector<Issue> issues, int search) {
  if (search != search_) return;
  issues_ = std::move(issues);
  fill();
  Q_EMIT found();
}

void IssuesPanel::fill() {
  list_->clear();
  const Names names = namesIn(document_.map());
  for (const Issue& issue : issues_) {
    auto* item = new QListWidgetItem(textOf(issue, names), list_);
    item->setIcon(style()->standardIcon(issue.isGrave() ? QStyle::SP_MessageBoxWarning
                                                        : QStyle::SP_MessageBoxInformation));
  }
  summary_->setText(issues_.empty() ? tr("Nothing to mend.")
                                    : tr("%n issue(s); a click shows where.", nullptr,
                                         static_cast<int>(issues_.size())));
}

void IssuesPanel::request(const QListWidgetItem* item) {
  const auto row = static_cast<std::size_t>(list_->row(item));
  if (row < issues_.size()) Q_EMIT showRequested(Issue(issues_[row]));
}

IssuesPanel::Names IssuesPanel::namesIn(const Map& map) {
  Names names;
  const auto add = [&](const auto& item) {
    const QString id = QString::fromStdString(item.id);
    names.emplace(item.id, item.name.empty() ? id
                                             : QStringLiteral("%1 (%2)").arg(
                                                   QString::fromStdString(item.name), id));
  };
  for (const Building& building : map.buildings) add(building);
  for (const Landmark& landmark : map.landmarks) add(landmark);
  return names;
}

QString IssuesPanel::textOf(const Issue& issue, const Names& names) {
  const auto name = [&](std::size_t i) {
    const auto found = names.find(issue.ids.at(i));  // it may be gone since the search began
    return found == names.end() ? QString::fromStdString(issue.ids[i]) : found->second;
  };
  const auto number = [&](int decimals) {
    return QLocale::c().toString(issue.metres, 'f', decimals);
  };
  switch (issue.kind) {
    case Issue::Kind::NoBuilding:
      return tr("There is no building yet.");
    case Issue::Kind::NoStart:
      return tr("There is no start yet: a run needs to know where the robot begins.");
    case Issue::Kind::StartInBuilding:
      return tr("The start lies in %1.").arg(name(0));
    case Issue::Kind::RouteInBuilding:
      return tr("The route leads through %1.").arg(name(0));
    case Issue::Kind::RouteFarFromStart:
      return tr("The route begins %1 m from the start.").arg(number(1));
    case Issue::Kind::Overlap:
      return tr("%1 and %2 overlap by %3 m².").arg(name(0), name(1), number(1));
    case Issue::Kind::CrossesItself:
      return tr("The outline of %1 crosses itself.").arg(name(0));
    case Issue::Kind::SameName:
      return tr("%1 and %2 have the same name.").arg(name(1), name(0));
    case Issue::Kind::TooNarrow:
      return tr("%1 is only %2 m wide.").arg(name(0), number(2));
  }
  return {};
}

}  // namespace handmap
