#pragma once

#include "tests/gui/window_user.h"

#include "gui/doctor/doctor_panel.h"
#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"

#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

#include <glm/matrix.hpp>

/// The workspace Doctor in tests: a window with a cube, and the hands that click and type in it.
namespace doctordesk {

using guitest::click;
using guitest::cubeScene;
using guitest::kCubeCenter;
using guitest::localOf;
using guitest::settle;
using guitest::shownWindow;
using unprojector::geometry::clipFromWorld;
using unprojector::geometry::Setup;
using unprojector::geometry::WorldPoint;
using unprojector::gui::DoctorPanel;
using unprojector::gui::MainWindow;
using unprojector::gui::openObjects;
using unprojector::gui::Workspace;
using unprojector::unproject::Pick;

inline constexpr QSize kWindow(1280, 800);

/// The window at the place, with a cube before it.
inline std::unique_ptr<MainWindow> doctorWindow()
{
    auto window = shownWindow(false, kWindow, true);
    openObjects(window->document(), cubeScene(),
                {WorldPoint(kCubeCenter + glm::dvec3(1.9, 2.3, 7.0)), WorldPoint(kCubeCenter), {0.0, 1.0, 0.0}});
    window->workspaces().enter(Workspace::Doctor);
    settle();
    return window;
}

inline DoctorPanel &panelOf(MainWindow &window)
{
    return *window.findChild<DoctorPanel *>();
}

inline QList<QLineEdit *> fieldsOf(MainWindow &window, const QString &name)
{
    QList<QLineEdit *> fields;
    for (QLineEdit *field : panelOf(window).findChildren<QLineEdit *>()) {
        if (field->accessibleName() == name && !field->isHidden())
            fields << field;
    }
    return fields;
}

inline QLineEdit *gotOf(MainWindow &window, int row = 0)
{
    return fieldsOf(window, QStringLiteral("Your program's coordinate")).value(row);
}

inline void type(QLineEdit *field, const QString &text)
{
    field->setFocus();
    field->clear();
    QApplication::clipboard()->setText(text); // keys make no U+2212
    QTest::keySequence(field, QKeySequence::Paste);
    QTest::keyClick(field, Qt::Key_Return);
}

inline QLabel *labelOf(MainWindow &window, const QString &name)
{
    for (QLabel *label : panelOf(window).findChildren<QLabel *>()) {
        if (label->accessibleName() == name)
            return label;
    }
    return nullptr;
}

inline QString verdictOf(MainWindow &window)
{
    return labelOf(window, QStringLiteral("Verdict"))->text();
}

inline void typeOwnWindow(MainWindow &window, const QString &size)
{
    for (QToolButton *button : panelOf(window).findChildren<QToolButton *>()) {
        if (button->text() == QStringLiteral("More about your program"))
            button->setChecked(true);
    }
    type(fieldsOf(window, QStringLiteral("Its window")).value(0), size);
}

inline QString pointText(const glm::dvec3 &point)
{
    return QStringLiteral("%1 %2 %3").arg(point.x, 0, 'f', 4).arg(point.y, 0, 'f', 4).arg(point.z, 0, 'f', 4);
}

/// A program's point for a window position: the product of the matrices inverted as a whole.
inline glm::dvec3 unprojected(const MainWindow &window, const glm::dvec3 &at)
{
    const Setup &g = const_cast<MainWindow &>(window).document().setup();
    const glm::dvec4 ndc(2.0 * (at.x - g.viewport.x) / g.viewport.width - 1.0,
                         2.0 * (at.y - g.viewport.y) / g.viewport.height - 1.0, 2.0 * at.z - 1.0, 1.0);
    const glm::dvec4 world = glm::inverse(*clipFromWorld(g)) * ndc;
    return glm::dvec3(world) / world.w;
}

/// Clicks the cube a little off its middle, and returns the result of a program without the flip of
/// y.
inline glm::dvec3 clickedAndWrong(MainWindow &window, const glm::dvec3 &off = {0.4, 0.6, 1.0})
{
    click(window.view(), localOf(window, kCubeCenter + off));
    const Pick &pick = *window.document().picks().pick();
    const double height = window.document().setup().surface.heightPixels;
    return unprojected(window, {pick.window.x, height - pick.window.y, pick.window.z});
}

/// Types the answer of a program that transposes the product of projection and view.
inline void typeTransposed(MainWindow &window)
{
    const Setup &g = window.document().setup();
    const Pick &pick = *window.document().picks().pick();
    const glm::dvec4 ndc(2.0 * (pick.window.x - g.viewport.x) / g.viewport.width - 1.0,
                         2.0 * (pick.window.y - g.viewport.y) / g.viewport.height - 1.0, 2.0 * pick.window.z - 1.0,
                         1.0);
    const glm::dvec4 got = glm::inverse(glm::transpose(*clipFromWorld(g))) * ndc;
    type(gotOf(window), pointText(glm::dvec3(got) / got.w));
}

} // namespace doctordesk
