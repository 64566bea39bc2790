#include "widgets/guide/guide_window.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScreen>
#include <QShortcut>
#include <QTextBrowser>
#include <QToolBar>
#include <QVBoxLayout>

#include "widgets/style/icons.h"

namespace handmap {

namespace {

constexpr QSize kSize(820, 760);
constexpr int kMargin = 48;  // beside a picture

/// Pictures are no wider than the page.
class Pages : public QTextBrowser {
 public:
  using QTextBrowser::QTextBrowser;

 protected:
  QVariant loadResource(int type, const QUrl& name) override {
    QVariant resource = QTextBrowser::loadResource(type, name);
    if (type != QTextDocument::ImageResource) return resource;
    const QImage image = resource.metaType() == QMetaType::fromType<QByteArray>()
                             ? QImage::fromData(resource.toByteArray())
                             : resource.value<QImage>();
    const int width = kSize.width() - kMargin;
    return image.width() > width ? image.scaledToWidth(width, Qt::SmoothTransformation) : image;
  }
};

}  // namespace

GuideWindow::GuideWindow(QWidget* parent)
    : QWidget(parent, Qt::Window), browser_(new Pages), search_(new QLineEdit) {
  setObjectName("guide");
  setWindowTitle(tr("The guide"));
  browser_->setOpenExternalLinks(true);
  browser_->setAccessibleName(tr("A page of the guide"));
  browser_->document()->setDocumentMargin(16.0);
  search_->setPlaceholderText(tr("Find in the guide"));
  search_->setClearButtonEnabled(true);
  auto* bar = new QToolBar;
  auto* back = bar->addAction(icon("undo"), tr("Back"), browser_, &QTextBrowser::backward);
  auto* forward = bar->addAction(icon("redo"), tr("Forward"), browser_, &QTextBrowser::forward);
  bar->addAction(tr("Contents"), this, [this] { open(); });
  bar->addWidget(search_);
  back->setShortcut(QKeySequence::Back);
  forward->setShortcut(QKeySequence::Forward);
  back->setEnabled(false);
  forward->setEnabled(false);
  connect(browser_, &QTextBrowser::backwardAvailable, back, &QAction::setEnabled);
  connect(browser_, &QTextBrowser::forwardAvailable, forward, &QAction::setEnabled);
  // Whatever in it has the focus.
  connect(new QShortcut(Qt::Key_Escape, this), &QShortcut::activated, this, &QWidget::close);
  connect(search_, &QLineEdit::returnPressed, this, &GuideWindow::findNext);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins({});
  layout->setSpacing(0);
  layout->addWidget(bar);
  layout->addWidget(browser_, 1);
  resize(kSize.boundedTo(screen()->availableSize() - QSize(20, 60)));
  browser_->setFocus();
}

QString GuideWindow::folder() {
  //: The folder of the guide in this language, under resources/guide.
  return QStringLiteral(":/guide/") + tr("en");
}

QStringList GuideWindow::pages() {
  QStringList pages;
  for (const QFileInfo& file : QDir(folder()).entryInfoList({"*.md"})) pages << file.baseName();
  return pages;
}

void GuideWindow::open(const QString& page) {
  const QString path = QStringLiteral("%1/%2.md")
                           .arg(folder(), pages().contains(page) ? page : QStringLiteral("index"));
  browser_->setSource(QUrl(QStringLiteral("qrc") + path));
}

void GuideWindow::findNext() {
  const QString text = search_->text();
  if (text.isEmpty() || browser_->find(text)) return;
  const QStringList all = pages();
  const auto here = all.indexOf(QFileInfo(browser_->source().path()).baseName());
  for (qsizetype i = 1; i <= all.size(); ++i) {
    const QString& page = all[(here + i) % all.size()];
    QFile file(QStringLiteral("%1/%2.md").arg(folder(), page));
    if (!file.open(QIODevice::ReadOnly)) continue;
    if (!QString::fromUtf8(file.readAll()).contains(text, Qt::CaseInsensitive)) continue;
    open(page);
    browser_->moveCursor(QTextCursor::Start);
    if (browser_->find(text)) return;
  }
}

void GuideWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    close();
  } else if (event->matches(QKeySequence::Find)) {
    search_->setFocus();
  } else {
    QWidget::keyPressEvent(event);
  }
}

}  // namespace handmap
