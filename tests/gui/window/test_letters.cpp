// Letters of lessons in both views: each clearly belongs to its own arrow, and covers nothing.

#include "tests/support/test.h"

#include "core/lessons/lesson.h"
#include "gui/document/camera_looks.h"
#include "gui/lessons/lesson_player.h"
#include "gui/outside/observer_view.h"
#include "gui/view/highlight_marks.h"
#include "gui/view/scene_view.h"
#include "tests/gui/window_user.h"

#include <algorithm>
#include <cmath>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;
using namespace unprojector::geometry;

namespace {

double distanceOf(const QRectF &box, const QPointF &point)
{
    return std::hypot(std::max({box.left() - point.x(), 0.0, point.x() - box.right()}),
                      std::max({box.top() - point.y(), 0.0, point.y() - box.bottom()}));
}

bool isCrossed(const QRectF &box, const QLineF &line)
{
    for (int i = 0; i <= 200; ++i) {
        if (box.contains(line.pointAt(i / 200.0)))
            return true;
    }
    return false;
}

QString nameOf(const HighlightMarks::Text &text)
{
    return QString::fromStdString(text.letter.letter + text.letter.index);
}

bool isLength(const HighlightMarks &marks, std::size_t text)
{
    return marks.texts[text].arrow && marks.arrows[*marks.texts[text].arrow].tips == HighlightMarks::Tips::Both;
}

/// The faults of the letters' positions; empty if there are none.
QString faultOf(const HighlightMarks &marks, const std::vector<QRectF> &boxes, const QRectF &area)
{
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const QString name = nameOf(marks.texts[i]);
        if (boxes[i].isNull()) {
            if (area.contains(marks.texts[i].at))
                return name + QStringLiteral(" has no place");
            continue;
        }
        if (!area.contains(boxes[i]))
            return name + QStringLiteral(" is outside");
        for (std::size_t j = 0; j < i; ++j) {
            if (boxes[i].intersects(boxes[j]))
                return name + QStringLiteral(" is on ") + nameOf(marks.texts[j]);
        }
        for (const HighlightMarks::Arrow &arrow : marks.arrows) {
            if (isCrossed(boxes[i], arrow.line))
                return name + QStringLiteral(" is on an arrow");
        }
        if (isLength(marks, i) || leaderOf(marks, i, boxes[i]))
            continue;
        const double own = distanceOf(boxes[i], marks.texts[i].at);
        constexpr double kMost = 22.0, kSamePlace = 4.0;
        if (own > kMost)
            return name + QStringLiteral(" is far from its place");
        for (std::size_t j = 0; j < boxes.size(); ++j) {
            if (j != i && !isLength(marks, j)
                && std::hypot(marks.texts[j].at.x() - marks.texts[i].at.x(),
                              marks.texts[j].at.y() - marks.texts[i].at.y())
                       > kSamePlace
                && distanceOf(boxes[i], marks.texts[j].at) < own)
                return name + QStringLiteral(" is nearer to ") + nameOf(marks.texts[j]);
        }
    }
    return {};
}

std::vector<QRectF> boxesIn(const HighlightMarks &marks, const QWidget &view)
{
    return boxesOf(marks, view.font(), QRectF(view.rect()), {});
}

bool goTo(LessonPlayer &player, const char *step)
{
    const lessons::Step *found = player.lesson()->step(step);
    return found && player.goTo(static_cast<std::size_t>(found - player.lesson()->steps.data()));
}

QStringList namesOf(const HighlightMarks &marks)
{
    QStringList names;
    for (const HighlightMarks::Text &text : marks.texts)
        names << nameOf(text);
    return names;
}

} // namespace

class TestLetters : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void eachIsAtItsOwn_data()
    {
        addColumn<QString>("lesson");
        for (const char *lesson : {"first", "weng", "pipeline", "parallel", "rows", "derivation"})
            newRow(lesson) << QString::fromLatin1(lesson);
    }

    void eachIsAtItsOwn()
    {
        QFETCH(QString, lesson);
        const auto window = windowOfSize({1280, 800});
        LessonPlayer &player = part<LessonPlayer>(*window);
        QVERIFY(player.start(lesson.toStdString()));
        for (std::size_t step = 0; step < player.lesson()->steps.size(); ++step) {
            QVERIFY(player.goTo(step));
            if (player.step().highlights.empty())
                continue;
            QAction *action = actionOf(*window, QStringLiteral("View from Outside"));
            if (!action->isChecked())
                action->trigger();
            settle(60);
            const QList<ObserverView *> observers = window->findChildren<ObserverView *>();
            const auto observer =
                std::find_if(observers.begin(), observers.end(), [](const QWidget *one) { return one->isVisible(); });
            QVERIFY(observer != observers.end());
            const HighlightMarks inView = highlightsInView(window->document(), player.step().highlights),
                                 outside = (*observer)->highlightMarks();
            const auto told = [&](const HighlightMarks &marks, const QWidget &view) {
                const QString fault = faultOf(marks, boxesIn(marks, view), QRectF(view.rect()));
                return fault.isEmpty()
                           ? fault
                           : QStringLiteral("%1, %2: %3").arg(step + 1).arg(view.metaObject()->className(), fault);
            };
            QVERIFY2(told(inView, window->view()).isEmpty(), qPrintable(told(inView, window->view())));
            QVERIFY2(told(outside, **observer).isEmpty(), qPrintable(told(outside, **observer)));
        }
    }

    void axesUponEachOtherAreOne()
    {
        const auto window = windowOfSize({1280, 800});
        LessonPlayer &player = part<LessonPlayer>(*window);
        QVERIFY(player.start("pipeline"));
        QVERIFY(goTo(player, "model_view")); // MC is moved along z, along which the eye looks as well
        QCOMPARE(namesOf(highlightsInView(window->document(), player.step().highlights)),
                 (QStringList{"xMC, WC, VC", "yMC, WC, VC", "zMC, WC, VC"}));
    }

    void theEyesOwnAxesAreNotInAPerspective()
    {
        const auto window = windowOfSize({1280, 800});
        LessonPlayer &player = part<LessonPlayer>(*window);
        QVERIFY(player.start("first"));
        QVERIFY(goTo(player, "world"));
        const std::set<Highlight> highlights = player.step().highlights;
        QVERIFY(highlights.contains(Highlight::Axes));
        SceneDocument &document = window->document();
        const LookAt start = document.setup().camera();
        // Turned and moved, the eye's depth is 0 but for rounding, above or below.
        for (int i = 0; i < 50; ++i) {
            LookAt camera = start;
            camera.eye = WorldPoint(start.eye.x + 0.37 * i, start.eye.y + 0.21 * i, start.eye.z - 0.13 * i);
            setCamera(document, camera);
            for (const QString &name : namesOf(highlightsInView(document, highlights)))
                QVERIFY2(!name.contains(QStringLiteral("VC")), qPrintable(QStringLiteral("%1 at %2").arg(name).arg(i)));
        }
    }

    void aLengthLeavesTheMiddleFree()
    {
        const auto window = windowOfSize({1280, 800});
        LessonPlayer &player = part<LessonPlayer>(*window);
        for (const auto &[lesson, step] : {std::pair("rows", "round_trip"), std::pair("weng", "windows"),
                                           std::pair("weng", "viewport"), std::pair("weng", "back")}) {
            QVERIFY(player.start(lesson));
            QVERIFY(goTo(player, step));
            settle(60);
            const HighlightMarks marks = highlightsInView(window->document(), player.step().highlights);
            const QSizeF size = window->view().size();
            const QRectF middle(size.width() / 4.0, size.height() / 4.0, size.width() / 2.0, size.height() / 2.0);
            const std::vector<QRectF> boxes = boxesIn(marks, window->view());
            bool isThere = false;
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                if (!isLength(marks, i))
                    continue;
                isThere |= nameOf(marks.texts[i]) == QStringLiteral("H");
                QVERIFY2(!boxes[i].isNull() && !boxes[i].intersects(middle), qPrintable(nameOf(marks.texts[i])));
            }
            QVERIFY2(isThere, qPrintable(QStringLiteral("%1 %2").arg(QLatin1String(lesson)).arg(QLatin1String(step))));
            QVERIFY(player.leave());
        }
    }

    void anAxisLineStrikesNoLetter()
    {
        const auto window = windowOfSize({1280, 800});
        LessonPlayer &player = part<LessonPlayer>(*window);
        for (const auto &[lesson, step] : {std::pair("first", "world"), std::pair("weng", "look_at"),
                                           std::pair("pipeline", "load_identity"), std::pair("pipeline", "look_at")}) {
            QVERIFY(player.start(lesson));
            QVERIFY(goTo(player, step));
            settle(60);
            const HighlightMarks marks = highlightsInView(window->document(), player.step().highlights);
            const std::vector<QRectF> boxes = boxesIn(marks, window->view());
            QVERIFY(!marks.lines.empty());
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                for (const QLineF &line : marks.lines)
                    QVERIFY2(!isCrossed(boxes[i], line),
                             qPrintable(QLatin1String(lesson) + u' ' + nameOf(marks.texts[i])));
            }
            QVERIFY(player.leave());
        }
    }

    void whereThereIsNoRoomALeaderLeads()
    {
        // Twelve tips in the place of one letter.
        HighlightMarks marks;
        for (int i = 0; i < 12; ++i) {
            const int column = i % 4, row = i / 4;
            const QPointF tip(200.0 + 6.0 * column, 150.0 + 6.0 * row);
            marks.texts.push_back({tip, {"x", std::to_string(i)}, Qt::black, marks.arrows.size()});
            marks.arrows.push_back(
                {QLineF(QPointF(200.0, 250.0 + 4.0 * i), tip), HighlightMarks::Tips::End, Qt::black});
        }
        const QRectF area(0, 0, 400, 300);
        QFont font;
        font.setPixelSize(13);
        const std::vector<QRectF> boxes = boxesOf(marks, font, area, {});
        QCOMPARE(faultOf(marks, boxes, area), QString());
        std::size_t led = 0;
        for (std::size_t i = 0; i < boxes.size(); ++i)
            led += leaderOf(marks, i, boxes[i]) ? 1 : 0;
        QVERIFY(led > 0);
    }
};

UNPROJECTOR_TEST(TestLetters, display)
#include "test_letters.moc"
