#include "gui/pipeline/pasted_matrix_box.h"

#include "gui/pipeline/matrix_findings_view.h"
#include "gui/pipeline/matrix_model.h"
#include "gui/pipeline/matrix_text.h"
#include "gui/text/sentences.h"
#include "gui/widgets/digits_font.h"
#include "gui/widgets/number_grid.h"
#include "gui/widgets/plain_text_box.h"
#include "gui/widgets/segmented_switch.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace unprojector::gui {
using namespace geometry;
using namespace cameras;
using namespace pipeline;

namespace {

constexpr int kTextLines = 5, kLinesOfCamera = 16;

/// The choices in the order of the switch.
constexpr std::array<std::optional<NdcDepth>, 3> kNdcDepths{std::nullopt, NdcDepth::MinusOneToOne, NdcDepth::ZeroToOne};

QString variableName(MatrixRole role)
{
    switch (role) {
    case MatrixRole::View: return QStringLiteral("eyeFromWorld");
    case MatrixRole::Projection: return QStringLiteral("clipFromEye");
    case MatrixRole::Product: break;
    }
    return QStringLiteral("clipFromWorld");
}

} // namespace

PastedMatrixBox::PastedMatrixBox(MatrixRole role, QWidget *parent) : QWidget(parent), m_role(role)
{
    m_title = new QLabel(QStringLiteral("%1   %2").arg(roleName(role), variableName(role)));
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);

    m_text = new PlainTextBox;
    m_text->setMost(kMostPastedCharacters);
    m_text->setFont(digitsFont(font()));
    m_text->setTabChangesFocus(true);
    m_text->setAcceptDrops(false); // the dialog takes files
    m_text->setLineWrapMode(PlainTextBox::NoWrap);
    m_text->setPlaceholderText(
        role == MatrixRole::Projection
            ? tr("Paste 16 numbers as a program prints them\n(glm::to_string, NumPy, JSON, C …), its calls\n"
                 "(gluPerspective(45, 1.5, 0.1, 100)), or a\ncamera: K, R, t, OpenCV's YAML, transforms.json …")
            : tr("Paste 16 numbers, as a program prints them\n(glm::to_string, NumPy, Eigen, JSON, C …), or its "
                 "calls:\ngluPerspective(45, 1.5, 0.1, 100)"));
    m_text->setAccessibleName(tr("Text of the matrix: %1").arg(roleName(role)));
    m_text->setToolTip(tr(
        "Sixteen numbers in a row are read column after column, four lines or brackets as rows. Calls of OpenGL, GLM, "
        "three.js, System.Numerics and DirectXMath are read with the numbers in them."));
    setTextLines(kTextLines);
    m_title->setBuddy(m_text);
    setFocusProxy(m_text);

    m_said = new QLabel;
    m_said->setWordWrap(true);
    m_said->setTextFormat(Qt::PlainText);
    m_move = new QPushButton;
    m_move->setAutoDefault(false);
    m_move->hide();
    m_order = new SegmentedSwitch(tr("Order of the numbers"),
                                  {{tr("By columns"), tr("Column-major: the first four numbers are the first column")},
                                   {tr("By rows"), tr("Row-major: the first four numbers are the first row")}});
    m_ndcDepth = new SegmentedSwitch(
        tr("NDC depths"),
        {{tr("By default"), tr("−1 to 1, unless the numbers allow only 0 to 1")},
         {tr("−1 to 1"), tr("The depths of NDC go from −1 at near to 1 at far: OpenGL")},
         {tr("0 to 1"), tr("The depths of NDC go from 0 to 1: Vulkan, Direct3D, Metal, WebGPU, glClipControl")}});
    auto *depths = new QWidget;
    auto *depthLine = new QHBoxLayout(depths);
    depthLine->setContentsMargins(0, 0, 0, 0);
    depthLine->addWidget(new QLabel(tr("NDC depths:")));
    depthLine->addWidget(m_ndcDepth);
    depthLine->addStretch();
    // A view has none; its grid stays aligned with the projection's.
    QSizePolicy keepsLine = depths->sizePolicy();
    keepsLine.setRetainSizeWhenHidden(true);
    depths->setSizePolicy(keepsLine);
    depths->setHidden(role == MatrixRole::View);
    m_asPasted = new QToolButton;
    m_asPasted->setText(tr("As Pasted"));
    m_asPasted->setToolTip(tr("Undo the changes to the matrix"));
    QSizePolicy keepsRoom = m_asPasted->sizePolicy();
    keepsRoom.setRetainSizeWhenHidden(true);
    m_asPasted->setSizePolicy(keepsRoom);
    m_asPasted->hide();
    m_model = new MatrixModel(PipelineStage::WholeMatrix, this);
    m_model->setVariableName(variableName(role));
    m_grid = new NumberGrid(m_model);
    m_grid->setAccessibleName(variableName(role));
    m_findings = new MatrixFindingsView;

    auto *how = new QHBoxLayout;
    how->addWidget(m_order);
    how->addStretch();
    how->addWidget(m_asPasted);
    m_read = new QWidget;
    auto *read = new QVBoxLayout(m_read);
    read->setContentsMargins(0, 0, 0, 0);
    read->addWidget(m_said);
    read->addWidget(m_move, 0, Qt::AlignLeft);
    read->addLayout(how);
    read->addWidget(depths);
    read->addWidget(m_grid);
    read->addWidget(m_findings);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_title);
    layout->addWidget(m_text);
    layout->addWidget(m_read);
    layout->addStretch();

    connect(m_text, &PlainTextBox::textChanged, this, [this] { emit textChanged(text()); });
    connect(m_text, &PlainTextBox::refused, this, &PastedMatrixBox::textRefused);
    connect(m_order, &SegmentedSwitch::chosen, this,
            [this](int index) { emit orderChosen(index == 0 ? NumberOrder::ByColumns : NumberOrder::ByRows); });
    connect(m_ndcDepth, &SegmentedSwitch::chosen, this,
            [this](int index) { emit ndcDepthChosen(kNdcDepths.at(std::size_t(index))); });
    connect(m_move, &QPushButton::clicked, this, &PastedMatrixBox::moveWanted);
    connect(m_asPasted, &QToolButton::clicked, this, &PastedMatrixBox::asPastedWanted);
    connect(m_findings, &MatrixFindingsView::repairWanted, this, &PastedMatrixBox::repairWanted);
}

QString PastedMatrixBox::text() const
{
    return m_text->toPlainText();
}

void PastedMatrixBox::setText(const QString &text)
{
    m_text->setText(text);
}

void PastedMatrixBox::showMatrix()
{
    m_title->setText(QStringLiteral("%1   %2").arg(roleName(m_role), variableName(m_role)));
    m_read->show();
    setTextLines(kTextLines);
}

void PastedMatrixBox::showTextOnly(bool isHalf)
{
    m_title->setText(!isHalf                            ? tr("Camera")
                     : m_role == MatrixRole::Projection ? tr("Camera, first text")
                                                        : tr("Camera, second text"));
    m_read->hide();
    setTextLines(isHalf ? kLinesOfCamera / 2 - 1 : kLinesOfCamera);
}

void PastedMatrixBox::setTextLines(int lines)
{
    m_text->setFixedHeight((lines + 1) * QFontMetrics(m_text->font()).lineSpacing() + 3 * m_text->frameWidth());
}

QStringList PastedMatrixBox::saidOf(const MatrixPaste &paste) const
{
    if (const auto &error = paste.error(m_role))
        return {errorText(*error, m_role)};
    const bool isBlank = text().trimmed().isEmpty();
    const PastedMatrix *pasted = paste.pasted(m_role);
    if (!pasted) {
        switch (m_role) {
        case MatrixRole::Projection:
            return {isBlank ? tr("Empty: the scene's projection is kept.")
                            : tr("The text has no projection: the scene's projection is kept.")};
        case MatrixRole::View:
            return {isBlank ? tr("Empty: the scene's view is kept.")
                            : tr("The text has no view: the scene's view is kept.")};
        case MatrixRole::Product: break;
        }
        return {isBlank ? tr("Empty.") : tr("The text has no product.")};
    }
    if (pasted->form == MatrixForm::Call)
        return {isBlank ? tr("From the other text: %1").arg(ended(pasted->call)) : ended(pasted->call)};
    return {isBlank ? tr("From the other text: %1.").arg(formName(pasted->form))
                    : tr("Read as %1.").arg(formName(pasted->form))};
}

void PastedMatrixBox::showPaste(const MatrixPaste &paste)
{
    const PastedMatrix *pasted = paste.pasted(m_role);
    const auto matrix = paste.matrix(m_role);
    {
        const QSignalBlocker blocker(m_order);
        m_order->setChoice(paste.order(m_role) == NumberOrder::ByColumns ? 0 : 1);
    }
    m_order->setEnabled(pasted && pasted->form != MatrixForm::Call);
    {
        const QSignalBlocker blocker(m_ndcDepth);
        const auto chosen = std::find(kNdcDepths.cbegin(), kNdcDepths.cend(), paste.ndcDepth(m_role));
        m_ndcDepth->setChoice(static_cast<int>(chosen - kNdcDepths.cbegin()));
    }
    m_ndcDepth->setEnabled(pasted != nullptr);
    QStringList said = saidOf(paste);
    if (text().contains(QStringLiteral("<Matrix 4x4")))
        said << tr("Blender prints this. If it is the camera's pose, write “matrix_world =” before it, and add the "
                   "lens in a line below: “lens = 50”.");
    if (pasted && pasted->isInverse)
        said << sentence(inverseText(*pasted));
    if (paste.leavesInverseOut(m_role))
        said << tr("The pasted text also has the inverse of this matrix. It is ignored.");
    QStringList aside;
    for (const std::string &name : paste.aside(m_role))
        aside << QString::fromStdString(name);
    if (!aside.isEmpty())
        said << tr("Numbers that belong to no matrix are not used: %1.").arg(aside.join(QStringLiteral(", ")));
    QStringList done;
    for (const MatrixFinding &finding : paste.repairs(m_role))
        done << repairName(finding, paste.order(m_role) == NumberOrder::ByColumns ? NumberOrder::ByRows
                                                                                  : NumberOrder::ByColumns);
    if (!done.isEmpty())
        said << tr("Done: %1.").arg(done.join(QStringLiteral(", ")));
    m_said->setText(joinSentences(said));
    if (const auto named = paste.namedRole(m_role)) {
        const bool isProduct = *named == MatrixRole::Product;
        m_move->setText(isProduct ? tr("Read as product") : tr("Read as projection and view"));
        m_move->setToolTip(isProduct ? tr("The text names a product (MVP): decompose it into projection and view")
                                     : tr("The text has a projection or a view: read it as these"));
    }
    m_move->setVisible(paste.namedRole(m_role).has_value());
    m_asPasted->setVisible(!done.isEmpty());
    m_grid->setVisible(matrix.has_value());
    if (matrix)
        m_model->setMatrix(*matrix, PipelineDirection::Forward, ProjectionKind::Perspective);
    m_findings->setFindings(paste.findings(m_role), m_role, paste.order(m_role));
}

} // namespace unprojector::gui
