// A switch of colours at run time: each widget gets the same palette, and each panel the same
// image, as after a fresh start in these colours.

#include "tests/support/test.h"

#include "tests/gui/window_user.h"

#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/shell/appearance.h"
#include "gui/widgets/contrast.h"
#include "gui/widgets/refused_field.h"
#include "tests/support/patience.h"

#include <QLineEdit>
#include <QMap>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolBar>
#include <QToolTip>

using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace guitest;

namespace {

/// The colours of all roles and groups.
QString coloursOf(const QPalette &palette)
{
    QString text;
    for (const QPalette::ColorGroup group : {QPalette::Active, QPalette::Inactive, QPalette::Disabled})
        for (int role = 0; role < QPalette::NColorRoles; ++role)
            text += palette.color(group, static_cast<QPalette::ColorRole>(role)).name(QColor::HexArgb) + u' ';
    return text;
}

/// The path from the window to a widget: each class, with the index among siblings of that class.
QString pathOf(const QWidget &widget)
{
    const QWidget *parent = widget.isWindow() ? nullptr : widget.parentWidget();
    const QString name = QString::fromLatin1(widget.metaObject()->className());
    if (!parent)
        return name;
    int place = 0;
    for (const QObject *child : parent->children()) {
        if (child == &widget)
            break;
        place += child->metaObject() == widget.metaObject() ? 1 : 0;
    }
    return QStringLiteral("%1/%2:%3").arg(pathOf(*parent), name).arg(place);
}

struct Look {
    QMap<QString, QString> palettes;
    QMap<QString, QImage> pictures;
    QString toolTips;
};

/// A window after a click and a camera rotation, in the workspace with the click's banner.
std::unique_ptr<MainWindow> prepared()
{
    auto window = windowOfSize({1280, 800});
    window->view().onLButtonDown(WidgetPoint(window->view().width() / 2.0, window->view().height() / 2.0));
    LookAt camera = window->document().setup().camera();
    camera.eye.x += 0.5;
    setCamera(window->document(), camera);
    window->view().setFocus(); // no field has the focus
    settle(20);
    return window;
}

Look lookOf(MainWindow &window)
{
    settle(20);
    Look look;
    for (const QWidget *widget : window.findChildren<QWidget *>()) {
        const QString path = pathOf(*widget);
        if (!path.contains(QStringLiteral("QComboBoxPrivateScroller"))) // only some styles have one
            look.palettes.insert(path, coloursOf(widget->palette()));
    }
    for (QDockWidget *dock : window.findChildren<QDockWidget *>()) {
        if (dock->isVisible() && dock->objectName() != QStringLiteral("outside"))
            look.pictures.insert(dock->objectName(), dock->grab().toImage());
    }
    for (QToolBar *bar : window.findChildren<QToolBar *>())
        look.pictures.insert(bar->objectName(), bar->grab().toImage());
    look.pictures.insert(QStringLiteral("menu bar"), window.menuBar()->grab().toImage());
    look.toolTips = coloursOf(QToolTip::palette());
    return look;
}

} // namespace

Q_DECLARE_METATYPE(Appearance)

class TestColoursSwitch : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }
    void cleanup() { setAppearance(Appearance::Desktop); }

    void itIsAsAfterAFreshStart_data()
    {
        addColumn<Appearance>("from");
        addColumn<QString>("to");
        newRow("dark to light") << Appearance::Dark << QStringLiteral("Light");
        newRow("light to dark") << Appearance::Light << QStringLiteral("Dark");
        newRow("dark to the system's") << Appearance::Dark << QStringLiteral("System");
    }

    void itIsAsAfterAFreshStart()
    {
        QFETCH(Appearance, from);
        QFETCH(QString, to);
        const Appearance wanted = to == QStringLiteral("Light")  ? Appearance::Light
                                  : to == QStringLiteral("Dark") ? Appearance::Dark
                                                                 : Appearance::Desktop;
        setAppearance(wanted);
        Look fresh;
        {
            const auto window = prepared();
            QVERIFY(window->document().picks().sinceClick().isAnything());
            fresh = lookOf(*window);
        }
        setAppearance(from);
        const auto window = prepared();
        const Look before = lookOf(*window);
        QAction *action = actionOf(*window, to);
        QVERIFY(action);
        action->trigger();
        QVERIFY(currentAppearance() == wanted);
        const Look after = lookOf(*window);

        QVERIFY(before.palettes != fresh.palettes);
        QCOMPARE(after.palettes.keys(), fresh.palettes.keys());
        QStringList others;
        for (auto it = fresh.palettes.cbegin(); it != fresh.palettes.cend(); ++it) {
            const QString parent = it.key().section(u'/', 0, -2);
            if (after.palettes[it.key()] != it.value() && after.palettes.value(parent) == fresh.palettes.value(parent))
                others << it.key().section(u'/', -3);
        }
        QVERIFY2(others.isEmpty(), qPrintable(others.mid(0, 20).join(u'\n')));
        // A system's own style may need another width, so that the panels are laid out otherwise.
        const QString panel = QStringLiteral("comparison");
        const bool isLaidOutAlike = after.pictures[panel].size() == fresh.pictures[panel].size();
        for (auto it = fresh.pictures.cbegin(); it != fresh.pictures.cend(); ++it) {
            if ((to != QStringLiteral("System") || isLaidOutAlike) && after.pictures[it.key()] != it.value())
                others << it.key();
        }
        QVERIFY2(others.isEmpty(), qPrintable(others.join(u'\n')));
        QCOMPARE(after.toolTips, fresh.toolTips);
    }

    /// Checks the backgrounds of a rejected field, of tooltips and of the banner.
    void whatIsMarkedCanBeRead()
    {
        setAppearance(Appearance::Light);
        QLineEdit field;
        setRefused(field, true);
        for (const Appearance appearance : {Appearance::Dark, Appearance::Light, Appearance::Desktop}) {
            setAppearance(appearance);
            const QPalette colours = field.palette();
            QVERIFY(colours.color(QPalette::Base) != QApplication::palette().color(QPalette::Base));
            QVERIFY(contrast(colours.color(QPalette::Text), colours.color(QPalette::Base)) >= kReadableContrast);
            QVERIFY(contrast(colours.color(QPalette::ToolTipText), colours.color(QPalette::ToolTipBase))
                    >= kReadableContrast);
            QVERIFY(colours.color(QPalette::ToolTipBase) != colours.color(QPalette::Window));
        }
        setRefused(field, false);
        QCOMPARE(field.palette().color(QPalette::Base), QApplication::palette().color(QPalette::Base));
    }
};

UNPROJECTOR_TEST(TestColoursSwitch, display)
#include "test_colours_switch.moc"
