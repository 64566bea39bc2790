#include "widgets/panels/property_panel.h"

#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "widgets/panels/building_page.h"
#include "widgets/panels/other_pages.h"
#include "widgets/panels/picture_page.h"

namespace handmap {

PropertyPanel::PropertyPanel(MapDocument& document, QWidget* parent)
    : QWidget(parent), document_(document), pages_(new QStackedWidget) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins({});
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(pages_);
  layout->addWidget(scroll);

  const auto add = [this](auto* page) {
    pages_->addWidget(page);
    connect(page, &PropertyPage::messageRaised, this, &PropertyPanel::messageRaised);
    return page;
  };
  building_ = add(new BuildingPage(document));
  landmark_ = add(new LandmarkPage(document));
  start_ = add(new StartPage(document));
  picture_ = add(new PicturePage(document));
  connect(picture_, &PicturePage::toolRequested, this, &PropertyPanel::pictureToolRequested);
  map_ = add(new MapPage(document));
  summary_ = add(new SummaryPage(document));
  connect(&document_, &MapDocument::mapChanged, this, &PropertyPanel::refresh);
  connect(&document_, &MapDocument::selectionChanged, this, [this] {
    static_cast<PropertyPage*>(pages_->currentWidget())->forgetTyping();
    refresh();
  });
  refresh();
}

void PropertyPanel::setPictureTool(PictureTool& tool) { picture_->setTool(tool); }

PropertyPage* PropertyPanel::pageOfSelection() const {
  const QStringList keys = document_.selection();
  if (keys.isEmpty()) return map_;
  if (keys == QStringList{kStartKey}) return start_;
  if (keys.size() == 1 && pictureIndex(keys.first())) return picture_;
  const MapChange objects = selected(document_.map(), keys);
  if (objects.buildings.size() == static_cast<std::size_t>(keys.size())) return building_;
  if (keys.size() == 1 && objects.landmarks.size() == 1) return landmark_;
  return summary_;
}

void PropertyPanel::refresh() {
  PropertyPage* page = pageOfSelection();
  page->refresh();
  pages_->setCurrentWidget(page);
}

}  // namespace handmap
