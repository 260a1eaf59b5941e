#include "gui/window/view_frame.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

namespace unprojector::gui {

ViewFrame::ViewFrame(QWidget &view) : m_view(view), m_layout(new QGridLayout(this)), m_bars(new QVBoxLayout)
{
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->addWidget(&view, 0, 0);
    m_bars->setSpacing(0);
    m_bars->addStretch();
    m_layout->addLayout(m_bars, 0, 0);
}

void ViewFrame::addBar(QWidget &bar)
{
    m_bars->insertWidget(m_bars->count() - 1, &bar);
    bar.raise();
}

void ViewFrame::addNote(QWidget &note)
{
    const int margin = fontMetrics().height() / 2;
    auto *line = new QHBoxLayout;
    line->setContentsMargins(margin, margin, margin, margin);
    line->addWidget(&note);
    line->addStretch();
    m_bars->insertLayout(m_bars->count() - 1, line);
    note.raise();
}

void ViewFrame::add(QWidget &widget, Qt::Alignment alignment)
{
    m_layout->addWidget(&widget, 0, 0, alignment);
    widget.raise();
}

void ViewFrame::limitView(const QSize &size)
{
    m_view.setMaximumSize(size.isValid() ? size : QSize(QWIDGETSIZE_MAX, QWIDGETSIZE_MAX));
    m_layout->setAlignment(&m_view, size.isValid() ? Qt::AlignCenter : Qt::Alignment());
}

} // namespace unprojector::gui
