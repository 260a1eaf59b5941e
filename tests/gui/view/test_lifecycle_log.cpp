// The log by itself, and the life of a real view in it.

#include "tests/support/test.h"

#include "core/examples/examples.h"
#include "gui/document/camera_looks.h"
#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"
#include "gui/pipeline/lifecycle_panel.h"
#include "gui/view/lifecycle_log.h"
#include "gui/view/lifecycle_recorder.h"
#include "gui/view/scene_view.h"
#include "gui/widgets/digits_font.h"
#include "tests/gui/document_edits.h"
#include "tests/support/patience.h"

#include <QAbstractItemModelTester>
#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QToolButton>
#include <QTreeView>

#include <memory>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::scene;
using Kind = LifecycleEvent::Kind;

namespace {

QString cell(const LifecycleLog &log, int row, int column)
{
    return log.index(row, column).data().toString();
}

QStringList column(const LifecycleLog &log, int number)
{
    QStringList cells;
    for (int row = 0; row < log.rowCount(); ++row)
        cells << cell(log, row, number);
    return cells;
}

LifecycleEvent draw(double milliseconds)
{
    return {Kind::OnDraw, {}, QStringLiteral("glClear, glDrawElements"), milliseconds};
}

LifecycleEvent size(int width)
{
    return {Kind::OnSize, QStringLiteral("%1, 768").arg(width), QStringLiteral("glViewport(0, 0, %1, 768)").arg(width),
            0.25};
}

/// A step's name without its arguments and counts.
QString nameOf(const QString &step)
{
    return step.section(u'(', 0, 0).section(u' ', 0, 0);
}

} // namespace

class TestLifecycleLog : public QObject {
    Q_OBJECT

private slots:
    void aStepIsShownAsACallWithWhatItStandsFor()
    {
        LifecycleLog log;
        log.append({Kind::PreCreateWindow, {}, QStringLiteral("OpenGL 3.3 core"), 0.0});
        log.append({Kind::OnCreate, {}, QStringLiteral("glLinkProgram"), 12.346});
        log.append(size(1024));
        log.append({Kind::OnLButtonDown, QStringLiteral("10, 20"), QStringLiteral("glReadPixels"), 0.004});
        log.append({Kind::OnDestroy, {}, QStringLiteral("glDeleteProgram"), 1.0});
        QCOMPARE(column(log, LifecycleLog::Step), QStringList({"PreCreateWindow()", "OnCreate()", "OnSize(1024, 768)",
                                                               "OnLButtonDown(10, 20)", "OnDestroy()"}));
        QCOMPARE(cell(log, 2, LifecycleLog::StandsFor), QStringLiteral("glViewport(0, 0, 1024, 768)"));
        QCOMPARE(column(log, LifecycleLog::Took), QStringList({"–", "12.35 ms", "0.25 ms", "0.00 ms", "1.00 ms"}));
        QCOMPARE(cell(log, 0, LifecycleLog::Time), QStringLiteral("0.000 s"));
        double last = 0.0;
        for (const QString &time : column(log, LifecycleLog::Time)) {
            const double seconds = time.section(u' ', 0, 0).toDouble();
            QVERIFY(seconds >= last);
            last = seconds;
        }
    }

    void picturesInARowAreOneRow()
    {
        LifecycleLog log;
        log.append(size(1024));
        log.append(draw(3.0));
        QCOMPARE(cell(log, 1, LifecycleLog::Step), QStringLiteral("OnDraw"));
        QCOMPARE(cell(log, 1, LifecycleLog::Took), QStringLiteral("3.00 ms"));
        log.append(draw(1.0));
        log.append(draw(0.5));
        QCOMPARE(log.rowCount(), 2);
        QCOMPARE(cell(log, 1, LifecycleLog::Step), QStringLiteral("OnDraw × 3"));
        QCOMPARE(cell(log, 1, LifecycleLog::Took), QStringLiteral("0.50 ms"));
        QCOMPARE(log.index(1, LifecycleLog::Took).data(Qt::ToolTipRole).toString(),
                 QStringLiteral("The last of 3. Mean: 1.50 ms"));
        // The row can be opened.
        const QModelIndex folded = log.index(1, 0);
        QCOMPARE(log.rowCount(folded), 3);
        QStringList each;
        for (int row = 0; row < 3; ++row) {
            const QModelIndex took = log.index(row, LifecycleLog::Took, folded);
            QVERIFY(took.parent() == folded);
            each << took.siblingAtColumn(LifecycleLog::Step).data().toString() + u' ' + took.data().toString();
        }
        QCOMPARE(each, QStringList({"OnDraw 3.00 ms", "OnDraw 1.00 ms", "OnDraw 0.50 ms"}));
        QCOMPARE(log.rowCount(log.index(0, 0)), 0); // it happened once
    }

    void picturesBehindTheSameParametersAreFolded()
    {
        LifecycleLog log;
        const QAbstractItemModelTester tester(&log, QAbstractItemModelTester::FailureReportingMode::QtTest);
        const auto camera = [](int x) {
            return LifecycleEvent{Kind::Camera, {}, QStringLiteral("gluLookAt(%1, 0, 5, …)").arg(x)};
        };
        log.append(draw(1.0));
        for (int x = 0; x < 3; ++x) { // a drag
            log.append(camera(x));
            log.append(draw(1.0));
        }
        log.append({Kind::Projection, {}, QStringLiteral("glOrtho(…)")});
        log.append(draw(1.0));
        log.append(draw(1.0));
        QCOMPARE(column(log, LifecycleLog::Step),
                 QStringList({"OnDraw", "Camera × 3", "OnDraw × 3", "Projection", "OnDraw × 2"}));
        QCOMPARE(cell(log, 1, LifecycleLog::StandsFor), QStringLiteral("gluLookAt(2, 0, 5, …)")); // its current value
        QCOMPARE(log.index(0, LifecycleLog::StandsFor, log.index(1, 0)).data().toString(),
                 QStringLiteral("gluLookAt(0, 0, 5, …)"));
        QCOMPARE(cell(log, 1, LifecycleLog::Took), QStringLiteral("–"));
    }

    void theOldestStepsOfAFoldedRowGo()
    {
        LifecycleLog log;
        const QAbstractItemModelTester tester(&log, QAbstractItemModelTester::FailureReportingMode::QtTest);
        for (int i = 1; i <= LifecycleLog::kMostRepeats + 3; ++i)
            log.append(draw(i));
        QCOMPARE(cell(log, 0, LifecycleLog::Step), QStringLiteral("OnDraw × 203"));
        QCOMPARE(log.rowCount(log.index(0, 0)), 200);
        QCOMPARE(log.index(0, LifecycleLog::Took, log.index(0, 0)).data().toString(), QStringLiteral("4.00 ms"));
    }

    void aFoldedRowOpensByTheKeyboard()
    {
        LifecycleLog log;
        LifecyclePanel panel(log);
        panel.resize(900, 300);
        panel.show();
        for (int i = 0; i < 46; ++i)
            log.append(draw(1.0));
        auto *tree = panel.findChild<QTreeView *>();
        QTRY_VERIFY_WITH_TIMEOUT(tree->isVisible(), kPatienceMilliseconds);
        tree->setCurrentIndex(log.index(0, 0));
        QTest::keyClick(tree, Qt::Key_Right);
        QVERIFY(tree->isExpanded(log.index(0, 0)));
        // Every row has one line and nothing scrolls sideways; the current row is shown whole below.
        const QString call = QStringLiteral("glReadPixels(…) ").repeated(20);
        log.append({Kind::OnLButtonDown, QStringLiteral("1, 2"), call, 1.0});
        const int line = QFontMetrics(tree->font()).height();
        QVERIFY(tree->visualRect(log.index(0, 0)).height() < 2 * line);
        QCOMPARE(tree->header()->length(), tree->viewport()->width());
        tree->setCurrentIndex(log.index(1, 0));
        const auto *whole = panel.findChild<QLabel *>();
        QVERIFY(whole->isVisible());
        QCOMPARE(whole->text(), QStringLiteral("OnLButtonDown(1, 2): ") + call);
        log.clear();
        QVERIFY(!whole->isVisible());
    }

    void coarsePicturesAreTold()
    {
        LifecycleLog log;
        LifecycleEvent coarse = draw(1.0);
        coarse.hasStandIns = true;
        log.append(coarse);
        QCOMPARE(cell(log, 0, LifecycleLog::StandsFor),
                 QStringLiteral("glClear, glDrawElements; large models were drawn coarsely"));
        log.append(coarse);
        log.append(draw(1.0)); // at rest
        QCOMPARE(log.rowCount(), 1);
        QCOMPARE(cell(log, 0, LifecycleLog::StandsFor),
                 QStringLiteral("glClear, glDrawElements; in 2 of 3 frames large models were drawn coarsely"));
        const QString tip = log.index(0, LifecycleLog::StandsFor).data(Qt::ToolTipRole).toString();
        QVERIFY2(tip.contains(QStringLiteral("Clicks always read the full model")), qPrintable(tip));
        log.append(size(800));
        log.append(draw(1.0));
        QVERIFY(!cell(log, 2, LifecycleLog::StandsFor).contains(QStringLiteral("coarse")));
    }

    void anotherStepEndsTheRow()
    {
        LifecycleLog log;
        for (const LifecycleEvent &event : {draw(1.0), draw(1.0), size(800), size(801), draw(1.0)})
            log.append(event);
        QCOMPARE(column(log, LifecycleLog::Step),
                 QStringList({"OnDraw × 2", "OnSize(800, 768)", "OnSize(801, 768)", "OnDraw"}));
        log.clear();
        QCOMPARE(log.rowCount(), 0);
        log.append(draw(1.0));
        QCOMPARE(column(log, LifecycleLog::Step), QStringList({"OnDraw"}));
    }

    void theOldestRowsGo()
    {
        LifecycleLog log;
        for (int width = 1; width <= 2003; ++width)
            log.append(size(width));
        QCOMPARE(log.rowCount(), 2000);
        QCOMPARE(cell(log, 0, LifecycleLog::Step), QStringLiteral("OnSize(4, 768)"));
        QCOMPARE(cell(log, 1999, LifecycleLog::Step), QStringLiteral("OnSize(2003, 768)"));
    }

    void thePanelFollowsUnlessScrolledUp()
    {
        LifecycleLog log;
        LifecyclePanel panel(log);
        panel.resize(900, 190);
        panel.show();
        const QScrollBar *bar = panel.findChild<QTreeView *>()->verticalScrollBar();
        for (int width = 0; width < 100; ++width)
            log.append(size(width));
        QTRY_VERIFY_WITH_TIMEOUT(bar->maximum() > 50, kPatienceMilliseconds);
        QTRY_COMPARE_WITH_TIMEOUT(bar->value(), bar->maximum(), kPatienceMilliseconds);

        panel.findChild<QTreeView *>()->verticalScrollBar()->setValue(20);
        log.append(size(100));
        QTest::qWait(20);
        QCOMPARE(bar->value(), 20);

        panel.findChild<QTreeView *>()->scrollToBottom();
        log.append(size(101));
        log.append(size(102));
        QTRY_COMPARE_WITH_TIMEOUT(bar->value(), bar->maximum(), kPatienceMilliseconds);
    }

    void thePanelCopiesAndClears()
    {
        LifecycleLog log;
        LifecyclePanel panel(log);
        const auto button = [&panel](const QString &text) {
            for (QToolButton *candidate : panel.findChildren<QToolButton *>()) {
                if (candidate->text().remove(u'&') == text)
                    return candidate;
            }
            return static_cast<QToolButton *>(nullptr);
        };
        QVERIFY(!button("Copy")->isEnabled());
        log.append(size(640));
        log.append(size(641));
        button("Copy")->click();
        QCOMPARE(QApplication::clipboard()->text().section(u'\t', 1, 3),
                 QStringLiteral("OnSize(640, 768)\tglViewport(0, 0, 640, 768)\t0.25 ms\n0.000 s"));
        panel.findChild<QTreeView *>()->selectionModel()->select(log.index(1, 0), QItemSelectionModel::ClearAndSelect
                                                                                      | QItemSelectionModel::Rows);
        button("Copy")->click();
        QCOMPARE(QApplication::clipboard()->text().section(u'\t', 1),
                 QStringLiteral("OnSize(641, 768)\tglViewport(0, 0, 641, 768)\t0.25 ms\n"));
        button("Clear")->click();
        QCOMPARE(log.rowCount(), 0);
        QVERIFY(!button("Clear")->isEnabled());
    }

    /// The columns and the rows grow with the font, and the digits are in the other tables' font.
    void thePanelFollowsAFont()
    {
        LifecycleLog log;
        log.append(size(640));
        LifecyclePanel panel(log);
        panel.resize(2000, 300);
        panel.show();
        const auto *table = panel.findChild<QTreeView *>();
        QCOMPARE(table->font().pointSizeF(), digitsFont(panel.font()).pointSizeF());
        const int column = table->columnWidth(LifecycleLog::Step), row = table->visualRect(log.index(0, 0)).height();
        QFont larger = panel.font();
        larger.setPointSizeF(larger.pointSizeF() * 2.0);
        panel.setFont(larger);
        QCOMPARE(table->font().pointSizeF(), digitsFont(larger).pointSizeF());
        QVERIFY(table->columnWidth(LifecycleLog::Step) > column * 3 / 2);
        // Some styles have rows with more room than the text needs.
        const int grown = table->visualRect(log.index(0, 0)).height();
        QVERIFY(grown > row && grown >= QFontMetrics(table->font()).height());
        QCOMPARE(table->header()->font().pointSizeF(), larger.pointSizeF());
    }

    void theLifeOfAViewIsLogged_data()
    {
        addColumn<int>("kind");
        addColumn<QString>("viewport"); // of a window of 400 x 300 device pixels
        newRow("whole window") << int(ViewportRule::Kind::WholeWindow) << "glViewport(0, 0, 400, 300)";
        // glViewport(width/2, 0, width/2, height/2)
        newRow("quarter") << int(ViewportRule::Kind::Quarter) << "glViewport(200, 0, 200, 150)";
    }

    void theLifeOfAViewIsLogged()
    {
        if (QGuiApplication::platformName() == QStringLiteral("offscreen"))
            QSKIP("A view needs OpenGL: run under a display.");
        QFETCH(int, kind);
        QFETCH(QString, viewport);

        SceneDocument document;
        openObjects(document, examples::bundledScene());
        ViewportRule rule;
        rule.kind = static_cast<ViewportRule::Kind>(kind);
        QVERIFY(editViewport(document, rule, document.scene().depthRange, {QStringLiteral("Viewport")}));

        LifecycleLog log;
        auto view = std::make_unique<SceneView>(document);
        LifecycleRecorder recorder(document, log);
        connect(view.get(), &SceneView::happened, &recorder, &LifecycleRecorder::record);
        view->resize(800, 600);
        view->show();
        QVERIFY(QTest::qWaitForWindowExposed(view.get(), kPatienceMilliseconds));
        QTRY_VERIFY_WITH_TIMEOUT(!column(log, LifecycleLog::Step).filter(QStringLiteral("OnDraw")).isEmpty(),
                                 kPatienceMilliseconds);
        const int beforeResize = log.rowCount();
        view->resize(400, 300);
        QTRY_VERIFY_WITH_TIMEOUT(log.rowCount() >= beforeResize + 2, kPatienceMilliseconds);
        QTest::mouseClick(view.get(), Qt::LeftButton, {}, {100, 40});
        QTRY_VERIFY_WITH_TIMEOUT(nameOf(cell(log, log.rowCount() - 1, LifecycleLog::Step)) == QStringLiteral("OnDraw"),
                                 kPatienceMilliseconds); // the pick is drawn
        view.reset();

        // First and last of each step, in this order.
        const QStringList steps = column(log, LifecycleLog::Step);
        QStringList names;
        for (const QString &step : steps) {
            const bool isParameter = step.startsWith(u"Projection") || step.startsWith(u"Camera");
            if (!isParameter && (names.isEmpty() || names.last() != nameOf(step)))
                names << nameOf(step);
        }
        QCOMPARE(names, QStringList({"PreCreateWindow", "OnCreate", "OnSize", "OnDraw", "OnSize", "OnDraw",
                                     "OnLButtonDown", "OnDraw", "OnDestroy"}));

        const double ratio = document.setup().surface.devicePixelRatio;
        if (ratio != 1.0)
            QSKIP("The numbers are those of one device pixel per logical pixel.");
        const auto rowOf = [&steps](const QString &step) { return static_cast<int>(steps.indexOf(step)); };
        QVERIFY2(rowOf("OnSize(800, 600)") >= 0, qPrintable(steps.join(u' ')));
        QVERIFY2(rowOf("OnSize(400, 300)") > rowOf("OnSize(800, 600)"), qPrintable(steps.join(u' ')));
        QCOMPARE(cell(log, rowOf("OnSize(400, 300)"), LifecycleLog::StandsFor), viewport);
        if (kind == int(ViewportRule::Kind::Quarter))
            QCOMPARE(cell(log, rowOf("OnSize(800, 600)"), LifecycleLog::StandsFor),
                     QStringLiteral("glViewport(400, 0, 400, 300)"));
        QVERIFY2(rowOf("OnLButtonDown(100, 40)") > 0, qPrintable(steps.join(u' ')));
        // Row 300 - 1 - 40 from the bottom.
        const QString read = cell(log, rowOf("OnLButtonDown(100, 40)"), LifecycleLog::StandsFor);
        QVERIFY2(read.startsWith(QStringLiteral("glReadPixels(100, 259, 1, 1, GL_DEPTH_COMPONENT")), qPrintable(read));
    }

    void aParameterIsLoggedWithItsCall()
    {
        SceneDocument document;
        openObjects(document, examples::bundledScene());
        document.setSurface({400, 300, 1.0});
        LifecycleLog log;
        LifecycleRecorder recorder(document, log);
        recorder.record(size(400));
        recorder.record(draw(1.0));
        QCOMPARE(column(log, LifecycleLog::Step), QStringList({"OnSize(400, 768)", "Projection", "Camera", "OnDraw"}));
        const auto changed = [&] {
            const int before = log.rowCount();
            recorder.record(draw(1.0));
            return log.rowCount() == before + 2
                       ? cell(log, before, LifecycleLog::Step) + u' ' + cell(log, before, LifecycleLog::StandsFor)
                       : QStringLiteral("%1 rows").arg(log.rowCount() - before);
        };
        ViewportRule rule;
        rule.kind = ViewportRule::Kind::Fixed;
        rule.fixed = {10.0, 20.0, 200.0, 150.0};
        QVERIFY(editViewport(document, rule, document.scene().depthRange, {QStringLiteral("Viewport")}));
        QCOMPARE(changed(), QStringLiteral("Viewport glViewport(10, 20, 200, 150)"));
        QVERIFY(editProjection(document, {Frustum{-1.0, 1.0, -0.75, 0.75, 2.0, 50.0}, false, false}, {"Projection"}));
        QCOMPARE(changed(), QStringLiteral("Projection glFrustum(-1, 1, -0.75, 0.75, 2, 50)"));
        QVERIFY(editProjection(document, {Ortho{-1.0, 1.0, -0.75, 0.75, 2.0, 50.0}, false, false}, {"Projection"}));
        recorder.record(draw(1.0)); // folded: the same two steps
        QCOMPARE(cell(log, log.rowCount() - 2, LifecycleLog::Step), QStringLiteral("Projection × 2"));
        QCOMPARE(cell(log, log.rowCount() - 2, LifecycleLog::StandsFor),
                 QStringLiteral("glOrtho(-1, 1, -0.75, 0.75, 2, 50)"));
        setCamera(document, {WorldPoint(3.0, 2.0, 5.0), WorldPoint(0.0, 0.5, 0.0), WorldVector(0.0, 1.0, 0.0)});
        QCOMPARE(changed(), QStringLiteral("Camera gluLookAt(3, 2, 5, 0, 0.5, 0, 0, 1, 0)"));
        glm::dmat4 lens(0.0); // of another program
        lens[0][0] = lens[1][1] = 2.0;
        lens[2][2] = -1.5;
        lens[2][3] = -1.0;
        lens[3][2] = -2.5;
        QVERIFY(editMatrices(document, MatrixProjection{lens, std::nullopt}, std::nullopt, {"Paste"}));
        QCOMPARE(changed(),
                 QStringLiteral("Projection glLoadMatrixd({2, 0, 0, 0, 0, 2, 0, 0, 0, 0, -1.5, -1, 0, 0, -2.5, 0})"));
        recorder.record(draw(1.0)); // nothing changed
        QCOMPARE(cell(log, log.rowCount() - 1, LifecycleLog::Step), QStringLiteral("OnDraw × 2"));
    }
};

UNPROJECTOR_TEST(TestLifecycleLog, display)
#include "test_lifecycle_log.moc"
