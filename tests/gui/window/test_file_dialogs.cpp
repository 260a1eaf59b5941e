// The folders in which dialogs for files start.

#include "tests/support/test.h"

#include "gui/document/landmark_files.h"
#include "gui/widgets/file_dialogs.h"
#include "tests/gui/window_user.h"
#include "tests/support/patience.h"

#include <QApplication>
#include <QFile>
#include <QFileDialog>
#include <QSettings>
#include <QTemporaryDir>
#include <QTimer>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;

class TestFileDialogs : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void init()
    {
        QSettings().clear();
        m_folder = std::make_unique<QTemporaryDir>();
        for (const char *name : {"scans", "landmarks"})
            QVERIFY(QDir(m_folder->path()).mkdir(QLatin1String(name)));
        QFile out(folder(QStringLiteral("scans/a.obj")));
        QVERIFY(out.open(QIODevice::WriteOnly));
        QVERIFY(out.write("v 0 0 0\nv 10 0 0\nv 10 10 0\nf 1 2 3\n") > 0);
        QFile points(folder(QStringLiteral("landmarks/a.csv")));
        QVERIFY(points.open(QIODevice::WriteOnly));
        QVERIFY(points.write("name,x,y,z\nfirst,1,0.5,0\n") > 0);
    }

    void aDialogStartsWithTheScan()
    {
        QWidget window;
        QCOMPARE(startFolder(window, FileKind::Model), QString());
        window.setWindowFilePath(QStringLiteral("scene.json")); // it has no folder
        QCOMPARE(startFolder(window, FileKind::Model), QString());
        window.setWindowFilePath(folder(QStringLiteral("scans/a.obj")));
        QCOMPARE(startFolder(window, FileKind::Model), folder(QStringLiteral("scans")));
    }

    void aKindOfFileHasItsFolder()
    {
        QWidget window;
        window.setWindowFilePath(folder(QStringLiteral("scans/a.obj")));
        rememberFolder(FileKind::Landmarks, folder(QStringLiteral("landmarks/a.csv")));
        QCOMPARE(startFolder(window, FileKind::Landmarks), folder(QStringLiteral("landmarks")));
        QCOMPARE(startFolder(window, FileKind::Image), folder(QStringLiteral("scans")));
        rememberFolder(FileKind::Series, folder(QStringLiteral("landmarks"))); // a folder itself
        QCOMPARE(startFolder(window, FileKind::Series), folder(QStringLiteral("landmarks")));
    }

    void aPanelKnowsItsWindowsFile()
    {
        QWidget window;
        window.setWindowFilePath(folder(QStringLiteral("scans/a.obj")));
        QWidget dock(&window, Qt::Tool), panel(&dock); // as a floating one
        QCOMPARE(startFolder(panel, FileKind::Template), folder(QStringLiteral("scans")));
    }

    void aRemovedFolderIsForgotten()
    {
        QWidget window;
        window.setWindowFilePath(folder(QStringLiteral("scans/a.obj")));
        rememberFolder(FileKind::Landmarks, folder(QStringLiteral("landmarks/a.csv")));
        QVERIFY(QDir(folder(QStringLiteral("landmarks"))).removeRecursively());
        QCOMPARE(startFolder(window, FileKind::Landmarks), folder(QStringLiteral("scans")));
    }

    void theWindowsDialogsStartThere()
    {
        const std::unique_ptr<MainWindow> window = windowOfSize({1280, 800});
        window->session().openFiles({std::filesystem::path(folder(QStringLiteral("scans/a.obj")).toStdU16String())});
        QTRY_COMPARE_WITH_TIMEOUT(window->document().objects()[0].name, std::string("a.obj"), kPatienceMilliseconds);
        QString start;
        /// Opens the dialog of a menu's action; chooses this file, or none.
        const auto open = [&](const char *action, const QString &chosen = {}) {
            start = QStringLiteral("no dialog");
            QTimer::singleShot(0, this, [&] {
                auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget());
                QVERIFY(dialog);
                start = dialog->directory().absolutePath();
                if (chosen.isEmpty()) {
                    dialog->reject();
                    return;
                }
                dialog->selectFile(chosen);
                QMetaObject::invokeMethod(dialog, "accept");
            });
            actionOf(*window, QString::fromUtf8(action))->trigger();
            return start;
        };
        const QString scans = folder(QStringLiteral("scans"));
        for (const char *action : {"Open…", "Add to Scene…", "Import Landmarks…", "Export Landmarks…", "Load Template…",
                                   "Save Names as Template…", "Open Folder…", "Save Scene As…"})
            QVERIFY2(open(action) == scans, qPrintable(QString::fromUtf8(action) + u' ' + start));
        QCOMPARE(open("Import Landmarks…", folder(QStringLiteral("landmarks/a.csv"))), scans);
        QCOMPARE(window->document().landmarks().size(), std::size_t(1));
        QCOMPARE(open("Import Landmarks…"), folder(QStringLiteral("landmarks")));
        QCOMPARE(open("Export Landmarks…"), folder(QStringLiteral("landmarks")));
        QCOMPARE(open("Open…"), scans); // another kind
    }

private:
    QString folder(const QString &name) const { return m_folder->filePath(name); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

UNPROJECTOR_TEST(TestFileDialogs, display)
#include "test_file_dialogs.moc"
