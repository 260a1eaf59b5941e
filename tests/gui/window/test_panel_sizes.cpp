// The panels of numbers at the fonts of the desktops, in both languages and at every width from the
// least one.
// - No text is cut off.
// - No pick, of tiny or of huge models, changes a panel's minimum width.
// - Labels grow with their texts; once they have, the same changes leave every part in place.

#include "tests/support/test.h"

#include "gui/click/comparison_panel.h"
#include "gui/click/coordinates_table.h"
#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/pipeline/lifecycle_panel.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/pipeline/viewport_inspector.h"
#include "gui/text/translation.h"
#include "gui/view/lifecycle_log.h"
#include "gui/widgets/elided_label.h"
#include "gui/widgets/number_grid.h"
#include "gui/widgets/steady_label.h"
#include "tests/gui/document_edits.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QFontInfo>
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QTextDocument>
#include <QToolButton>
#include <QVBoxLayout>

#include <functional>
#include <memory>
#include <optional>

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::mesh;
using namespace unprojector::scene;

namespace {

/// Opens a scene seen by glFrustum from five units away, scaled by `size`.
void openScene(SceneDocument &document, double size, double offset = 0.0)
{
    Scene scene;
    scene.camera = scene.home = {WorldPoint(offset, 0, 5 * size), WorldPoint(offset, 0, 0), {0, 1, 0}};
    scene.projection = Frustum{-1.2345678 * size, 1.2345678 * size, -0.98765432 * size,
                               0.98765432 * size, 2.0123456 * size, 10.987654 * size};
    scene.projectionFollowsViewport = false;
    scene.clipDistancesFitObjects = false;
    auto model = std::make_shared<Model>();
    model->bounds.add(glm::dvec3(-size));
    model->bounds.add(glm::dvec3(size));
    SceneObject object;
    object.name = "Box";
    object.model = model;
    scene.objects = {object};
    QVERIFY(document.open(scene));
}

/// The user's changes to the numbers, one after the other.
const std::vector<std::function<void(SceneDocument &)>> &happenings()
{
    const auto pick = [](SceneDocument &document) {
        pickAt(document, WidgetPoint(412.0, 199.0), {0.712345678, 0, 24});
    };
    static const std::vector<std::function<void(SceneDocument &)>> list{
        pick,
        [](SceneDocument &document) {
            pickAt(document, WidgetPoint(3.0, 2.0), {1.0, {}, 24});
        },
        [pick](SceneDocument &document) {
            pick(document);
            LookAt camera = document.setup().camera();
            camera.eye.x += 37.0;
            camera.eye.y -= 55.0;
            camera.eye.z += 12.0;
            setCamera(document, camera);
        },
        [pick](SceneDocument &document) {
            openScene(document, 1e-9);
            pick(document);
        },
        [pick](SceneDocument &document) {
            openScene(document, 123456789.0, -4.5e9);
            pick(document);
        },
        [](SceneDocument &document) {
            LookAt camera = document.setup().camera();
            camera.eye.z *= 9.0;
            setCamera(document, camera);
        },
        [](SceneDocument &document) {
            QVERIFY(editTransform(document, 0, {Translate{{1.0, 2.0, 3.0}}}, {QStringLiteral("Move")}));
        },
        [pick](SceneDocument &document) {
            openScene(document, 0.03);
            setProjection(document, Oblique{{-0.2, 0.2, -0.1, 0.1, 0.01, 0.9}, 0.7, 0.9});
            pick(document);
        },
        [](SceneDocument &document) { document.picks().clearPick(); },
    };
    return list;
}

bool isShown(const QWidget &widget, const QWidget &panel)
{
    return widget.isVisibleTo(&panel) && widget.width() > 0;
}

/// The texts of a panel that do not have the room they need.
QStringList cutTexts(const QWidget &panel)
{
    QStringList cut;
    const auto need = [&cut](const QString &text, double needed, double given) {
        if (needed > given + 0.5)
            cut << QStringLiteral("\"%1\" needs %2, has %3").arg(text).arg(needed).arg(given);
    };
    for (const QLabel *label : panel.findChildren<QLabel *>()) {
        if (!isShown(*label, panel) || label->text().isEmpty())
            continue;
        const QRect inside = label->contentsRect();
        const int indent = std::max(0, label->indent());
        if (label->textFormat() == Qt::RichText) {
            QTextDocument set;
            set.setDocumentMargin(0.0);
            set.setDefaultFont(label->font());
            set.setHtml(label->text());
            set.setTextWidth(inside.width());
            need(set.toPlainText(), set.size().height(), inside.height());
            need(set.toPlainText(), set.size().width(), inside.width());
        } else if (label->wordWrap()) {
            const QRect needed = label->fontMetrics().boundingRect(QRect(0, 0, inside.width(), 1 << 16),
                                                                   Qt::TextWordWrap, label->text());
            need(label->text(), needed.height(), inside.height());
            need(label->text(), needed.width(), inside.width());
        } else {
            need(label->text(), label->fontMetrics().size(Qt::TextShowMnemonic, label->text()).width() + indent,
                 inside.width());
        }
        if (const auto *elided = qobject_cast<const ElidedLabel *>(label);
            elided && elided->fullText() != elided->text())
            cut << elided->fullText();
    }
    for (const QAbstractButton *button : panel.findChildren<QAbstractButton *>()) {
        if (isShown(*button, panel))
            need(button->text(), button->fontMetrics().size(Qt::TextShowMnemonic, button->text()).width(),
                 button->width());
    }
    for (const QTableView *table : panel.findChildren<QTableView *>()) {
        if (!isShown(*table, panel))
            continue;
        const QAbstractItemModel &model = *table->model();
        const QFontMetrics metrics(table->font());
        for (int column = 0; column < model.columnCount(); ++column) {
            if (table->isColumnHidden(column))
                continue;
            if (table->horizontalHeader()->isVisibleTo(table)) {
                const QString head = model.headerData(column, Qt::Horizontal).toString();
                need(head, table->horizontalHeader()->fontMetrics().horizontalAdvance(head),
                     table->columnWidth(column));
            }
            for (int row = 0; row < model.rowCount(); ++row) {
                const QModelIndex index = model.index(row, column);
                const QString text = index.data().toString();
                if (table->wordWrap()) {
                    const QRect needed = metrics.boundingRect(QRect(0, 0, table->columnWidth(column) - 6, 1 << 16),
                                                              Qt::TextWordWrap, text);
                    need(text, needed.height(), table->rowHeight(row));
                    need(text, needed.width(), table->columnWidth(column));
                } else {
                    need(text, metrics.horizontalAdvance(text), table->columnWidth(column));
                }
            }
        }
        // A part out of sight must be reachable by scrolling.
        if (table->horizontalHeader()->length() > table->viewport()->width() + 1
            && table->horizontalScrollBar()->maximum() == 0)
            cut << QStringLiteral("%1 cannot be scrolled").arg(table->accessibleName());
    }
    const auto nameOf = [](const QWidget &child) {
        return QStringLiteral("%1 %2").arg(QLatin1String(child.metaObject()->className()), child.accessibleName());
    };
    const QWidgetList children = panel.findChildren<QWidget *>(Qt::FindDirectChildrenOnly);
    for (const QWidget *child : children) {
        if (!isShown(*child, panel))
            continue;
        if (!panel.rect().contains(child->geometry()))
            cut << nameOf(*child) + QStringLiteral(" leaves the panel");
        for (const QWidget *other : children) {
            if (other != child && isShown(*other, panel) && other->geometry().intersects(child->geometry()))
                cut << QStringLiteral("%1 lies on %2").arg(nameOf(*child), nameOf(*other));
        }
    }
    return cut;
}

QString places(const QWidget &panel)
{
    QStringList list;
    for (const QWidget *child : panel.findChildren<QWidget *>(Qt::FindDirectChildrenOnly)) {
        const QRect r = child->geometry();
        list << QStringLiteral("%1 (%2): %3,%4 %5x%6")
                    .arg(QLatin1String(child->metaObject()->className()), child->accessibleName())
                    .arg(r.x())
                    .arg(r.y())
                    .arg(r.width())
                    .arg(r.height());
    }
    const QSize least = panel.minimumSizeHint().expandedTo(panel.minimumSize());
    list << QStringLiteral("at least %1x%2").arg(least.width()).arg(least.height());
    return list.join(u'\n');
}

} // namespace

class TestPanelSizes : public QObject {
    Q_OBJECT

private slots:
    void aSteadyLabelGrowsAndDoesNotShrink()
    {
        QWidget panel;
        auto *label = new SteadyLabel;
        auto *below = new QLabel(QStringLiteral("below"));
        auto *layout = new QVBoxLayout(&panel);
        layout->addWidget(label);
        layout->addWidget(below);
        layout->addStretch();
        panel.show();
        const auto placeAt = [&](int width) {
            panel.resize(width, 800);
            QCoreApplication::sendPostedEvents();
            QCoreApplication::processEvents();
            return below->y();
        };
        const int first = placeAt(300);
        label->setText(QStringLiteral("several words in a row ").repeated(8));
        const int grown = placeAt(300), grownNarrow = placeAt(200);
        QVERIFY(first < grown && grown < grownNarrow);
        for (const QString &text : {QString(), QStringLiteral("short")}) {
            label->setText(text);
            QCOMPARE(placeAt(200), grownNarrow);
            QCOMPARE(placeAt(300), grown);
            label->setMarkup(QStringLiteral("<b>%1</b>").arg(text), text);
            QCOMPARE(placeAt(300), grown);
        }
        label->setText({});
        label->startOver();
        QCOMPARE(placeAt(300), first);
    }

    void nothingIsCutAndNothingMoves_data()
    {
        QTest::addColumn<QString>("which");
        QTest::addColumn<double>("points");
        QTest::addColumn<bool>("isChinese");
        for (const char *which : {"comparison", "pipeline", "viewport", "life"}) {
            for (const double points : {9.0, 11.0, 13.0}) {
                for (const bool isChinese : {false, true})
                    QTest::addRow("%s, %g pt, %s", which, points, isChinese ? "Chinese" : "English")
                        << QString::fromLatin1(which) << points << isChinese;
            }
        }
    }

    void nothingIsCutAndNothingMoves()
    {
#ifdef _WIN32
        QSKIP("The layout is judged with the fonts of the desktops that the sizes are of.");
#endif
        QFETCH(QString, which);
        QFETCH(double, points);
        QFETCH(bool, isChinese);
        QFont font = m_font;
        font.setPointSizeF(points);
        QApplication::setFont(font);
        const Translation translation(isChinese ? QStringList{QStringLiteral("zh-CN")} : QStringList());

        SceneDocument document;
        document.setSurface({842, 723, 1.0});
        openScene(document, 1.0);
        LifecycleLog log;
        QWidget frame;
        std::unique_ptr<QWidget> panel; // goes before the frame
        if (which == QStringLiteral("comparison"))
            panel = std::make_unique<ComparisonPanel>(document);
        else if (which == QStringLiteral("pipeline"))
            panel = std::make_unique<PipelinePanel>(document);
        else if (which == QStringLiteral("viewport"))
            panel = std::make_unique<ViewportInspector>(document);
        else
            panel = std::make_unique<LifecyclePanel>(log);

        const auto settle = [] {
            // A layout that grows asks the one around it, level by level.
            for (int level = 0; level < 4; ++level)
                QCoreApplication::sendPostedEvents();
            QCoreApplication::processEvents();
        };
        const int digit = QFontMetrics(font).horizontalAdvance(u'0');
        const int least = panel->minimumSizeHint().expandedTo(panel->minimumSize()).width();
        // The width is in sizes of the type: the ratio of digits to letters differs from font to font.
        const int most = 32 * QFontInfo(font).pixelSize();
        QVERIFY2(least <= most, qPrintable(QStringLiteral("%1 of %2").arg(least).arg(most)));
        // The panel is inside a window, not one itself: the window system resizes windows late, and
        // once more after that.
        frame.resize(160 * digit, 2400);
        panel->setParent(&frame);
        panel->show();
        frame.show();
        for (const int width : {least, least + 5 * digit, 60 * digit, 90 * digit, 160 * digit}) {
            panel->resize(width, 2400);
            settle();
            QCOMPARE(panel->width(), width);
            QString grown;
            for (const bool isGrown : {false, true}) {
                openScene(document, 1.0);
                document.picks().clearPick();
                for (std::size_t i = 0; i < happenings().size(); ++i) {
                    happenings()[i](document);
                    if (auto *inspector = qobject_cast<ViewportInspector *>(panel.get()))
                        inspector->setPointer(WidgetPoint(100.0 * static_cast<double>(i), 321.5));
                    log.append(
                        {LifecycleEvent::Kind::OnLButtonDown, QStringLiteral("1234.5, 987.5"),
                         QStringLiteral("glReadPixels(1234, 1987, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth): depth = "
                                        "0.123456789, object id 12"),
                         12.3456});
                    log.append({LifecycleEvent::Kind::OnDraw,
                                {},
                                QStringLiteral("glBindFramebuffer, glClearBuffer"),
                                8888.88});
                    log.append({LifecycleEvent::Kind::OnDraw, {}, QStringLiteral("glDrawArrays"), 8888.88});
                    settle();
                    const QString where = QStringLiteral(" at %1 px, happening %2").arg(width).arg(i);
                    const QStringList cut = cutTexts(*panel);
                    QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n') + where));
                    QCOMPARE(panel->minimumSizeHint().expandedTo(panel->minimumSize()).width(), least);
                    const QString now = places(*panel);
                    // The comparison's parts come and go with the pick: test_comparison_panel checks
                    // that it stands still.
                    QVERIFY2(which == QStringLiteral("comparison") || !isGrown || now == grown,
                             qPrintable(grown + QStringLiteral("\n->\n") + now + where));
                }
                grown = places(*panel);
            }
        }
    }

    void cleanup()
    {
        QApplication::setFont(m_font);
    }

private:
    const QFont m_font = QApplication::font();
};

UNPROJECTOR_TEST(TestPanelSizes, layout, fonts)
#include "test_panel_sizes.moc"
