// The window of a series: the list of landmarks out of place, and the expected places in the view.

#include "tests/support/test.h"

#include "tests/gui/scan_folder.h"
#include "tests/gui/window_user.h"

#include "gui/document/scene_edits.h"
#include "gui/landmarks/deviations_model.h"
#include "gui/landmarks/deviations_view.h"
#include "gui/landmarks/scan_series.h"
#include "gui/landmarks/series_panel.h"
#include "gui/view/picture_options.h"
#include "gui/view/scene_picture.h"
#include "tests/support/patience.h"

#include <QFile>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QStatusBar>
#include <QToolButton>
#include <QTreeView>

#include <algorithm>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;
using namespace unprojector::geometry;

namespace {

/// Eight landmarks; small differences from scan to scan.
QStringList landmarksOf(int scan)
{
    const auto row = [scan](const char *name, double x, double y) {
        const double shift = 0.01 * ((scan * 7 + int(x) * 3 + int(y) * 5) % 5 - 2);
        return QStringLiteral("%1,%2,%3,0\n").arg(QLatin1String(name)).arg(x + shift).arg(y - shift);
    };
    return {row("nasion", 5, 8),     row("pogonion", 5, 1),    row("eye left", 7, 7), row("eye right", 3, 7),
            row("mouth left", 6, 3), row("mouth right", 4, 3), row("ear left", 9, 6), row("ear right", 1, 6)};
}

} // namespace

class TestOutOfPlaceWindow : public QObject, ScanFolder {
    Q_OBJECT

private slots:
    void init()
    {
        begin();
        for (int scan = 1; scan <= 5; ++scan)
            writeScan(scan, landmarksOf(scan));
    }

    void theWorstComesFirst()
    {
        QStringList swapped = landmarksOf(2), moved = landmarksOf(4), mixed = landmarksOf(5);
        swapped[2].replace(QStringLiteral("left"), QStringLiteral("right"));
        swapped[3].replace(QStringLiteral("right"), QStringLiteral("left"));
        moved[1] = QStringLiteral("pogonion,5,1.8,0\n");
        mixed[0].replace(QStringLiteral("nasion"), QStringLiteral("ear right"));
        mixed[7].replace(QStringLiteral("ear right"), QStringLiteral("nasion"));
        writeScan(2, swapped);
        writeScan(4, moved);
        writeScan(5, mixed);
        const std::unique_ptr<MainWindow> window = openedWindow();
        DeviationsModel *model = list(*window);
        QCOMPARE(model->rowCount(), 40);
        QStringList rows;
        for (int row = 0; row < 5; ++row) {
            const auto text = [&](int column) { return model->index(row, column).data().toString(); };
            rows << text(DeviationsModel::Scan) + u' ' + text(DeviationsModel::Landmark) + QStringLiteral(": ")
                        + text(DeviationsModel::Outcome);
        }
        QStringList sorted = rows;
        sorted.sort();
        QCOMPARE(sorted, QStringList({QStringLiteral("s2.obj eye left: left and right are swapped"),
                                      QStringLiteral("s2.obj eye right: left and right are swapped"),
                                      QStringLiteral("s4.obj pogonion: out of place"),
                                      QStringLiteral("s5.obj ear right: swapped with nasion"),
                                      QStringLiteral("s5.obj nasion: swapped with ear right")}));
        QCOMPARE(rows[4], QStringLiteral("s4.obj pogonion: out of place")); // only 0.8 off
        QVERIFY(std::abs(model->index(4, DeviationsModel::Distance).data().toDouble() - 0.8) < 0.1);
        QVERIFY(model->index(5, DeviationsModel::Outcome).data().toString().isEmpty());
        const QString summary = window->findChild<DeviationsView *>()->findChild<QLabel *>()->text();
        QVERIFY2(summary.contains(QStringLiteral("Compared scans: 5. Landmarks more than 2.8 spreads off: 5.")),
                 qPrintable(summary));
    }

    void aClickShowsTheLandmark()
    {
        QStringList moved = landmarksOf(4);
        moved[1] = QStringLiteral("pogonion,5,1.8,0\n");
        writeScan(4, moved);
        const std::unique_ptr<MainWindow> window = openedWindow();
        DeviationsModel *model = list(*window);
        auto *rows = window->findChild<DeviationsView *>()->findChild<QTreeView *>();
        QTest::mouseClick(rows->viewport(), Qt::LeftButton, {}, rows->visualRect(model->index(0, 0)).center());
        QTRY_COMPARE_WITH_TIMEOUT(window->document().objects()[0].name, std::string("s4.obj"), kPatienceMilliseconds);
        QTRY_COMPARE_WITH_TIMEOUT(window->document().sceneLandmarks().current(), std::optional<std::size_t>(1),
                                  kPatienceMilliseconds);
        // On the same scan, at once.
        const auto same = [&] {
            for (int row = 1; row < model->rowCount(); ++row) {
                if (model->at(row).specimen == 3)
                    return row;
            }
            return 0;
        }();
        rows->scrollTo(model->index(same, 0));
        QTest::mouseClick(rows->viewport(), Qt::LeftButton, {}, rows->visualRect(model->index(same, 0)).center());
        const auto current = window->document().sceneLandmarks().current();
        QVERIFY(current);
        QCOMPARE(window->document().landmarks()[*current].name,
                 model->index(same, DeviationsModel::Landmark).data().toString().toStdString());
        // A corrected landmark leaves the top of the list.
        QVERIFY(window->document().sceneLandmarks().moveTo(1, WorldPoint(5.0, 1.0, 0.0)));
        auto *summary = window->findChild<DeviationsView *>()->findChild<QLabel *>();
        QTRY_VERIFY_WITH_TIMEOUT(summary->text().contains(QStringLiteral("off: 0.")), kPatienceMilliseconds);
    }

    /// The second landmark of a name is listed with a number, and one without a name by its number.
    void oneOfTwoOfANameIsShown()
    {
        for (int scan = 1; scan <= 5; ++scan) {
            QStringList rows = landmarksOf(scan);
            for (const int twin : {5, 7}) {
                rows[twin].replace(QStringLiteral("mouth right"), QStringLiteral("mouth left"));
                rows[twin].replace(QStringLiteral("ear right"), QString());
            }
            if (scan == 4)
                rows[5] = QStringLiteral("mouth left,4,3.9,0\n");
            if (scan == 3)
                rows[7] = QStringLiteral(",1,6.8,0\n");
            writeScan(scan, rows);
        }
        const std::unique_ptr<MainWindow> window = openedWindow();
        DeviationsModel *model = list(*window);
        auto *rows = window->findChild<DeviationsView *>()->findChild<QTreeView *>();
        QStringList worst;
        for (int row = 0; row < 2; ++row) {
            const QString scan = model->index(row, DeviationsModel::Scan).data().toString(),
                          name = model->index(row, DeviationsModel::Landmark).data().toString();
            worst << scan + u' ' + name;
            window->statusBar()->showMessage(QStringLiteral("All landmarks of the other scan are placed."));
            rows->scrollTo(model->index(row, 0));
            QTest::mouseClick(rows->viewport(), Qt::LeftButton, {}, rows->visualRect(model->index(row, 0)).center());
            QTRY_COMPARE_WITH_TIMEOUT(window->document().objects()[0].name, scan.toStdString(), kPatienceMilliseconds);
            QTRY_COMPARE_WITH_TIMEOUT(window->document().sceneLandmarks().current(),
                                      std::optional<std::size_t>(scan == QStringLiteral("s4.obj") ? 5 : 7),
                                      kPatienceMilliseconds);
            QVERIFY2(!window->statusBar()->currentMessage().startsWith(QStringLiteral("All landmarks")),
                     "a message about another scan");
        }
        worst.sort();
        QCOMPARE(worst, (QStringList{QStringLiteral("s3.obj 8"), QStringLiteral("s4.obj mouth left (2)")}));
    }

    void aLowPanelScrolls()
    {
        for (int scan = 6; scan <= 16; ++scan) // many names in the summary
            writeScan(scan, landmarksOf(scan).mid(0, 2));
        const std::unique_ptr<MainWindow> window = openedWindow();
        QVERIFY(list(*window)->rowCount() > 0);
        auto *view = window->findChild<DeviationsView *>();
        auto *rows = view->findChild<QTreeView *>();
        auto *scroll = view->findChild<QScrollArea *>();
        window->resizeDocks({dockOf(*window, "series")}, {60}, Qt::Vertical);
        settle();
        const int line = rows->fontMetrics().lineSpacing();
        QVERIFY2(view->height() < 7 * line, qPrintable(QString::number(view->height() / line)));
        QVERIFY(rows->height() >= 6 * line); // with the header
        scroll->verticalScrollBar()->setValue(scroll->verticalScrollBar()->maximum());
        settle();
        const int bottom = rows->mapTo(view, QPoint(0, rows->height())).y();
        QVERIFY2(bottom <= view->height(), qPrintable(QString::number(bottom)));
        QVERIFY(rows->viewport()->visibleRegion().boundingRect().height() >= 2 * line);
    }

    void fewScansAreTold()
    {
        for (int scan = 3; scan <= 5; ++scan) {
            QFile::remove(path(QStringLiteral("s%1.obj").arg(scan)));
            QFile::remove(path(QStringLiteral("s%1.obj.points.csv").arg(scan)));
        }
        const std::unique_ptr<MainWindow> window = openedWindow();
        QCOMPARE(list(*window)->rowCount(), 0);
        const QString summary = window->findChild<DeviationsView *>()->findChild<QLabel *>()->text();
        QVERIFY2(summary.contains(QStringLiteral("at least 3 scans with the same 5 landmarks")), qPrintable(summary));
    }

    void expectedPlacesAreDrawn()
    {
        QStringList rows = landmarksOf(5);
        rows[6] = QStringLiteral("ear left,,,\n");
        rows[7] = QStringLiteral("ear right,,,\n");
        writeScan(5, rows);
        const std::unique_ptr<MainWindow> window = openedWindow();
        QTRY_COMPARE_WITH_TIMEOUT(window->document().landmarks().size(), std::size_t(8), kPatienceMilliseconds);
        QCOMPARE(window->document().objects()[0].name, std::string("s5.obj"));
        QAction *action = actionOf(*window, QStringLiteral("Show Expected Places"));
        QVERIFY(action->isChecked());
        const auto grab = [&] {
            settle();
            return window->view().grabFramebuffer();
        };
        const QImage with = grab();
        action->setChecked(false);
        const QImage without = grab();
        action->setChecked(true);
        QCOMPARE(differentPixels(with, grab()), 0);
        // Both places changed, but not much else.
        QVERIFY(differentPixels(with, without) > 50);
        const auto isChanged = [&](const glm::dvec3 &world) {
            const QPointF at = localOf(*window, world) * with.devicePixelRatio();
            const QRect about(at.toPoint() - QPoint(4, 4), QSize(9, 9));
            return differentPixels(with.copy(about), without.copy(about)) > 5;
        };
        QVERIFY(isChanged({9.0, 6.0, 0.0}));
        QVERIFY(isChanged({1.0, 6.0, 0.0}));
        QVERIFY(!isChanged({5.0, 5.0, 0.0}));

        // An image has them with the landmarks only.
        const auto pictureWith = [&](bool landmarks) {
            PictureOptions options{window->document().setup().surface, {}, true};
            options.marks.landmarks = landmarks;
            const auto picture = scenePicture(window->view(), options);
            return picture ? *picture : QImage();
        };
        const QImage shown = pictureWith(true), plain = pictureWith(false);
        action->setChecked(false);
        QVERIFY(!shown.isNull() && !plain.isNull());
        QVERIFY(differentPixels(shown, pictureWith(true)) > 50);
        QCOMPARE(differentPixels(plain, pictureWith(false)), 0);
        action->setChecked(true);

        // The key turns the camera there; a reason is told where there is none.
        window->activateWindow(); // keys are for the active one
        QVERIFY(QTest::qWaitForWindowActive(window.get(), kPatienceMilliseconds));
        QTest::keyClick(&window->view(), Qt::Key_N);
        QTRY_VERIFY_WITH_TIMEOUT(distance(LookAt(window->document().scene().camera).center, WorldPoint(9.0, 6.0, 0.0))
                                     < 0.2,
                                 kPatienceMilliseconds);
        QVERIFY(window->document().sceneLandmarks().remove({6, 7}));
        QTest::keyClick(&window->view(), Qt::Key_N);
        QTRY_VERIFY_WITH_TIMEOUT(window->statusBar()->currentMessage().contains(QStringLiteral("No landmark is next")),
                                 kPatienceMilliseconds);
    }

    void anExpectedNameCoversNoMarker()
    {
        QStringList rows = landmarksOf(5);
        rows[6] = QStringLiteral("ear left,,,\n");
        writeScan(5, rows);
        const std::unique_ptr<MainWindow> window = openedWindow();
        QTRY_COMPARE_WITH_TIMEOUT(window->document().landmarks().size(), std::size_t(8), kPatienceMilliseconds);
        QAction *action = actionOf(*window, QStringLiteral("Show Expected Places"));
        const auto grab = [&](bool hasExpected) {
            action->setChecked(hasExpected);
            settle();
            return window->view().grabFramebuffer();
        };
        // A marker where the name stands otherwise: beside the expected place, to the right and below.
        const QPointF expected = localOf(*window, {9.0, 6.0, 0.0});
        const double unit = localOf(*window, {9.1, 6.0, 0.0}).x() - expected.x();
        landmarks::Landmark wart;
        wart.world = WorldPoint(9.0 + 0.1 * 40.0 / unit, 6.0 - 0.1 * 16.0 / unit, 0.0);
        std::vector<landmarks::Landmark> all = window->document().landmarks();
        all.push_back(wart);
        QVERIFY(editLandmarks(window->document(), all, {QStringLiteral("Wart")}));
        const QImage with = grab(true), without = grab(false);
        const QPointF at = localOf(*window, wart.world->coordinates()) * with.devicePixelRatio();
        const QRect about(at.toPoint() - QPoint(6, 6), QSize(13, 13));
        QVERIFY(with.rect().contains(about));
        QVERIFY(differentPixels(with, without) > 50);
        QCOMPARE(differentPixels(with.copy(about), without.copy(about)), 0);
    }

private:
    void writeScan(int number, const QStringList &rows) const
    {
        write(QStringLiteral("s%1.obj").arg(number), kSquare);
        write(QStringLiteral("s%1.obj.points.csv").arg(number), "name,x,y,z\n" + rows.join(QString()).toUtf8());
    }

    std::unique_ptr<MainWindow> openedWindow() const
    {
        std::unique_ptr<MainWindow> window = windowOfSize({1280, 800});
        part<ScanSeries>(*window).open(path(QString()).toStdU16String());
        [&] {
            QTRY_COMPARE_WITH_TIMEOUT(window->document().objects().size(), std::size_t(1), kPatienceMilliseconds);
        }();
        window->workspaces().show(Panel::Series);
        return window;
    }

    /// Opens the list and waits for its rows.
    DeviationsModel *list(MainWindow &window) const
    {
        for (QToolButton *button : part<SeriesPanel>(window).findChildren<QToolButton *>()) {
            if (button->text() == QStringLiteral("Out of Place"))
                button->click();
        }
        auto *model = window.findChild<DeviationsModel *>();
        auto *summary = window.findChild<DeviationsView *>()->findChild<QLabel *>();
        [&] { QTRY_VERIFY_WITH_TIMEOUT(!summary->text().isEmpty(), kPatienceMilliseconds); }();
        return model;
    }
};

UNPROJECTOR_TEST(TestOutOfPlaceWindow, display)
#include "test_out_of_place_window.moc"
