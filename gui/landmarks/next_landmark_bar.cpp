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

#include <algorithm>
#include <utility>

namespace unprojector::gui {

NextLandmarkBar::NextLandmarkBar(SceneDocument &document, Hint hint, Picture picture, IsOfTemplate isOfTemplate,
                                 QWidget *parent)
    : QWidget(parent), m_document(document), m_hint(std::move(hint)), m_picture(std::move(picture)),
      m_isOfTemplate(std::move(isOfTemplate)), m_name(new QLabel), m_how(new QLabel), m_where(new QLabel),
      m_drawing(new QLabel), m_count(new QLabel), m_skip(new QToolButton), m_missing(new QToolButton)
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
    m_skip->setToolTip(tr("Go on with the next one; this one comes again after the others (K)"));
    m_missing->setText(tr("Missing", "button: mark the landmark as missing"));
    m_missing->setToolTip(tr("Mark this one as missing on this specimen, and go on with the next (X)"));
    m_missing->setCheckable(true);
    for (QToolButton *button : {m_skip, m_missing})
        button->setFocusPolicy(Qt::StrongFocus);
    connect(m_skip, &QToolButton::clicked, this, [this] {
        SceneLandmarks &landmarks = m_document.sceneLandmarks();
        if (landmarks.nextUnplaced())
            static_cast<void>(landmarks.skip(*landmarks.nextUnplaced()));
    });
    connect(m_missing, &QToolButton::clicked, this, [this](bool isMissing) {
        SceneLandmarks &landmarks = m_document.sceneLandmarks();
        if (landmarks.nextUnplaced())
            static_cast<void>(landmarks.setMissing({*landmarks.nextUnplaced()}, isMissing));
    });
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & (Change::Landmarks | Change::LandmarkSelection))
            showNext();
    });
    m_name->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_where->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_count->setMinimumWidth(1); // it does not widen the panel
    connect(&m_document, &SceneDocument::opened, this, [this] { m_hasNext = m_isDone = false; });
    auto *line = new QHBoxLayout;
    line->addWidget(m_count, 1);
    line->addWidget(m_skip);
    line->addWidget(m_missing);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_name);
    layout->addWidget(m_how);
    auto *place = new QHBoxLayout;
    place->addWidget(m_where, 1, Qt::AlignTop);
    place->addWidget(m_drawing, 0, Qt::AlignTop);
    layout->addLayout(place);
    layout->addLayout(line);
    useFonts();
    refresh();
}

void NextLandmarkBar::setPlacing(bool isPlacing)
{
    m_isPlacing = isPlacing;
    showHow();
}

QString NextLandmarkBar::howText(bool isDone, bool isPlacing)
{
    if (isDone)
        return isPlacing ? tr("A click places a further landmark; P or Esc ends placing.")
                         : tr("To place further landmarks, press P.");
    return isPlacing ? tr("Click its position; P or Esc ends placing.") : tr("Press P, then click its position.");
}

void NextLandmarkBar::showHow()
{
    m_how->setText(howText(m_isDone, m_isPlacing));
}

void NextLandmarkBar::useFonts()
{
    QFont large = QApplication::font(this);
    large.setPointSizeF(1.4 * large.pointSizeF());
    large.setBold(true);
    m_name->setFont(large);
    m_names.clear();
    reserveRoom();
}

void NextLandmarkBar::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::ApplicationFontChange)
        useFonts();
}

void NextLandmarkBar::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    m_names.clear();
    reserveRoom();
}

int NextLandmarkBar::pictureSide() const
{
    constexpr int kLines = 9;
    return kLines * fontMetrics().lineSpacing();
}

void NextLandmarkBar::reserveRoom()
{
    const std::vector<landmarks::Landmark> &landmarks = m_document.landmarks();
    const auto isKnown = [](const landmarks::Landmark &landmark, const std::string &name) {
        return landmark.name == name;
    };
    if (std::equal(landmarks.begin(), landmarks.end(), m_names.begin(), m_names.end(), isKnown))
        return;
    m_names.clear();
    constexpr int kLeastHintLines = 2;
    const bool hasPictures = std::any_of(landmarks.begin(), landmarks.end(), [this](const auto &landmark) {
        return !m_picture(QString::fromStdString(landmark.name)).empty();
    });
    const int width = contentsRect().width();
    const int hintWidth = hasPictures ? width - pictureSide() - layout()->spacing() : width;
    int nameHeight = 0, hintHeight = hasPictures ? pictureSide() : kLeastHintLines * fontMetrics().lineSpacing();
    const auto heightOf = [](const QLabel &label, int room, const QString &text) {
        return label.fontMetrics()
            .boundingRect(0, 0, std::max(1, room), QWIDGETSIZE_MAX, Qt::TextWordWrap, text)
            .height();
    };
    bool hasHints = false;
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
        m_names.push_back(landmarks[i].name);
        const QString hint = m_hint(QString::fromStdString(landmarks[i].name));
        hasHints = hasHints || !hint.isEmpty();
        nameHeight = std::max(nameHeight, heightOf(*m_name, width, nextText(i)));
        hintHeight = std::max(hintHeight, heightOf(*m_where, hintWidth, hint));
    }
    int howHeight = 0;
    for (const bool isDone : {false, true}) {
        for (const bool isPlacing : {false, true})
            howHeight = std::max(howHeight, heightOf(*m_how, width, howText(isDone, isPlacing)));
    }
    m_name->setMinimumHeight(nameHeight);
    m_how->setMinimumHeight(howHeight);
    m_where->setMinimumHeight(hintHeight);
    m_where->setVisible(hasHints || hasPictures);
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
    const double ratio = devicePixelRatioF();
    const int side = static_cast<int>(pictureSide() * ratio);
    QPixmap pixmap = QPixmap::fromImage(image.scaled(side, side, Qt::KeepAspectRatio, Qt::SmoothTransformation));
    pixmap.setDevicePixelRatio(ratio);
    m_drawing->setPixmap(pixmap);
}

void NextLandmarkBar::refresh()
{
    m_names.clear();
    showNext();
}

void NextLandmarkBar::showNext()
{
    const std::vector<landmarks::Landmark> &landmarks = m_document.landmarks();
    const std::optional<std::size_t> unplaced = m_document.sceneLandmarks().nextUnplaced();
    const bool isSameList = std::exchange(m_listed, landmarks.size()) == landmarks.size();
    m_isDone = !unplaced && isSameList && !landmarks.empty() && (m_hasNext || m_isDone);
    m_hasNext = unplaced.has_value();
    const bool isShown = unplaced || m_isDone;
    // It would be a window of its own without a parent; a visible parent shows it later.
    if (!isShown || parentWidget())
        setVisible(isShown);
    for (QToolButton *button : {m_skip, m_missing})
        button->setEnabled(m_hasNext);
    showHow();
    if (m_isDone)
        showDone();
    if (!unplaced)
        return;
    reserveRoom();
    m_name->setText(nextText(*unplaced));
    const QString name = QString::fromStdString(landmarks[*unplaced].name);
    showPicture(m_picture(name));
    m_where->setText(m_hint(name));
    m_missing->setChecked(landmarks[*unplaced].isMissing());
    showCount();
}

void NextLandmarkBar::showDone()
{
    const std::vector<landmarks::Landmark> &landmarks = m_document.landmarks();
    const bool areAllPlaced = std::all_of(landmarks.begin(), landmarks.end(),
                                          [](const landmarks::Landmark &landmark) { return landmark.isPlaced(); });
    m_name->setText(areAllPlaced ? tr("All landmarks are placed") : tr("All landmarks are placed or missing"));
    m_where->clear();
    showPicture({});
    m_missing->setChecked(false);
    showCount();
}

QString NextLandmarkBar::nextText(std::size_t index) const
{
    return tr("Next: %1").arg(SceneLandmarks::shownNameOf(m_document.landmarks(), index));
}

void NextLandmarkBar::showCount()
{
    const std::vector<landmarks::Landmark> &landmarks = m_document.landmarks();
    // Other names don't belong to the template; if the next one is such, or no name belongs to it,
    // all names count.
    const auto isOfTemplate = [&](const landmarks::Landmark &landmark) {
        return m_isOfTemplate(QString::fromStdString(landmark.name));
    };
    const std::optional<std::size_t> next = m_document.sceneLandmarks().nextUnplaced();
    const bool countsAll =
        next ? !isOfTemplate(landmarks[*next]) : std::none_of(landmarks.begin(), landmarks.end(), isOfTemplate);
    int all = 0, placed = 0, missing = 0, skipped = 0;
    for (const landmarks::Landmark &landmark : landmarks) {
        if (!countsAll && !isOfTemplate(landmark))
            continue;
        ++all;
        placed += landmark.isPlaced() ? 1 : 0;
        missing += landmark.isMissing() ? 1 : 0;
        skipped += !landmark.isPlaced() && landmark.absence == landmarks::Absence::Skipped ? 1 : 0;
    }
    QString text = tr("%1 of %2 placed").arg(placed).arg(all);
    if (missing > 0)
        text += tr(", %1 missing", "after the number of placed landmarks").arg(missing);
    if (skipped > 0)
        text += tr(", %1 skipped", "after the number of placed landmarks").arg(skipped);
    m_count->setText(text);
    m_count->setToolTip(plainToolTip(text));
}

} // namespace unprojector::gui
