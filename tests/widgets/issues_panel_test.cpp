// The list of issues follows the drawing and leads to where they are.
#include "widgets/panels/issues_panel.h"

#include <QListWidget>
#include <QSignalSpy>
#include <QTest>
#include <memory>

#include "widgets/background/background.h"

namespace handmap {

class IssuesPanelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void followsTheDrawingAndLeadsThere() {
    MapDocument document;
    IssuesPanel panel(document);
    panel.show();
    auto* list = panel.findChild<QListWidget*>("issues");
    QTRY_COMPARE(list->count(), 2);
    Building building;
    building.shape = Rectangle{{10.0, 0.0}, 8.0, 8.0, 0.0};
    document.addBuilding(building);
    building.shape = Rectangle{{13.0, 0.0}, 8.0, 8.0, 0.0};
    document.addBuilding(building);
    document.setStart(Pose2{});
    QTRY_COMPARE(list->count(), 1);
    QCOMPARE(list->item(0)->text(), "B1 and B2 overlap by 40.0 m².");
    std::vector<std::string> ids;
    connect(&panel, &IssuesPanel::showRequested, this,
            [&](const Issue& issue) { ids = issue.ids; });
    panel.activateWindow();
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->item(0)).center());
    QCOMPARE(ids, (std::vector<std::string>{"B1", "B2"}));
    document.undoStack().setIndex(0);
    QTRY_COMPARE(list->count(), 2);
  }

  void mayGoWhileItSearches() {
    MapDocument document;
    Map map;
    for (int i = 0; i < 5000; ++i) {
      Building building;
      building.id = std::to_string(i);
      building.shape = Rectangle{{5.0 * i, 0.0}, 8.0, 8.0, 0.0};
      map.buildings.push_back(building);
    }
    auto panel = std::make_unique<IssuesPanel>(document);
    document.reset(map);
    QTest::qWait(450);  // it has begun
    panel.reset();
    QVERIFY(waitForBackground(std::chrono::seconds(30)));
  }
};

}  // namespace handmap

QTEST_MAIN(handmap::IssuesPanelTest)
#include "issues_panel_test.moc"
