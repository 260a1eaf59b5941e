#include "gui/doctor/diagnosis_view.h"

#include "core/doctor/report_text.h"
#include "gui/text/doctor_text.h"
#include "gui/text/number_text.h"
#include "gui/widgets/contrast.h"

#include <QEvent>
#include <QFontInfo>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace unprojector::gui {
using namespace doctor;

DiagnosisView::DiagnosisView(QWidget *parent)
    : QWidget(parent), m_verdict(new QLabel), m_facts(new QLabel), m_click(new QPushButton)
{
    m_verdict->setWordWrap(true);
    m_verdict->setTextFormat(Qt::PlainText);
    m_verdict->setAccessibleName(tr("Verdict"));
    m_facts->setWordWrap(true);
    m_facts->setTextFormat(Qt::RichText);
    m_facts->setAccessibleName(tr("Evidence"));
    for (QLabel *label : {m_verdict, m_facts})
        label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_layout = new QVBoxLayout(this);
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(6);
    m_layout->addWidget(m_verdict);
    m_layout->addWidget(m_click, 0, Qt::AlignLeft);
    m_layout->addWidget(m_facts);
    connect(m_click, &QPushButton::clicked, this, [this] {
        if (m_shown && m_shown->diagnosis.next)
            emit clickRequested(*m_shown->diagnosis.next);
    });
    setMessage({});
}

void DiagnosisView::setBelowVerdict(QWidget *widget)
{
    m_below = widget;
    m_layout->insertWidget(1, widget);
}

void DiagnosisView::placeClick(bool isOfSeveral)
{
    m_layout->removeWidget(m_click);
    const int first = m_layout->indexOf(m_verdict) + 1;
    m_layout->insertWidget(isOfSeveral || !m_below ? first : first + 1, m_click, 0, Qt::AlignLeft);
}

void DiagnosisView::setMessage(const QString &text)
{
    m_shown.reset();
    m_text = text;
    m_verdict->setText(text);
    m_verdict->setFont(QFont()); // the window's font
    m_facts->hide();
    m_click->hide();
}

void DiagnosisView::setDiagnosis(const Diagnosis &diagnosis, const WrongPoint &first)
{
    m_shown = {diagnosis, first};
    enlargeVerdict();
    showAnswer(*m_shown);
}

void DiagnosisView::enlargeVerdict()
{
    constexpr double kVerdictScale = 1.25;
    QFont large = font();
    // The font's own size is −1 where it is set in pixels.
    large.setPointSizeF(QFontInfo(large).pointSizeF() * kVerdictScale);
    large.setBold(true);
    m_verdict->setFont(large);
}

QString DiagnosisView::text() const
{
    return m_text;
}

QString DiagnosisView::gotMarkup(const Shown &shown) const
{
    const QPalette &colors = palette();
    const QColor quiet = quietInk(colors.color(QPalette::WindowText), colors.color(QPalette::Window));
    const Candidate &best = shown.diagnosis.candidates.front();
    QStringList coordinates;
    for (int axis = 0; axis < 3; ++axis) {
        const double got = shown.first.got[axis], digit = shown.first.lastDigit[axis];
        const QString text = coordinateText(got, digit);
        const qsizetype explained = explainedLength(got, digit, best.digitsOfFirst[static_cast<std::size_t>(axis)]);
        coordinates << QStringLiteral("<b>%1</b><span style='color:%2'>%3</span>")
                           .arg(text.left(explained), quiet.name(), text.mid(explained));
    }
    return coordinates.join(QStringLiteral("&nbsp; "));
}

void DiagnosisView::showAnswer(const Shown &shown)
{
    const Diagnosis &diagnosis = shown.diagnosis;
    const Candidate &best = diagnosis.candidates.front();
    m_text = verdictText(diagnosis) + u'\n';
    QString rows;
    const auto add = [&](const QString &name, const QString &markup, const QString &plain) {
        rows += QStringLiteral("<tr><td style='padding-right:8px'>%1</td><td>%2</td></tr>")
                    .arg(name.toHtmlEscaped(), markup);
        m_text += name + u' ' + plain + u'\n';
    };
    const auto addPlain = [&](const QString &name, const QString &plain) { add(name, plain.toHtmlEscaped(), plain); };
    const QString explained = QString::fromStdString(digitsText(best, diagnosis));
    const QString bestName = QString::fromStdString(candidateName(best));
    // Close candidates are no evidence if the wrong point is a known point of the scene.
    const bool isKnown = diagnosis.verdict == "known-point";
    if (!isKnown)
        add(best.explains ? tr("Explains") : tr("Closest"),
            gotMarkup(shown) + QStringLiteral("<br>")
                + tr("%1: %2", "a mistake: how many digits it explains").arg(bestName.toHtmlEscaped(), explained),
            pointText(shown.first.got, shown.first.lastDigit) + QStringLiteral(", ")
                + tr("%1: %2", "a mistake: how many digits it explains").arg(bestName, explained));
    const auto addCandidate = [&](const QString &name, const Candidate &candidate) {
        addPlain(name, tr("%1: %2, %3", "runner-up: its answer, how many digits it explains")
                           .arg(QString::fromStdString(candidateName(candidate)),
                                pointText(candidate.point, shown.first.lastDigit),
                                QString::fromStdString(digitsText(candidate, diagnosis))));
    };
    const std::vector<Candidate> asWell = diagnosis.asWell();
    for (const Candidate &each : asWell)
        addCandidate(tr("As well"), each);
    if (const Candidate *next = isKnown ? nullptr : diagnosis.runnerUp())
        addCandidate(tr("Next best"), *next);
    if (!diagnosis.known.empty() && diagnosis.namesMistake())
        addPlain(tr("Is also"), QString::fromStdString(knownPointName(diagnosis.known)));
    if (best.explains && best.id != "right" && !isKnown)
        addPlain(tr("Chance"), QString::fromStdString(chanceText(diagnosis.chance)));
    addPlain(tr("Projects"), QString::fromStdString(projectedText(diagnosis)));
    if (diagnosis.right)
        addPlain(tr("Right is"), pointText(*diagnosis.right, glm::dvec3(diagnosis.rightLastDigit)));
    if (diagnosis.depthKnown == DepthKnown::FromMesh)
        addPlain(tr("Depth"), tr("from the mesh under the pixel"));
    if (diagnosis.isSinglePrecision)
        addPlain(tr("Digits"), QString::fromStdString(precisionSentence()));
    const bool asks = diagnosis.next && diagnosis.verdict != "right" && !isKnown;
    if (asks) {
        const QString pixel =
            QStringLiteral("%1, %2").arg(writtenText(diagnosis.next->x, 9), writtenText(diagnosis.next->y, 9));
        addPlain(tr("To be sure"), QString::fromStdString(nextClickText(diagnosis)));
        // Mistakes that are alike everywhere stay so: the click only rules out the next best.
        const bool isOfNextBest = diagnosis.isNextFromRunnerUp();
        const bool areSeveral = !isOfNextBest && !asWell.empty();
        m_click->setText((isOfNextBest ? tr("Click &there to rule out the next best: %1")
                          : areSeveral ? tr("Click &there to tell them apart: %1")
                                       : tr("Click &there to be sure: %1"))
                             .arg(pixel));
        m_click->setToolTip(
            isOfNextBest
                ? tr("Pick that pixel and type your program's result there; it separates the named mistakes from the "
                     "next best")
                : tr("Pick that pixel and type your program's result there; it separates the first mistake from the "
                     "others"));
        placeClick(areSeveral);
    }
    m_click->setVisible(asks);
    m_verdict->setText(verdictText(diagnosis));
    m_facts->setText(QStringLiteral("<table cellspacing='0' cellpadding='1'>%1</table>").arg(rows));
    m_facts->show();
}

void DiagnosisView::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_shown)
        showAnswer(*m_shown);
    else if (event->type() == QEvent::FontChange && m_shown)
        enlargeVerdict();
}

} // namespace unprojector::gui
