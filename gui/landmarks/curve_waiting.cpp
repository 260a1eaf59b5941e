#include "gui/landmarks/curve_waiting.h"

#include "gui/document/scene_curves.h"
#include "gui/document/scene_document.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QProgressDialog>
#include <QTimer>

namespace unprojector::gui {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::CurveWaiting)
};

} // namespace

bool waitForCurves(QWidget &window, SceneDocument &document)
{
    const SceneCurves &curves = document.curves();
    QEventLoop loop;
    QObject::connect(&document, &SceneDocument::changed, &loop, [&] {
        if (!curves.isComputing())
            loop.quit();
    });
    constexpr int kUnnoticedMilliseconds = 300, kTickMilliseconds = 100;
    QTimer::singleShot(kUnnoticedMilliseconds, &loop, &QEventLoop::quit);
    if (curves.isComputing()) // blocks keys and clicks, because they would change what is being exported
        loop.exec(QEventLoop::ExcludeUserInputEvents);
    if (!curves.isComputing())
        return true;

    QProgressDialog dialog(Texts::tr("Computing curves on the surface…"), Texts::tr("Cancel"), 0, 0, &window);
    dialog.setWindowTitle(Texts::tr("Curves"));
    dialog.setWindowModality(Qt::ApplicationModal);
    dialog.setAutoReset(false);
    dialog.setAutoClose(false);
    const auto show = [&] {
        const SceneCurves::Progress progress = curves.progress();
        const int count = static_cast<int>(progress.count), done = static_cast<int>(progress.done);
        constexpr int kPercent = 100;
        dialog.setRange(0, kPercent);
        dialog.setValue(static_cast<int>(kPercent * progress.share));
        if (count < 2)
            return;
        dialog.setLabelText(Texts::tr("Computing curves on the surface: %1 of %2").arg(done).arg(count));
    };
    QTimer tick;
    QObject::connect(&tick, &QTimer::timeout, &dialog, show);
    QObject::connect(&dialog, &QProgressDialog::canceled, &loop, &QEventLoop::quit);
    tick.start(kTickMilliseconds);
    dialog.show();
    loop.exec();
    return !curves.isComputing();
}

} // namespace unprojector::gui
