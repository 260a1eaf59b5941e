#include "gui/shell/scene_code_window.h"

#include "core/base/replace_file.h"
#include "gui/document/overwriting.h"
#include "gui/document/scene_document.h"
#include "gui/document/session.h"
#include "gui/shell/window_questions.h"
#include "gui/text/error_text.h"
#include "gui/widgets/digits_font.h"
#include "gui/widgets/help_link.h"
#include "gui/widgets/plain_text_box.h"
#include "gui/widgets/save_name.h"
#include "gui/widgets/segmented_switch.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QScrollBar>
#include <QVBoxLayout>

#include <array>

namespace unprojector::gui {
using namespace scene_code;

namespace {

/// The dialects, in the order of the switch.
constexpr std::array kDialects{CodeDialect::Glu, CodeDialect::Glm, CodeDialect::Qt, CodeDialect::ThreeJs,
                               CodeDialect::NumPy};

} // namespace

SceneCodeWindow::SceneCodeWindow(const SceneDocument &document, const Session &session, QWidget *parent)
    : QDialog(parent), m_document(document), m_session(session), m_text(new PlainTextBox)
{
    setWindowTitle(tr("Scene as Code"));
    constexpr int kDigits = 118, kLines = 40;
    resize(QSize(kDigits * fontMetrics().horizontalAdvance(u'0'), kLines * fontMetrics().lineSpacing())
               .boundedTo(screen()->availableSize() * 9 / 10));
    m_dialects = new SegmentedSwitch(
        tr("Library"),
        {{tr("GLU and MFC"), tr("OpenGL's own calls and GLU's, with the paper's handlers for a view of MFC")},
         {QStringLiteral("GLM"), tr("C++ with GLM, in double precision")},
         {QStringLiteral("Qt"), tr("C++ with QMatrix4x4, in single precision")},
         {QStringLiteral("three.js"), tr("JavaScript with three.js")},
         {QStringLiteral("NumPy"),
          tr("Python with NumPy alone: the matrices, and a click by formula and by inverse")}});
    m_text->setReadOnly(true);
    m_text->setLineWrapMode(PlainTextBox::NoWrap);
    m_text->setFont(digitsFont(font()));
    m_text->setAccessibleName(tr("The scene's code"));
    // The text can be selected by the keyboard too.
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);

    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close | QDialogButtonBox::Help);
    QPushButton *copies = buttons->addButton(tr("&Copy"), QDialogButtonBox::ActionRole);
    copies->setToolTip(tr("Copy all of the code"));
    QPushButton *saves = buttons->addButton(tr("&Save…"), QDialogButtonBox::ActionRole);
    saves->setToolTip(tr("Write the code to a file"));

    auto *layout = new QVBoxLayout(this);
    layout->addWidget(m_dialects, 0, Qt::AlignLeft);
    layout->addWidget(m_text, 1);
    m_said = new QLabel;
    m_said->setTextFormat(Qt::PlainText);
    m_said->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto *below = new QHBoxLayout;
    below->addWidget(m_said, 1);
    below->addWidget(buttons);
    layout->addLayout(below);

    connect(m_dialects, &SegmentedSwitch::chosen, this, [this] {
        refresh();
        m_text->verticalScrollBar()->setValue(0);
        emit dialectChosen(dialect());
    });
    connect(&document, &SceneDocument::changed, this, [this](Changes changes) {
        if (isVisible() && changes & (kVisibleChanges | Change::Names))
            refresh();
    });
    connect(&session, &Session::changed, this, [this] {
        if (isVisible()) // paths of models are relative to the scene's file
            refresh();
    });
    connect(copies, &QPushButton::clicked, this, &SceneCodeWindow::copy);
    connect(saves, &QPushButton::clicked, this, &SceneCodeWindow::save);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::helpRequested, this,
            [] { openManual(QStringLiteral("conventions.md#a-scene-as-code")); });
}

CodeDialect SceneCodeWindow::dialect() const
{
    return kDialects.at(static_cast<std::size_t>(m_dialects->choice()));
}

void SceneCodeWindow::setDialect(CodeDialect dialect)
{
    for (std::size_t i = 0; i < kDialects.size(); ++i) {
        if (kDialects.at(i) == dialect)
            m_dialects->setChoice(static_cast<int>(i));
    }
}

QString SceneCodeWindow::code() const
{
    return QString::fromStdString(sceneCode(m_session.contents(), dialect()));
}

void SceneCodeWindow::refresh()
{
    const QString text = code();
    if (text == m_text->toPlainText())
        return;
    const int line = m_text->verticalScrollBar()->value(), column = m_text->horizontalScrollBar()->value();
    m_said->clear(); // the code has changed since it was saved
    m_text->setPlainText(text);
    m_text->verticalScrollBar()->setValue(line);
    m_text->horizontalScrollBar()->setValue(column);
}

void SceneCodeWindow::copy() const
{
    QGuiApplication::clipboard()->setText(code());
}

void SceneCodeWindow::save()
{
    const QString filter = dialect() == CodeDialect::ThreeJs ? tr("JavaScript (%1)").arg(QStringLiteral("*.js *.mjs"))
                           : dialect() == CodeDialect::NumPy
                               ? tr("Python (%1)").arg(QStringLiteral("*.py"))
                               : tr("C++ (%1)").arg(QStringLiteral("*.cpp *.cc *.cxx *.h *.hpp"));
    const std::filesystem::path file =
        askSaveName(*this, tr("Save Code"), {filter}, pathText(m_session.proposedName().stem()), FileKind::Code).file;
    if (file.empty())
        return;
    if (const QString problem = exportTo(file); !problem.isEmpty())
        warn(*this, tr("Save Code"), problem);
}

QString SceneCodeWindow::exportTo(const std::filesystem::path &file)
{
    m_said->clear();
    if (QString refusal = overwritingText(m_document, m_session, file); !refusal.isEmpty())
        return refusal;
    const base::Done written = base::replaceFile(file, code().toStdString());
    if (!written)
        return QStringLiteral("%1: %2").arg(pathText(file), QString::fromStdString(written.error().text));
    m_said->setText(tr("Saved: %1").arg(pathText(file.filename())));
    m_said->setToolTip(plainToolTip(pathText(file)));
    return {};
}

void SceneCodeWindow::showEvent(QShowEvent *event)
{
    refresh();
    QDialog::showEvent(event);
}

} // namespace unprojector::gui
