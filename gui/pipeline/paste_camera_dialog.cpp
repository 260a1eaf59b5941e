#include "gui/pipeline/paste_camera_dialog.h"

#include "core/matrices/matrix_format.h"
#include "core/text/error_text.h"
#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"
#include "gui/pipeline/matrix_text.h"
#include "gui/pipeline/pasted_matrix_box.h"
#include "gui/text/number_text.h"
#include "gui/text/sentences.h"
#include "gui/widgets/segmented_switch.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace matrices;

namespace {

constexpr std::array kRoles{MatrixRole::Projection, MatrixRole::View, MatrixRole::Product};

QString notACamera(const Error &error)
{
    return PasteCameraDialog::tr("Not a camera: %1").arg(ended(text::errorText(error)));
}

} // namespace

PasteCameraDialog::PasteCameraDialog(SceneDocument &document, QWidget *parent)
    : QDialog(parent), m_document(document)
{
    setWindowTitle(tr("Paste Matrices"));
    m_kind = new SegmentedSwitch(
        tr("Pasted matrices"),
        {{tr("Projection and view"), tr("The two matrices, or one of them; the scene keeps the other")},
         {tr("Product"), tr("Projection times view, or times modelview (MVP), decomposed into the two")}});
    auto *boxes = new QWidget;
    auto *columns = new QHBoxLayout(boxes);
    columns->setContentsMargins(0, 0, 0, 0);
    columns->setSpacing(2 * fontMetrics().horizontalAdvance(u'0'));
    for (const MatrixRole role : kRoles) {
        auto *one = new PastedMatrixBox(role);
        m_boxes[std::size_t(role)] = one;
        columns->addWidget(one, 1);
        connect(one, &PastedMatrixBox::textChanged, this, [this, role](const QString &text) {
            m_paste.setText(role, text.toStdString());
            refresh();
        });
        connect(one, &PastedMatrixBox::orderChosen, this, [this, role](NumberOrder order) {
            m_paste.setOrder(role, order);
            refresh();
        });
        connect(one, &PastedMatrixBox::ndcDepthChosen, this, [this, role](const std::optional<NdcDepth> &depth) {
            m_paste.setNdcDepth(role, depth);
            refresh();
        });
        connect(one, &PastedMatrixBox::asPastedWanted, this, [this, role] {
            m_paste.takeBack(role);
            refresh();
        });
        connect(one, &PastedMatrixBox::moveWanted, this, [this, role] { moveText(role); });
        connect(one, &PastedMatrixBox::repairWanted, this,
                [this, role](const MatrixFinding &finding) { repair(role, finding); });
    }
    m_scrolled = new QScrollArea;
    m_scrolled->setWidgetResizable(true);
    m_scrolled->setFrameShape(QFrame::NoFrame);
    m_scrolled->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scrolled->setWidget(boxes);

    m_meaning = new QLabel;
    m_meaning->setWordWrap(true);
    m_meaning->setTextFormat(Qt::PlainText);
    m_meaning->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_meaning->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_meaning->setAccessibleName(tr("Meaning of the matrices"));
    constexpr int kLines = 3;
    m_meaning->setMinimumHeight(kLines * fontMetrics().lineSpacing());
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    m_ok = buttons->button(QDialogButtonBox::Ok);
    m_ok->setToolTip(tr("Set the scene's camera from these matrices; Ctrl+Z undoes it"));
    connect(buttons, &QDialogButtonBox::accepted, this, &PasteCameraDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &PasteCameraDialog::reject);

    auto *layout = new QVBoxLayout(this);
    layout->addWidget(m_kind, 0, Qt::AlignLeft);
    layout->addWidget(m_scrolled, 1);
    layout->addWidget(m_meaning);
    layout->addWidget(buttons);
    connect(m_kind, &SegmentedSwitch::chosen, this, &PasteCameraDialog::refresh);
    constexpr int kDigits = 110, kHeight = 34;
    const QSize wanted(kDigits * fontMetrics().horizontalAdvance(u'0'), kHeight * fontMetrics().lineSpacing());
    resize(wanted.boundedTo(screen()->availableSize()));
    refresh();
}

void PasteCameraDialog::open(SceneDocument &document, QWidget *parent, MatrixRole role, const QString &text)
{
    auto *dialog = new PasteCameraDialog(document, parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setText(role, text);
    dialog->QDialog::open();
}

bool PasteCameraDialog::isProduct() const
{
    return m_kind->choice() == 1;
}

void PasteCameraDialog::setText(MatrixRole role, const QString &text)
{
    m_kind->setChoice(role == MatrixRole::Product ? 1 : 0);
    box(role)->setText(text);
    box(role)->setFocus();
}

void PasteCameraDialog::repair(MatrixRole role, const MatrixFinding &finding)
{
    if (finding.repair != MatrixRepair::Exchange) {
        m_paste.repair(role, finding);
        refresh();
        return;
    }
    // A text with both matrices is split between them.
    const auto textOf = [this](MatrixRole one) {
        const PastedMatrix *pasted = m_paste.pasted(one);
        if (!pasted || !box(one)->text().trimmed().isEmpty())
            return box(one)->text();
        return QString::fromStdString(formatted(meantMatrix(*pasted, m_paste.order(one)), {}, {}));
    };
    const QString projection = textOf(MatrixRole::Projection), view = textOf(MatrixRole::View);
    box(MatrixRole::Projection)->setText(view);
    box(MatrixRole::View)->setText(projection);
}

void PasteCameraDialog::moveText(MatrixRole role)
{
    const std::optional<MatrixRole> named = m_paste.namedRole(role);
    if (!named)
        return;
    const QString text = box(role)->text();
    box(role)->setText({});
    setText(*named, text);
    refresh();
}

MatrixPaste::Camera PasteCameraDialog::camera() const
{
    if (!isProduct())
        return m_paste.camera();
    MatrixPaste::Camera camera;
    if (const auto apart = m_paste.apart()) {
        camera.projection = MatrixProjection{apart->clipFromEye, m_paste.ndcDepth(MatrixRole::Product)};
        camera.eyeFromWorld = apart->eyeFromWorld;
    }
    return camera;
}

QString PasteCameraDialog::meaning(const MatrixPaste::Camera &camera, bool &isUsable) const
{
    isUsable = false;
    if (isProduct() && m_paste.pasted(MatrixRole::Product) && !camera.isAnything())
        return tr("The product cannot be decomposed: it is not a perspective or orthographic projection times a view. "
                  "Paste projection and view.");
    if (!camera.isAnything())
        return {};
    Setup setup = m_document.setup();
    if (camera.projection)
        setup.lens = *camera.projection;
    if (camera.eyeFromWorld)
        setup.pose = *camera.eyeFromWorld;
    const Result<Setup> shown = byParameters(setup);
    if (!shown)
        return notACamera(shown.error());
    isUsable = true;
    QStringList said{cameraText(*shown, camera.projection)};
    if (isProduct())
        said << sentence(decompositionText(*m_paste.apart()));
    if (camera.viewport)
        said << tr("The viewport is set by glViewport: %1 × %2 at (%3, %4).")
                    .arg(writtenText(camera.viewport->width, 6), writtenText(camera.viewport->height, 6),
                         writtenText(camera.viewport->x, 6), writtenText(camera.viewport->y, 6));
    else if (const auto viewport = m_paste.viewport())
        said << tr("The viewport, %1 × %2, is ignored: the view keeps its own (Parameters, Viewport).")
                    .arg(writtenText(viewport->width, 6), writtenText(viewport->height, 6));
    return joinSentences(said);
}

void PasteCameraDialog::refresh()
{
    for (const MatrixRole role : kRoles) {
        box(role)->setVisible((role == MatrixRole::Product) == isProduct());
        box(role)->showPaste(m_paste);
    }
    bool isUsable = false;
    const QString text = meaning(camera(), isUsable);
    m_meaning->setText(text);
    // Errors in a text are not ignored.
    for (const MatrixRole role : kRoles) {
        if ((role == MatrixRole::Product) == isProduct() && m_paste.error(role))
            isUsable = false;
    }
    m_ok->setEnabled(isUsable);
    growToContent();
}

void PasteCameraDialog::growToContent()
{
    if (!isVisible())
        return;
    const QWidget *boxes = m_scrolled->widget();
    const QSize room = m_scrolled->viewport()->size();
    const int missing = boxes->layout()->totalHeightForWidth(room.width()) - room.height()
                        + m_meaning->heightForWidth(m_meaning->width()) - m_meaning->height();
    if (missing > 0)
        resize(width(), std::min(height() + missing, screen()->availableSize().height()));
}

void PasteCameraDialog::showEvent(QShowEvent *event)
{
    QDialog::showEvent(event);
    growToContent();
}

void PasteCameraDialog::accept()
{
    if (!m_ok->isEnabled())
        return;
    const MatrixPaste::Camera taken = camera();
    const Check done =
        editMatrices(m_document, taken.projection, taken.eyeFromWorld, {tr("Paste Matrices")}, taken.viewport);
    if (!done) {
        m_meaning->setText(notACamera(done.error()));
        return;
    }
    QDialog::accept();
}

} // namespace unprojector::gui
