#include "gui/landmarks/next_landmark_bar.h"

#include "gui/document/scene_document.h"
#include "gui/text/error_text.h"

#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QImageReader>
#include <QLabel>
#include <QPixmap>
#include <QToolButton>
#include <QVBoxLayout>

#include <cstddef>
#include <utility>

namespace unprojector::gui {

NextLandmarkBar::NextLandmarkBar(SceneDocument &document, Hint hint, Picture picture, IsOfTemplate isOfTemplate,
                                 QWidget *parent)
    : QWidget(parent), m_document(document), m_hint(std::move(hint)), m_picture(std::move(picture)),
      m_isOfTemplate(std::move(isOfTemplate)), m_name(new QLabel), m_how(new QLabel), m_where(new QLabel),
      m_drawing(new QLabel), m_count(new QLabel), m_skip(new QToolButton)
{
    for (QLabel *label : {m_name, m_how, m_where, m_drawing, m_count}) {
        label->setTextFormat(Qt::PlainText); // names come from files
        label->setWordWrap(label != m_count);
    }
    m_name->setAccessibleName(tr("Landmark to place next"));
    m_how->setAccessibleName(tr("Instruction for placing"));
    m_where->setAccessibleName(tr("Definition of the landmark"));
    m_drawing->setAccessibleName(tr("Image from the template"));
    m_drawing->hide();
    m_count->setAccessibleName(tr("Number of placed landmarks"));
    m_skip->setText(tr("Skip"));
    m_skip->setToolTip(tr("Leave this one missing and go on with the next"));
    m_skip->setFocusPolicy(Qt::StrongFocus);
    connect(m_skip, &QToolButton::clicked, this, [this] {
        SceneLandmarks &landmarks = m_document.sceneLandmarks();
        landmarks.waitForNext(landmarks.nextUnplaced());
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
    layout->addWidget(m_how);
    auto *place = new QHBoxLayout;
    place->addWidget(m_where, 1, Qt::AlignTop);
    place->addWidget(m_drawing, 0, Qt::AlignTop);
    layout->addLayout(place);
    useFonts();
    refresh();
}

void NextLandmarkBar::setPlacing(bool isPlacing)
{
    m_how->setText(isPlacing ? tr("Click its position; P or Esc ends placing.")
                             : tr("Press P, then click its position."));
}

void NextLandmarkBar::useFonts()
{
    QFont large = QApplication::font(this);
    large.setPointSizeF(1.4 * large.pointSizeF());
    large.setBold(true);
    m_name->setFont(large);
}

void NextLandmarkBar::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::ApplicationFontChange)
        useFonts();
}

void NextLandmarkBar::showPicture(const std::filesystem::path &file)
{
    if (file == m_shownPicture)
        return;
    m_shownPicture = file;
    m_drawing->clear();
    m_drawing->setVisible(!file.empty());
    if (file.empty())
        return;
    const QString name = pathText(file);
    m_drawing->setToolTip(plainToolTip(name));
    QImageReader reader(name);
    reader.setAutoTransform(true);
    const QImage image = reader.read();
    if (image.isNull()) {
        m_drawing->setText(tr("The image %1 cannot be shown: %2.").arg(name, reader.errorString()));
        return;
    }
    constexpr int kLines = 9;
    const double ratio = devicePixelRatioF();
    const int side = static_cast<int>(kLines * fontMetrics().lineSpacing() * ratio);
    QPixmap pixmap = QPixmap::fromImage(image.scaled(side, side, Qt::KeepAspectRatio, Qt::SmoothTransformation));
    pixmap.setDevicePixelRatio(ratio);
    m_drawing->setPixmap(pixmap);
}

void NextLandmarkBar::refresh()
{
    const std::vector<landmarks::Landmark> &landmarks = m_document.landmarks();
    const std::optional<std::size_t> unplaced = m_document.sceneLandmarks().nextUnplaced();
    // It would be a window of its own without a parent; a visible parent shows it later.
    if (!unplaced || parentWidget())
        setVisible(unplaced.has_value());
    if (!unplaced)
        return;
    const QString name = SceneLandmarks::shownNameOf(landmarks, *unplaced);
    m_name->setText(tr("Next: %1").arg(name));
    showPicture(m_picture(QString::fromStdString(landmarks[*unplaced].name)));
    const QString hint = m_hint(QString::fromStdString(landmarks[*unplaced].name));
    m_where->setText(hint);
    m_where->setVisible(!hint.isEmpty());
    // Other names don't belong to the template; if the next one is such, all names count.
    const auto isOfTemplate = [&](const landmarks::Landmark &landmark) {
        return m_isOfTemplate(QString::fromStdString(landmark.name));
    };
    const bool countsAll = !isOfTemplate(landmarks[*unplaced]);
    std::size_t all = 0, placed = 0;
    for (const landmarks::Landmark &landmark : landmarks) {
        const bool counts = countsAll || isOfTemplate(landmark);
        all += counts ? 1U : 0U;
        placed += counts && landmark.isPlaced() ? 1U : 0U;
    }
    m_count->setText(tr("%1 of %2").arg(placed).arg(all));
}

} // namespace unprojector::gui
