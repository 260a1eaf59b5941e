// The table of placed points, the next one to place, and the measures, as a user handles them.

#include "tests/support/test.h"

#include "core/examples/examples.h"
#include "core/landmarks/point_template.h"
#include "gui/document/camera_looks.h"
#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"
#include "gui/landmarks/guided_placing.h"
#include "gui/landmarks/landmark_templates.h"
#include "gui/landmarks/landmarks_model.h"
#include "gui/landmarks/landmarks_panel.h"
#include "gui/landmarks/landmarks_table.h"
#include "gui/landmarks/measure_rows.h"
#include "gui/landmarks/measures_view.h"
#include "gui/text/landmark_text.h"
#include "gui/text/short_name.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QColorDialog>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QGuiApplication>
#include <QHeaderView>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QSignalSpy>
#include <QStyle>
#include <QTemporaryDir>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::scene;
using landmarks::Landmark;

Q_DECLARE_METATYPE(std::vector<std::size_t>)

class TestLandmarksPanel : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_panel.reset();
        m_templates = std::make_unique<LandmarkTemplates>();
        m_document = std::make_unique<SceneDocument>();
        m_document->setSurface({800, 600, 1.0});
        std::vector<SceneObject> objects = examples::bundledScene();
        objects.resize(1);
        openObjects(*m_document, objects);
        std::vector<Landmark> landmarks{point("nasion", glm::dvec3(1.25, -2.0, 3.0), 0.05),
                                        point("pronasale", glm::dvec3(4.0, 5.0, 6.5)), point("gone", {})};
        landmarks[0].anchor = landmarks::AtVertex{7};
        landmarks[0].object = objects[0].name;
        landmarks[0].note = "worn";
        landmarks[0].color = glm::u8vec3(10, 20, 30);
        QVERIFY(editLandmarks(*m_document, landmarks, {QStringLiteral("test")}));
        m_panel = std::make_unique<LandmarksPanel>(*m_document, *m_templates);
        m_panel->resize(900, 700);
        m_panel->show();
        m_table = m_panel->findChild<LandmarksTable *>();
        QVERIFY(m_table);
    }

    void aRowTellsItsPoint()
    {
        QCOMPARE(m_table->model()->rowCount(), 3);
        QCOMPARE(textAt(0, LandmarksModel::Number), QStringLiteral("1"));
        QCOMPARE(textAt(0, LandmarksModel::Name), QStringLiteral("nasion"));
        QCOMPARE(at(0, LandmarksModel::Name).data(Qt::DecorationRole).value<QColor>(), QColor(10, 20, 30));
        QCOMPARE(textAt(0, LandmarksModel::X),
                 QStringLiteral("1.250")); // two digits below the hundredths that are certain
        QCOMPARE(at(0, LandmarksModel::X).data(Qt::EditRole).toString(), QStringLiteral("1.25"));
        QCOMPARE(textAt(0, LandmarksModel::PlusMinus), QStringLiteral("0.09")); // 0.05 along each axis
        QCOMPARE(textAt(0, LandmarksModel::HeldBy), QStringLiteral("vertex 7"));
        QCOMPARE(textAt(0, LandmarksModel::Note), QStringLiteral("worn"));
        QCOMPARE(textAt(1, LandmarksModel::HeldBy), QStringLiteral("free"));
        QCOMPARE(textAt(1, LandmarksModel::PlusMinus), QStringLiteral("?")); // unknown
        QCOMPARE(textAt(2, LandmarksModel::PlusMinus), QString());           // it has no position
        QCOMPARE(textAt(2, LandmarksModel::HeldBy), QStringLiteral("not placed"));
        QCOMPARE(textAt(2, LandmarksModel::X), QStringLiteral("–"));
        QVERIFY(m_document->sceneLandmarks().skip(2));
        QCOMPARE(textAt(2, LandmarksModel::X), QStringLiteral("skipped"));
        QVERIFY(m_document->sceneLandmarks().setMissing({2}));
        QCOMPARE(textAt(2, LandmarksModel::X), QStringLiteral("missing"));
        QCOMPARE(textAt(2, LandmarksModel::HeldBy), QStringLiteral("missing"));
        QVERIFY(at(2, LandmarksModel::X).data(Qt::ToolTipRole).toString().contains(QStringLiteral("Missing on this")));
    }

    void certainDigitsAreTold_data()
    {
        addColumn<double>("value");
        addColumn<double>("uncertainty");
        addColumn<QString>("text");
        addColumn<QString>("certain");
        newRow("hundredths") << 12.3456789 << 0.008 << "12.3457"
                             << "12.34";
        newRow("whole ones") << 1234.5678 << 0.9 << "1234.57"
                             << "1234";
        newRow("hundreds") << 1234.5678 << 80.0 << "1235"
                           << "12";
        newRow("more than the usual room") << 123.456789123 << 2e-6 << "123.45679"
                                           << "123.45679";
        newRow("more than any room") << 123.456789123 << 2e-9 << "123.45678912"
                                     << "123.45678912";
        newRow("nothing known, on a map") << 5412345.987654321 << 0.0 << "5412345.988"
                                          << "";
        newRow("nothing known") << 12.5 << 0.0 << "12.5000"
                                << "";
    }

    void certainDigitsAreTold()
    {
        QFETCH(double, value);
        QFETCH(double, uncertainty);
        QFETCH(QString, text);
        QFETCH(QString, certain);
        QVERIFY(editLandmarks(*m_document, {point("a", glm::dvec3(value, 0.0, 0.0), uncertainty)},
                              {QStringLiteral("test")}));
        QCOMPARE(textAt(0, LandmarksModel::X), text);
        QCOMPARE(text.left(at(0, LandmarksModel::X).data(LandmarksModel::kCertainLengthRole).toInt()), certain);
    }

    void errorsAreShownWhole_data()
    {
        addColumn<double>("off");
        for (const double off : {0.0, 0.5, 12.0, 0.011, 0.0011, 0.00011, 0.00097, 0.000004, 123456.0})
            addRow("%g", off) << off;
    }

    void errorsAreShownWhole()
    {
        QFETCH(double, off);
        QVERIFY(editLandmarks(*m_document, {point("one", glm::dvec3(1.0, 2.0, 3.0), off)}, {QStringLiteral("test")}));
        const int padding = 2 * (m_table->style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, m_table) + 1);
        const QString text = textAt(0, LandmarksModel::PlusMinus);
        const int needed = m_table->fontMetrics().horizontalAdvance(text) + padding;
        const int width = m_table->header()->sectionSize(LandmarksModel::PlusMinus);
        QVERIFY2(needed <= width, qPrintable(QStringLiteral("%1: %2 of %3").arg(text).arg(needed).arg(width)));
    }

    void certainDigitsHaveTheirRoom()
    {
        QHeaderView &header = *m_table->header();
        const int usual = header.sectionSize(LandmarksModel::X);
        QVERIFY(editLandmarks(*m_document, {point("one", glm::dvec3(123.456789123), 2e-8)}, {QStringLiteral("test")}));
        const int needed = m_table->fontMetrics().horizontalAdvance(textAt(0, LandmarksModel::X));
        QVERIFY(needed > usual);
        QVERIFY(header.sectionSize(LandmarksModel::X) >= needed);
        // A width chosen by the user stays.
        header.resizeSection(LandmarksModel::X, usual);
        QVERIFY(m_document->sceneLandmarks().moveTo(0, WorldPoint(1.0, 1.0, 1.0)));
        QVERIFY(editLandmarks(*m_document, {point("one", glm::dvec3(123.4567), 2e-6)}, {QStringLiteral("test")}));
        QCOMPARE(header.sectionSize(LandmarksModel::X), usual);
    }

    void namesInLittleRoomStayApart()
    {
        const QFontMetrics metrics = m_table->fontMetrics();
        const int room = metrics.horizontalAdvance(QStringLiteral("mmm. mmm. mmm."));
        for (const LandmarkTemplates::Bundled &bundled : m_templates->bundled()) {
            QStringList shown;
            for (const Landmark &one : bundled.points) {
                const QString name = QString::fromStdString(one.name);
                const std::optional<QString> text = shortName(name, metrics, room);
                QVERIFY2(text && metrics.horizontalAdvance(*text) <= room, qPrintable(name));
                shown << *text;
            }
            QCOMPARE(shown.removeDuplicates(), qsizetype(0));
        }
        QCOMPARE(shortName(QStringLiteral("a b"), metrics, room), QStringLiteral("a b"));
        QCOMPARE(shortName(QStringLiteral("left exocanthion"), metrics,
                           metrics.horizontalAdvance(QStringLiteral("left exo."))),
                 QStringLiteral("left exo."));
        QVERIFY(!shortName(QStringLiteral("onewordthatislongerthantheroomforit"), metrics, room));
        QVERIFY(!shortName(QStringLiteral("palpebrale superius right"), metrics, 10));
        // The names are drawn this way.
        QVERIFY(editLandmarks(*m_document,
                              {point("palpebrale superius right", {}), point("palpebrale inferius right", {})},
                              {QStringLiteral("test")}));
        m_document->sceneLandmarks().select({}, std::nullopt);
        const auto drawn = [this](int row) {
            const QRect cell = m_table->visualRect(m_table->model()->index(row, LandmarksModel::Name));
            return m_table->viewport()->grab(cell).toImage();
        };
        for (const int characters : {14, 18}) {
            m_table->header()->resizeSection(LandmarksModel::Name, characters * metrics.horizontalAdvance(u'0'));
            QVERIFY(drawn(0) != drawn(1));
        }
    }

    void whoPlacesIsNotToldToPressP()
    {
        QVERIFY(editLandmarks(*m_document, {}, {QStringLiteral("none")}));
        const QList<QLabel *> labels = m_panel->findChildren<QLabel *>();
        const auto found = std::find_if(labels.begin(), labels.end(), [](QLabel *label) {
            return label->text().contains(QStringLiteral("yet. Press P"));
        });
        QVERIFY(found != labels.end() && (*found)->isVisible());
        m_panel->setPlacing(true);
        QVERIFY((*found)->text().startsWith(QStringLiteral("No landmarks yet. Click the")));
        m_panel->setPlacing(false);
        QVERIFY((*found)->text().contains(QStringLiteral("Press P")));
        // The hint also appears while a name is still to be placed.
        QVERIFY(editLandmarks(*m_document, {point("tip", {})}, {QStringLiteral("one")}));
        const auto *how = named<QLabel>(QStringLiteral("Instruction for placing"));
        QVERIFY(how->isVisible());
        QCOMPARE(how->text(), QStringLiteral("Press P, then click its position."));
        m_panel->setPlacing(true);
        QCOMPARE(how->text(), QStringLiteral("Click its position; P or Esc ends placing."));
    }

    void aDoubleClickOnTheNumberGoesThere()
    {
        const WorldPoint before = m_document->scene().camera->center;
        const auto doubleClick = [this](int column) {
            const QPoint middle = m_table->visualRect(at(0, column)).center();
            QTest::mouseClick(m_table->viewport(), Qt::LeftButton, {}, middle);
            QTest::mouseDClick(m_table->viewport(), Qt::LeftButton, {}, middle);
        };
        doubleClick(LandmarksModel::Name); // that one is written
        QVERIFY(m_document->scene().camera->center == before);
        QTest::keyClick(m_table->findChild<QLineEdit *>(), Qt::Key_Escape);
        doubleClick(LandmarksModel::Number);
        QVERIFY(distance(m_document->scene().camera->center, *m_document->landmarks().front().world) < 1e-9);
    }

    void namesAreEditedInPlace()
    {
        type(1, LandmarksModel::Name, QStringLiteral("tip"));
        QCOMPARE(names(), (QStringList{"nasion", "tip", "gone"}));
        m_document->undoStack().undo();
        QCOMPARE(names(), (QStringList{"nasion", "pronasale", "gone"}));
        type(1, LandmarksModel::Note, QStringLiteral("soft"));
        QCOMPARE(m_document->landmarks()[1].note, std::string("soft"));
    }

    void aTypedCoordinateMovesAndFrees()
    {
        type(0, LandmarksModel::Y, QStringLiteral("1/4"));
        const Landmark &moved = m_document->landmarks()[0];
        QCOMPARE(moved.world->coordinates(), glm::dvec3(1.25, 0.25, 3.0));
        QVERIFY(std::holds_alternative<landmarks::Free>(moved.anchor));
        QCOMPARE(reason(), QString());
        QCOMPARE(m_document->undoStack().undoText(), QStringLiteral("Move nasion"));
    }

    void whatIsNotChangedStaysHeld()
    {
        const int before = m_document->undoStack().count();
        type(0, LandmarksModel::X, QStringLiteral("1.25"));
        QVERIFY(std::holds_alternative<landmarks::AtVertex>(m_document->landmarks()[0].anchor));
        QCOMPARE(m_document->undoStack().count(), before);
    }

    void refusedCoordinatesSayWhy_data()
    {
        addColumn<int>("row");
        addColumn<QString>("typed");
        addColumn<QString>("said");
        newRow("no number") << 0 << "abc"
                            << "abc";
        newRow("nothing") << 0 << ""
                          << "";
        newRow("two numbers") << 0 << "1 2"
                              << "2";
        newRow("one of a point without a place") << 2 << "1"
                                                 << "not placed yet";
    }

    void refusedCoordinatesSayWhy()
    {
        QFETCH(int, row);
        QFETCH(QString, typed);
        QFETCH(QString, said);
        const std::vector<Landmark> before = m_document->landmarks();
        m_table->edit(at(row, LandmarksModel::X));
        auto *editor = m_table->findChild<QLineEdit *>();
        QVERIFY(editor);
        editor->setText(QStringLiteral("9"));
        editor->setText(typed);
        QTest::keyClick(editor, Qt::Key_Return);
        QCoreApplication::processEvents();
        QVERIFY2(!reason().isEmpty() && reason().contains(said), qPrintable(reason()));
        QVERIFY(m_document->landmarks() == before);
    }

    void threeCoordinatesAtOnce_data()
    {
        addColumn<QString>("typed");
        newRow("blanks") << "1 -2 3.5";
        newRow("commas") << "1, -2, 3.5";
        newRow("semicolons") << "1;-2;3.5";
        newRow("tabs, as tables are copied") << "1\t-2\t3.5";
        newRow("expressions") << "2/2 -2 7/2";
    }

    void threeCoordinatesAtOnce()
    {
        QFETCH(QString, typed);
        type(2, LandmarksModel::Z, typed);
        QVERIFY(m_document->landmarks()[2].world);
        QCOMPARE(m_document->landmarks()[2].world->coordinates(), glm::dvec3(1.0, -2.0, 3.5));
    }

    void theSelectionGoesBothWays()
    {
        m_document->sceneLandmarks().select({0, 2}, 2);
        QCOMPARE(m_table->selectedIndices(), (std::vector<std::size_t>{0, 2}));
        QCOMPARE(m_table->currentIndex().row(), 2);
        m_table->setCurrentIndex(at(1, LandmarksModel::X));
        QCOMPARE(m_document->sceneLandmarks().selection(), (std::vector<std::size_t>{1}));
        QCOMPARE(m_document->sceneLandmarks().current(), std::optional<std::size_t>(1));
        m_document->sceneLandmarks().clearSelection();
        QVERIFY(m_table->selectedIndices().empty());
    }

    void theSelectionStaysInASortedTable()
    {
        m_table->header()->setSortIndicator(LandmarksModel::X, Qt::DescendingOrder);
        m_document->sceneLandmarks().selectOnly(0);
        QVERIFY(m_document->sceneLandmarks().moveTo(0, WorldPoint(100.0, 0.0, 0.0))); // the row changes its place
        QCOMPARE(m_table->selectedIndices(), (std::vector<std::size_t>{0}));
        QCOMPARE(m_document->sceneLandmarks().selection(), (std::vector<std::size_t>{0}));
    }

    void sortingChangesOnlyTheView()
    {
        m_table->header()->setSortIndicator(LandmarksModel::Name, Qt::DescendingOrder);
        QCOMPARE(textAt(0, LandmarksModel::Name), QStringLiteral("pronasale"));
        QCOMPARE(textAt(0, LandmarksModel::Number), QStringLiteral("2"));
        QCOMPARE(names(), (QStringList{"nasion", "pronasale", "gone"}));
        QVERIFY(!m_table->dragEnabled());
        m_table->header()->setSortIndicator(LandmarksModel::X, Qt::AscendingOrder);
        QCOMPARE(textAt(2, LandmarksModel::Name), QStringLiteral("gone")); // without a place behind all others
        m_table->header()->setSortIndicator(LandmarksModel::Number, Qt::DescendingOrder);
        QVERIFY(!m_table->dragEnabled()); // a drop below a row would come before it
        m_table->header()->setSortIndicator(-1, Qt::AscendingOrder);
        QCOMPARE(textAt(0, LandmarksModel::Name), QStringLiteral("nasion"));
        QVERIFY(m_table->dragEnabled());
    }

    void draggingPutsAPointElsewhere()
    {
        const std::unique_ptr<QMimeData> dragged(m_table->model()->mimeData({at(2, 0)}));
        QVERIFY(m_table->model()->dropMimeData(dragged.get(), Qt::MoveAction, 0, 0, {}));
        QCOMPARE(names(), (QStringList{"gone", "nasion", "pronasale"}));
    }

    void upAndDown()
    {
        m_document->sceneLandmarks().selectOnly(1);
        QTest::mouseClick(button(QStringLiteral("Up")), Qt::LeftButton);
        QCOMPARE(names(), (QStringList{"pronasale", "nasion", "gone"}));
        QVERIFY(!button(QStringLiteral("Up"))->isEnabled());
        QTest::mouseClick(button(QStringLiteral("Down")), Qt::LeftButton);
        QTest::mouseClick(button(QStringLiteral("Down")), Qt::LeftButton);
        QCOMPARE(names(), (QStringList{"nasion", "gone", "pronasale"}));
        QVERIFY(!button(QStringLiteral("Down"))->isEnabled());
    }

    void deleteRemovesAllThatAreSelected()
    {
        m_document->sceneLandmarks().select({0, 2});
        QTest::keyClick(m_table, Qt::Key_Delete);
        QCOMPARE(names(), QStringList{"pronasale"});
        m_document->undoStack().undo();
        QCOMPARE(names().size(), 3);
    }

    void theCheckBoxHides()
    {
        QVERIFY(m_table->model()->setData(at(1, LandmarksModel::Name), Qt::Unchecked, Qt::CheckStateRole));
        QVERIFY(m_document->landmarks()[1].isHidden);
    }

    void copiedAsATable()
    {
        m_document->sceneLandmarks().selectOnly(1);
        QTest::keyClick(m_table, Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QGuiApplication::clipboard()->text(),
                 QStringLiteral("name,x,y,z,object,face,u,v,w,note\npronasale,4,5,6.5,,,,,,\n"));
    }

    void aTemplateIsPlacedOneAfterTheOther()
    {
        // It replaces "gone", which is not placed, but not a landmark that is missing on this specimen.
        QVERIFY(m_document->sceneLandmarks().place(point("", glm::dvec3(0.0))));
        QVERIFY(m_document->sceneLandmarks().place(point("lost", glm::dvec3(0.0))));
        QVERIFY(m_document->sceneLandmarks().setMissing({3}) && m_document->sceneLandmarks().placeAgain({2}));
        const QStringList removed = fillFromTemplate(
            *m_document, {point("nasion", {}), point("chin", {}), point("ear", {})}, QStringLiteral("Mine"));
        QCOMPARE(removed, QStringList("gone"));
        QCOMPARE(names(), (QStringList{"nasion", "chin", "ear", "pronasale", "lost"}));
        QCOMPARE(m_document->undoStack().undoText(), QStringLiteral("Template Mine"));
        const auto *next = named<QLabel>(QStringLiteral("Landmark to place next"));
        const auto *count = named<QLabel>(QStringLiteral("Number of placed landmarks"));
        QVERIFY(next && count);
        QVERIFY(next->isVisible());
        QCOMPARE(next->text(), QStringLiteral("Next: chin"));
        QCOMPARE(count->text(), QStringLiteral("2 of 5 placed, 1 missing"));
        place(1.0);
        QCOMPARE(next->text(), QStringLiteral("Next: ear"));
        place(2.0);
        QCOMPARE(next->text(), QStringLiteral("All landmarks are placed or missing"));
        QCOMPARE(count->text(), QStringLiteral("4 of 5 placed, 1 missing"));
        QVERIFY(!button(QStringLiteral("Skip"))->isEnabled() && !button(QStringLiteral("Missing"))->isEnabled());
        m_document->undoStack().undo();
        QCOMPARE(next->text(), QStringLiteral("Next: ear"));
        m_document->undoStack().redo();
        place(9.0); // a further one
        QVERIFY(!next->isVisible());
        m_document->undoStack().undo();
        QCOMPARE(names().size(), 5);
        QCOMPARE(m_document->landmarks()[2].world->x, 2.0);
        // Another template by its menu reports the names that it replaces.
        QSignalSpy noticed(m_panel.get(), &LandmarksPanel::noticed);
        QVERIFY(m_document->sceneLandmarks().placeAgain({1, 2}));
        button(QStringLiteral("Template"))->menu()->actions().front()->trigger();
        QCOMPARE(noticed.count(), 1);
        QCOMPARE(noticed[0][0].toString(),
                 QStringLiteral("The template Skull (craniometric points) replaced 2 names that "
                                "were not placed yet."));
        m_document->undoStack().undo();
        QCOMPARE(names(), (QStringList{"nasion", "chin", "ear", "pronasale", "lost"}));
    }

    void theNextOfATemplateIsCountedAndInSight()
    {
        // Two of the existing points are not in the template; the last existing point is selected.
        std::vector<Landmark> mine;
        for (int i = 0; i < 60; ++i)
            mine.push_back(point(("p" + std::to_string(i)).c_str(), {}));
        m_document->sceneLandmarks().selectOnly(2);
        m_templates->choose(mine);
        fillFromTemplate(*m_document, mine, QStringLiteral("Mine"));
        const auto isInSight = [&](int row) {
            return m_table->viewport()->rect().contains(m_table->visualRect(at(row, LandmarksModel::Name)).center());
        };
        QVERIFY(isInSight(0));
        place(1.0);
        QCOMPARE(named<QLabel>(QStringLiteral("Number of placed landmarks"))->text(), QStringLiteral("1 of 60 placed"));
        for (int i = 1; i < 40; ++i)
            place(1.0 + i);
        QVERIFY(isInSight(40));
        // The row that is selected is scrolled into view.
        m_document->sceneLandmarks().selectOnly(0);
        QVERIFY(isInSight(0));
    }

    void skippedOnesComeAgain()
    {
        fillFromTemplate(*m_document, {point("chin", {}), point("ear", {})}, QStringLiteral("Mine"));
        const auto *next = named<QLabel>(QStringLiteral("Landmark to place next"));
        QTest::mouseClick(button(QStringLiteral("Skip")), Qt::LeftButton);
        QCOMPARE(next->text(), QStringLiteral("Next: ear"));
        const auto *count = named<QLabel>(QStringLiteral("Number of placed landmarks"));
        QCOMPARE(count->text(), QStringLiteral("2 of 4 placed, 1 skipped"));
        place(1.0);
        QCOMPARE(next->text(), QStringLiteral("Next: chin")); // it comes again
        QVERIFY(!m_document->landmarks()[0].isPlaced());
        m_document->undoStack().undo();
        QTest::mouseClick(button(QStringLiteral("Missing")), Qt::LeftButton);
        QVERIFY(m_document->landmarks()[1].isMissing());
        QCOMPARE(next->text(), QStringLiteral("Next: chin"));
        QCOMPARE(count->text(), QStringLiteral("2 of 4 placed, 1 missing, 1 skipped"));
        // The row of the missing one makes it the next; the button takes the mark back.
        QVERIFY(!button(QStringLiteral("Missing"))->isChecked());
        clickRow(1);
        QCOMPARE(next->text(), QStringLiteral("Next: ear"));
        QVERIFY(button(QStringLiteral("Missing"))->isChecked());
        QTest::mouseClick(button(QStringLiteral("Missing")), Qt::LeftButton);
        QVERIFY(m_document->landmarks()[1].isToPlace());
        QCOMPARE(next->text(), QStringLiteral("Next: ear"));
    }

    void aClickOnARowToPlaceMakesItTheNext()
    {
        fillFromTemplate(*m_document, {point("chin", {}), point("ear", {}), point("tip", {})}, QStringLiteral("Mine"));
        const auto next = [this] { return *m_document->sceneLandmarks().nextUnplaced(); };
        clickRow(2);
        QCOMPARE(next(), std::size_t(2));
        m_document->sceneLandmarks().setNextUnplaced(0);
        clickRow(2); // it is selected already
        QCOMPARE(next(), std::size_t(2));
    }

    void theRowsStayWhileLandmarksArePlaced_data()
    {
        addColumn<int>("width");
        addColumn<bool>("hasPicture");
        newRow("a narrow panel") << 300 << false;
        newRow("the usual panel") << 420 << false;
        newRow("an image beside some hints") << 420 << true;
    }

    void theRowsStayWhileLandmarksArePlaced()
    {
        QFETCH(int, width);
        QFETCH(bool, hasPicture);
        QTemporaryDir folder;
        std::vector<Landmark> mine = m_templates->bundled()[1].points;
        mine[4].name = "a name that is too long for one line of the panel in large letters";
        mine[5].note.clear();
        if (hasPicture) {
            QImage image(100, 100, QImage::Format_RGB32);
            image.fill(Qt::red);
            QVERIFY(image.save(folder.filePath(QStringLiteral("p.png"))));
            mine[3].extra.edit()[landmarks::kPictureColumn] = "p.png";
        }
        m_panel->setPlacing(true);
        m_panel->resize(width, 900);
        m_templates->choose(mine, folder.path().toStdU16String());
        fillFromTemplate(*m_document, mine, QStringLiteral("Mine"));
        QCoreApplication::processEvents();
        const int top = m_table->mapTo(m_panel.get(), QPoint(0, 0)).y();
        const auto *hint = named<QLabel>(QStringLiteral("Definition of the landmark"));
        bool hasOneLine = false, hasMore = false, hadPicture = false;
        while (m_document->sceneLandmarks().nextUnplaced()) {
            const std::size_t index = *m_document->sceneLandmarks().nextUnplaced();
            QCoreApplication::processEvents();
            QCOMPARE(m_table->mapTo(m_panel.get(), QPoint(0, 0)).y(), top);
            const int needed = hint->fontMetrics()
                                   .boundingRect(0, 0, hint->width(), QWIDGETSIZE_MAX, Qt::TextWordWrap, hint->text())
                                   .height();
            QVERIFY2(needed <= hint->height(), qPrintable(hint->text())); // none is cut
            (needed < 2 * hint->fontMetrics().lineSpacing() ? hasOneLine : hasMore) = true;
            hadPicture = hadPicture || named<QLabel>(QStringLiteral("Image from the template"))->isVisible();
            if (index % 5 == 1)
                QVERIFY(m_document->sceneLandmarks().setMissing({index}));
            else
                place(1.0 + double(index));
        }
        QCoreApplication::processEvents();
        QCOMPARE(m_table->mapTo(m_panel.get(), QPoint(0, 0)).y(), top); // nor at the end, below the button
        QVERIFY(hasOneLine && hasMore && hadPicture == hasPicture);
    }

    void namesHaveTheWidthFirst()
    {
        m_panel->resize(420, 900);
        fillFromTemplate(*m_document, m_templates->bundled()[1].points, QStringLiteral("Face"));
        QVERIFY(m_document->sceneLandmarks().placeAgain({0, 2}));
        std::vector<std::size_t> placed;
        for (std::size_t i = 0; i < m_document->landmarks().size(); ++i) {
            if (m_document->landmarks()[i].isPlaced())
                placed.push_back(i);
        }
        QVERIFY(m_document->sceneLandmarks().remove(placed));
        m_table->setFont(m_table->font()); // the columns are fitted anew
        QEvent event(QEvent::FontChange);
        QCoreApplication::sendEvent(m_table, &event);
        const QHeaderView &header = *m_table->header();
        const auto width = [&](int column) { return header.sectionSize(column); };
        const auto areNamesWhole = [&](int most) {
            for (int row = 0; row < m_table->model()->rowCount(); ++row) {
                const int needed = m_table->fontMetrics().horizontalAdvance(textAt(row, LandmarksModel::Name));
                if (width(LandmarksModel::Name) <= std::min(needed, most))
                    return false;
            }
            return true;
        };
        QVERIFY(areNamesWhole(QWIDGETSIZE_MAX)); // no coordinate takes their room
        const int narrow = width(LandmarksModel::X);
        QVERIFY(narrow < width(LandmarksModel::Name) / 3);
        QVERIFY(m_document->sceneLandmarks().place(point("", glm::dvec3(-5412345.678), 1e-4))); // on a map
        QVERIFY(width(LandmarksModel::X) > narrow);
        QVERIFY(areNamesWhole(20 * m_table->fontMetrics().horizontalAdvance(u'0') - 1));
    }

    void theMenuOfTheSelection()
    {
        const auto open = [this] {
            m_panel->openMenu(QPoint(0, 0));
            const QList<QMenu *> menus = m_panel->findChildren<QMenu *>(QStringLiteral("landmarkMenu"));
            return menus.isEmpty() ? nullptr : menus.back();
        };
        const auto trigger = [](QMenu *menu, const QString &text) {
            QVERIFY(menu);
            for (QAction *action : menu->actions()) {
                if (action->text().remove(u'&') == text) {
                    QVERIFY(action->isEnabled());
                    action->trigger();
                    menu->close();
                    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
                    return;
                }
            }
            QFAIL(qPrintable(text));
        };
        QVERIFY(!open()); // nothing is selected
        m_document->sceneLandmarks().selectOnly(1);
        trigger(open(), QStringLiteral("Go to Landmark"));
        QVERIFY(distance(m_document->scene().camera->center, *m_document->landmarks()[1].world) < 1e-9);
        trigger(open(), QStringLiteral("Hide"));
        QVERIFY(m_document->landmarks()[1].isHidden);
        trigger(open(), QStringLiteral("Show"));
        trigger(open(), QStringLiteral("Mark as Missing"));
        QVERIFY(m_document->landmarks()[1].isMissing());
        trigger(open(), QStringLiteral("Mark as Not Missing"));
        QVERIFY(m_document->landmarks()[1].isToPlace());
        m_document->sceneLandmarks().setNextUnplaced(2);
        QSignalSpy placing(m_panel.get(), &LandmarksPanel::placingRequested);
        trigger(open(), QStringLiteral("Place Next"));
        QCOMPARE(m_document->sceneLandmarks().nextUnplaced(), std::optional<std::size_t>(1));
        QCOMPARE(placing.count(), 1);
        QSignalSpy shown(m_panel.get(), &LandmarksPanel::showRequested);
        trigger(open(), QStringLiteral("Rename"));
        QCOMPARE(shown.count(), 1);
        QVERIFY(m_table->findChild<QLineEdit *>());
        m_table->applyTyped();
        trigger(open(), QStringLiteral("Remove"));
        QCOMPARE(names(), (QStringList{"nasion", "gone"}));
    }

    void placingEndsWithTheTemplate()
    {
        GuidedPlacing guided(*m_document);
        QSignalSpy wanted(&guided, &GuidedPlacing::placingWanted), noticed(&guided, &GuidedPlacing::noticed);
        connect(&guided, &GuidedPlacing::placingWanted, &guided, &GuidedPlacing::setPlacing); // as the action does
        const auto lastText = [&] { return noticed.isEmpty() ? QString() : noticed.back()[0].toString(); };
        fillFromTemplate(*m_document, {point("chin", {}), point("ear", {}), point("tip", {})}, QStringLiteral("Mine"));
        guided.setPlacing(true);
        guided.skipNext();
        QCOMPARE(lastText(), QStringLiteral("chin is skipped. It comes again after the others. Next: ear."));
        guided.toggleMissing();
        QCOMPARE(lastText(), QStringLiteral("ear is marked as missing on this specimen. Next: tip."));
        place(1.0);
        QVERIFY(wanted.isEmpty());
        place(2.0);
        QCOMPARE(wanted.count(), 1);
        QVERIFY(!wanted.back()[0].toBool());
        QCOMPARE(lastText(), QStringLiteral("Placed: 4 of 5 landmarks. Missing on this specimen: 1."));
        // An undone placement goes on with it.
        m_document->undoStack().undo();
        QCOMPARE(wanted.count(), 2);
        QVERIFY(wanted.back()[0].toBool());
        m_document->sceneLandmarks().selectOnly(1);
        place(3.0);
        place(4.0);
        QCOMPARE(wanted.count(), 3);
        QCOMPARE(lastText(), QStringLiteral("All 5 landmarks are placed."));
        // It has ended for this scene, not for another one.
        std::vector<landmarks::Landmark> waiting{point("a", {}), point("b", {})};
        const auto openOther = [&] {
            scene::Scene other = m_document->scene();
            other.landmarks.landmarks = waiting;
            QVERIFY(m_document->open(std::move(other)));
            m_document->sceneLandmarks().waitForNext(1); // a change, as the marks of another template
        };
        const scene::Scene before = m_document->scene();
        openOther();
        QCOMPARE(wanted.count(), 3);
        guided.continueOnScan(); // the first scan of a series: the placing of a scene does not go on
        QCOMPARE(wanted.count(), 3);
        guided.setPlacing(true);
        place(1.0);
        place(2.0);
        QCOMPARE(wanted.count(), 4);
        openOther();
        QCOMPARE(wanted.count(), 4);
        guided.continueOnScan(); // the next scan of that series
        QCOMPARE(wanted.count(), 5);
        QVERIFY(wanted.back()[0].toBool());
        QVERIFY(m_document->open(before));
        wanted.clear();
        // The user goes on freely: nothing ends any more.
        guided.setPlacing(true);
        place(5.0);
        place(6.0);
        QCOMPARE(names().size(), 7);
        QCOMPARE(wanted.count(), 0);
        // Without a name to place, the selection is marked.
        m_document->sceneLandmarks().select({5, 6});
        guided.toggleMissing();
        QCOMPARE(lastText(), QStringLiteral("2 landmarks are marked as missing on this specimen."));
        guided.toggleMissing();
        QVERIFY(m_document->landmarks()[5].isToPlace());
        guided.setPlacing(false);
        QVERIFY(m_document->sceneLandmarks().remove({5, 6}));
        m_document->sceneLandmarks().clearSelection();
        for (const auto &verb : {&GuidedPlacing::skipNext, &GuidedPlacing::toggleMissing}) {
            const auto count = noticed.count();
            (guided.*verb)();
            QCOMPARE(noticed.count(), count + 1); // it tells why nothing happens
        }
    }

    void withoutATemplateNothingIsMissing()
    {
        const QList<QAction *> actions = button(QStringLiteral("Template"))->menu()->actions();
        const auto none = std::find_if(actions.begin(), actions.end(),
                                       [](const QAction *action) { return action->text() == QStringLiteral("&None"); });
        QVERIFY(none != actions.end());
        (*none)->trigger();
        QCOMPARE(names(), (QStringList{"nasion", "pronasale"}));
        m_document->undoStack().undo();
        QCOMPARE(names().size(), 3);
        // The first bundled template, by its entry.
        actions.front()->trigger();
        // nasion is there; "gone" is replaced
        QCOMPARE(names().size(), 3 + static_cast<int>(m_templates->bundled().front().points.size()) - 2);
        QVERIFY(named<QLabel>(QStringLiteral("Landmark to place next"))->isVisible());
    }

    void bundledTemplatesHaveHints()
    {
        QVERIFY(m_templates->bundled().size() >= 2);
        for (const LandmarkTemplates::Bundled &bundled : m_templates->bundled()) {
            QVERIFY(!bundled.name.isEmpty() && !bundled.source.isEmpty());
            QVERIFY(bundled.points.size() > 30);
            for (const Landmark &named : bundled.points) {
                QVERIFY(!named.isPlaced());
                QVERIFY2(!named.note.empty(), named.name.c_str());
            }
        }
        QVERIFY(!m_templates->hintFor(QStringLiteral("Nasion")).isEmpty());
        QCOMPARE(m_templates->hintFor(QStringLiteral("nowhere")), QString());
        m_templates->choose({[] {
            Landmark mine = point("nasion", {});
            mine.note = "my own";
            return mine;
        }()});
        QCOMPARE(m_templates->hintFor(QStringLiteral("nasion")), QStringLiteral("my own"));
    }

    void aTemplatesPictureIsShown()
    {
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkpath(QStringLiteral("pictures")));
        QImage image(400, 100, QImage::Format_RGB32);
        image.fill(Qt::red);
        QVERIFY(image.save(folder.filePath(QStringLiteral("pictures/ear.png"))));
        QFile file(folder.filePath(QStringLiteral("t.csv")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(
            "name,x,y,z,note,picture\near,,,,behind the eye,pictures/ear.png\nchin,,,,below,none.png\ntip,,,,,\n");
        file.close();
        m_panel->takeTemplate(file.fileName().toStdU16String());
        auto *picture = [this]() -> QLabel * {
            for (QLabel *label : m_panel->findChildren<QLabel *>()) {
                if (label->accessibleName() == QStringLiteral("Image from the template"))
                    return label;
            }
            return nullptr;
        }();
        QVERIFY(picture);
        QVERIFY(!picture->isHidden());
        const QSize size = picture->pixmap(Qt::ReturnByValue).deviceIndependentSize().toSize();
        QVERIFY(std::abs(size.width() - 4 * size.height()) <= 4); // the picture's aspect, to a pixel
        QVERIFY(size.width() < 400);
        // A missing picture causes a message; it does not pass for a point without one.
        m_document->sceneLandmarks().waitForNext(m_document->sceneLandmarks().nextUnplaced());
        QVERIFY2(picture->isVisibleTo(m_panel.get()) && picture->text().contains(QStringLiteral("none.png")),
                 qPrintable(picture->text()));
        m_document->sceneLandmarks().waitForNext(m_document->sceneLandmarks().nextUnplaced());
        QCOMPARE(m_document->landmarks()[*m_document->sceneLandmarks().nextUnplaced()].name, std::string("tip"));
        QVERIFY(picture->isHidden());
    }

    void measuresOfWhatIsSelected_data()
    {
        addColumn<std::vector<std::size_t>>("places");
        addColumn<QStringList>("rows");
        using P = std::vector<std::size_t>;
        newRow("none") << P{} << QStringList{};
        newRow("one") << P{0} << QStringList{};
        newRow("two") << P{0, 1} << QStringList{"Distance|a – b|3.0 ± 0.2 mm"};
        newRow("two of unknown certainty") << P{1, 2} << QStringList{"Distance|b – c|5 ± ? mm"};
        newRow("three") << P{0, 1, 2} << QStringList{"Distance|a – b|3.0 ± 0.2 mm",    "Distance|a – c|4 ± ? mm",
                                                     "Distance|b – c|5 ± ? mm",        "Angle|at a|90° ± ?",
                                                     "Angle|at b|53.1301° ± ?",        "Angle|at c|36.8699° ± ?",
                                                     "Length along|a – b – c|8 ± ? mm"};
        newRow("four") << P{0, 1, 2, 3}
                       << QStringList{"Height|d over the plane a – b – c|2 ± ? mm",
                                      "Length along|a – b – c – d|12.47214 ± ? mm"};
        newRow("one to place") << P{0, 4} << QStringList{"Distance|a – e|e is not placed yet"};
        newRow("a missing one") << P{0, 5} << QStringList{"Distance|a – f|f is missing on this specimen"};
        newRow("both") << P{0, 4, 5}
                       << QStringList{"Distance|a – e|e is not placed yet",
                                      "Distance|a – f|f is missing on this specimen",
                                      "Distance|e – f|e is not placed yet",
                                      "Angle|at a|f is missing on this specimen",
                                      "Angle|at e|e is not placed yet",
                                      "Angle|at f|f is missing on this specimen",
                                      "Length along|a – e – f|e is not placed yet"};
    }

    void measuresOfWhatIsSelected()
    {
        QFETCH(std::vector<std::size_t>, places);
        QFETCH(QStringList, rows);
        landmarks::LandmarkSet set;
        set.unit = "mm";
        set.landmarks = {point("a", glm::dvec3(0.0), 0.1),
                         point("b", glm::dvec3(3.0, 0.0, 0.0), 0.1),
                         point("c", glm::dvec3(0.0, 4.0, 0.0)),
                         point("d", glm::dvec3(0.0, 0.0, 2.0)),
                         point("e", {}),
                         point("f", {})};
        set.landmarks[5].absence = landmarks::Absence::Missing;
        QStringList shown;
        for (const MeasureRow &row : measuresOf(set, places))
            shown << QStringList{row.kind, row.points, QString(row.value).replace(QChar::Nbsp, u' ')}.join(u'|');
        QCOMPARE(shown, rows);
        QVERIFY(editLandmarkSet(*m_document, set, {QStringLiteral("test")}));
        m_document->sceneLandmarks().select(places);
        // The length along the surface comes as well: SceneCurves knows it.
        QCOMPARE(named<QTreeWidget>(QStringLiteral("Measures"))->topLevelItemCount(),
                 rows.size() + (places.size() >= 2 ? 1 : 0));
    }

    void aRowShowsTheOrderOfItsNames()
    {
        const QString names = QStringLiteral("exocanthion left – nasion – exocanthion right");
        const QFontMetrics metrics{QFont()};
        const int whole = metrics.horizontalAdvance(names);
        QCOMPARE(namesFitted(names, metrics, whole), names);
        const QString fitted = namesFitted(names, metrics, whole * 3 / 5);
        QVERIFY(metrics.horizontalAdvance(fitted) <= whole * 3 / 5);
        const QStringList parts = fitted.split(QStringLiteral(" – "));
        QCOMPARE(parts.size(), 3);
        QCOMPARE(parts[1], QStringLiteral("nasion"));
        QVERIFY2(parts[0].startsWith(u'e') && parts[0].endsWith(u't') && parts[0].size() > 3, qPrintable(fitted));
        QVERIFY2(parts[2].startsWith(u'e') && parts[2].endsWith(u't') && parts[2].size() > 3, qPrintable(fitted));
    }

    void leftAndRight()
    {
        landmarks::LandmarkSet set;
        set.unit = "mm";
        set.landmarks = {point("eye left", glm::dvec3(-2.0, 0.0, 0.0)), point("eye right", glm::dvec3(2.0, 0.0, 0.0)),
                         point("ear left", glm::dvec3(-3.0, 1.0, 1.0)), point("ear right", glm::dvec3(3.0, 1.0, 1.0)),
                         point("nose", glm::dvec3(0.0, 1.0, 5.0))};
        const auto shown = [](const std::vector<MeasureRow> &rows) {
            QStringList lines;
            for (const MeasureRow &row : rows)
                lines << QStringList{row.kind, row.points, QString(row.value).replace(QChar::Nbsp, u' ')}.join(u'|');
            return lines;
        };
        const std::vector<MeasureRow> rows = sidesOf(set);
        QCOMPARE(rows.size(), std::size_t(6));
        QCOMPARE(rows[0].points, QStringLiteral("normal (1, 0, 0)"));
        QCOMPARE(rows[1].points, QStringLiteral("pairs: 2; in the middle: nose"));
        QCOMPARE(rows[2].kind, QStringLiteral("Without ±"));
        QCOMPARE(rows[3].points, QStringLiteral("eye left ↔ eye right"));
        QVERIFY(*rows[3].number < 1e-12);
        QCOMPARE(rows[5].points, QStringLiteral("nose"));
        using Points = std::vector<std::size_t>;
        QVERIFY(rows[0].shown->points == (Points{0, 1, 2, 3, 4, 4}) && rows[3].shown->points == (Points{0, 1}));
        QVERIFY(rows[5].shown->points == (Points{4, 4}));
        for (const WorldPoint &corner : rows[0].shown->mirror->corners)
            QVERIFY(std::abs(corner.x) < 1e-12);
        for (Landmark &each : set.landmarks)
            each.uncertainty = WorldVector(0.1, 0.1, 0.1);
        set.landmarks[4].uncertainty.reset();
        QCOMPARE(shown(sidesOf(set))[2], QStringLiteral("Without ±|nose|leave the errors open"));
        // A sided point without a partner does not count for the midline; a hidden or unplaced point
        // does not count at all.
        set.landmarks.push_back(point("jaw left", glm::dvec3(-9.0, -9.0, 2.0), 0.1));
        set.landmarks.push_back(point("brow left", {}));
        set.landmarks.push_back(point("brow right", glm::dvec3(1.0, 4.0, 4.0), 0.1));
        set.landmarks[4].isHidden = true;
        const QStringList lines = shown(sidesOf(set));
        QCOMPARE(lines.size(), 7);
        QVERIFY2(lines[0].startsWith(QStringLiteral("Mirror plane|normal (1, 0, 0)|")), qPrintable(lines[0]));
        QCOMPARE(lines[1], QStringLiteral("Made from|pairs: 2|"));
        QCOMPARE(lines[4], QStringLiteral("Plane distance|nose|nose is hidden"));
        QCOMPARE(lines[5], QStringLiteral("Left out|jaw left|no partner on the other side"));
        QCOMPARE(lines[6], QStringLiteral("Left out|not placed yet: brow left|pairs: 1"));
        set.landmarks[6].absence = landmarks::Absence::Missing;
        set.landmarks.push_back(point("chin left", {}));
        set.landmarks.push_back(point("chin right", {}));
        QCOMPARE(shown(sidesOf(set)).mid(6), (QStringList{"Left out|not placed yet: chin left, chin right|pairs: 1",
                                                          "Left out|missing on this specimen: brow left|pairs: 1"}));
        // The nose is 0.3 off the plane, and 0.6 from its mirror image.
        landmarks::LandmarkSet bent;
        bent.landmarks = {point("L a", glm::dvec3(-2, 0, 0)),  point("R a", glm::dvec3(4, 0, 0)),
                          point("L b", glm::dvec3(-1, 3, 1)),  point("R b", glm::dvec3(3, 3, 1)),
                          point("L c", glm::dvec3(-4, 1, 5)),  point("R c", glm::dvec3(6, 1, 5)),
                          point("top", glm::dvec3(1.3, 9, 2)), point("nose", glm::dvec3(0.7, 9, 2))};
        QCOMPARE(shown(sidesOf(bent)).back(), QStringLiteral("Plane distance|nose|0.3 ± ?"));
        set.landmarks[0].world = WorldPoint(-2.5, 0.0, 0.0);
        QVERIFY(*sidesOf(set)[2].number > 0.1);
        const std::vector<MeasureRow> turned = sidesOf(set);
        QVERIFY(turned[0].copied.size() > turned[0].points.size() + 10); // all digits are copied
        QVERIFY(csvOf(turned, {}).contains(turned[0].copied));
        QVERIFY(sidesOf({}).empty());
        QCOMPARE(csvOf(sidesOf(set), QStringLiteral("mm")).section(u'\n', 0, 0),
                 QStringLiteral("kind,points,value,error,unit"));
    }

    void theUnitIsTheScenes()
    {
        auto *unit = named<QComboBox>(QStringLiteral("Unit of the scene"));
        QVERIFY(unit);
        unit->setCurrentIndex(unit->findData(QStringLiteral("cm")));
        emit unit->activated(unit->currentIndex());
        QCOMPARE(m_document->scene().landmarks.unit, std::string("cm"));
        m_document->undoStack().undo();
        QCOMPARE(unit->currentData().toString(), QString());
        landmarks::LandmarkSet set = m_document->scene().landmarks;
        set.unit = "furlong"; // as a file may have it
        QVERIFY(editLandmarkSet(*m_document, set, {QStringLiteral("test")}));
        QCOMPARE(unit->currentText(), QStringLiteral("furlong"));
    }

    void noRowOfTheMeasuresIsCut()
    {
        auto *rows = named<QTreeWidget>(QStringLiteral("Measures"));
        QVERIFY(editLandmarks(
            *m_document,
            {point("a", glm::dvec3(0.0)), point("b", glm::dvec3(1.0, 0.0, 0.0)), point("c", glm::dvec3(0.0, 1.0, 0.0))},
            {QStringLiteral("test")}));
        m_document->sceneLandmarks().select({0, 1, 2});
        for (int height = 420; height < 480; height += 7) {
            m_panel->resize(900, height);
            QCoreApplication::processEvents();
            QVERIFY(rows->viewport()->height() > 0);
            QCOMPARE(rows->viewport()->height() % rows->sizeHintForRow(0), 0);
        }
    }

    void templatesAreSavedUnderTheirSuffix_data()
    {
        addColumn<int>("filter");
        addColumn<QString>("file");
        addColumn<int>("warnings");
        newRow("MeshLab's, which has no hints") << 0 << "mine.pptpl" << 1;
        newRow("a table") << 1 << "mine.csv" << 0;
    }

    void templatesAreSavedUnderTheirSuffix()
    {
        QFETCH(int, filter);
        QFETCH(QString, file);
        QFETCH(int, warnings);
        QTemporaryDir folder;
        QSignalSpy warned(m_panel.get(), &LandmarksPanel::warned);
        const auto save = [&](bool isThere) {
            bool hasAsked = false;
            QTimer::singleShot(0, this, [&] {
                auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget());
                QVERIFY(dialog);
                dialog->setDirectory(folder.path());
                dialog->selectNameFilter(dialog->nameFilters()[filter]);
                emit dialog->filterSelected(dialog->nameFilters()[filter]); // as by a user
                dialog->findChild<QLineEdit *>()->setText(QStringLiteral("mine"));
                if (isThere) {
                    QTimer::singleShot(0, this, [&] {
                        auto *box = qobject_cast<QMessageBox *>(QApplication::activeModalWidget());
                        hasAsked = box != nullptr;
                        if (box)
                            box->button(QMessageBox::No)->click();
                        dialog->reject();
                    });
                }
                QMetaObject::invokeMethod(dialog, "accept");
            });
            const QList<QAction *> actions = button(QStringLiteral("Template"))->menu()->actions();
            const auto entry = std::find_if(actions.begin(), actions.end(), [](const QAction *action) {
                return action->text().startsWith(QStringLiteral("&Save Names"));
            });
            QVERIFY(entry != actions.end());
            (*entry)->trigger();
            QCOMPARE(hasAsked, isThere);
        };
        save(false);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList(file));
        QCOMPARE(warned.count(), warnings);
        QFile written(folder.filePath(file));
        QVERIFY(written.open(QIODevice::ReadOnly));
        QVERIFY(written.readAll().contains("nasion"));
        save(true); // an existing file is asked about by its whole name
    }

    void aColourIsForWhatIsSelectedThen()
    {
        m_document->sceneLandmarks().select({1, 2});
        emit m_table->customContextMenuRequested(m_table->visualRect(at(1, 0)).center());
        auto *menu = m_panel->findChild<QMenu *>({}, Qt::FindDirectChildrenOnly);
        QVERIFY(menu);
        QAction *other = nullptr;
        for (QAction *action : menu->findChildren<QAction *>()) {
            if (action->text() == QStringLiteral("&Other…"))
                other = action;
        }
        QVERIFY(other);
        QTimer::singleShot(0, this, [this] {
            auto *dialog = qobject_cast<QColorDialog *>(QApplication::activeModalWidget());
            QVERIFY(dialog);
            QVERIFY(m_document->sceneLandmarks().remove({0, 2})); // below it
            dialog->setCurrentColor(QColor(1, 2, 3));
            QMetaObject::invokeMethod(dialog, "accept");
        });
        other->trigger();
        QCOMPARE(names(), QStringList("pronasale"));
        QCOMPARE(m_document->landmarks()[0].color, std::optional(glm::u8vec3(1, 2, 3)));
    }

private:
    QModelIndex at(int row, int column) const { return m_table->model()->index(row, column); }
    QString textAt(int row, int column) const { return at(row, column).data().toString(); }
    template <class Widget>
    Widget *named(const QString &name) const
    {
        for (Widget *widget : m_panel->findChildren<Widget *>()) {
            if (widget->accessibleName() == name)
                return widget;
        }
        return nullptr;
    }
    QToolButton *button(const QString &text) const
    {
        for (QToolButton *button : m_panel->findChildren<QToolButton *>()) {
            if (button->text() == text)
                return button;
        }
        return nullptr;
    }
    QStringList names() const
    {
        QStringList names;
        for (const Landmark &landmark : m_document->landmarks())
            names << QString::fromStdString(landmark.name);
        return names;
    }
    QString reason() const
    {
        const auto *label = named<QLabel>(QStringLiteral("Reason why the number was rejected"));
        return !label ? QStringLiteral("no label") : label->isHidden() ? QString() : label->text();
    }
    void type(int row, int column, const QString &text)
    {
        m_table->setCurrentIndex(at(row, column));
        m_table->edit(at(row, column));
        auto *editor = m_table->findChild<QLineEdit *>();
        QVERIFY(editor);
        editor->setText(text);
        QTest::keyClick(editor, Qt::Key_Return);
        QCoreApplication::processEvents(); // it ends when the key has been dealt with
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    static Landmark point(const char *name, std::optional<glm::dvec3> world, double off = 0.0)
    {
        Landmark landmark;
        landmark.name = name;
        if (world)
            landmark.world = WorldPoint(*world);
        if (off > 0.0)
            landmark.uncertainty = WorldVector(off, off, off);
        return landmark;
    }
    void place(double x) { QVERIFY(m_document->sceneLandmarks().place(point("", glm::dvec3(x, 0.0, 0.0)))); }

    void clickRow(int row)
    {
        QTest::mouseClick(m_table->viewport(), Qt::LeftButton, {},
                          m_table->visualRect(at(row, LandmarksModel::PlusMinus)).center());
    }

    std::unique_ptr<LandmarkTemplates> m_templates;
    std::unique_ptr<SceneDocument> m_document;
    std::unique_ptr<LandmarksPanel> m_panel;
    LandmarksTable *m_table = nullptr;
};

UNPROJECTOR_TEST(TestLandmarksPanel)
#include "test_landmarks_panel.moc"
