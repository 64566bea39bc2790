#include "widgets/messages/dialogs.h"

#include <QComboBox>
#include <QFileDialog>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QWidget>

namespace handmap {

class DialogsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatIsSavedHasTheEndingOfTheChosenKind();
};

void DialogsTest::whatIsSavedHasTheEndingOfTheChosenKind() {
  const QTemporaryDir folder;
  QWidget window;
  QTimer::singleShot(0, &window, [&window] {
    auto* dialog = window.findChild<QFileDialog*>();
    QVERIFY(dialog);
    auto* kinds = dialog->findChild<QComboBox*>("fileTypeCombo");
    QVERIFY(kinds);
    QTest::keyClick(kinds, Qt::Key_Down);
    static_cast<QDialog*>(dialog)->accept();
  });
  const QString path = systemDialogs(window)->fileToSave(
      {"Save", folder.path(), "A (*.a);;B (*.bb *.c)", "town.a", "a"});
  QCOMPARE(path, folder.filePath("town.bb"));
}

}  // namespace handmap

QTEST_MAIN(handmap::DialogsTest)
#include "dialogs_test.moc"
