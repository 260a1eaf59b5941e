#include "gui/pipeline/factors_view.h"

#include "gui/pipeline/factor_shares.h"
#include "gui/pipeline/matrix_model.h"
#include "gui/text/help_anchors.h"
#include "gui/text/number_text.h"
#include "gui/widgets/number_grid.h"

#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace unprojector::gui {
using namespace geometry;
using namespace pipeline;

namespace {

/// The letter in the written product.
QString letterOf(MatrixStep step)
{
    switch (step) {
    case MatrixStep::MoveEye:
    case MatrixStep::MoveBox: return QStringLiteral("T");
    case MatrixStep::TurnAxes: return QStringLiteral("R");
    case MatrixStep::Shear:
    case MatrixStep::Skew: return QStringLiteral("H");
    case MatrixStep::ScaleBox: return QStringLiteral("S");
    case MatrixStep::TurnZ: return QStringLiteral("Z");
    case MatrixStep::OntoNear: return QStringLiteral("N");
    case MatrixStep::NearToSquare: return QStringLiteral("B");
    case MatrixStep::FromConventions: return QStringLiteral("C′");
    case MatrixStep::ToConventions: return QStringLiteral("C");
    }
    Q_UNREACHABLE();
}

QString helpOf(MatrixStep step)
{
    switch (step) {
    case MatrixStep::MoveEye:
    case MatrixStep::TurnAxes: return QStringLiteral("view-steps");
    case MatrixStep::MoveBox:
    case MatrixStep::ScaleBox:
    case MatrixStep::TurnZ: return QStringLiteral("ortho-steps");
    case MatrixStep::Shear: return QStringLiteral("oblique");
    case MatrixStep::Skew:
    case MatrixStep::OntoNear:
    case MatrixStep::NearToSquare: return QStringLiteral("frustum-steps");
    case MatrixStep::FromConventions:
    case MatrixStep::ToConventions: return QStringLiteral("conventions");
    }
    Q_UNREACHABLE();
}

QString textOf(MatrixStep step)
{
    switch (step) {
    case MatrixStep::MoveEye: return FactorsView::tr("moves the eye to the origin");
    case MatrixStep::TurnAxes:
        return FactorsView::tr("turns the world: the eye's axes, right, up and backward (s, u, −f), become x, y and z");
    case MatrixStep::Shear: return FactorsView::tr("shears: x and y go along with z, by cot θ and cot φ");
    case MatrixStep::Skew: return FactorsView::tr("shears: x goes along with y, by the skew");
    case MatrixStep::MoveBox: return FactorsView::tr("moves the box's middle to the origin");
    case MatrixStep::ScaleBox: return FactorsView::tr("scales the box's sides to 2");
    case MatrixStep::TurnZ: return FactorsView::tr("flips z: greater is then farther away");
    case MatrixStep::OntoNear:
        return FactorsView::tr(
            "projects onto the near plane, once w = −z divides: n·x, n·y, and a·z + b for the depth");
    case MatrixStep::NearToSquare: return FactorsView::tr("takes the near plane's window to −1 to 1 across and up");
    case MatrixStep::FromConventions: return FactorsView::tr("converts the axes of the chosen conventions to OpenGL's");
    case MatrixStep::ToConventions: return FactorsView::tr("converts OpenGL's axes to those of the chosen conventions");
    }
    Q_UNREACHABLE();
}

} // namespace

FactorsView::FactorsView(QWidget *parent)
    : QWidget(parent), m_product(new QLabel), m_shares(new FactorShares),
      m_noShares(new QLabel(tr("To change the strength of each factor, choose OpenGL's conventions: the drawing "
                               "compares with OpenGL's cube.")))
{
    m_noShares->setWordWrap(true);
    m_noShares->hide();
    m_product->setWordWrap(true);
    m_product->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_product->setAccessibleName(tr("The product of the factors"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 0, 0, 4);
    layout->setSpacing(2);
    layout->addWidget(m_product);
    for (Part &part : m_parts) {
        part.text = new QLabel;
        part.text->setWordWrap(true);
        part.text->setTextFormat(Qt::RichText);
        part.text->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
        part.text->setOpenExternalLinks(true);
        part.model = new MatrixModel(PipelineStage::WholeMatrix, this);
        part.grid = new NumberGrid(part.model);
        part.grid->setAccessibleName(tr("Factor"));
        part.text->setBuddy(part.grid);
        layout->addWidget(part.text);
        layout->addWidget(part.grid);
        part.text->hide();
        part.grid->hide();
    }
    layout->addWidget(m_shares);
    layout->addWidget(m_noShares);
    m_shares->hide();
}

void FactorsView::setFactors(const std::vector<MatrixFactor> &factors, const glm::dmat4 &matrix, const MatrixView &view,
                             bool isGiven, const Projection *projection)
{
    Q_ASSERT(!factors.empty() && factors.size() <= m_parts.size());
    QStringList letters;
    std::vector<FactorShares::Told> told;
    for (std::size_t i = 0; i < m_parts.size(); ++i) {
        const Part &part = m_parts[i];
        const bool isThere = i < factors.size();
        part.text->setVisible(isThere);
        part.grid->setVisible(isThere);
        if (!isThere)
            continue;
        const QString letter = letterOf(factors[i].step), text = textOf(factors[i].step);
        letters << letter;
        told.push_back({letter, text});
        // The letter links to the derivation of the step in the help.
        const QString link = QStringLiteral("<a href=\"%1\">%2</a>").arg(helpAddress(helpOf(factors[i].step)), letter);
        part.text->setText(QStringLiteral("%1.&nbsp; %2&nbsp; %3").arg(i + 1).arg(link, text.toHtmlEscaped()));
        part.model->setVariableName(letter);
        part.model->setView(view);
        part.model->setMatrix(factors[i].matrix, PipelineDirection::Forward, ProjectionKind::Perspective, false);
        part.grid->setAccessibleName(QStringLiteral("%1, %2").arg(letter, text));
    }
    // A column vector is to the right of the factor that acts first.
    if (view.layout == MatrixLayout::Column)
        std::reverse(letters.begin(), letters.end());
    const double off = differenceUlps(factors, matrix);
    const QString product = letters.join(QStringLiteral(" · "));
    QString text = off == 0.0
                       ? tr("= %1, to the last digit").arg(product)
                       : tr("= %1, to within %2 ulp (units in the last place)").arg(product, significantText(off, 2));
    if (isGiven)
        text +=
            u'\n' + tr("The sixteen numbers as given cannot be decomposed; these are the factors of their conversion.");
    m_product->setText(text);
    // The cube from −1 to 1 is OpenGL's.
    const bool areOurs = std::none_of(factors.begin(), factors.end(), [](const MatrixFactor &factor) {
        return factor.step == MatrixStep::FromConventions || factor.step == MatrixStep::ToConventions;
    });
    const bool canBeTried = projection && areOurs;
    if (canBeTried)
        m_shares->setFactors(factors, told, *projection, matrix, view);
    m_shares->setVisible(canBeTried);
    m_noShares->setVisible(projection && !areOurs);
}

void FactorsView::setNone(const QString &reason)
{
    for (const Part &part : m_parts) {
        part.text->hide();
        part.grid->hide();
    }
    m_shares->hide();
    m_noShares->hide();
    m_product->setText(reason);
}

} // namespace unprojector::gui
