#include "tests/gui/parameters/panel_user.h"
#include "tests/support/patience.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QTest>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;

bool isSameScene(const Scene &a, const Scene &b)
{
    const auto isSameView = [](const LookAt &v, const LookAt &w) {
        return v.eye.coordinates() == w.eye.coordinates() && v.center.coordinates() == w.center.coordinates()
               && v.up == w.up;
    };
    if (a.objects.size() != b.objects.size())
        return false;
    for (std::size_t i = 0; i < a.objects.size(); ++i) {
        if (a.objects[i].transform != b.objects[i].transform)
            return false;
    }
    return isSameView(a.camera, b.camera) && a.projection == b.projection && a.viewport == b.viewport
           && a.depthRange == b.depthRange && a.clipPlanes == b.clipPlanes
           && a.clipPlanesOff.size() == b.clipPlanesOff.size()
           && a.projectionFollowsViewport == b.projectionFollowsViewport
           && a.clipDistancesFitObjects == b.clipDistancesFitObjects;
}

void PanelUser::open(const Scene &scene)
{
    QVERIFY(m_document->open(scene).hasValue());
}

void PanelUser::start()
{
    m_panel.reset();
    m_document = std::make_unique<SceneDocument>();
    m_document->setSurface({801, 601, 1.0});
    open(startScene());
    m_panel = std::make_unique<ParametersPanel>(*m_document);
    m_panel->resize(m_panel->minimumSizeHint().width(), 430);
    m_panel->show();
    m_panel->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_panel.get(), kPatienceMilliseconds));
}

ParameterGroup *PanelUser::showGroup(const QString &name)
{
    auto *group = m_panel->findChild<ParameterGroup *>(name);
    if (!group)
        qFatal("no group %s", qPrintable(name));
    group->setOpen(true);
    return group;
}

NumberField *PanelUser::field(const QString &name, const QString &within)
{
    for (ParameterGroup *group : m_panel->findChildren<ParameterGroup *>()) {
        const bool wasOpen = group->isOpen();
        group->setOpen(true); // its rows are made when they are seen
        const QWidget *place = within.isEmpty() ? group : group->findChild<QWidget *>(within);
        if (auto *found = place ? place->findChild<NumberField *>(name) : nullptr)
            return found;
        group->setOpen(wasOpen);
    }
    qFatal("no field %s", qPrintable(name));
}

void PanelUser::begin(NumberField *target, const QString &text)
{
    target->setFocus();
    target->selectAll();
    if (text.isEmpty())
        QTest::keyClick(target, Qt::Key_Delete);
    else
        QTest::keyClicks(target, text);
}

void PanelUser::type(NumberField *target, const QString &text)
{
    begin(target, text);
    QTest::keyClick(target, Qt::Key_Return);
}

QString PanelUser::reasonBeneath(const NumberField *field) const
{
    QCoreApplication::processEvents(); // the layout
    const int bottom = field->geometry().bottom();
    for (const QLabel *label : field->parentWidget()->findChildren<QLabel *>()) {
        const int between = label->geometry().top() - bottom;
        if (label->isVisible() && label->wordWrap() && between > 0 && between < field->height())
            return label->text();
    }
    return {};
}

void PanelUser::choose(const QString &comboBox, const QString &text)
{
    auto *box = m_panel->findChild<QComboBox *>(comboBox);
    const int index = box->findText(text, Qt::MatchStartsWith);
    QVERIFY2(index >= 0, qPrintable(text));
    box->setCurrentIndex(index);
    emit box->activated(index);
}

void PanelUser::click(const QString &button, const QString &within)
{
    const QWidget *place = within.isEmpty() ? m_panel.get() : m_panel->findChild<QWidget *>(within);
    QVERIFY2(place, qPrintable(within));
    auto *found = place->findChild<QAbstractButton *>(button);
    QVERIFY2(found, qPrintable(button));
    QVERIFY(found->isEnabled());
    found->click();
    // Rows that went are deleted later.
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

} // namespace unprojector::gui
