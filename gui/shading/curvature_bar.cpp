#include "gui/shading/curvature_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>

#include <cmath>

namespace unprojector::gui {

CurvatureBar::CurvatureBar(QWidget *parent) : QFrame(parent), m_progress(new QProgressBar), m_delay(new QTimer(this))
{
    setObjectName(QStringLiteral("curvatureBar"));
    setAutoFillBackground(true);
    setFrameShape(QFrame::StyledPanel);
    m_progress->setRange(0, 100);
    m_progress->setAccessibleName(tr("Computing the curvature"));
    auto *cancel = new QPushButton(tr("Cancel"));
    cancel->setToolTip(tr("Show the surface without its curvature"));
    auto *layout = new QHBoxLayout(this);
    layout->addWidget(new QLabel(tr("Computing the curvature")));
    layout->addWidget(m_progress);
    layout->addWidget(cancel);
    m_delay->setSingleShot(true);
    constexpr int kUnnoticedMilliseconds = 500;
    m_delay->setInterval(kUnnoticedMilliseconds);
    connect(m_delay, &QTimer::timeout, this, &QWidget::show);
    connect(cancel, &QPushButton::clicked, this, &CurvatureBar::cancelRequested);
    hide();
}

void CurvatureBar::start()
{
    m_progress->setValue(0);
    if (isHidden() && !m_delay->isActive())
        m_delay->start();
}

void CurvatureBar::setProgress(double share)
{
    m_progress->setValue(static_cast<int>(std::lround(100.0 * share)));
}

void CurvatureBar::finish()
{
    m_delay->stop();
    hide();
}

} // namespace unprojector::gui
