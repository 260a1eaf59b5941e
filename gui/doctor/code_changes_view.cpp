#include "gui/doctor/code_changes_view.h"

#include "core/doctor/mistakes.h"
#include "core/doctor/report_text.h"
#include "gui/widgets/contrast.h"
#include "gui/widgets/copy_menu.h"
#include "gui/widgets/digits_font.h"
#include "gui/widgets/segmented_switch.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <span>

namespace unprojector::gui {
namespace {

constexpr std::array<const char *, 5> kLibraries{"GLU", "GLM", "Qt", "three.js", "NumPy"};

// Marked by signs, and by orange and blue, which the colour-blind distinguish too.
constexpr QColor kWrongColor(0xd5, 0x5e, 0x00), kRightColor(0x00, 0x72, 0xb2);
constexpr double kShareOfColor = 0.22;

QString lineOf(const QString &sign, const QString &code, const QColor &color, const QPalette &palette)
{
    const QColor ground = mixed(palette.color(QPalette::Base), color, kShareOfColor);
    return QStringLiteral(
               "<tr><td style='background:%1; padding:2px 4px'><b>%2</b></td><td style='background:%1; padding:2px "
               "4px'>%3</td></tr>")
        .arg(ground.name(), sign, code.toHtmlEscaped());
}

/// The number of a candidate's mistakes that a library has lines for.
int mistakesWithLines(const std::string &id, std::span<const doctor::SolvedValue> values, std::string_view library)
{
    int count = 0;
    for (const std::string &part : doctor::partsOf(id)) {
        const auto code = doctor::codeOf(part, values);
        count += std::any_of(code.begin(), code.end(), [library](const auto &line) { return line.library == library; });
    }
    return count;
}

} // namespace

CodeChangesView::CodeChangesView(QWidget *parent)
    : QWidget(parent), m_title(new QLabel), m_copy(new QPushButton(tr("Copy these &lines"))), m_lines(new QLabel)
{
    QList<SegmentedSwitch::Choice> choices;
    for (const char *library : kLibraries)
        choices << SegmentedSwitch::Choice{QLatin1String(library), tr("Lines for %1").arg(QLatin1String(library))};
    m_library = new SegmentedSwitch(tr("Library"), choices);
    m_title->setWordWrap(true);
    m_title->setTextFormat(Qt::PlainText);
    m_lines->setTextFormat(Qt::RichText);
    m_lines->setWordWrap(true);
    m_lines->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_lines->setAccessibleName(tr("Code to change"));
    m_lines->setFont(digitsFont(font()));
    m_copy->setToolTip(tr("Copy the lines before and after the change"));
    auto *tools = new QHBoxLayout;
    tools->addWidget(m_library);
    tools->addStretch();
    tools->addWidget(m_copy);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_title);
    layout->addLayout(tools);
    layout->addWidget(m_lines);
    connect(m_library, &SegmentedSwitch::chosen, this, [this](int index) {
        m_chosen = index;
        showLines();
    });
    connect(m_copy, &QPushButton::clicked, this, [this] { copyToClipboard(m_text); });
    hide();
}

void CodeChangesView::setMistake(const std::string &id, const std::vector<doctor::SolvedValue> &values)
{
    m_id = id;
    m_values = values;
    showLibrary();
    showLines();
    setVisible(!m_id.empty());
}

QString CodeChangesView::library() const
{
    return QLatin1String(kLibraries[static_cast<std::size_t>(m_library->choice())]);
}

QString CodeChangesView::chosenLibrary() const
{
    return QLatin1String(kLibraries[static_cast<std::size_t>(m_chosen)]);
}

void CodeChangesView::setLibrary(const QString &library)
{
    for (std::size_t i = 0; i < kLibraries.size(); ++i) {
        if (library == QLatin1String(kLibraries[i]))
            m_chosen = static_cast<int>(i);
    }
    showLibrary();
    showLines();
}

void CodeChangesView::showLibrary()
{
    std::array<int, kLibraries.size()> counts{};
    for (std::size_t i = 0; i < kLibraries.size(); ++i)
        counts[i] = mistakesWithLines(m_id, m_values, kLibraries[i]);
    const auto most = std::max_element(counts.begin(), counts.end());
    const auto chosen = static_cast<std::size_t>(m_chosen);
    const QSignalBlocker blocker(m_library); // this is not the user's choice
    for (std::size_t i = 0; i < kLibraries.size(); ++i)
        m_library->setChoiceEnabled(static_cast<int>(i), counts[i] > 0 || *most == 0);
    m_library->setChoice(counts[chosen] == *most ? m_chosen : static_cast<int>(most - counts.begin()));
}

void CodeChangesView::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange)
        m_lines->setFont(digitsFont(font()));
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        showLines();
}

void CodeChangesView::showLines()
{
    m_text.clear();
    QString rows;
    const QStringList parts = QString::fromStdString(m_id).split(u'+', Qt::SkipEmptyParts);
    for (const QString &part : parts) {
        bool hasLine = false;
        for (const doctor::CodeChange &change : doctor::codeOf(part.toStdString(), m_values)) {
            if (library() != QString::fromStdString(change.library))
                continue;
            hasLine = true;
            const QString wrong = QString::fromStdString(change.wrong), right = QString::fromStdString(change.right);
            rows += lineOf(QStringLiteral("−"), wrong, kWrongColor, palette())
                    + lineOf(QStringLiteral("+"), right, kRightColor, palette());
            m_text += QStringLiteral("- %1\n+ %2\n").arg(wrong, right);
        }
        if (!hasLine)
            rows +=
                QStringLiteral("<tr><td></td><td>%1</td></tr>")
                    .arg(tr("%1: no line of this library causes it. Choose another library to see the line that does.")
                             .arg(QString::fromStdString(doctor::mistakeName(part.toStdString())))
                             .toHtmlEscaped());
    }
    QString title = tr("To change: %1").arg(QString::fromStdString(doctor::mistakeName(m_id)));
    if (parts.size() == 2)
        title += u'\n'
                 + QString::fromStdString(doctor::twoChangesSentence(doctor::mistakeName(parts[0].toStdString()),
                                                                     doctor::mistakeName(parts[1].toStdString())));
    m_title->setText(title);
    m_lines->setText(QStringLiteral("<table width='100%' cellspacing='2'>%1</table>").arg(rows));
    m_copy->setEnabled(!m_text.isEmpty());
}

} // namespace unprojector::gui
