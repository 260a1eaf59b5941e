#include "gui/pipeline/matrix_findings_view.h"

#include "gui/pipeline/matrix_text.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace unprojector::gui {
using namespace cameras;
using namespace pipeline;

MatrixFindingsView::MatrixFindingsView(QWidget *parent) : QWidget(parent)
{
    m_rows = new QVBoxLayout(this);
    m_rows->setContentsMargins(4, 0, 0, 0);
    m_rows->setSpacing(2);
    hide();
}

void MatrixFindingsView::setFindings(const std::vector<MatrixFinding> &findings, MatrixRole role, NumberOrder order)
{
    QStringList texts;
    for (const MatrixFinding &finding : findings)
        texts << findingSentence(finding, role) << repairName(finding, order);
    m_findings = findings;
    if (texts == m_texts) // the focused button keeps the focus
        return;
    m_texts = texts;
    while (QLayoutItem *item = m_rows->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater(); // one of them may have emitted the signal
        delete item;
    }
    for (std::size_t i = 0; i < m_findings.size(); ++i) {
        auto *row = new QWidget;
        auto *line = new QHBoxLayout(row);
        line->setContentsMargins(0, 0, 0, 0);
        auto *sentence = new QLabel(texts[qsizetype(2 * i)]);
        sentence->setTextFormat(Qt::PlainText);
        sentence->setWordWrap(true);
        sentence->setTextInteractionFlags(Qt::TextSelectableByMouse);
        line->addWidget(sentence, 1);
        if (const QString name = texts[qsizetype(2 * i + 1)]; !name.isEmpty()) {
            auto *button = new QPushButton(name);
            button->setAutoDefault(false);
            button->setToolTip(sentence->text());
            connect(button, &QPushButton::clicked, this, [this, i] {
                const MatrixFinding finding = m_findings[i];
                emit repairWanted(finding);
            });
            line->addWidget(button, 0, Qt::AlignTop);
        }
        m_rows->addWidget(row);
    }
    setVisible(!m_findings.empty());
}

} // namespace unprojector::gui
