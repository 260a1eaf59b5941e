#include "gui/objects/objects_panel.h"

#include "gui/document/camera_looks.h"
#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"
#include "gui/objects/objects_model.h"

#include <QAbstractItemDelegate>
#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>

namespace unprojector::gui {

ObjectsPanel::ObjectsPanel(SceneDocument &document, QWidget *parent)
    : QWidget(parent), m_document(document), m_model(new ObjectsModel(document, this)), m_list(new QTreeView),
      m_reason(new QLabel), m_fit(new QToolButton), m_remove(new QToolButton)
{
    m_list->setModel(m_model);
    m_list->setAccessibleName(tr("Objects of the scene"));
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setTextElideMode(Qt::ElideMiddle);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_list->setDragDropMode(QAbstractItemView::InternalMove);
    m_list->setDragDropOverwriteMode(false);
    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(ObjectsModel::Name, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(ObjectsModel::Triangles, QHeaderView::ResizeToContents);
    connect(m_list, &QWidget::customContextMenuRequested, this, &ObjectsPanel::showMenu);

    m_reason->setWordWrap(true);
    m_reason->setTextFormat(Qt::PlainText); // it contains the name
    m_reason->setAccessibleName(tr("Reason why the name was rejected"));
    m_reason->hide();
    connect(m_model, &ObjectsModel::nameRefused, m_reason, [this](const QString &reason) {
        m_reason->setText(reason);
        m_reason->show();
    });
    connect(m_model, &ObjectsModel::nameAccepted, m_reason, &QWidget::hide);

    m_fit->setText(tr("Fit"));
    m_fit->setToolTip(tr("Move the camera so that this object fills the view"));
    m_remove->setText(tr("Remove"));
    m_remove->setToolTip(tr("Remove this object from the scene (Del)"));
    for (QToolButton *button : {m_fit, m_remove})
        button->setFocusPolicy(Qt::StrongFocus);
    connect(m_fit, &QToolButton::clicked, this, &ObjectsPanel::fitCurrent);
    connect(m_remove, &QToolButton::clicked, this, &ObjectsPanel::removeCurrent);
    m_list->installEventFilter(this);

    connect(m_model, &QAbstractItemModel::modelAboutToBeReset, this, [this] { m_rowBeforeReset = current(); });
    connect(m_model, &QAbstractItemModel::modelReset, this, [this] {
        m_reason->hide();
        int row = m_model->rowAfterReset(m_rowBeforeReset);
        if (row < 0) // the row was removed: select the next one, or the last
            row = std::min(m_rowBeforeReset, m_model->rowCount() - 1);
        m_list->setCurrentIndex(m_model->index(row, ObjectsModel::Name));
        updateButtons();
    });
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this, [this] {
        m_reason->hide();
        updateButtons();
    });

    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_fit);
    buttons->addWidget(m_remove);
    buttons->addStretch();
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(m_list, 1);
    layout->addWidget(m_reason);
    layout->addLayout(buttons);
    updateButtons();
}

QSize ObjectsPanel::minimumSizeHint() const
{
    constexpr int kDigits = 20, kLines = 7;
    return {kDigits * fontMetrics().horizontalAdvance(u'0'), kLines * fontMetrics().lineSpacing()};
}

int ObjectsPanel::current() const
{
    const QModelIndex index = m_list->currentIndex();
    return index.isValid() && index.row() < m_model->rowCount() ? index.row() : -1;
}

bool ObjectsPanel::eventFilter(QObject *watched, QEvent *event)
{
    // Unused keys of a row's editor arrive here as well, such as the Enter that ends it.
    const QWidget *focus = window()->focusWidget();
    const bool isEditing = focus && m_list->viewport()->isAncestorOf(focus);
    if (event->type() == QEvent::KeyPress && !isEditing) {
        switch (static_cast<QKeyEvent *>(event)->key()) {
        case Qt::Key_Delete: removeCurrent(); return true;
        case Qt::Key_Return:
        case Qt::Key_Enter: renameCurrent(); return true;
        default: break;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void ObjectsPanel::updateButtons()
{
    for (QToolButton *button : {m_fit, m_remove})
        button->setEnabled(current() >= 0);
}

void ObjectsPanel::fitCurrent()
{
    if (current() >= 0)
        fitObject(m_document, static_cast<std::size_t>(current()));
}

void ObjectsPanel::removeCurrent()
{
    if (current() >= 0)
        // fewer objects always give a valid setup
        static_cast<void>(removeObject(m_document, static_cast<std::size_t>(current())));
}

void ObjectsPanel::renameCurrent()
{
    if (current() >= 0)
        m_list->edit(m_model->index(current(), ObjectsModel::Name));
}

void ObjectsPanel::applyTyped()
{
    auto *editor = m_list->viewport()->findChild<QLineEdit *>();
    if (!editor)
        return;
    // Slots that the list reserves for its own editors.
    QMetaObject::invokeMethod(m_list, "commitData", Q_ARG(QWidget *, editor));
    QMetaObject::invokeMethod(m_list, "closeEditor", Q_ARG(QWidget *, editor),
                              Q_ARG(QAbstractItemDelegate::EndEditHint, QAbstractItemDelegate::NoHint));
}

void ObjectsPanel::showMenu(const QPoint &place)
{
    if (current() < 0)
        return;
    const QModelIndex index = m_model->index(current(), ObjectsModel::Name);
    const bool isHidden = index.data(Qt::CheckStateRole).toInt() != Qt::Checked;
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Fit"), this, &ObjectsPanel::fitCurrent);
    menu->addAction(isHidden ? tr("Show") : tr("Hide"), this, [this, isHidden] {
        m_model->setData(m_model->index(current(), ObjectsModel::Name), isHidden ? Qt::Checked : Qt::Unchecked,
                         Qt::CheckStateRole);
    });
    menu->addAction(tr("Show All Objects"), this, [this] { static_cast<void>(showAllObjects(m_document)); })
        ->setEnabled(hasHiddenObjects(m_document.scene()));
    menu->addSeparator();
    menu->addAction(tr("Rename"), this, &ObjectsPanel::renameCurrent);
    menu->addAction(tr("Remove"), this, &ObjectsPanel::removeCurrent);
    connect(m_model, &QAbstractItemModel::modelReset, menu, &QWidget::close);
    menu->popup(m_list->viewport()->mapToGlobal(place));
}

} // namespace unprojector::gui
