// The layout of the whole window, in both languages, at several sizes of letters and of the window:
// in no panel, lesson or bar is anything cut or covered, nothing scrolls sideways (but for what
// mayScrollSideways and isExpected name), and the view stands still.

#include "tests/support/test.h"

#include "tests/gui/cut_texts.h"
#include "tests/gui/doctor/doctor_desk.h"
#include "tests/gui/scan_folder.h"
#include "tests/gui/window_user.h"

#include "gui/click/comparison_panel.h"
#include "gui/click/pick_strip.h"
#include "gui/doctor/code_changes_view.h"
#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/document/scene_curves.h"
#include "gui/document/scene_edits.h"
#include "gui/document/scene_landmarks.h"
#include "gui/landmarks/scan_series.h"
#include "gui/lessons/lesson_player.h"
#include "gui/parameters/parameter_group.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/text/translation.h"
#include "gui/widgets/fold.h"
#include "tests/support/patience.h"

#include <QApplication>
#include <QDockWidget>
#include <QFile>
#include <QFontDatabase>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenuBar>
#include <QScrollBar>
#include <QSet>
#include <QStatusBar>
#include <QTabBar>
#include <QTableView>
#include <QToolBar>
#include <QToolButton>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::scene;

namespace {

const QList<QSize> kSizes{{800, 600}, {1024, 700}, {1280, 800}};

bool isNarrow(const QDockWidget &dock)
{
    return dock.window()->width() < kSizes.back().width();
}

/// Tables of landmarks have more columns than a panel is wide.
bool isOfLandmarks(const QDockWidget &dock)
{
    return dock.objectName() == QStringLiteral("points") || dock.objectName() == QStringLiteral("series");
}

/// Returns whether something in a panel may be wider than the panel.
bool mayScrollSideways(const QDockWidget &dock, const QWidget &scrolled)
{
    if (isOfLandmarks(dock))
        return true;
    const QString panel = dock.objectName();
    // So have these, with all columns and with long numbers.
    if (panel == QStringLiteral("comparison") && qobject_cast<const QTableView *>(&scrolled))
        return true;
    // Their least widths are those of rows of digits.
    return isNarrow(dock)
           && QStringList{QStringLiteral("comparison"), QStringLiteral("doctor"), QStringLiteral("pipeline"),
                          QStringLiteral("inspector")}
                  .contains(panel);
}

/// Returns whether a fault is known, or none.
bool isExpected(const QDockWidget &dock, const QString &fault)
{
    // The entries are names of objects, of any length.
    for (const char *group : {"unprojector::gui::PipelineSwitches", "unprojector::gui::ModelGroup"}) {
        if (fault.contains(QStringLiteral("(%1)").arg(QCoreApplication::translate(group, "Object"))))
            return true;
    }
    // What scrolls sideways sticks out.
    if (!isOfLandmarks(dock) && fault.contains(QStringLiteral("sticks out")) && mayScrollSideways(dock, *dock.widget()))
        return fault.contains(QStringLiteral("Panel")) || fault.contains(QStringLiteral("Inspector"));
    // In narrow windows these have too little room for large letters.
    if (isNarrow(dock) && dock.objectName() == QStringLiteral("points"))
        return fault.contains(QCoreApplication::translate("unprojector::gui::MeasuresView", "Measured quantity"));
    return isNarrow(dock) && dock.objectName() == QStringLiteral("series")
           && fault.contains(QStringLiteral("(QToolButton)"));
}

/// The cells of tables, and their headings, that are narrower or lower than their text.
QStringList cutCells(const QWidget &panel)
{
    QStringList found;
    const auto need = [&found](const QString &text, const QSize &needed, const QSize &room) {
        if (needed.width() > room.width() || needed.height() > room.height() + 1)
            found << QStringLiteral("“%1” needs %2 x %3 of %4 x %5")
                         .arg(text)
                         .arg(needed.width())
                         .arg(needed.height())
                         .arg(room.width())
                         .arg(room.height());
    };
    for (const QTableView *table : panel.findChildren<QTableView *>()) {
        const QAbstractItemModel &model = *table->model();
        const QHeaderView &heads = *table->horizontalHeader();
        for (int column = 0; table->isVisible() && column < model.columnCount(); ++column) {
            if (table->isColumnHidden(column))
                continue;
            const int width = table->columnWidth(column);
            const QString head = model.headerData(column, Qt::Horizontal).toString();
            if (heads.isVisible())
                need(head, heads.fontMetrics().size(0, head), {width, heads.height()});
            for (int row = 0; row < model.rowCount(); ++row) {
                const QModelIndex cell = model.index(row, column);
                const QString text = cell.data().toString();
                const QVariant font = cell.data(Qt::FontRole);
                const QFontMetrics metrics(font.isValid() ? font.value<QFont>() : table->font());
                const QRect room(0, 0, width - 2, 1 << 16);
                if (!table->isRowHidden(row))
                    need(text,
                         table->wordWrap() ? metrics.boundingRect(room, Qt::TextWordWrap, text).size()
                                           : metrics.size(0, text),
                         {width, table->rowHeight(row)});
            }
        }
    }
    return found;
}

QStringList faultsOf(const QDockWidget &dock)
{
    QStringList faults = cutTexts(*dock.widget());
    if (!isOfLandmarks(dock))
        faults += cutCells(*dock.widget());
    for (const QScrollBar *bar : dock.findChildren<QScrollBar *>()) {
        const QWidget &scrolled = *bar->parentWidget()->parentWidget();
        if (bar->orientation() == Qt::Horizontal && bar->isVisible() && bar->maximum() > 0
            && !mayScrollSideways(dock, scrolled))
            faults << QStringLiteral("%1 scrolls sideways, %2 beyond %3")
                          .arg(QLatin1String(scrolled.metaObject()->className()))
                          .arg(bar->maximum())
                          .arg(bar->width());
    }
    if (!dock.window()->rect().contains(QRect(dock.mapTo(dock.window(), QPoint()), dock.size())))
        faults << QStringLiteral("the panel leaves the window");
    faults.removeIf([&dock](const QString &fault) { return isExpected(dock, fault); });
    for (QString &fault : faults)
        fault.prepend(dock.objectName() + QStringLiteral(": "));
    return faults;
}

/// The faults around the panels.
QStringList faultsOfBars(MainWindow &window)
{
    QStringList faults;
    for (const QTabBar *tabs : window.findChildren<QTabBar *>()) {
        for (int tab = 0; !tabs->visibleRegion().isEmpty() && tab < tabs->count(); ++tab) {
            if (tabs->fontMetrics().horizontalAdvance(tabs->tabText(tab)) > tabs->tabRect(tab).width())
                faults << QStringLiteral("the tab %1 is cut").arg(tabs->tabText(tab));
        }
    }
    for (const QToolButton *button :
         window.findChild<QToolBar *>(QStringLiteral("tools"))->findChildren<QToolButton *>()) {
        if (button->objectName() == QStringLiteral("qt_toolbar_ext_button") && button->isVisible())
            faults << QStringLiteral("the tool bar has no room");
    }
    const QList<QAction *> menus = window.menuBar()->actions();
    if (window.menuBar()->actionGeometry(menus.last()).right() > window.menuBar()->width())
        faults << QStringLiteral("the menus have no room");
    for (const QString &text : cutTexts(*window.statusBar()))
        faults << QStringLiteral("status bar: %1").arg(text);
    for (const auto *button : part<PickStrip>(window).findChildren<QToolButton *>()) {
        if (button->isVisible() && button->fontMetrics().size(0, button->text()).width() > button->width())
            faults << QStringLiteral("the line below the view: “%1” needs %2 of %3")
                          .arg(button->text())
                          .arg(button->fontMetrics().size(0, button->text()).width())
                          .arg(button->width());
    }
    return faults;
}

/// Gives the layout time, a few turns if it needs them, and returns its faults.
template <class Find>
QStringList settled(const Find &find)
{
    QStringList faults;
    for (int trial = 0; trial < 6; ++trial) {
        settle(trial == 0 ? 1 : 20);
        if (faults = find(); faults.isEmpty())
            break;
    }
    return faults;
}

} // namespace

class TestLayout : public QObject, ScanFolder {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        redirectSettings();
        begin();
        const QByteArray names[] = {"frontomalare orbitale (left side)", "posterior margin of the ramus, lowest point",
                                    "tip"};
        for (const char *file : {"specimen 0042, left mandible, scan 1.obj", "specimen 0043.obj"}) {
            write(QLatin1String(file), kSquare);
            QByteArray table = "name,x,y,z\n";
            for (int i = 0; i < 3; ++i)
                table += '"' + names[i] + "\"," + QByteArray::number(2.123456789 + 2.0 * i) + ','
                         + QByteArray::number(3.0 + i * i) + ",0\n";
            write(QLatin1String(file) + QStringLiteral(".points.csv"),
                  table + "\"not placed yet, on the other side\",,,\n");
        }
    }

    void everythingFits_data()
    {
        addColumn<int>("points");
        addColumn<QString>("language");
        for (const int points : {9, 11, 13}) {
            for (const QString &language : {QStringLiteral("en"), QStringLiteral("zh_CN")})
                addRow("%d pt, %s", points, qPrintable(language)) << points << language;
        }
    }

    void everythingFits()
    {
        QFETCH(int, points);
        QFETCH(QString, language);
        if (language != QStringLiteral("en")) {
            if (!QFile::exists(QStringLiteral(":/translations/unprojector_zh_CN.qm")))
                QSKIP("Built without Qt's LinguistTools.");
            if (!QFontDatabase::writingSystems().contains(QFontDatabase::SimplifiedChinese))
                QSKIP("No font here has Hanzi: boxes say nothing of their room. Install one, such as fonts-noto-cjk.");
        }
        const QFont before = QApplication::font();
        QFont font = before;
        font.setPointSize(points);
        QApplication::setFont(font);
        m_faults.clear();
        {
            const Translation translation({language});
            MainWindow::Options options;
            options.smoothEdges = false;
            options.remembers = false;
            options.translation = &translation;
            MainWindow window(options);
            window.session().openBundledScene();
            bringUp(window);
            lookAtPanels(window, QStringLiteral("the bundled scene"), {kSizes[0]});
            openLongScene(window);
            lookAtPanels(window, QStringLiteral("long texts"), kSizes);
            lookAtParameters(window);
            // All of them where letters need the most room.
            lookAtLessons(window, points == 13);
        }
        QApplication::setFont(before);
        m_faults.removeDuplicates();
        for (const QString &fault : std::as_const(m_faults))
            qWarning("%s", qPrintable(fault)); // a message of a failure has a limit
        QCOMPARE(m_faults.size(), 0);
    }

private:
    void add(const QString &where, const QStringList &faults)
    {
        for (const QString &fault : faults)
            m_faults << QStringLiteral("%1: %2").arg(where, fault);
    }

    /// A series of scans with landmarks, a curve and a selection; numbers of all lengths, and one of
    /// every kind of part, all open.
    void openLongScene(MainWindow &window)
    {
        SceneDocument &document = window.document();
        QVERIFY(part<ScanSeries>(window).open(path(QString()).toStdU16String()));
        QTRY_VERIFY_WITH_TIMEOUT(!window.session().isLoading() && document.landmarks().size() == 4,
                                 kPatienceMilliseconds);
        QVERIFY(document.sceneLandmarks().setNote(0, QStringLiteral("broken off, place it where the rim would be")));
        QCOMPARE(document.curves().join({0, 1, 2}, landmarks::CurveKind::Geodesic), QString());
        QVERIFY(document.edit({QStringLiteral("long")}, [](Scene &scene) {
            scene.objects[0].transform = {Translate{{-1.0 / 3.0, 123.456789, -1e-5}},
                                          Rotate{-23.456789, {0.1 + 0.2, 1.0, 0.0}},
                                          Scale{{1.0000001, 4.0 / 3.0, 1e10}}};
            scene.clipPlanes.assign(3, {-0.123456789, 1.0, 2.0e-7, 123456789.0});
            scene.depthRange = {0.049999976, 1.0 / 3.0};
        }));
        fitAll(document);
        const geometry::ProjectionWindow seen = projectionWindow(document.setup().projection());
        QVERIFY(document.edit({QStringLiteral("long")}, [&seen](Scene &scene) {
            scene.projectionFollowsViewport = scene.clipDistancesFitObjects = false;
            scene.projection = Frustum{seen.left - 1e-7, seen.right,        seen.bottom,
                                       seen.top,         seen.nearDistance, 8000.0 * seen.farDistance};
            scene.viewport = {ViewportRule::Kind::KeepAspect, {}, 4.0 / 3.0};
        }));
        for (ParameterGroup *group : window.findChildren<ParameterGroup *>())
            group->setOpen(true);
        for (Fold *fold : window.findChildren<Fold *>())
            fold->setOpen(true);
        part<ComparisonPanel>(window).setShowsFloat(true);
        part<ComparisonPanel>(window).setShowsRay(true);
        part<PipelinePanel>(window).setAllOpen(true);
    }

    /// Types a point into the doctor's form as of a program that does not flip y, and waits for its
    /// answer.
    /// @param mustKnow  the answer is that mistake, with its code
    void askDoctor(MainWindow &window, bool mustKnow)
    {
        const auto &pick = window.document().picks().pick();
        QVERIFY(pick && pick->hit());
        const QString name =
            QCoreApplication::translate("unprojector::gui::WrongPointsForm", "Your program's coordinate");
        const double height = window.document().setup().surface.heightPixels;
        const glm::dvec3 wrong =
            doctordesk::unprojected(window, {pick->window.x, height - pick->window.y, pick->window.z});
        for (QLineEdit *field : window.findChildren<QLineEdit *>()) {
            if (field->accessibleName() == name && !field->isHidden() && field->text().isEmpty())
                doctordesk::type(field, doctordesk::pointText(wrong));
        }
        if (mustKnow)
            QTRY_VERIFY_WITH_TIMEOUT(part<DoctorPanel>(window).code().isVisible(), kPatienceMilliseconds);
        else
            settle(300);
    }

    void lookAtPanels(MainWindow &window, const QString &content, const QList<QSize> &sizes)
    {
        for (const QSize &size : sizes) {
            window.resize(size);
            settle(10);
            QSet<const QDockWidget *> looked;
            const auto docks = window.findChildren<QDockWidget *>();
            for (const char *place : lessons::kWorkspaceNames) {
                const QString where = QStringLiteral("%1, %2 x %3, %4")
                                          .arg(content)
                                          .arg(size.width())
                                          .arg(size.height())
                                          .arg(QLatin1String(place));
                enter(window, place);
                window.workspaces().reset(); // as it starts at this size
                settle(10);
                QCOMPARE(window.size(), size);
                const QSize viewSize = window.view().size();
                QList<QDockWidget *> shown;
                for (QDockWidget *dock : docks) {
                    // Those of no workspace are shown in the last one.
                    const bool isElsewhere = place == lessons::kWorkspaceNames.back() && !looked.contains(dock);
                    if (!dock->isHidden() || isElsewhere)
                        shown << dock;
                }
                QList<QPointF> shares{{0.5, 0.55}};
                if (window.workspaces().current() == Workspace::Click)
                    shares.prepend({0.01, 0.01}); // the background
                for (const QPointF &share : std::as_const(shares)) {
                    const QPointF at(share.x() * viewSize.width(), share.y() * viewSize.height());
                    click(window.view(), at);
                    sendMouse(window.view(), QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton);
                    add(where, settled([&] { return faultsOfBars(window); }));
                    QCOMPARE(window.view().size(), viewSize);
                }
                if (window.workspaces().current() == Workspace::Doctor)
                    askDoctor(window, window.document().landmarks().empty());
                if (window.workspaces().current() == Workspace::Landmarks && window.document().landmarks().size() > 2)
                    window.document().sceneLandmarks().select({0, 1, 2});
                window.setUpdatesEnabled(false); // drawing takes most of the time
                for (QDockWidget *dock : std::as_const(shown)) {
                    const bool isOfPlace = !dock->isHidden();
                    window.workspaces().show(panelNamed(dock->objectName()));
                    add(where, settled([&] { return faultsOf(*dock) + faultsOfBars(window); }));
                    QVERIFY2(window.workspaces().isFront(*dock), qPrintable(dock->objectName()));
                    looked << dock;
                    if (!isOfPlace)
                        dock->hide();
                }
                window.setUpdatesEnabled(true);
            }
            QCOMPARE(looked.size(), docks.size());
        }
    }

    /// The parameters of each projection with fields that are refused, and then of no objects.
    void lookAtParameters(MainWindow &window)
    {
        SceneDocument &document = window.document();
        window.resize(kSizes[0]);
        window.workspaces().show(Panel::Parameters);
        const QDockWidget &dock = window.workspaces().dock(Panel::Parameters);
        const geometry::ProjectionWindow seen = projectionWindow(document.setup().projection());
        const Ortho box{seen.left, seen.right, seen.bottom, seen.top, seen.nearDistance, seen.farDistance};
        for (const Projection &projection : {Projection(Perspective()), Projection(box), Projection(Oblique{box})}) {
            QVERIFY(document.edit({QStringLiteral("kind")}, [&](Scene &scene) { scene.projection = projection; }));
            settle(1);
            for (QLineEdit *field : dock.findChildren<QLineEdit *>()) {
                if (field->isVisible())
                    doctordesk::type(field, QStringLiteral("abc"));
            }
            add(QStringLiteral("refused, projection %1").arg(projection.index()),
                settled([&] { return faultsOf(dock); }));
        }
        QVERIFY(document.edit({QStringLiteral("none")}, [&](Scene &scene) { scene.objects.clear(); }));
        add(QStringLiteral("no objects"), settled([&] { return faultsOf(dock); }));
        window.resize(kSizes.back());
    }

    /// The texts of the lessons, their questions' answers among them, and the view from outside.
    /// @param areAll  or only the first one
    void lookAtLessons(MainWindow &window, bool areAll)
    {
        LessonPlayer &lessons = part<LessonPlayer>(window);
        window.setUpdatesEnabled(false); // drawing takes most of the time
        for (const auto &lesson : lessons.lessons()) {
            if (!areAll && &lesson != &lessons.lessons().front())
                break;
            QVERIFY(lessons.start(lesson.name));
            for (bool isThere = true; isThere; isThere = lessons.hasNext() && lessons.next()) {
                for (const bool isRevealed : {false, true}) {
                    if (isRevealed && !lessons.step().question)
                        continue;
                    if (isRevealed)
                        lessons.reveal();
                    for (const Panel panel : {Panel::Lesson, Panel::Observer}) {
                        const QDockWidget &dock = window.workspaces().dock(panel);
                        if (window.workspaces().isFront(dock))
                            add(QString::fromStdString(lesson.name + ", " + lessons.step().title),
                                settled([&] { return faultsOf(dock); }));
                    }
                }
            }
            QVERIFY(lessons.leave());
        }
    }

    QStringList m_faults;
};

UNPROJECTOR_TEST(TestLayout, unsanitized, display)
#include "test_layout.moc"
