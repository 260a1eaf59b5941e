#include "gui/pipeline/derivation_line.h"

#include "gui/document/scene_document.h"
#include "gui/pipeline/entry_derivation.h"
#include "gui/pipeline/stage_text.h"
#include "gui/widgets/help_link.h"
#include "gui/widgets/steady_label.h"

#include <QHBoxLayout>

namespace unprojector::gui {
using namespace geometry;
using namespace pipeline;

using Space = PointModel::Space;

DerivationLine::DerivationLine(const SceneDocument &document, PipelineModel &model, QWidget *parent)
    : QWidget(parent), m_document(document), m_model(model), m_label(new SteadyLabel), m_help(new HelpLink({}))
{
    m_label->setObjectName(QStringLiteral("derivation"));
    m_label->setAccessibleName(tr("Computation of the chosen number"));
    auto *line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(2);
    line->addWidget(m_label, 1, Qt::AlignTop);
    line->addWidget(m_help, 0, Qt::AlignTop);
}

void DerivationLine::choose(PointModel::Space space, int coordinate)
{
    const bool isSameSpace = chosenSpace() == space;
    m_chosen = {space, coordinate};
    if (isSameSpace)
        refresh();
    else
        startOver();
}

void DerivationLine::clear()
{
    m_chosen.reset();
    startOver();
}

std::optional<Space> DerivationLine::chosenSpace() const
{
    return m_chosen ? std::optional(m_chosen->space) : std::nullopt;
}

void DerivationLine::startOver()
{
    refresh();
    m_label->startOver();
}

void DerivationLine::refresh()
{
    const EntryDerivation derivation =
        m_chosen ? entryDerivation(m_model, m_model.setup(), m_chosen->space, m_chosen->coordinate)
                 : EntryDerivation{entryHint(), {}, 0, {}, {}};
    m_label->setText(unbrokenTerms(derivation.text));
    m_help->setAnchor(helpOf(derivation));
    m_label->setToolTip(derivation.text);
    for (const PipelineStage stage : kPipelineStages) {
        MatrixModel *matrix = m_model.matrix(stage);
        QModelIndexList marked;
        for (int column = 0; column < 4 && derivation.stage == stage; ++column)
            marked << matrix->indexOf(derivation.matrixRow, column);
        matrix->setMarked(marked);
    }
    for (int i = 0; i < PointModel::kSpaces; ++i) {
        PointModel *point = m_model.point(static_cast<Space>(i));
        QModelIndexList marked;
        if (m_chosen && m_chosen->space == point->space())
            marked << point->indexOf(m_chosen->coordinate);
        if (derivation.source == point->space()) {
            for (const int coordinate : derivation.coordinates)
                marked << point->indexOf(coordinate);
        }
        point->setMarked(marked);
    }
}

QString DerivationLine::helpOf(const EntryDerivation &derivation) const
{
    if (derivation.stage)
        return stageHelp(*derivation.stage, m_model.direction(), kindOf(m_model.setup().projection()));
    if (!m_chosen || !derivation.source)
        return QStringLiteral("spaces");
    // The flip, and the division.
    return m_chosen->space == Space::Window || m_chosen->space == Space::Widget ? QStringLiteral("half-pixel")
                                                                                : QStringLiteral("viewport");
}

} // namespace unprojector::gui
