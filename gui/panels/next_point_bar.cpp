#include "gui/panels/next_point_bar.h"

#include "gui/document/scene_document.h"

#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace unprojector::gui {

NextPointBar::NextPointBar(SceneDocument &document, Hint hint, QWidget *parent)
    : QWidget(parent), m_document(document), m_hint(std::move(hint)), m_name(new QLabel), m_where(new QLabel),
      m_count(new QLabel), m_skip(new QToolButton)
{
    for (QLabel *label : {m_name, m_where, m_count}) {
        label->setTextFormat(Qt::PlainText); // names come from files
        label->setWordWrap(label != m_count);
    }
    m_name->setAccessibleName(tr("The point that is placed next"));
    m_where->setAccessibleName(tr("Where that is"));
    m_count->setAccessibleName(tr("How many points are placed"));
    m_skip->setText(tr("Skip"));
    m_skip->setToolTip(tr("Leave this one missing and go on with the next"));
    m_skip->setFocusPolicy(Qt::StrongFocus);
    connect(m_skip, &QToolButton::clicked, this, [this] {
        ScenePoints &points = m_document.points();
        points.waitForNext(points.waiting());
    });
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & (Change::Landmarks | Change::LandmarkSelection))
            refresh();
    });
    auto *line = new QHBoxLayout;
    line->addWidget(m_name, 1);
    line->addWidget(m_count, 0, Qt::AlignTop);
    line->addWidget(m_skip, 0, Qt::AlignTop);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(line);
    layout->addWidget(m_where);
    useFonts();
    refresh();
}

void NextPointBar::useFonts()
{
    QFont large = QApplication::font(this);
    large.setPointSizeF(1.4 * large.pointSizeF());
    large.setBold(true);
    m_name->setFont(large);
}

void NextPointBar::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::ApplicationFontChange)
        useFonts();
}

void NextPointBar::refresh()
{
    const std::vector<landmarks::Landmark> &points = m_document.landmarks();
    const std::optional<std::size_t> waiting = m_document.points().waiting();
    // Before it stands anywhere it would be a window of its own; what is not hidden comes with its parent.
    if (!waiting || parentWidget())
        setVisible(waiting.has_value());
    if (!waiting)
        return;
    const QString name = ScenePoints::shownNameOf(points, *waiting);
    m_name->setText(tr("Next: %1").arg(name));
    const QString hint = m_hint(QString::fromStdString(points[*waiting].name));
    m_where->setText(hint);
    m_where->setVisible(!hint.isEmpty());
    const auto placed =
        std::count_if(points.begin(), points.end(), [](const auto &point) { return !point.isMissing(); });
    m_count->setText(tr("%1 of %2").arg(placed).arg(points.size()));
}

} // namespace unprojector::gui
