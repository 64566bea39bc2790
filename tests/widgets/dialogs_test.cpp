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
  void whatIsTypedReplacesWhatIsProposed();
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

void DialogsTest::whatIsTypedReplacesWhatIsProposed() {
  QWidget window;
  const auto type = [&window](const QString& text) {
    QTimer::singleShot(0, &window, [&window, text] {
      auto* dialog = window.findChild<QDialog*>();
      QVERIFY(dialog);
      QVERIFY(QTest::qWaitForWindowActive(dialog));
      QTest::keyClicks(dialog->focusWidget(), text);
      dialog->accept();
    });
  };
  type("150");
  QCOMPARE(systemDialogs(window)->numbers("Size", {{"Width", 200.0, 1.0, 1e5, 0, " m"}}),
           QList<double>{150.0});
  type("b.avi");
  QCOMPARE(systemDialogs(window)->typedOrKnown("Camera", "Device", {"/dev/video0"}), "b.avi");
}

}  // namespace handmap

QTEST_MAIN(handmap::DialogsTest)
#include "dialogs_test.moc"
