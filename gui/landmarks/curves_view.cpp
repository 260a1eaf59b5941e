#include "gui/landmarks/curves_view.h"

#include "gui/document/scene_curves.h"
#include "gui/document/scene_document.h"
#include "gui/landmarks/computing_button.h"
#include "gui/landmarks/measure_rows.h"
#include "gui/text/error_text.h"
#include "gui/text/typed_numbers.h"
#include "gui/widgets/number_delegate.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QShortcut>
#include <QSignalBlocker>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <QVariant>

#include <algorithm>

namespace unprojector::gui {
namespace {

using landmarks::Curve;
using landmarks::CurveKind;

enum Column { Name, Points, Kind, Count, Length };

/// Edits names and numbers of semilandmarks in place.
class CurveDelegate : public NumberDelegate {
public:
    using NumberDelegate::NumberDelegate;

    QWidget *createEditor(QWidget *parent, const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        const bool isTyped = index.column() == Name || index.column() == Count;
        return isTyped ? QStyledItemDelegate::createEditor(parent, option, index) : nullptr;
    }
};

bool isDigit(const QKeyEvent &event)
{
    return event.key() >= Qt::Key_0 && event.key() <= Qt::Key_9
           && (event.modifiers() & ~Qt::KeyboardModifiers(Qt::KeypadModifier)) == Qt::NoModifier;
}

/// Uses digits for the current row's number of semilandmarks, not as camera keys.
class CurveRows : public QTreeWidget {
public:
    using QTreeWidget::QTreeWidget;

    /// The pending input of the closed editor.
    struct Typed {
        int row = 0, column = 0;
        QString text;
    };
    std::optional<Typed> takeTyped()
    {
        auto *editor = state() == EditingState ? viewport()->findChild<QLineEdit *>() : nullptr;
        if (!editor)
            return std::nullopt;
        const QModelIndex index = indexAt(editor->geometry().center());
        const Typed typed{index.row(), index.column(), editor->text()};
        closeEditor(editor, QAbstractItemDelegate::NoHint);
        return index.isValid() ? std::optional(typed) : std::nullopt;
    }

protected:
    bool event(QEvent *event) override
    {
        if (event->type() == QEvent::ShortcutOverride && currentItem() && isDigit(*static_cast<QKeyEvent *>(event))) {
            event->accept();
            return true;
        }
        return QTreeWidget::event(event);
    }
    void keyPressEvent(QKeyEvent *event) override
    {
        if (!currentItem() || !isDigit(*event) || state() == EditingState) {
            QTreeWidget::keyPressEvent(event);
            return;
        }
        setCurrentItem(currentItem(), Count);
        editItem(currentItem(), Count);
        if (auto *editor = viewport()->findChild<QLineEdit *>())
            editor->setText(event->text());
    }
};

} // namespace

CurvesView::CurvesView(SceneDocument &document, QWidget *parent)
    : QWidget(parent), m_document(document), m_rows(new CurveRows), m_reason(new QLabel), m_join(new QToolButton(this))
{
    m_rows->setAccessibleName(tr("Curves"));
    m_rows->setRootIsDecorated(false);
    m_rows->setUniformRowHeights(true);
    m_rows->setHeaderLabels({tr("Curve"), tr("Landmarks"), tr("Kind"), tr("n"), tr("Length")});
    m_rows->headerItem()->setToolTip(
        Count, plainToolTip(tr(
                   "Semilandmarks at equal steps along the curve, both ends included; exported with the landmarks")));
    m_rows->setTextElideMode(Qt::ElideMiddle);
    m_rows->setItemDelegate(new CurveDelegate(m_rows));
    m_rows->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_rows->setContextMenuPolicy(Qt::CustomContextMenu);
    m_rows->header()->setStretchLastSection(false);
    for (const int column : {Name, Kind, Count, Length})
        m_rows->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    m_rows->header()->setSectionResizeMode(Points, QHeaderView::Stretch);
    connect(m_rows, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem *item, int column) {
        const int row = m_rows->indexOfTopLevelItem(item);
        // Deferred until the editor has finished: the rows are rebuilt.
        QTimer::singleShot(0, this,
                           [this, row, column, text = item->data(column, Qt::EditRole)] { apply(row, column, text); });
    });
    connect(m_rows, &QWidget::customContextMenuRequested, this, &CurvesView::showMenu);
    auto *remove = new QShortcut(QKeySequence::Delete, m_rows);
    remove->setContext(Qt::WidgetShortcut);
    connect(remove, &QShortcut::activated, this, &CurvesView::removeCurrent);

    m_reason->setWordWrap(true);
    m_reason->setTextFormat(Qt::PlainText);
    m_reason->setAccessibleName(tr("Reason for the missing curve"));
    m_reason->hide();

    m_join->setText(tr("Join"));
    m_join->setToolTip(tr(
        "Join the selected landmarks on the surface, in the order of their selection, to a curve with semilandmarks"));
    m_join->setFocusPolicy(Qt::StrongFocus);
    m_join->setPopupMode(QToolButton::InstantPopup);
    auto *menu = new QMenu(m_join);
    menu->setToolTipsVisible(true);
    const auto add = [&](const QString &text, const QString &tip, CurveKind kind) {
        menu->addAction(text, this, [this, kind] { join(kind); })->setToolTip(tip);
    };
    add(tr("On the &Surface") + QStringLiteral("\tJ"), tr("Geodesic: like a thread pulled tight on the surface"),
        CurveKind::Geodesic);
    add(tr("Along a &Plane") + QStringLiteral("\t")
            + QKeySequence(Qt::SHIFT | Qt::Key_J).toString(QKeySequence::NativeText),
        tr("Section of the surface with the plane through two landmarks and the surface's normals there"),
        CurveKind::PlaneSection);
    m_join->setMenu(menu);

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_rows, 1);
    layout->addWidget(m_reason);
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & (Change::Landmarks | Change::LandmarkSelection))
            m_reason->hide();
        if (changes & Change::Landmarks)
            showRows();
        else if (changes & (Change::Objects | Change::Placement | Change::Curves))
            showLengths();
        m_join->setEnabled(m_document.sceneLandmarks().selection().size() >= 2);
        fitHeight();
        setVisible(!m_reason->isHidden() || !m_document.curves().all().empty());
    });
    m_join->setEnabled(false);
    showRows();
    if (m_document.curves().all().empty())
        hide();
}

void CurvesView::join(landmarks::CurveKind kind)
{
    const QString reason = m_document.curves().join(m_document.sceneLandmarks().selectionInOrder(), kind);
    say(reason.isEmpty() ? QString() : tr("No curve: %1.").arg(reason));
    if (!reason.isEmpty())
        return;
    // Digits typed next set its number of semilandmarks: elsewhere they turn the camera.
    m_rows->setCurrentItem(m_rows->topLevelItem(m_rows->topLevelItemCount() - 1), Count);
    m_rows->setFocus(Qt::ShortcutFocusReason);
}

void CurvesView::applyTyped()
{
    if (const auto typed = static_cast<CurveRows *>(m_rows)->takeTyped())
        apply(typed->row, typed->column, typed->text);
}

void CurvesView::say(const QString &reason)
{
    m_reason->setText(reason);
    m_reason->setVisible(!reason.isEmpty());
    fitHeight();
    setVisible(!reason.isEmpty() || !m_document.curves().all().empty());
}

void CurvesView::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    // The reason of a failed curve is longer than its column: the tooltip shows it all.
    m_rows->header()->setMaximumSectionSize(std::max(m_rows->header()->minimumSectionSize(), width() / 2));
}

void CurvesView::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    emit shownOrHidden();
}

void CurvesView::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    emit shownOrHidden();
}

std::optional<std::size_t> CurvesView::current() const
{
    const int row = m_rows->indexOfTopLevelItem(m_rows->currentItem());
    return row < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(row));
}

void CurvesView::showRows()
{
    const QSignalBlocker blocker(m_rows);
    const int current = m_rows->indexOfTopLevelItem(m_rows->currentItem());
    m_rows->clear();
    const std::vector<Curve> &all = m_document.curves().all();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Curve &curve = all[i];
        auto *item = new QTreeWidgetItem(m_rows);
        item->setText(Name, SceneCurves::shownNameOf(curve, i));
        QStringList names;
        for (const std::string &name : curve.points)
            names << QString::fromStdString(name).simplified();
        item->setText(Points, names.join(QStringLiteral(" – ")));
        item->setText(Kind, curve.points.empty()                ? tr("as read")
                            : curve.kind == CurveKind::Geodesic ? tr("geodesic")
                                                                : tr("plane"));
        if (curve.points.empty())
            item->setText(Count, QString::number(curve.semilandmarks.size()));
        else
            item->setText(Count, QString::number(curve.count));
        item->setTextAlignment(Length, Qt::AlignRight | Qt::AlignVCenter);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
    }
    if (current >= 0 && current < m_rows->topLevelItemCount())
        m_rows->setCurrentItem(m_rows->topLevelItem(current));
    showLengths();
    fitHeight();
}

void CurvesView::fitHeight()
{
    const int row = m_rows->sizeHintForRow(0);
    if (row <= 0)
        return;
    const int bar = m_rows->horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff ? 0 : m_rows->frameWidth();
    const int height =
        m_rows->header()->sizeHint().height() + 2 * m_rows->frameWidth() + bar + m_rows->topLevelItemCount() * row;
    m_rows->setMaximumHeight(height);
    setMaximumHeight(m_reason->isHidden() ? height : QWIDGETSIZE_MAX);
}

void CurvesView::showLengths()
{
    const QSignalBlocker blocker(m_rows);
    SceneCurves &curves = m_document.curves();
    const QString unit = QString::fromStdString(m_document.scene().landmarks.unit);
    for (std::size_t i = 0; i < curves.all().size(); ++i) {
        QTreeWidgetItem *item = m_rows->topLevelItem(static_cast<int>(i));
        if (!item)
            return; // the landmarks have not been reported yet
        item->setText(Length, curveLengthText(curves.line(i), unit));
        item->setData(Length, NumberDelegate::kTextsRole, curveLengthTexts(curves.line(i), unit));
        showComputing(*m_rows, *item, Length, curves, curves.line(i).isComputing);
        for (int column = 0; column <= Length; ++column)
            item->setToolTip(column, plainToolTip(tr("%1 %2: %3", "a curve, its points, its length")
                                                      .arg(item->text(Name), item->text(Points), item->text(Length))));
    }
}

void CurvesView::apply(int row, int column, const QVariant &typed)
{
    const auto index = static_cast<std::size_t>(row);
    SceneCurves &curves = m_document.curves();
    if (row < 0 || index >= curves.all().size())
        return;
    if (column == Name) {
        if (!curves.rename(index, typed.toString()))
            say(tr("“%1” cannot be the name: it is empty, or another curve has it.")
                    .arg(typedBeginning(typed.toString().trimmed())));
    } else if (column == Count && !curves.all()[index].points.empty()) {
        bool isNumber = false;
        const int count = typed.toString().trimmed().toInt(&isNumber);
        if (isNumber && count >= 2 && count <= landmarks::kMostSemilandmarks)
            curves.setCount(index, count);
        else
            say(tr("n is “%1”; a curve has 2 to %2 semilandmarks.")
                    .arg(typedBeginning(typed.toString().trimmed()))
                    .arg(landmarks::kMostSemilandmarks));
    }
    showRows(); // restores the value after a rejection
}

void CurvesView::removeCurrent()
{
    if (const std::optional<std::size_t> index = current())
        m_document.curves().remove(*index);
}

void CurvesView::showMenu(const QPoint &place)
{
    const std::optional<std::size_t> curve = current();
    if (!curve)
        return;
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const Curve &shown = m_document.curves().all()[*curve];
    if (!shown.points.empty()) {
        const bool isGeodesic = shown.kind == CurveKind::Geodesic;
        menu->addAction(
            isGeodesic ? tr("Follow a &Plane") : tr("Follow the &Surface"), this, [this, curve, isGeodesic] {
                m_document.curves().setKind(*curve, isGeodesic ? CurveKind::PlaneSection : CurveKind::Geodesic);
            });
    }
    if (m_document.curves().line(*curve).isCancelled)
        menu->addAction(tr("&Compute Again"), this, [this] { m_document.curves().computeAgain(); });
    menu->addAction(tr("Re&move"), this, [this, curve] { m_document.curves().remove(*curve); });
    connect(&m_document, &SceneDocument::changed, menu, &QWidget::close);
    menu->popup(m_rows->viewport()->mapToGlobal(place));
}

} // namespace unprojector::gui
