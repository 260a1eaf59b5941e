// Points in the whole window: opened with their model, dropped, from menus, and on a series of scans by keys.

#include "window_user.h"

#include "gui/document/point_files.h"
#include "gui/document/scan_series.h"
#include "gui/panels/points_model.h"
#include "gui/panels/points_table.h"

#include <QFile>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QUrl>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;

namespace {

const QByteArray kSquare = "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nf 1 2 3\nf 1 3 4\n";

} // namespace

class TestPointsWindow : public QObject {
    Q_OBJECT

private slots:
    void init();
    void droppedPointsComeToTheTable();
    void keysGoThroughASeries();
    void whatIsBeingTypedIsKeptWithItsScan();

private:
    QString path(const QString &name) const { return m_folder->filePath(name); }
    void write(const QString &name, const QByteArray &text) const
    {
        QFile out(path(name));
        QVERIFY(out.open(QIODevice::WriteOnly));
        QCOMPARE(out.write(text), text.size());
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestPointsWindow::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    for (const char *name : {"a.obj", "b.obj"})
        write(QLatin1String(name), kSquare);
}

void TestPointsWindow::droppedPointsComeToTheTable()
{
    const std::unique_ptr<MainWindow> window = windowOfSize({1280, 800});
    write(QStringLiteral("p.csv"), "name,x,y,z\nfirst,1,2,0\n");
    emit window->view().filesDropped(
        {QUrl::fromLocalFile(path(QStringLiteral("p.csv"))), QUrl::fromLocalFile(path(QStringLiteral("a.obj")))});
    QTRY_COMPARE(window->document().landmarks().size(), std::size_t(1));
    window->places().show("points");
    QVERIFY(isSeen(*window, "points"));
    auto *table = window->findChild<PointsTable *>();
    QVERIFY(table);
    QCOMPARE(table->model()->rowCount(), 1);
    QVERIFY(actionOf(*window, QStringLiteral("Import Points…")));
    QVERIFY(actionOf(*window, QStringLiteral("Export Points…")));
    write(QStringLiteral("p.csv"), "name,x,y,z\nfirst,1,two,0\n");
    emit window->view().filesDropped({QUrl::fromLocalFile(path(QStringLiteral("p.csv")))});
    QVERIFY2(window->message().contains(QStringLiteral("p.csv:2:")), qPrintable(window->message()));
    QCOMPARE(window->document().landmarks().size(), std::size_t(1));
}

void TestPointsWindow::keysGoThroughASeries()
{
    std::unique_ptr<MainWindow> window = windowOfSize({1280, 800});
    QVERIFY(window->series().open(m_folder->path().toStdU16String()));
    QTRY_COMPARE(window->document().objects().size(), std::size_t(1));
    landmarks::Landmark point;
    point.name = "first";
    point.world = WorldPoint(1.0, 2.0, 0.0);
    QVERIFY(window->document().points().place(point));
    window->activateWindow(); // keys are for the active one
    QVERIFY(QTest::qWaitForWindowActive(window.get()));
    QTest::keyClick(&window->view(), Qt::Key_PageDown, Qt::ControlModifier);
    QTRY_COMPARE(window->document().objects()[0].name, std::string("b.obj"));
    QVERIFY(QFile::exists(path(QStringLiteral("a.obj.points.csv"))));
    QCOMPARE(window->document().landmarks().size(), std::size_t(1)); // it waits here
    QVERIFY(window->document().landmarks()[0].isMissing());
    QVERIFY(window->document().points().place(point));
    QVERIFY(window->close());
    QVERIFY(QFile::exists(path(QStringLiteral("b.obj.points.csv"))));
}

void TestPointsWindow::whatIsBeingTypedIsKeptWithItsScan()
{
    write(QStringLiteral("a.obj.points.csv"), "name,x,y,z\nfirst,1,2,0\nlast,,,\n");
    const std::unique_ptr<MainWindow> window = windowOfSize({1280, 800});
    QVERIFY(window->series().open(m_folder->path().toStdU16String()));
    QTRY_COMPARE(window->document().landmarks().size(), std::size_t(2));
    window->places().show("points");
    auto *table = window->findChild<PointsTable *>();
    const auto type = [table](const QString &text) {
        const QModelIndex name = table->model()->index(0, PointsModel::Name);
        table->setCurrentIndex(name);
        table->edit(name);
        auto *editor = table->viewport()->findChild<QLineEdit *>();
        QVERIFY(editor);
        editor->setText(text);
    };
    const auto kept = [this] {
        QFile file(path(QStringLiteral("a.obj.points.csv")));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    type(QStringLiteral("nasion"));
    window->series().next();
    QTRY_COMPARE(window->document().objects()[0].name, std::string("b.obj"));
    QVERIFY2(kept().contains("nasion,1,2,0"), kept().constData());
    QVERIFY(window->document().landmarks()[0].isMissing());
    window->series().previous();
    QTRY_COMPARE(window->document().objects()[0].name, std::string("a.obj"));
    type(QStringLiteral("bregma"));
    QVERIFY(window->close());
    QVERIFY2(kept().contains("bregma,1,2,0"), kept().constData());
}

QTEST_MAIN(TestPointsWindow)
#include "test_points_window.moc"
