// A point of the user's own: typed and pasted into the pipeline panel, undone, left for a click and
// followed again.

#include "tests/support/test.h"

#include "tests/gui/document_edits.h"
#include "tests/gui/pipeline/pipeline_figures.h"

#include "gui/document/given_points.h"
#include "gui/document/scene_edits.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/text/typed_numbers.h"
#include "gui/widgets/number_grid.h"
#include "tests/support/patience.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

#include <algorithm>

using namespace unprojector;
using namespace unprojector::gui;
using namespace pipelinetest;
using namespace unprojector::geometry;
using namespace unprojector::pipeline;

namespace {

/// A shown panel, and a user's actions on it.
struct ShownPanel {
    SceneDocument document;
    PipelinePanel panel{document};

    ShownPanel()
    {
        openFigures(document);
        panel.resize(420, 900);
        panel.show();
        if (!QTest::qWaitForWindowExposed(&panel, kPatienceMilliseconds))
            qFatal("The panel is not shown.");
    }
    const PipelineModel &model() const { return panel.model(); }
    NumberGrid *grid(Space space) const
    {
        for (NumberGrid *grid : panel.findChildren<NumberGrid *>()) {
            if (grid->model() == model().point(space))
                return grid;
        }
        qFatal("There is no such row.");
    }
    /// Types a number as a user does: a click on the cell, then the first key begins it.
    void type(Space space, int coordinate, const QString &text) const
    {
        NumberGrid *rows = grid(space);
        rows->setFocus();
        rows->setCurrentIndex(model().point(space)->indexOf(coordinate));
        QTest::keyClicks(rows, text.left(1));
        const QList<QLineEdit *> editors = rows->viewport()->findChildren<QLineEdit *>();
        const auto open = std::find_if(editors.begin(), editors.end(), [](QLineEdit *e) { return e->isVisible(); });
        QVERIFY2(open != editors.end(), "no editor was opened");
        QLineEdit *editor = *open;
        QCOMPARE(editor->text(), text.left(1));
        QTest::keyClicks(editor, text.mid(1));
        QTest::keyClick(editor, Qt::Key_Return);
        QCoreApplication::processEvents(); // a line edit in a table may look at its text before it counts
    }
    void paste(Space space, const QString &text) const
    {
        QGuiApplication::clipboard()->setText(text);
        QTest::keySequence(grid(space), QKeySequence::Paste);
    }
    bool tells(const QString &text) const
    {
        for (const QLabel *label : panel.findChildren<QLabel *>()) {
            if (label->text().contains(text))
                return true;
        }
        qWarning("It says: %s", qPrintable(model().status()));
        return false;
    }
    QToolButton *button(const QString &text) const
    {
        for (QToolButton *button : panel.findChildren<QToolButton *>()) {
            if (button->text() == text && button->isVisible())
                return button;
        }
        return nullptr;
    }
};

} // namespace

class TestGivenPoint : public QObject {
    Q_OBJECT

private slots:
    void aTypedNumberIsAPointBothWays()
    {
        const ShownPanel shown;
        // fig. 2.7 and 2.10: eye z = -8 is NDC 0.8, depth 0.9.
        shown.type(Space::Eye, 2, QStringLiteral("-8"));
        QVERIFY(isPoint(shown.model().point(Space::Object), {0, 0, 0}));
        QVERIFY(isPoint(shown.model().point(Space::World), {0, 0, -3}));
        QVERIFY(isPoint(shown.model().point(Space::Eye), {0, 0, -8}));
        QVERIFY(isPoint(shown.model().point(Space::Clip), {0, 0, 0.8, 1}));
        QVERIFY(isPoint(shown.model().point(Space::Window), {25, 25, 0.9}));
        QVERIFY(isPoint(shown.model().point(Space::Widget), {25, 25}));
        QVERIFY(shown.tells(QStringLiteral("Your point in eye coordinates")));
        QVERIFY(shown.document.scene().givenPoint->point == GivenPoint{EyePoint(0, 0, -8)}.point);
        QVERIFY(givenWorld(shown.document.scene(), shown.document.setup()).value() == WorldPoint(0, 0, -3));
        QVERIFY(shown.document.isEdited());
        // The camera moves on, the eye point stays.
        QVERIFY(shown.document.scene().givenPoint.has_value());
    }

    void whatIsTypedForOneCoordinateLeavesTheOthers()
    {
        const ShownPanel shown;
        shown.type(Space::World, 0, QStringLiteral("1/4"));
        shown.type(Space::World, 1, QStringLiteral("2"));
        QVERIFY(isPoint(shown.model().point(Space::World), {0.25, 2, 0}));
        shown.type(Space::Clip, 3, QStringLiteral("2"));
        QVERIFY(isPoint(shown.model().point(Space::Clip), {0.025, 0.2, 0.5, 2}));
        QVERIFY(isPoint(shown.model().point(Space::Ndc), {0.0125, 0.1, 0.25}));
    }

    void allCoordinatesArePastedAsProgramsPrintThem_data()
    {
        addColumn<QString>("text");
        for (const char *text :
             {"1.5 2 -3", "1.5, 2, -3", "1.5,2,-3", "(1.5, 2, -3)", "vec3(1.500000, 2.000000, -3.000000)",
              "[1.5 2. -3.]", "array([ 1.5,  2. , -3. ])", "{1.5f, 2.0f, -3.f};", "QVector3D(1.5, 2, -3)", "1.5\t2\t-3",
              "1.5\n2\n-3\n", "1,5 2,0 -3", "1.5; 2; -3", "dvec4(1.5, 2, -3, 1)", "3/2 2 -3"})
            newRow(text) << QString::fromLatin1(text);
    }

    void allCoordinatesArePastedAsProgramsPrintThem()
    {
        QFETCH(QString, text);
        const ShownPanel shown;
        shown.paste(Space::World, text);
        QVERIFY(shown.document.scene().givenPoint.has_value());
        QVERIFY(shown.document.scene().givenPoint->point == GivenPoint{WorldPoint(1.5, 2, -3)}.point);
    }

    void nonsenseIsRefusedWithItsReason()
    {
        const ShownPanel shown;
        for (const char *text : {"1 2", "1 2 3 4", "vec3(a, b, c)", "", "1 / 3 /", "1e999", "(((("}) {
            shown.paste(Space::World, QString::fromLatin1(text));
            QVERIFY2(!shown.document.scene().givenPoint, text);
        }
        shown.type(Space::World, 0, QStringLiteral("2x"));
        QVERIFY(!shown.document.scene().givenPoint);
        QVERIFY(shown.tells(QStringLiteral("x")));
        QVERIFY(!typedNumbers(QStringLiteral("1 2 3 0"), 3)); // a direction
    }

    void theLaterOfClickAndGivenPointIsFollowed()
    {
        ShownPanel shown;
        shown.paste(Space::World, QStringLiteral("1 2 3"));
        QVERIFY(shown.model().followsGiven());
        pickAt(shown.document, WidgetPoint(30, 35), {0.85, 0, 24});
        QVERIFY(!shown.model().followsGiven());
        QVERIFY(isPoint(shown.model().point(Space::World), {2.2, -4.2, -2}));
        // Both points exist, and either can be followed.
        QToolButton *other = shown.button(QStringLiteral("Your point"));
        QVERIFY(other);
        other->click();
        QVERIFY(isPoint(shown.model().point(Space::World), {1, 2, 3}));
        other = shown.button(QStringLiteral("The click"));
        QVERIFY(other);
        other->click();
        QVERIFY(isPoint(shown.model().point(Space::World), {2.2, -4.2, -2}));
        QToolButton *remove = shown.button(QStringLiteral("✕"));
        QVERIFY(remove);
        remove->click();
        QVERIFY(!shown.document.scene().givenPoint);
        QVERIFY(!remove->isVisible() && !other->isVisible());
    }

    void everyStepIsUndone()
    {
        ShownPanel shown;
        shown.paste(Space::World, QStringLiteral("1 2 3"));
        shown.type(Space::Ndc, 0, QStringLiteral("0.5"));
        shown.document.undoStack().undo();
        QVERIFY(isPoint(shown.model().point(Space::World), {1, 2, 3}));
        shown.document.undoStack().undo();
        QVERIFY(!shown.document.scene().givenPoint);
        QVERIFY(isBlank(shown.model()));
        shown.document.undoStack().redo();
        shown.document.undoStack().redo();
        QVERIFY(isPoint(shown.model().point(Space::Ndc), {0.5, 0.2, 0.2}));
    }

    void aPointOfAnObjectGoesWithIt()
    {
        ShownPanel shown;
        shown.paste(Space::Object, QStringLiteral("1 1 0"));
        QCOMPARE(shown.document.scene().givenPoint->object, "small");
        QVERIFY(isPoint(shown.model().point(Space::World), {1, 1, -3}));
        QCOMPARE(int(renameObject(shown.document, 0, QStringLiteral("face"))), int(NameFault::None));
        QCOMPARE(shown.document.scene().givenPoint->object, "face");
        QVERIFY(editTransform(shown.document, 0, {Translate{{5, 0, 0}}}, {QStringLiteral("Move")}));
        QVERIFY(isPoint(shown.model().point(Space::World), {6, 1, 0}));
        QVERIFY(moveObject(shown.document, 0, 1));
        QVERIFY(isPoint(shown.model().point(Space::World), {6, 1, 0}));
        // A point without its object stays in place.
        QVERIFY(removeObject(shown.document, 1));
        QVERIFY(shown.document.scene().givenPoint->point == GivenPoint{WorldPoint(6, 1, 0)}.point);
        shown.document.undoStack().undo();
        QCOMPARE(shown.document.scene().givenPoint->object, "face");
    }

    void outsideTheViewVolumeIsSaid()
    {
        const ShownPanel shown;
        shown.paste(Space::World, QStringLiteral("100 0 0"));
        QVERIFY(shown.tells(QStringLiteral("x > w")));
        QVERIFY(givenWorld(shown.document.scene(), shown.document.setup())
                    .has_value()); // it is marked in the view from outside
    }

    void aWidgetPositionKeepsTheDepth()
    {
        const ShownPanel shown;
        shown.type(Space::Widget, 0, QStringLiteral("10"));
        QVERIFY(!shown.document.scene().givenPoint);
        QVERIFY(shown.tells(QStringLiteral("depth")));
        shown.paste(Space::Window, QStringLiteral("25 25 0.75"));
        shown.type(Space::Widget, 1, QStringLiteral("10"));
        QVERIFY(isPoint(shown.model().point(Space::Window), {25, 40, 0.75}));
    }

    void theWFromTheDivisionCannotBeTyped()
    {
        ShownPanel shown;
        shown.panel.setDirection(PipelineDirection::Backward);
        shown.paste(Space::Clip, QStringLiteral("1 2 3 4"));
        QVERIFY(!shown.document.scene().givenPoint);
        const PointModel *world = shown.model().point(Space::World);
        QVERIFY(world->flags(world->indexOf(2)) & Qt::ItemIsEditable);
        QVERIFY(!(world->flags(world->indexOf(3)) & Qt::ItemIsEditable));
    }

    void aPanelMayGoWhileANumberIsTyped()
    {
        auto document = std::make_unique<SceneDocument>();
        openFigures(*document);
        {
            PipelinePanel panel(*document);
            panel.show();
            QVERIFY(QTest::qWaitForWindowExposed(&panel, kPatienceMilliseconds));
            NumberGrid *grid = panel.findChildren<NumberGrid *>().constFirst();
            grid->setFocus();
            grid->setCurrentIndex(grid->model()->index(0, 0));
            QTest::keyClicks(grid, QStringLiteral("7"));
            QTest::keyClick(grid->viewport()->findChild<QLineEdit *>(), Qt::Key_Return); // counts a moment later
            document.reset();                                                            // as in a window
        }
    }

    void whatIsBeingTypedCountsWhenAsked()
    {
        ShownPanel shown;
        NumberGrid *grid = shown.grid(Space::World);
        grid->setFocus();
        grid->setCurrentIndex(shown.model().point(Space::World)->indexOf(1));
        QTest::keyClicks(grid, QStringLiteral("7"));
        QVERIFY(!shown.document.scene().givenPoint);
        shown.panel.applyTyped();
        QVERIFY(isPoint(shown.model().point(Space::World), {0, 7, 0}));
    }
};

UNPROJECTOR_TEST(TestGivenPoint)
#include "test_given_point.moc"
