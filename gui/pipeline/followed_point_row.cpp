#include "gui/pipeline/followed_point_row.h"

#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/pipeline/pipeline_model.h"
#include "gui/widgets/steady_label.h"

#include <QHBoxLayout>
#include <QToolButton>

namespace unprojector::gui {

FollowedPointRow::FollowedPointRow(const SceneDocument &document, PipelineModel &model, QWidget *parent)
    : QWidget(parent), m_document(document), m_model(model), m_status(new SteadyLabel), m_follow(new QToolButton),
      m_remove(new QToolButton)
{
    m_status->setAccessibleName(tr("Meaning of the points"));
    m_follow->setAutoRaise(true);
    m_remove->setAutoRaise(true);
    m_remove->setText(QStringLiteral("✕"));
    m_remove->setToolTip(tr("Remove your point"));
    m_remove->setAccessibleName(m_remove->toolTip());
    m_follow->setAccessibleName(tr("Point to follow"));
    connect(m_follow, &QToolButton::clicked, this, [this] { m_model.followGiven(!m_model.followsGiven()); });
    connect(m_remove, &QToolButton::clicked, &m_model, &PipelineModel::removeGiven);
    // The rows below stay where they are when these come.
    for (QToolButton *button : {m_follow, m_remove}) {
        QSizePolicy policy = button->sizePolicy();
        policy.setRetainSizeWhenHidden(true);
        button->setSizePolicy(policy);
    }
    auto *line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(2);
    line->addWidget(m_status, 1);
    line->addWidget(m_follow, 0, Qt::AlignTop);
    line->addWidget(m_remove, 0, Qt::AlignTop);
    connect(&m_model, &PipelineModel::refused, this, &FollowedPointRow::showStatus);
    showButtons();
}

void FollowedPointRow::refresh()
{
    showButtons();
    if (m_status->text() != m_model.status())
        showStatus(m_model.status());
}

void FollowedPointRow::showStatus(const QString &text)
{
    m_status->setText(text);
    m_status->setToolTip(text);
}

void FollowedPointRow::showButtons()
{
    const bool isGiven = m_model.followsGiven();
    m_follow->setText(isGiven ? tr("The click") : tr("Your point"));
    m_follow->setToolTip(isGiven ? tr("Follow the clicked point again; your point is kept")
                                 : tr("Follow the point that you typed"));
    m_follow->setVisible(m_document.scene().givenPoint && (!isGiven || m_document.picks().pick()));
    m_remove->setVisible(m_document.scene().givenPoint.has_value());
}

} // namespace unprojector::gui
