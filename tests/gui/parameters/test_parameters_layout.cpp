// The parameters at the fonts of the desktops, in both languages and several widths: nothing is
// cut, nothing scrolls sideways, and no action in the panel changes the width that it asks for.

#include "tests/support/test.h"

#include "tests/gui/cut_texts.h"
#include "tests/gui/parameters/panel_user.h"

#include "gui/parameters/number_slider.h"
#include "gui/text/translation.h"
#include "tests/support/patience.h"

#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QScrollBar>
#include <QSet>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::scene;

namespace {

const char *const kGroups[] = {"viewGroup", "projectionGroup", "viewportGroup", "modelGroup", "clipGroup"};

/// Numbers of all lengths, and one of every kind of part.
Scene fullScene()
{
    Scene scene = startScene();
    scene.camera = {WorldPoint(-1.0 / 3.0, 1.2345678901234567e-300, 123456789.123456789),
                    scene.camera->center,
                    {1e-5, 1.0, -2.0 / 3.0}};
    scene.projection = Frustum{-1.0 / 3.0, 2.0 / 3.0, -1e-7, 80000.0, 7.149488340677281, 31.88249808802577};
    scene.viewport = {ViewportRule::Kind::Fixed, Viewport{-16384.0, -16384.0, 16384.0, 16384.0}, 4.0 / 3.0};
    scene.depthRange = {0.649999976, 1.0 / 3.0};
    scene.objects[0].transform = {Translate{{-1.0 / 3.0, 123.456789, -1e-5}},
                                  Rotate{-123.456789, {0.1 + 0.2, 1.0, 0.0}}, Scale{{1e-10, -1.0 / 3.0, 1e10}}};
    scene.clipPlanes.assign(6, {-0.123456789, 1.0, 2.0e-7, -123456789.0});
    return scene;
}

} // namespace

class TestParametersLayout : public QObject, PanelUser {
    Q_OBJECT

private slots:
    void init() { m_translation.reset(); }

    void cleanup()
    {
        m_panel.reset();
        m_translation.reset();
        QApplication::setFont(m_font);
    }

    void nothingIsCut_data()
    {
        QTest::addColumn<double>("points");
        QTest::addColumn<QString>("language");
        QTest::addColumn<double>("width"); // least ones
        for (const double points : {9.0, 10.0, 11.0, 13.0}) {
            for (const QString &language : {QStringLiteral("en"), QStringLiteral("zh-CN")}) {
                for (const double width : {1.0, 1.1, 1.5, 2.5})
                    QTest::addRow("%g-pt-%s-%g-wide", points, qPrintable(language), width)
                        << points << language << width;
            }
        }
    }

    void nothingIsCut()
    {
        QFETCH(double, points);
        QFETCH(QString, language);
        QFETCH(double, width);
        if (language != QStringLiteral("en") && !QFile::exists(QStringLiteral(":/translations/unprojector_zh_CN.qm")))
            QSKIP("Built without Qt's LinguistTools.");
        startWith(points, language);
        const int least = m_panel->minimumSizeHint().width();
        QVERIFY2(least <= 300.0 * points / 9.0, qPrintable(QString::number(least)));
        m_panel->resize(static_cast<int>(std::lround(least * width)), 600);
        QTRY_COMPARE_WITH_TIMEOUT(whatIsCut(), QString(), kPatienceMilliseconds);

        // Every kind of projection and of viewport.
        Scene scene = fullScene();
        oblique(scene);
        letterbox(scene);
        open(scene);
        QTRY_COMPARE_WITH_TIMEOUT(whatIsCut(), QString(), kPatienceMilliseconds);
        perspective(scene);
        scene.viewport = {};
        open(scene);
        QTRY_COMPARE_WITH_TIMEOUT(whatIsCut(), QString(), kPatienceMilliseconds);

        // The error messages are sentences.
        for (const char *name : {"eyeX", "upY", "fovy", "nearDistance", "farDistance", "depthAtFar"})
            type(QString::fromLatin1(name), QStringLiteral("1,2,3"));
        type(field(QStringLiteral("number2"), QStringLiteral("step2")), QStringLiteral("0"));
        QVERIFY(field(QStringLiteral("fovy"))->isBad());
        QTRY_COMPARE_WITH_TIMEOUT(whatIsCut(), QString(), kPatienceMilliseconds);

        // The scene is empty now.
        scene.objects.clear();
        scene.clipPlanes.clear();
        open(scene);
        QTRY_COMPARE_WITH_TIMEOUT(whatIsCut(), QString(), kPatienceMilliseconds);
    }

    void numbersShareARowWhereTheyFit()
    {
        startWith(9.0);
        const auto isShared = [this] {
            QCoreApplication::processEvents();
            return field(QStringLiteral("eyeX"))->y() == field(QStringLiteral("eyeZ"))->y();
        };
        QVERIFY(!isShared());
        m_panel->resize(2 * m_panel->minimumSizeHint().width(), 600);
        QVERIFY(isShared());
        m_panel->resize(m_panel->minimumSizeHint().width(), 600);
        QVERIFY(!isShared());
    }

    void unitsStandInOneColumn()
    {
        startWith(9.0);
        for (const int width : {m_panel->minimumSizeHint().width(), 2 * m_panel->minimumSizeHint().width()}) {
            m_panel->resize(width, 600);
            QCoreApplication::processEvents();
            QSet<int> columns;
            int fields = 0;
            for (const NumberField *field : m_panel->findChildren<NumberField *>()) {
                if (!field->isVisible())
                    continue;
                ++fields;
                int units = 0;
                for (const QLabel *label : field->parentWidget()->findChildren<QLabel *>()) {
                    if (!label->isVisible() || label->y() != field->y() || label->x() < field->x())
                        continue;
                    if (label->text().size() > 1) {
                        ++units;
                        columns << label->mapTo(m_panel->widget(), QPoint()).x();
                    }
                }
                // A factor has no unit. If sliders are in that column, the row has its unit once,
                // beneath the title.
                const auto sliders = field->parentWidget()->findChildren<NumberSlider *>();
                const bool isBeneath = std::any_of(sliders.begin(), sliders.end(), [field](const NumberSlider *slider) {
                    return slider->y() == field->y() && slider->x() > field->geometry().right();
                });
                const bool isFactor = field->accessibleName().contains(QStringLiteral("Scale"));
                QVERIFY2(units == (isFactor || isBeneath ? 0 : 1), qPrintable(field->accessibleName()));
                if (isBeneath) {
                    const auto labels = field->parentWidget()->findChildren<QLabel *>();
                    QCOMPARE(std::count_if(labels.begin(), labels.end(),
                                           [](const QLabel *label) {
                                               return label->isVisible()
                                                      && label->text() == QStringLiteral("world units");
                                           }),
                             1);
                }
            }
            QVERIFY(fields > 50);
            QCOMPARE(columns.size(), 1);
        }
    }

    void itAsksForTheSameWidthWhateverIsDone()
    {
        startWith(9.0);
        const QSize least = m_panel->minimumSizeHint();
        const auto isSame = [&] {
            QCoreApplication::processEvents();
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            return m_panel->minimumSizeHint() == least && m_panel->widget()->minimumSizeHint().width() <= least.width();
        };
        open(startScene());
        QVERIFY(isSame());
        for (const char *group : kGroups) {
            showGroup(QString::fromLatin1(group))->setOpen(false);
            QVERIFY2(isSame(), group);
        }
        openAll();
        for (const char *kind : {"Perspective", "Orthographic", "Oblique", "Frustum"}) {
            choose(QStringLiteral("projectionKind"), QString::fromLatin1(kind));
            QVERIFY2(isSame(), kind);
        }
        for (const char *step : {"addTranslate", "addRotate", "addScale", "addPlane"}) {
            click(QString::fromLatin1(step));
            QVERIFY2(isSame(), step);
        }
        type(QStringLiteral("nearDistance"), QStringLiteral("abcdefghijklmnopqrstuvwxyzabcdefghijklmnopqrstuvwxyz"));
        QVERIFY(isSame());
        Scene named = startScene();
        named.objects[0].name = std::string(200, 'M');
        open(named);
        QVERIFY(isSame());
    }

private:
    void startWith(double points, const QString &language = QStringLiteral("en"))
    {
        QFont font = m_font;
        font.setPointSizeF(points);
        QApplication::setFont(font);
        m_translation = std::make_unique<Translation>(QStringList{language});
        start();
        open(fullScene());
        openAll();
    }

    void openAll()
    {
        for (const char *group : kGroups)
            showGroup(QString::fromLatin1(group));
    }

    /// Lets the layout come to rest and returns the cut texts.
    QString whatIsCut()
    {
        for (int i = 0; i < 5; ++i)
            QCoreApplication::processEvents();
        QStringList found = cutTexts(*m_panel);
        if (m_panel->horizontalScrollBar()->isVisible() || m_panel->horizontalScrollBar()->maximum() > 0)
            found << QStringLiteral("it scrolls sideways");
        if (m_panel->widget()->width() > m_panel->viewport()->width())
            found << QStringLiteral("the column is wider than what is seen of it");
        const QSize seen = m_panel->viewport()->size();
        if (m_panel->widget()->height() > std::max(seen.height(), m_panel->widget()->heightForWidth(seen.width())))
            found << QStringLiteral("it scrolls beyond its end");
        return found.join(u'\n');
    }

    QFont m_font = QApplication::font();
    std::unique_ptr<Translation> m_translation;
};

UNPROJECTOR_TEST(TestParametersLayout, fonts)
#include "test_parameters_layout.moc"
