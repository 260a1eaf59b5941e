#include "gui/pipeline/matrix_text.h"

#include "gui/text/sentences.h"

#include <QCoreApplication>
#include <QStringList>

#include <cmath>

namespace unprojector::gui {
using namespace cameras;
using namespace pipeline;
namespace {

struct MatrixText {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::MatrixText)
};

/// The window's action or advice about a finding, beside the button that repairs it.
QString adviceFor(const MatrixFinding &finding, MatrixRole role)
{
    switch (finding.fault) {
    case MatrixFault::DepthReversed: return MatrixText::tr("The depth range is reversed to match.");
    case MatrixFault::FarAtInfinity: return MatrixText::tr("It is drawn up to one million times near.");
    case MatrixFault::UnknownForm:
        return MatrixText::tr("The window cannot show it; only the inverted matrix can answer.");
    case MatrixFault::OrderOpen: return MatrixText::tr("Choose the order in which your program prints it.");
    case MatrixFault::Mirrored:
        return role == MatrixRole::View
                   ? MatrixText::tr("The program's world may be left-handed. “Flip x” keeps the coordinates of that "
                                    "world and mirrors the image; it is then not the program's camera.")
                   : QString();
    case MatrixFault::Scaled:
        return finding.repair == MatrixRepair::None ? MatrixText::tr("Paste only the view.") : QString();
    default: return {};
    }
}

} // namespace

QString roleName(MatrixRole role)
{
    switch (role) {
    case MatrixRole::View: return MatrixText::tr("View or modelview");
    case MatrixRole::Projection: return MatrixText::tr("Projection");
    case MatrixRole::Product: break;
    }
    return MatrixText::tr("Product (MVP)");
}

QString findingSentence(const MatrixFinding &finding, MatrixRole role)
{
    const QString found = QString::fromStdString(findingText(finding, role));
    return joinSentences(
        {MatrixText::tr("It %1.", "a matrix: the finding about it").arg(found), adviceFor(finding, role)});
}

QString repairName(const MatrixFinding &finding, NumberOrder order)
{
    switch (finding.repair) {
    case MatrixRepair::None: return {};
    case MatrixRepair::OtherOrder:
        return order == NumberOrder::ByColumns ? MatrixText::tr("Read as Row-major")
                                               : MatrixText::tr("Read as Column-major");
    case MatrixRepair::Invert: return MatrixText::tr("Invert");
    case MatrixRepair::Exchange: return MatrixText::tr("Swap Them");
    case MatrixRepair::DepthZeroToOne:
        return std::isnan(finding.other) ? MatrixText::tr("Keep 0 to 1") : MatrixText::tr("Read as 0 to 1");
    case MatrixRepair::TurnY: return MatrixText::tr("Flip y");
    case MatrixRepair::TurnX: return MatrixText::tr("Flip x");
    case MatrixRepair::WithoutScale: return MatrixText::tr("Remove the Scale");
    case MatrixRepair::Orthonormal: return MatrixText::tr("Make Perpendicular");
    case MatrixRepair::Negate: return MatrixText::tr("Negate");
    case MatrixRepair::TurnEye: break;
    }
    return MatrixText::tr("Turn to −z");
}

} // namespace unprojector::gui
