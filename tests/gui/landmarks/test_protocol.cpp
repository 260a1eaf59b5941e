// The protocol: measures that the user keeps; and the table of the error of measurement.

#include "tests/support/test.h"

#include "core/geometry/spaces.h"
#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"
#include "gui/document/scene_landmarks.h"
#include "gui/landmarks/measures_view.h"
#include "gui/landmarks/protocol_rows.h"
#include "gui/landmarks/repeats_dialog.h"
#include "gui/widgets/segmented_switch.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>
#include <QTreeWidget>
#include <QUndoStack>

#include <memory>

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using landmarks::KeptMeasure;
using landmarks::Landmark;
using landmarks::MeasureKind;

namespace {

Landmark placed(const char *name, double x, double y, double z)
{
    Landmark landmark;
    landmark.name = name;
    landmark.world = WorldPoint(x, y, z);
    return landmark;
}

} // namespace

class TestProtocol : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_view.reset();
        m_document = std::make_unique<SceneDocument>();
        QVERIFY(editLandmarks(*m_document,
                              {placed("a", 0, 0, 0), placed("b", 3, 0, 0), placed("c", 0, 4, 0), placed("", 1, 1, 1)},
                              {QString()}));
        m_view = std::make_unique<MeasuresView>(*m_document);
        m_view->resize(500, 400);
        m_view->show();
    }

    void aMeasureIsKept()
    {
        QSignalSpy warned(m_view.get(), &MeasuresView::warned);
        m_document->sceneLandmarks().select({0, 1});
        QCOMPARE(button().text(), QStringLiteral("Keep"));
        button().click(); // nothing is chosen
        QCOMPARE(warned.size(), 1);
        choose(0);
        button().click();
        QCOMPARE(measures(), (std::vector<KeptMeasure>{{"a-b", MeasureKind::Distance, {"a", "b"}}}));
        choose(0); // hides it in the view
        choose(0);
        button().click(); // a second one has a name of its own
        QCOMPARE(measures().size(), std::size_t(2));
        QCOMPARE(measures()[1].name, std::string("a-b 2"));
        m_document->undoStack().undo();
        QCOMPARE(measures().size(), std::size_t(1));
        show(2);
        QCOMPARE(rows().topLevelItemCount(), 1);
        QCOMPARE(rows().topLevelItem(0)->text(0), QStringLiteral("a-b"));
        QCOMPARE(rows().topLevelItem(0)->text(1), QStringLiteral("distance: a – b"));
        QVERIFY2(rows().topLevelItem(0)->text(2).startsWith(QStringLiteral("3")),
                 qPrintable(rows().topLevelItem(0)->text(2)));
        QVERIFY2(m_view->csv().contains(QStringLiteral("a-b,distance: a – b,3,")), qPrintable(m_view->csv()));
        // Its landmarks are selected by a click, so that the view shows it.
        m_document->sceneLandmarks().clearSelection();
        choose(0);
        QCOMPARE(m_document->sceneLandmarks().selection(), (std::vector<std::size_t>{0, 1}));
        QVERIFY(m_document->curves().shownMeasure());
    }

    /// The first angle of the list is that at the first landmark.
    void anglesKeepTheirVertex()
    {
        m_document->sceneLandmarks().select({0, 1, 2});
        constexpr int kFirstAngle = 3; // after three distances
        QVERIFY(rows().topLevelItem(kFirstAngle)->text(2).startsWith(QStringLiteral("90")));
        choose(kFirstAngle);
        button().click();
        QCOMPARE(measures().size(), std::size_t(1));
        QCOMPARE(measures()[0].kind, MeasureKind::Angle);
        QCOMPARE(measures()[0].landmarks[1], std::string("a"));
        show(2);
        QVERIFY2(rows().topLevelItem(0)->text(2).startsWith(QStringLiteral("90")),
                 qPrintable(rows().topLevelItem(0)->text(2)));
    }

    void landmarksNeedNames()
    {
        QSignalSpy warned(m_view.get(), &MeasuresView::warned);
        m_document->sceneLandmarks().select({0, 3});
        choose(0);
        button().click();
        QCOMPARE(warned.size(), 1);
        QVERIFY(measures().empty());
    }

    void aMeasureIsRenamedAndRemoved()
    {
        landmarks::LandmarkSet set = m_document->scene().landmarks;
        set.measures = {{"one", MeasureKind::Distance, {"a", "b"}}, {"two", MeasureKind::Distance, {"a", "c"}}};
        QVERIFY(editLandmarkSet(*m_document, set, {QString()}));
        QSignalSpy warned(m_view.get(), &MeasuresView::warned);
        show(2);
        rows().topLevelItem(1)->setText(0, QStringLiteral("one"));
        QCOMPARE(warned.size(), 1); // the name is taken
        QCOMPARE(measures()[1].name, std::string("two"));
        QCOMPARE(rows().topLevelItem(1)->text(0), QStringLiteral("two"));
        rows().topLevelItem(1)->setText(0, QStringLiteral("height"));
        QCOMPARE(measures()[1].name, std::string("height"));
        QCOMPARE(button().text(), QStringLiteral("Remove"));
        const QRect removes(button().mapTo(m_view.get(), QPoint()), button().size());
        show(0);
        QCOMPARE(button().text(), QStringLiteral("Keep"));
        const QPoint keeps = button().mapTo(m_view.get(), button().rect().center());
        QVERIFY2(!removes.contains(keeps), "a second press on Keep's place removes");
        show(2);
        choose(0);
        button().click();
        QCOMPARE(measures(), (std::vector<KeptMeasure>{{"height", MeasureKind::Distance, {"a", "c"}}}));
        m_document->undoStack().undo();
        QCOMPARE(measures().size(), std::size_t(2));
    }

    void aRowSaysWhyItHasNoValue()
    {
        landmarks::LandmarkSet set = m_document->scene().landmarks;
        set.landmarks[1].world.reset();
        set.landmarks[1].absence = landmarks::Absence::Missing;
        set.measures = {{"gone", MeasureKind::Distance, {"a", "b"}},
                        {"unknown", MeasureKind::Angle, {"a", "q", "c"}},
                        {"path", MeasureKind::Surface, {"a", "c"}}};
        const std::vector<MeasureRow> rows = protocolRows(set, {}, nullptr);
        QCOMPARE(rows.size(), std::size_t(3));
        QCOMPARE(rows[0].value, QStringLiteral("\"b\" is missing on this specimen"));
        QCOMPARE(rows[1].value, QStringLiteral("no landmark has the name \"q\""));
        QCOMPARE(rows[2].value, QStringLiteral("click to compute"));
        QVERIFY(!rows[0].number && !rows[1].number && !rows[2].number);
        QCOMPARE(protocolText(set.measures[0], set), QStringLiteral("–"));
        QVERIFY(protocolTip(set.measures[0], set).contains(QStringLiteral("is missing on this specimen")));
        SceneCurves::Line line;
        line.line.emplace();
        line.line->length = {7.5, std::nullopt};
        const std::vector<MeasureRow> selected = protocolRows(set, {0, 2}, &line);
        QCOMPARE(selected[2].number, std::optional(7.5));
    }

    void theErrorsAsATable()
    {
        landmarks::MeasurementError error;
        error.placings = {1, 3};
        error.all.error = 0.5;
        for (const auto &[name, size] : {std::pair("first", 0.25), std::pair("worst", 2.0), std::pair("none", -1.0)}) {
            landmarks::LandmarkError &landmark = error.landmarks.emplace_back();
            landmark.name = name;
            landmark.byPlacing.resize(2);
            if (size > 0.0)
                landmark.error = size;
        }
        error.landmarks[1].icc1 = 0.123456789;
        error.all.byPlacing.resize(2);
        RepeatsDialog dialog(error, QStringLiteral("mm"), {QStringLiteral("A remark.")});
        const QTreeWidget &table = dialog.table();
        const auto column = [&table](int index) {
            QStringList texts;
            for (int row = 0; row < table.topLevelItemCount(); ++row)
                texts << table.topLevelItem(row)->text(index);
            return texts;
        };
        QStringList titles;
        for (int i = 0; i < table.columnCount(); ++i)
            titles << table.headerItem()->text(i);
        QCOMPARE(titles, (QStringList{"Landmark", "Scans", "Placings", "Error ± [mm]", "ICC(1)", "ICC(2,1)",
                                      "Error of 1 [mm]", "Bias of 1 [mm]", "Error of 3 [mm]", "Bias of 3 [mm]"}));
        QCOMPARE(column(0), (QStringList{"All landmarks", "first", "worst", "none"}));
        QCOMPARE(column(3), (QStringList{"0.5", "0.25", "2", "–"}));
        QCOMPARE(column(4)[2], QStringLiteral("0.1235"));
        auto &sorted = const_cast<QTreeWidget &>(table);
        sorted.sortByColumn(3, Qt::DescendingOrder); // the worst first, below the row of all
        QCOMPARE(column(0), (QStringList{"All landmarks", "worst", "first", "none"}));
        sorted.sortByColumn(3, Qt::AscendingOrder);
        QCOMPARE(column(0), (QStringList{"All landmarks", "first", "worst", "none"}));
        for (QPushButton *each : dialog.findChildren<QPushButton *>()) {
            if (each->text() == QStringLiteral("&Copy"))
                each->click();
        }
        QVERIFY2(QApplication::clipboard()->text().contains(QStringLiteral("worst\t0\t0\t2\t0.123456789\tNA")),
                 qPrintable(QApplication::clipboard()->text()));
    }

private:
    const std::vector<KeptMeasure> &measures() const { return m_document->scene().landmarks.measures; }
    QTreeWidget &rows() { return *m_view->findChild<QTreeWidget *>(); }
    /// The shown one of Keep and Remove.
    QToolButton &button()
    {
        for (QToolButton *button : m_view->findChildren<QToolButton *>(QString(), Qt::FindDirectChildrenOnly)) {
            if (button->isVisibleTo(m_view.get()))
                return *button;
        }
        qFatal("no button");
    }
    void choose(int row)
    {
        const QRect where = rows().visualItemRect(rows().topLevelItem(row));
        QTest::mouseClick(rows().viewport(), Qt::LeftButton, {}, where.center());
    }
    void show(int tab) { m_view->findChild<SegmentedSwitch *>()->setChoice(tab); }

    std::unique_ptr<SceneDocument> m_document;
    std::unique_ptr<MeasuresView> m_view;
};

UNPROJECTOR_TEST(TestProtocol)
#include "test_protocol.moc"
