#include "gui/landmarks/landmarks_panel.h"

#include "core/landmark_files/landmark_file.h"
#include "gui/document/landmark_views.h"
#include "gui/document/scene_document.h"
#include "gui/landmarks/curves_view.h"
#include "gui/landmarks/landmark_templates.h"
#include "gui/landmarks/landmarks_model.h"
#include "gui/landmarks/landmarks_table.h"
#include "gui/landmarks/measures_view.h"
#include "gui/landmarks/next_landmark_bar.h"
#include "gui/text/error_text.h"
#include "gui/text/note_text.h"
#include "gui/widgets/copy_menu.h"
#include "gui/widgets/file_dialogs.h"
#include "gui/widgets/save_name.h"

#include <QColorDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPixmap>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <utility>

namespace unprojector::gui {
namespace {

using landmarks::Landmark;

/// Distinguishable for the colour-blind too. Source: Okabe and Ito, Color Universal Design (2008).
constexpr std::array<glm::u8vec3, 7> kColors{
    {{230, 159, 0}, {86, 180, 233}, {0, 158, 115}, {240, 228, 66}, {0, 114, 178}, {213, 94, 0}, {204, 121, 167}}};

QIcon swatch(const glm::u8vec3 &color, int size)
{
    QPixmap pixmap(size, size);
    pixmap.fill(QColor(color.r, color.g, color.b));
    return pixmap;
}

} // namespace

LandmarksPanel::LandmarksPanel(SceneDocument &document, LandmarkTemplates &templates, QWidget *parent)
    : QWidget(parent), m_document(document), m_templates(templates), m_model(new LandmarksModel(document, this)),
      m_table(new LandmarksTable(document, m_model)),
      m_next(new NextLandmarkBar(
          document, [this](const QString &name) { return m_templates.hintFor(name); },
          [this](const QString &name) { return m_templates.pictureFor(name); },
          [this](const QString &name) { return m_templates.isChosen(name); })),
      m_empty(new QLabel), m_reason(new QLabel), m_template(new QToolButton), m_up(new QToolButton),
      m_down(new QToolButton), m_remove(new QToolButton), m_curves(new CurvesView(document)),
      m_parts(new QSplitter(Qt::Vertical))
{
    setPlacing(false);
    m_empty->setWordWrap(true);
    m_reason->setWordWrap(true);
    m_reason->setTextFormat(Qt::PlainText);
    m_reason->setAccessibleName(tr("Reason why the number was rejected"));
    m_reason->hide();
    connect(m_model, &LandmarksModel::refused, m_reason, [this](const QString &reason) {
        m_reason->setText(reason);
        m_reason->show();
    });
    connect(m_model, &LandmarksModel::accepted, m_reason, &QWidget::hide);
    connect(m_table, &QWidget::customContextMenuRequested, this,
            [this](const QPoint &place) { openMenu(m_table->viewport()->mapToGlobal(place)); });
    connect(m_table, &LandmarksTable::removeRequested, this, &LandmarksPanel::removeSelected);
    connect(m_table, &LandmarksTable::copyRequested, this, &LandmarksPanel::copySelected);

    const auto set = [](QToolButton *button, const QString &text, const QString &tip) {
        button->setText(text);
        button->setToolTip(tip);
        button->setFocusPolicy(Qt::StrongFocus);
    };
    set(m_template, tr("Template"), tr("Names to place one after the other"));
    set(m_up, tr("Up"), tr("Move the selected landmark up"));
    set(m_down, tr("Down"), tr("Move the selected landmark down"));
    set(m_remove, tr("Remove"), tr("Remove the selected landmarks (Del)"));
    m_template->setPopupMode(QToolButton::InstantPopup);
    fillTemplateMenu();
    connect(m_up, &QToolButton::clicked, this, [this] { moveSelected(-1); });
    connect(m_down, &QToolButton::clicked, this, [this] { moveSelected(1); });
    connect(m_remove, &QToolButton::clicked, this, &LandmarksPanel::removeSelected);
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & (Change::Landmarks | Change::LandmarkSelection)) {
            m_reason->hide();
            updateButtons();
        }
    });

    auto *buttons = new QHBoxLayout;
    for (QToolButton *button : {m_template, m_up, m_down, m_remove})
        buttons->addWidget(button);
    buttons->addWidget(m_curves->joinButton());
    buttons->addStretch();
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(m_next);
    layout->addWidget(m_empty);
    auto *list = new QWidget;
    auto *listLayout = new QVBoxLayout(list);
    listLayout->setContentsMargins(0, 0, 0, 0);
    listLayout->addWidget(m_table, 1);
    listLayout->addWidget(m_reason);
    listLayout->addLayout(buttons);
    m_parts->setChildrenCollapsible(false);
    m_parts->addWidget(list);
    m_parts->addWidget(m_curves);
    auto *measures = new MeasuresView(document);
    connect(measures, &MeasuresView::warned, this, &LandmarksPanel::warned);
    m_parts->addWidget(measures);
    layout->addWidget(m_parts, 1);
    connect(m_parts, &QSplitter::splitterMoved, this, [this] { m_isPartedByUser = true; });
    connect(m_curves, &CurvesView::shownOrHidden, this, &LandmarksPanel::partHeight,
            Qt::QueuedConnection); // after the splitter has processed the change
    updateButtons();
}

void LandmarksPanel::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    partHeight();
}

void LandmarksPanel::partHeight()
{
    if (!m_isPartedByUser)
        m_parts->setSizes({2 * height(), height(), height()}); // hidden parts are ignored
}

QSize LandmarksPanel::minimumSizeHint() const
{
    constexpr int kDigits = 24, kLines = 10;
    return {kDigits * fontMetrics().horizontalAdvance(u'0'), kLines * fontMetrics().lineSpacing()};
}

void LandmarksPanel::setPlacing(bool isPlacing)
{
    m_next->setPlacing(isPlacing);
    m_empty->setText(
        isPlacing ? tr(
            "No landmarks yet. Click the surface. Or choose a template and place its landmarks one after the other.")
                  : tr("No landmarks yet. Press P, then click the surface. Or choose a template and place its "
                       "landmarks one after the other."));
}

void LandmarksPanel::join(landmarks::CurveKind kind)
{
    m_curves->join(kind);
}

void LandmarksPanel::applyTyped()
{
    m_table->applyTyped();
    m_curves->applyTyped();
}

void LandmarksPanel::updateButtons()
{
    const std::vector<std::size_t> &selected = m_document.sceneLandmarks().selection();
    const std::size_t count = m_document.landmarks().size();
    m_up->setEnabled(selected.size() == 1 && selected.front() > 0);
    m_down->setEnabled(selected.size() == 1 && selected.front() + 1 < count);
    m_remove->setEnabled(!selected.empty());
    m_empty->setVisible(count == 0);
}

// ---- templates ----------------------------------------------------------------------------------

void LandmarksPanel::fillTemplateMenu()
{
    auto *menu = new QMenu(m_template);
    menu->setToolTipsVisible(true);
    for (const LandmarkTemplates::Bundled &bundled : m_templates.bundled()) {
        QAction *action = menu->addAction(bundled.name, this, [this, &bundled] {
            m_templates.choose(bundled.points);
            fillFrom(bundled.points, bundled.name);
        });
        action->setToolTip(bundled.source);
    }
    menu->addAction(tr("&None"), this,
                    [this] {
                        std::vector<std::size_t> toPlace;
                        for (std::size_t i = 0; i < m_document.landmarks().size(); ++i) {
                            if (m_document.landmarks()[i].isToPlace())
                                toPlace.push_back(i);
                        }
                        static_cast<void>(m_document.sceneLandmarks().remove(toPlace));
                    })
        ->setToolTip(tr("Remove the names not placed yet and place landmarks freely"));
    menu->addSeparator();
    menu->addAction(tr("&Load Template…"), this, &LandmarksPanel::loadTemplate);
    menu->addAction(tr("&Save Names as Template…"), this, &LandmarksPanel::saveTemplate);
    menu->addSeparator();
    QAction *again = menu->addAction(tr("&Place All Again"), this, [this] {
        std::vector<std::size_t> all(m_document.landmarks().size());
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = i;
        static_cast<void>(m_document.sceneLandmarks().placeAgain(all));
        m_document.sceneLandmarks().waitForNext(std::nullopt);
        beginPlacing();
    });
    again->setToolTip(tr("Keep the names and place every landmark again"));
    m_template->setMenu(menu);
}

void LandmarksPanel::loadTemplate()
{
    const std::filesystem::path file = askFileName(
        *this, FileKind::Template, tr("Load Template"),
        tr("Templates and landmarks (%1)").arg(QStringLiteral("*.pptpl *.csv *.pp *.mrk.json *.fcsv *.pts *.tps")));
    if (!file.empty())
        takeTemplate(file);
}

void LandmarksPanel::takeTemplate(const std::filesystem::path &file)
{
    auto read = landmark_files::readLandmarkFile(file);
    if (!read) {
        emit warned(QString::fromStdString(read.error().message()));
        return;
    }
    std::vector<Landmark> landmarks = std::move(read).value().sets.front().landmarks;
    m_templates.choose(landmarks, file.parent_path());
    fillFrom(landmarks, pathText(file.stem()));
}

void LandmarksPanel::fillFrom(const std::vector<Landmark> &landmarks, const QString &name)
{
    const QStringList removed = fillFromTemplate(m_document, landmarks, name);
    emit templateChosen();
    m_next->refresh();
    beginPlacing();
    if (removed.size() == 1)
        emit noticed(tr("The template %1 replaced %2, which was not placed yet.").arg(name, removed.front()));
    else if (!removed.isEmpty())
        emit noticed(
            tr("The template %1 replaced %n names that were not placed yet.", nullptr, static_cast<int>(removed.size()))
                .arg(name));
}

void LandmarksPanel::beginPlacing()
{
    if (m_document.sceneLandmarks().nextUnplaced())
        emit placingRequested();
}

void LandmarksPanel::saveTemplate()
{
    const std::filesystem::path file = askSaveName(*this, tr("Save Names as Template"),
                                                   {tr("MeshLab's template (%1)").arg(QStringLiteral("*.pptpl")),
                                                    tr("Table with hints (%1)").arg(QStringLiteral("*.csv"))},
                                                   {}, FileKind::Template)
                                           .file;
    if (file.empty())
        return;
    const landmarks::LandmarkSet set = m_templates.templateOf(m_document.landmarks(), file.parent_path());
    const auto written = landmark_files::writeLandmarkFile(file, {&set, 1});
    if (!written) {
        emit warned(QString::fromStdString(written.error().message()));
        return;
    }
    if (!written->empty())
        emit warned(landmarkNotesText(pathText(file.filename()), *written));
}

// ---- actions on the selection -------------------------------------------------------------------

void LandmarksPanel::removeSelected()
{
    static_cast<void>(m_document.sceneLandmarks().remove(m_document.sceneLandmarks().selection()));
}

void LandmarksPanel::moveSelected(int by)
{
    const std::vector<std::size_t> selected = m_document.sceneLandmarks().selection();
    if (selected.size() != 1)
        return;
    const std::size_t from = selected.front(), to = by < 0 ? from - 1 : from + 1;
    if (to < m_document.landmarks().size()) // an index below 0 wraps around to a large number
        static_cast<void>(m_document.sceneLandmarks().reorder(from, to));
}

void LandmarksPanel::copySelected()
{
    landmarks::LandmarkSet set;
    for (const std::size_t index : m_table->selectedIndices())
        set.landmarks.push_back(m_document.landmarks()[index]);
    if (set.landmarks.empty())
        set = m_document.scene().landmarks;
    const auto text = landmark_files::landmarksText({&set, 1}, landmark_files::Format::Csv);
    if (text)
        copyToClipboard(QString::fromStdString(text->text));
}

void LandmarksPanel::chooseColor()
{
    const QColor color = QColorDialog::getColor(Qt::white, this, tr("Colour of Landmarks"));
    // The colour is for the present selection: the list may have changed during the dialog, and the
    // selection follows it.
    if (color.isValid())
        static_cast<void>(m_document.sceneLandmarks().setColor(m_document.sceneLandmarks().selection(),
                                                               glm::u8vec3(color.red(), color.green(), color.blue())));
}

void LandmarksPanel::addColorMenu(QMenu &menu)
{
    QMenu *colors = menu.addMenu(tr("&Colour"));
    const auto set = [this](const std::optional<glm::u8vec3> &color) {
        static_cast<void>(m_document.sceneLandmarks().setColor(m_document.sceneLandmarks().selection(), color));
    };
    colors->addAction(tr("&Default"), this, [set] { set(std::nullopt); });
    const std::array names{tr("Orange"), tr("Sky Blue"),  tr("Green"), tr("Yellow"),
                           tr("Blue"),   tr("Vermilion"), tr("Purple")};
    for (std::size_t i = 0; i < kColors.size(); ++i)
        colors->addAction(swatch(kColors[i], fontMetrics().height()), names[i], this, [set, i] { set(kColors[i]); });
    colors->addAction(tr("&Other…"), this, &LandmarksPanel::chooseColor);
}

void LandmarksPanel::openMenu(const QPoint &global)
{
    SceneLandmarks &landmarks = m_document.sceneLandmarks();
    const std::vector<std::size_t> selected = landmarks.selection();
    if (selected.empty())
        return;
    const std::vector<Landmark> &all = m_document.landmarks();
    const auto areAll = [&](const auto &condition) {
        return std::all_of(selected.begin(), selected.end(), [&](std::size_t index) { return condition(all[index]); });
    };
    const bool areHidden = areAll([](const Landmark &landmark) { return landmark.isHidden; });
    const bool areMissing = areAll([](const Landmark &landmark) { return landmark.isMissing(); });
    const bool isPlaced = landmarks.current() && all[*landmarks.current()].isPlaced();
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setObjectName(QStringLiteral("landmarkMenu"));
    // Each applies to the selection when triggered: the selection follows the landmarks, indices
    // don't.
    menu->addAction(tr("&Go to Landmark"), this,
                    [this, &landmarks] {
                        if (landmarks.current())
                            goToLandmark(m_document, *landmarks.current());
                    })
        ->setEnabled(isPlaced);
    if (landmarks.current() && !isPlaced)
        menu->addAction(tr("&Place Next"), this, [this, &landmarks] {
            landmarks.setNextUnplaced(landmarks.current());
            emit placingRequested();
        });
    menu->addSeparator();
    menu->addAction(tr("&Rename"), this, [this] {
        emit showRequested();
        m_table->renameCurrent();
    });
    menu->addAction(areHidden ? tr("&Show") : tr("&Hide"), this, [&landmarks, areHidden] {
        static_cast<void>(landmarks.setHidden(landmarks.selection(), !areHidden));
    });
    menu->addAction(areMissing ? tr("Mark as Not &Missing") : tr("Mark as &Missing"), this, [&landmarks, areMissing] {
        static_cast<void>(landmarks.setMissing(landmarks.selection(), !areMissing));
    });
    addColorMenu(*menu);
    menu->addAction(tr("Copy as C&SV"), this, &LandmarksPanel::copySelected);
    menu->addSeparator();
    menu->addAction(tr("Re&move"), this, &LandmarksPanel::removeSelected);
    connect(m_model, &QAbstractItemModel::modelReset, menu, &QWidget::close);
    menu->popup(global);
}

} // namespace unprojector::gui
