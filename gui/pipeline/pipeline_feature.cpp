#include "gui/pipeline/pipeline_feature.h"

#include "gui/document/scene_document.h"
#include "gui/document/session.h"
#include "gui/pipeline/depth_precision_panel.h"
#include "gui/pipeline/lifecycle_panel.h"
#include "gui/pipeline/paste_camera_dialog.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/pipeline/viewport_inspector.h"
#include "gui/view/lifecycle_log.h"
#include "gui/view/lifecycle_recorder.h"
#include "gui/view/scene_view.h"
#include "gui/window/actions.h"
#include "gui/window/feature.h"
#include "gui/window/panel_scroll.h"
#include "gui/window/window.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>

#include <utility>

namespace unprojector::gui {
using namespace pipeline;
using namespace unproject;

class PipelineFeature : public Feature {
    Q_OBJECT
public:
    explicit PipelineFeature(Window &window);

    std::vector<PanelSpec> panels() override;
    std::optional<WorkspaceSpec> workspace() override
    {
        return WorkspaceSpec{Workspace::Pipeline,
                             tr("Pipeline"),
                             tr("Every number and every matrix between an object and its pixel"),
                             Drawing::Pipeline,
                             Qt::Key_F6,
                             {Panel::Pipeline, Panel::Parameters, Panel::Inspector, Panel::Lifecycle}};
    }
    void addActions(MenuKind kind, QMenu &menu, QToolBar &) override;
    bool follow(const lessons::Link &link) override;
    QVariantMap state() const override;
    void restore(const QVariantMap &state) override;
    using Feature::restore;

protected:
    /// Handles the key of Paste Camera, which pastes any text; the action, which buttons trigger too,
    /// begins with a camera only.
    bool eventFilter(QObject *action, QEvent *event) override;

private:
    void showStep(const lessons::Step *step);

    Window &m_window;
    PipelinePanel *m_pipeline;
    ViewportInspector *m_inspector;
    LifecycleLog *m_log;
    bool m_isInLesson = false;
};

PipelineFeature::PipelineFeature(Window &window)
    : Feature(&window), m_window(window), m_pipeline(new PipelinePanel(window.document())),
      m_inspector(new ViewportInspector(window.document())), m_log(new LifecycleLog(this))
{
    m_pipeline->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored); // it scrolls vertically by itself
    connect(&window.session(), &Session::commitPendingEdits, m_pipeline, &PipelinePanel::applyTyped);
    connect(m_pipeline, &PipelinePanel::aboutToPaste, &window.session(), &Session::commitTyped);
    auto *recorder = new LifecycleRecorder(window.document(), *m_log, this);
    connect(&window.view(), &SceneView::happened, recorder, &LifecycleRecorder::record);
    connect(&window, &Window::pointed, m_inspector, [this](const std::optional<PixelClick> &click) {
        if (click)
            m_inspector->setPointer(click->position);
        else
            m_inspector->clearPointer();
    });
    connect(m_inspector, &ViewportInspector::sizeRequested, &window, [&window] { trigger(window, kViewSizeAction); });
    connect(&window, &Window::clickValuesWanted, m_pipeline, &PipelinePanel::showClickValues);
    connect(&window, &Window::stepShown, this, &PipelineFeature::showStep);
}

std::vector<PanelSpec> PipelineFeature::panels()
{
    const auto scrolled = [](QWidget *panel) { return new PanelScroll(panel); };
    constexpr auto kRight = Qt::RightDockWidgetArea, kBottom = Qt::BottomDockWidgetArea;
    return {
        {Panel::Pipeline, tr("Pipeline"), scrolled(m_pipeline), kRight, Qt::ALT | Qt::Key_2},
        {Panel::Inspector, tr("Viewport"), scrolled(m_inspector), kBottom, Qt::ALT | Qt::Key_4},
        {Panel::Lifecycle, tr("Life of the View"), new LifecyclePanel(*m_log), kBottom, Qt::ALT | Qt::Key_5},
        {Panel::Precision, tr("Depth Precision"), scrolled(new DepthPrecisionPanel(m_window.document())), kBottom,
         Qt::ALT | Qt::Key_9},
    };
}

void PipelineFeature::addActions(MenuKind kind, QMenu &menu, QToolBar &)
{
    if (kind != MenuKind::Edit)
        return;
    menu.addSeparator();
    QAction *paste = addAction(
        menu, tr("Paste Ca&mera…"), QKeySequence::Paste,
        tr("Set the camera from another program's: its matrices, K, R, t, its calls, or its camera's file"), [this] {
            m_window.session().commitTyped();
            PasteCameraDialog::open(m_window.document(), &m_window);
        });
    paste->setObjectName(kPasteCameraAction);
    paste->installEventFilter(this);
}

bool PipelineFeature::eventFilter(QObject *action, QEvent *event)
{
    if (event->type() != QEvent::Shortcut)
        return Feature::eventFilter(action, event);
    if (const QString text = QGuiApplication::clipboard()->text(); !text.isEmpty()) {
        m_window.session().commitTyped();
        PasteCameraDialog::open(m_window.document(), &m_window, text);
    }
    return true;
}

bool PipelineFeature::follow(const lessons::Link &link)
{
    if (std::holds_alternative<lessons::GivenPointLink>(link)) {
        m_pipeline->followGiven();
        return true;
    }
    if (const auto *matrix = std::get_if<lessons::MatrixLink>(&link)) {
        m_window.workspaces().show(Panel::Pipeline);
        m_pipeline->openMatrix(matrix->stage);
        return true;
    }
    const auto *factors = std::get_if<lessons::FactorsLink>(&link);
    if (!factors)
        return false;
    m_window.follow(lessons::PanelLink{Panel::Pipeline});
    m_window.workspaces().giveRoom(Panel::Pipeline, Panel::Observer);
    m_pipeline->takeApart(factors->matrix == lessons::FactorsLink::Matrix::View ? PipelineStage::ViewMatrix
                                                                                : PipelineStage::ProjectionMatrix);
    return true;
}

void PipelineFeature::showStep(const lessons::Step *step)
{
    const bool isInLesson = step != nullptr;
    // A lesson starts without traces of a former one, and leaves no decomposition open.
    if (std::exchange(m_isInLesson, isInLesson) != isInLesson)
        m_pipeline->startOver();
}

QVariantMap PipelineFeature::state() const
{
    const MatrixView &view = m_pipeline->matrixView();
    return {{QStringLiteral("direction"), static_cast<int>(m_pipeline->direction())},
            {QStringLiteral("conventions"), static_cast<int>(m_window.document().scene().conventions)},
            {QStringLiteral("layout"), static_cast<int>(view.layout)},
            {QStringLiteral("isMemoryOrder"), view.isMemoryOrder},
            {QStringLiteral("digits"), static_cast<int>(view.digits)},
            {QStringLiteral("isWhole"), view.isWhole},
            {QStringLiteral("kept"), QVariant::fromValue(m_pipeline->kept())}};
}

void PipelineFeature::restore(const QVariantMap &state)
{
    m_pipeline->setDirection(static_cast<PipelineDirection>(state[QStringLiteral("direction")].toInt()));
    // The conventions of another scene set their own vector layout.
    const bool areSame =
        state[QStringLiteral("conventions")].toInt() == static_cast<int>(m_window.document().scene().conventions);
    m_pipeline->setMatrixView(
        {areSame ? static_cast<MatrixLayout>(state[QStringLiteral("layout")].toInt()) : m_pipeline->matrixView().layout,
         state[QStringLiteral("isMemoryOrder")].toBool(), static_cast<Digits>(state[QStringLiteral("digits")].toInt()),
         state[QStringLiteral("isWhole")].toBool()});
    m_pipeline->restore(state[QStringLiteral("kept")].value<PipelinePanel::Kept>());
}

Feature *makePipelineFeature(Window &window)
{
    return new PipelineFeature(window);
}

} // namespace unprojector::gui

#include "pipeline_feature.moc"
