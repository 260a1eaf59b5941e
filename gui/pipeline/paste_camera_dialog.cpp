#include "gui/pipeline/paste_camera_dialog.h"

#include "core/base/utf8.h"
#include "core/geometry/error_text.h"
#include "gui/document/scene_document.h"
#include "gui/pipeline/paste_choices_form.h"
#include "gui/pipeline/paste_report.h"
#include "gui/text/error_text.h"
#include "gui/text/sentences.h"
#include "gui/widgets/digits_font.h"
#include "gui/widgets/file_dialogs.h"
#include "gui/widgets/plain_text_box.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QScreen>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace cameras;
using namespace pipeline;

namespace {

/// Returns whether a text can be shown and changed in a field.
bool isTypable(const NamedText &one)
{
    if (one.name.empty()) // it is there
        return true;
    constexpr std::size_t kMostBytes = 3; // of UTF-8 for a character
    const std::string &text = one.text;
    return text.size() <= kMostBytes * std::size_t(kMostPastedCharacters) && text.find('\0') == text.npos
           && base::firstNotUtf8(text) == text.npos && QString::fromStdString(text).size() <= kMostPastedCharacters;
}

std::vector<std::filesystem::path> localFiles(const QList<QUrl> &urls)
{
    std::vector<std::filesystem::path> files;
    for (const QUrl &url : urls) {
        if (url.isLocalFile())
            files.emplace_back(url.toLocalFile().toStdU16String());
    }
    return files;
}

bool isRead(const PastedCamera &camera)
{
    return camera.foreign || camera.projection || camera.eyeFromWorld;
}

/// Returns whether a text is another one with changes, not a new one.
bool isChanged(const std::string &before, const std::string &after)
{
    const auto front = std::mismatch(before.begin(), before.end(), after.begin(), after.end()).first - before.begin();
    const auto back =
        std::mismatch(before.rbegin(), before.rend(), after.rbegin(), after.rend()).first - before.rbegin();
    return 2 * std::size_t(front + back) >= std::max(before.size(), after.size());
}

} // namespace

PasteCameraDialog::PasteCameraDialog(SceneDocument &document, QWidget *parent) : QDialog(parent), m_document(document)
{
    setWindowTitle(tr("Paste Camera"));
    setAcceptDrops(true);
    m_text = new PlainTextBox;
    m_text->setMost(kMostPastedCharacters);
    m_text->setTakesFiles(true);
    m_text->setFont(digitsFont(font()));
    m_text->setTabChangesFocus(true);
    m_text->setAcceptDrops(false); // the dialog takes files
    m_text->setLineWrapMode(PlainTextBox::NoWrap);
    m_text->setAccessibleName(tr("Text with a camera"));
    m_text->setPlaceholderText(tr("Paste a camera as a program prints it:\n\n"
                                  "K, R and t, OpenCV's YAML, transforms.json …\n"
                                  "matrices: NumPy, Eigen, glm::to_string, JSON, C …\n"
                                  "calls: gluPerspective(45, 1.5, 0.1, 100)"));
    m_report = new QTextBrowser;
    m_report->setOpenLinks(false);
    m_report->setAccessibleName(tr("How the text is read"));
    m_report->document()->setDefaultStyleSheet(QStringLiteral(
        "h3 { margin-top: 8px; margin-bottom: 2px; font-size: medium; } p { margin-top: 2px; margin-bottom: 2px; } "
        "pre { margin-top: 4px; margin-bottom: 4px; } td { padding-right: 12px; }"));
    m_form = new PasteChoicesForm;
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    m_ok = buttons->button(QDialogButtonBox::Ok);
    m_ok->setToolTip(tr("Set the scene's camera from this text; Ctrl+Z undoes it"));

    auto *layout = new QVBoxLayout(this);
    layout->addLayout(createHead());
    layout->addWidget(m_text, 2);
    layout->addWidget(m_report, 3);
    layout->addWidget(m_form);
    layout->addWidget(buttons);

    connect(m_text, &PlainTextBox::textChanged, this, [this] {
        const QString text = m_text->toPlainText();
        take(text.trimmed().isEmpty() ? std::vector<NamedText>() : std::vector<NamedText>{{{}, text.toStdString()}});
    });
    connect(m_text, &PlainTextBox::refused, this, [this](qsizetype characters) {
        refuse(tr("The text has %1 characters; at most %2 can be pasted. Save it as a file, and open that.")
                   .arg(characters)
                   .arg(kMostPastedCharacters));
    });
    connect(m_text, &PlainTextBox::filesPasted, this, [this](const QList<QUrl> &urls) { readFiles(localFiles(urls)); });
    connect(m_report, &QTextBrowser::anchorClicked, this, &PasteCameraDialog::follow);
    connect(m_form, &PasteChoicesForm::choicesChanged, this, &PasteCameraDialog::refresh);
    connect(buttons, &QDialogButtonBox::accepted, this, &PasteCameraDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &PasteCameraDialog::reject);
    // Queued: all others see the scene's own change first.
    connect(
        &m_document, &SceneDocument::changed, this,
        [this](Changes changes) {
            if (isVisible() && (changes & kVisibleChanges))
                refresh();
        },
        Qt::QueuedConnection);
    placeBeside(parent);
    m_text->setFocus();
    take({});
}

/// Narrow and at the window's right edge, so that the view is seen.
void PasteCameraDialog::placeBeside(const QWidget *parent)
{
    constexpr int kDigits = 66, kLines = 46, kMostPixels = 780; // of the height: the screen may have 800
    const QRect window = parent ? parent->window()->frameGeometry() : screen()->availableGeometry();
    const QSize wanted(kDigits * fontMetrics().horizontalAdvance(u'0'),
                       std::min(kLines * fontMetrics().lineSpacing(), kMostPixels));
    resize(wanted.boundedTo(screen()->availableSize() * 0.9));
    const QRect room = screen()->availableGeometry();
    const int x = std::min(window.right(), room.right()) - width(),
              y = std::min(window.center().y() - height() / 2, room.bottom() - height());
    move(std::max(x, room.left()), std::max(y, room.top()));
}

QHBoxLayout *PasteCameraDialog::createHead()
{
    m_fileNames = new QLabel;
    m_fileNames->setTextFormat(Qt::PlainText);
    m_fileNames->setWordWrap(true);
    m_fileNames->setAccessibleName(tr("Files of the camera"));
    m_dropsFiles = new QPushButton(tr("&Type instead"));
    m_dropsFiles->setToolTip(tr("Forget the files and read pasted texts again"));
    m_dropsFiles->setAutoDefault(false);
    auto *open = new QPushButton(tr("Open &File…"));
    open->setToolTip(tr("Read a camera's file, or several that belong together (COLMAP). Files can be dropped here"));
    open->setAutoDefault(false);
    auto *head = new QHBoxLayout;
    head->addWidget(open);
    head->addWidget(m_fileNames, 1);
    head->addWidget(m_dropsFiles);
    head->addStretch(0);
    connect(m_dropsFiles, &QPushButton::clicked, this, [this] {
        take({});
        m_text->setFocus();
    });
    connect(open, &QPushButton::clicked, this, &PasteCameraDialog::askForFiles);
    return head;
}

void PasteCameraDialog::open(SceneDocument &document, QWidget *parent, const QString &text)
{
    auto *dialog = new PasteCameraDialog(document, parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setText(text);
    dialog->QDialog::open();
}

void PasteCameraDialog::open(SceneDocument &document, QWidget *parent)
{
    const QMimeData *data = QGuiApplication::clipboard()->mimeData();
    if (const auto files = localFiles(data ? data->urls() : QList<QUrl>()); !files.empty()) {
        auto *dialog = new PasteCameraDialog(document, parent);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->readFiles(files);
        if (!isRead(dialog->m_camera)) // they were copied for something else
            dialog->take({});
        dialog->QDialog::open();
        return;
    }
    const QString text = QGuiApplication::clipboard()->text();
    const NamedText copied{{}, text.size() <= kMostPastedCharacters ? text.toStdString() : std::string()};
    const PastedCamera camera = pastedCamera({&copied, 1}, {}, std::nullopt);
    open(document, parent, isRead(camera) ? text : QString());
}

void PasteCameraDialog::setText(const QString &text)
{
    m_text->setText(text);
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
            refuse(file.isOpen() ? tr("%1 is larger than 256 MiB: it is no camera's file.").arg(pathText(path))
                                 : tr("%1 cannot be read: %2.").arg(pathText(path), file.errorString()));
            return;
        }
        texts.push_back({pathText(path.filename()).toStdString(), base::utf8FromFile(file.readAll().toStdString())});
    }
    take(withEarlier(std::move(texts)));
}

std::vector<NamedText> PasteCameraDialog::withEarlier(std::vector<NamedText> texts) const
{
    const auto isCamera = [](const std::vector<NamedText> &all) { return isRead(pastedCamera(all, {}, std::nullopt)); };
    if (m_texts.empty() || m_texts.front().name.empty() || isCamera(m_texts) || isCamera(texts))
        return texts;
    std::vector<NamedText> all = m_texts;
    all.insert(all.end(), texts.begin(), texts.end());
    return isCamera(all) ? all : texts;
}

void PasteCameraDialog::take(std::vector<NamedText> texts)
{
    // The choices about a camera last while its text is changed.
    if (m_texts.size() == 1 && texts.size() == 1 && isChanged(m_texts.front().text, texts.front().text))
        m_form->forgetText();
    else
        m_form->forgetAll();
    m_corrections.clear();
    m_texts = std::move(texts);
    const bool isTyped = m_texts.empty() || (m_texts.size() == 1 && isTypable(m_texts.front()));
    const bool isFile = !m_texts.empty() && !m_texts.front().name.empty();
    if (isFile || m_texts.empty()) {
        const QSignalBlocker blocker(m_text);
        m_text->setPlainText(isTyped && isFile ? QString::fromStdString(m_texts.front().text) : QString());
    }
    QStringList names;
    for (const NamedText &one : m_texts)
        names << QString::fromStdString(one.name);
    m_fileNames->setText(names.join(isTyped ? QStringLiteral(", ") : QStringLiteral("\n")));
    m_fileNames->setVisible(isFile);
    m_text->setVisible(isTyped);
    m_dropsFiles->setVisible(!isTyped);
    refresh();
}

GivenCamera PasteCameraDialog::given() const
{
    GivenCamera given{m_camera.projection, m_camera.eyeFromWorld};
    if (m_camera.isViewportSet)
        given.viewport = m_camera.viewport;
    if (m_camera.scene && m_form->isSizeWanted())
        given.size = Surface{m_camera.scene->size.width, m_camera.scene->size.height, 1.0};
    return given;
}

void PasteCameraDialog::refresh()
{
    PasteChoices choices = m_form->choices();
    choices.corrections = m_corrections;
    const bool hasObjects = !m_document.objects().empty();
    m_camera = m_texts.empty()
                   ? PastedCamera()
                   : pastedCamera(m_texts, choices, hasObjects ? std::optional(m_document.bounds()) : std::nullopt);
    m_form->showCamera(m_camera);
    QString fault = m_form->fault();
    if (fault.isEmpty() && m_camera.scene && m_camera.scene->distortion)
        fault =
            tr("The view cannot draw the camera's distortion. If your pixels are of the undistorted image, tick the "
               "box. Else undistort the image first, then tick the box.");
    const bool isCamera = m_camera.projection || m_camera.eyeFromWorld || m_camera.isViewportSet;
    bool isShown = isCamera && fault.isEmpty() && !m_camera.fault;
    if (isShown) {
        Check shown = std::monostate{};
        if (const auto settings = withCamera(m_document.ownScene(), m_document.ownSetup(), given()))
            shown = m_document.preview(*settings);
        else
            shown = settings.error();
        isShown = shown.hasValue();
        if (!isShown)
            fault = tr("Not a camera: %1").arg(ended(geometry::errorText(shown.error())));
    }
    if (!isShown)
        m_document.endPreview();
    showReport(fault, isShown);
}

void PasteCameraDialog::showReport(const QString &fault, bool isShown)
{
    ShownPaste shown{m_camera};
    shown.fault = fault;
    if (isShown)
        shown.setup = m_document.setup();
    if (!m_document.objects().empty())
        shown.objects = m_document.bounds();
    shown.size = given().size;
    shown.isBlenders = m_text->toPlainText().contains(QStringLiteral("<Matrix 4x4"));
    shown.isCorrected = !m_corrections.empty();
    shown.refusal = m_refusal;
    const int top = m_report->verticalScrollBar()->value();
    m_report->setHtml(QString::fromStdString(report::asHtml(pasteReport(shown))));
    m_report->verticalScrollBar()->setValue(top);
    m_ok->setEnabled(isShown);
}

void PasteCameraDialog::refuse(const QString &reason)
{
    m_refusal = reason;
    refresh();
    m_refusal.clear();
    m_report->verticalScrollBar()->setValue(0);
}

void PasteCameraDialog::follow(const QUrl &link)
{
    const QStringList words = link.toString().split(u':');
    const auto number = [&words](qsizetype i) { return std::size_t(words.value(i).toUInt()); };
    if (words[0] == QLatin1String(kDirection)) {
        m_form->chooseDirection(static_cast<PoseDirection>(number(1)));
        return;
    }
    if (words[0] == QLatin1String(kAsPasted)) {
        m_corrections.clear();
        m_form->forgetText();
    } else {
        const ReadMatrix &one = m_camera.matrices.at(number(1));
        m_corrections.push_back({one.role, one.findings.at(number(2))});
    }
    refresh();
}

void PasteCameraDialog::dragEnterEvent(QDragEnterEvent *event)
{
    if (event->mimeData()->hasUrls())
        event->acceptProposedAction();
}

void PasteCameraDialog::dropEvent(QDropEvent *event)
{
    const auto files = localFiles(event->mimeData()->urls());
    if (files.empty())
        return;
    event->acceptProposedAction();
    readFiles(files);
}

void PasteCameraDialog::accept()
{
    if (!m_ok->isEnabled())
        return;
    m_document.endPreview();
    if (const Check done = editCamera(m_document, given(), {tr("Paste Camera")}); !done) {
        showReport(tr("Not a camera: %1").arg(ended(geometry::errorText(done.error()))), false);
        return;
    }
    QDialog::accept();
}

void PasteCameraDialog::done(int result)
{
    m_document.endPreview();
    QDialog::done(result);
}

} // namespace unprojector::gui
