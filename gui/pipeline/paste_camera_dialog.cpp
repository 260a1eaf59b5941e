#include "gui/pipeline/paste_camera_dialog.h"

#include "core/base/utf8.h"
#include "core/cameras/seen_objects.h"
#include "core/geometry/error_text.h"
#include "core/pipeline/matrix_format.h"
#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"
#include "gui/pipeline/foreign_camera_box.h"
#include "gui/pipeline/matrix_text.h"
#include "gui/pipeline/pasted_matrix_box.h"
#include "gui/text/error_text.h"
#include "gui/text/number_text.h"
#include "gui/text/sentences.h"
#include "gui/widgets/file_dialogs.h"
#include "gui/widgets/plain_text_box.h"
#include "gui/widgets/segmented_switch.h"

#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace cameras;
using namespace pipeline;

namespace {

constexpr std::array kRoles{MatrixRole::Projection, MatrixRole::View, MatrixRole::Product};

QString notACamera(const Error &error)
{
    return PasteCameraDialog::tr("Not a camera: %1").arg(ended(geometry::errorText(error)));
}

} // namespace

PasteCameraDialog::PasteCameraDialog(SceneDocument &document, QWidget *parent)
    : QDialog(parent), m_document(document), m_foreign(new ForeignCameraBox)
{
    setWindowTitle(tr("Paste Camera"));
    setAcceptDrops(true);
    auto *boxes = new QWidget;
    auto *columns = new QHBoxLayout(boxes);
    columns->setContentsMargins(0, 0, 0, 0);
    m_texts = new QBoxLayout(QBoxLayout::LeftToRight);
    for (QBoxLayout *layout : {static_cast<QBoxLayout *>(columns), m_texts})
        layout->setSpacing(2 * fontMetrics().horizontalAdvance(u'0'));
    columns->addLayout(m_texts, 1);
    for (const MatrixRole role : kRoles) {
        m_boxes[std::size_t(role)] = new PastedMatrixBox(role);
        m_texts->addWidget(box(role), 1);
        connectBox(role);
    }
    columns->addWidget(m_foreign, 1);
    connect(m_foreign, &ForeignCameraBox::choicesChanged, this, &PasteCameraDialog::refresh);
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
    m_meaning->setAccessibleName(tr("Meaning of the camera"));
    constexpr int kLines = 3;
    m_meaning->setMinimumHeight(kLines * fontMetrics().lineSpacing());
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    m_ok = buttons->button(QDialogButtonBox::Ok);
    m_ok->setToolTip(tr("Set the scene's camera from these texts; Ctrl+Z undoes it"));
    connect(buttons, &QDialogButtonBox::accepted, this, &PasteCameraDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &PasteCameraDialog::reject);

    auto *layout = new QVBoxLayout(this);
    layout->addLayout(createHead());
    layout->addWidget(m_scrolled, 1);
    layout->addWidget(m_meaning);
    layout->addWidget(buttons);
    constexpr int kDigits = 110, kHeight = 34;
    const QSize wanted(kDigits * fontMetrics().horizontalAdvance(u'0'), kHeight * fontMetrics().lineSpacing());
    resize(wanted.boundedTo(screen()->availableSize()));
    refresh();
}

QHBoxLayout *PasteCameraDialog::createHead()
{
    m_kind = new SegmentedSwitch(
        tr("Pasted matrices"),
        {{tr("Camera, or projection and view"),
          tr("A program's camera, or the two matrices, or one of them; the scene keeps the other")},
         {tr("Product"), tr("Projection times view, or times modelview (MVP), decomposed into the two")}});
    m_fileNames = new QLabel;
    m_fileNames->setTextFormat(Qt::PlainText);
    m_fileNames->setAccessibleName(tr("Files of the camera"));
    m_dropsFiles = new QPushButton(tr("&Type instead"));
    m_dropsFiles->setToolTip(tr("Forget the files and read pasted texts again"));
    m_dropsFiles->setAutoDefault(false);
    auto *open = new QPushButton(tr("Open &File…"));
    open->setToolTip(tr("Read a camera's file, or several that belong together (COLMAP). Files can be dropped here"));
    open->setAutoDefault(false);
    auto *head = new QHBoxLayout;
    head->addWidget(m_kind);
    head->addWidget(m_fileNames, 1);
    head->addWidget(m_dropsFiles);
    head->addStretch();
    head->addWidget(open);
    connect(m_kind, &SegmentedSwitch::chosen, this, &PasteCameraDialog::refresh);
    connect(m_dropsFiles, &QPushButton::clicked, this, &PasteCameraDialog::dropFiles);
    connect(open, &QPushButton::clicked, this, &PasteCameraDialog::askForFiles);
    return head;
}

void PasteCameraDialog::connectBox(MatrixRole role)
{
    connect(box(role), &PastedMatrixBox::textChanged, this, [this, role](const QString &text) {
        m_paste.setText(role, text.toStdString());
        refresh();
    });
    connect(box(role), &PastedMatrixBox::textRefused, this, [this](qsizetype characters) {
        m_meaning->setText(tr("The text has %1 characters; at most %2 can be pasted. Save it as a file, and make a "
                              "scene of it by the command “unproject scene FILE”.")
                               .arg(characters)
                               .arg(kMostPastedCharacters));
    });
    connect(box(role), &PastedMatrixBox::orderChosen, this, [this, role](NumberOrder order) {
        m_paste.setOrder(role, order);
        refresh();
    });
    connect(box(role), &PastedMatrixBox::ndcDepthChosen, this, [this, role](const std::optional<NdcDepth> &depth) {
        m_paste.setNdcDepth(role, depth);
        refresh();
    });
    connect(box(role), &PastedMatrixBox::asPastedWanted, this, [this, role] {
        m_paste.takeBack(role);
        refresh();
    });
    connect(box(role), &PastedMatrixBox::moveWanted, this, [this, role] { moveText(role); });
    connect(box(role), &PastedMatrixBox::repairWanted, this,
            [this, role](const MatrixFinding &finding) { repair(role, finding); });
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

void PasteCameraDialog::askForFiles()
{
    const auto files = askFileNames(*this, FileKind::Camera, tr("Open a Camera"), tr("All files (*)"));
    if (!files.empty())
        readFiles(files);
}

void PasteCameraDialog::readFiles(const std::vector<std::filesystem::path> &files)
{
    std::vector<NamedText> texts;
    for (const std::filesystem::path &path : files) {
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly) || file.size() > qint64(kMostCameraBytes)) {
            m_meaning->setText(file.isOpen()
                                   ? tr("%1 is larger than 256 MiB: it is no camera's file.").arg(pathText(path))
                                   : tr("%1 cannot be read: %2.").arg(pathText(path), file.errorString()));
            m_ok->setEnabled(false);
            return;
        }
        texts.push_back({pathText(path.filename()).toStdString(), base::utf8FromFile(file.readAll().toStdString())});
    }
    m_kind->setChoice(0);
    m_files = withEarlier(std::move(texts));
    readForeign();
    if (!isForeign() && m_files.size() == 1) {
        const QString text = QString::fromStdString(m_files.front().text);
        m_files.clear();
        refresh();
        setText(MatrixRole::Projection, text);
        return;
    }
    refresh();
}

std::vector<NamedText> PasteCameraDialog::withEarlier(std::vector<NamedText> texts) const
{
    const auto isCamera = [](const std::vector<NamedText> &all) {
        const auto camera = readCamera(all, {});
        return camera && *camera;
    };
    if (m_files.empty() || isCamera(m_files) || isCamera(texts))
        return texts;
    std::vector<NamedText> all = m_files;
    all.insert(all.end(), texts.begin(), texts.end());
    return isCamera(all) ? all : texts;
}

void PasteCameraDialog::dropFiles()
{
    m_files.clear();
    refresh();
    box(MatrixRole::Projection)->setFocus();
}

std::vector<NamedText> PasteCameraDialog::cameraTexts() const
{
    if (!m_files.empty() || isProduct())
        return m_files;
    std::vector<NamedText> texts;
    for (const MatrixRole role : {MatrixRole::Projection, MatrixRole::View}) {
        if (const QString text = box(role)->text(); !text.trimmed().isEmpty())
            texts.push_back({{}, text.toStdString()});
    }
    return texts;
}

void PasteCameraDialog::readForeign()
{
    std::vector<NamedText> texts = cameraTexts();
    // A camera may be divided between the fields, as Unity's two matrices.
    if (m_files.empty() && texts.size() == 2 && !readCamera(texts, {}))
        texts = {{{}, texts[0].text + '\n' + texts[1].text}};
    const bool hasObjects = !m_document.objects().empty();
    m_foreign->read(texts, hasObjects ? std::optional(m_document.bounds()) : std::nullopt);
}

bool PasteCameraDialog::isForeign() const
{
    const auto &camera = m_foreign->camera();
    if (!camera)
        return false;
    // Matrices that can be read count more than a camera that cannot. A camera that is read may
    // still lack its image's size.
    const bool haveMatrices = m_files.empty() && m_paste.camera().isAnything() && !m_paste.error(MatrixRole::Projection)
                              && !m_paste.error(MatrixRole::View);
    return m_foreign->isRead() || !haveMatrices;
}

std::optional<Surface> PasteCameraDialog::viewSize() const
{
    if (!isForeign() || !*m_foreign->camera() || !m_foreign->isSizeWanted())
        return std::nullopt;
    const ImageSize size = (*m_foreign->camera())->size;
    return Surface{size.width, size.height, 1.0};
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
    if (isForeign()) {
        MatrixPaste::Camera camera;
        if (const auto &foreign = *m_foreign->camera()) {
            camera.projection = foreign->projection;
            camera.eyeFromWorld = foreign->eyeFromWorld;
        }
        return camera;
    }
    if (!isProduct())
        return m_paste.camera();
    MatrixPaste::Camera camera;
    if (const auto apart = m_paste.apart()) {
        camera.projection = MatrixProjection{apart->clipFromEye, m_paste.ndcDepth(MatrixRole::Product)};
        camera.eyeFromWorld = apart->eyeFromWorld;
    }
    return camera;
}

QString PasteCameraDialog::emptyText(const Setup &setup) const
{
    const auto view = eyeFromWorld(setup);
    if (m_document.objects().empty() || !view)
        return {};
    const DepthExtent depths = depthExtent(*view, m_document.bounds());
    const ProjectionWindow w = projectionWindow(setup.projection());
    const bool isEmpty = depths.farthest > 0.0
                         && (depths.farthest <= std::min(w.nearDistance, w.farDistance)
                             || depths.nearest >= std::max(w.nearDistance, w.farDistance));
    return isEmpty ? tr("Nothing will be seen: the objects are %1 to %2 in front of the eye, not between near and far.")
                         .arg(writtenText(depths.nearest, 4), writtenText(depths.farthest, 4))
                   : QString();
}

QString PasteCameraDialog::meaning(const MatrixPaste::Camera &camera, bool &isUsable) const
{
    isUsable = false;
    if (isForeign() && !m_foreign->fault().isEmpty())
        return m_foreign->fault();
    if (!m_files.empty() && !isForeign())
        return tr("These files have no camera of a program that is known here. Open cameras.txt and images.txt of "
                  "COLMAP together, or paste the camera's numbers.");
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
    QStringList said{cameraText(*shown, camera.projection), emptyText(*shown)};
    if (const auto size = viewSize())
        said << tr("The view gets the image's size, %1 × %2.").arg(size->widthPixels).arg(size->heightPixels);
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
    readForeign();
    const bool isHalf = isForeign() && cameraTexts().size() == 2;
    m_texts->setDirection(isForeign() ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    for (const MatrixRole role : kRoles) {
        const bool isOfKind = (role == MatrixRole::Product) == isProduct() && m_files.empty();
        const bool isSecond = isForeign() && role == MatrixRole::View && box(role)->text().trimmed().isEmpty();
        box(role)->setVisible(isOfKind && !isSecond);
        if (isForeign())
            box(role)->showTextOnly(isHalf);
        else
            box(role)->showMatrix();
        box(role)->showPaste(m_paste);
    }
    m_foreign->setVisible(isForeign());
    QStringList names;
    for (const NamedText &file : m_files)
        names << QString::fromStdString(file.name);
    m_fileNames->setText(names.join(QStringLiteral(", ")));
    m_fileNames->setVisible(!m_files.empty());
    m_dropsFiles->setVisible(!m_files.empty());
    bool isUsable = false;
    const QString text = meaning(camera(), isUsable);
    m_meaning->setText(text);
    // Errors in a text are not ignored.
    for (const MatrixRole role : kRoles) {
        if (!isForeign() && (role == MatrixRole::Product) == isProduct() && m_paste.error(role))
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

void PasteCameraDialog::dragEnterEvent(QDragEnterEvent *event)
{
    if (event->mimeData()->hasUrls())
        event->acceptProposedAction();
}

void PasteCameraDialog::dropEvent(QDropEvent *event)
{
    std::vector<std::filesystem::path> files;
    for (const QUrl &url : event->mimeData()->urls()) {
        if (url.isLocalFile())
            files.emplace_back(url.toLocalFile().toStdU16String());
    }
    if (files.empty())
        return;
    event->acceptProposedAction();
    readFiles(files);
}

void PasteCameraDialog::accept()
{
    if (!m_ok->isEnabled())
        return;
    const MatrixPaste::Camera taken = camera();
    const Check done = editMatrices(m_document, taken.projection, taken.eyeFromWorld, {tr("Paste Camera")},
                                    taken.viewport, viewSize());
    if (!done) {
        m_meaning->setText(notACamera(done.error()));
        return;
    }
    QDialog::accept();
}

} // namespace unprojector::gui
