// Links from computed values to their formulas in Help.

#include "tests/support/test.h"

#include "gui/click/comparison_panel.h"
#include "gui/doctor/doctor_panel.h"
#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/map/map_panel.h"
#include "gui/outside/observer_panel.h"
#include "gui/parameters/parameters_panel.h"
#include "gui/pipeline/depth_precision_panel.h"
#include "gui/pipeline/lifecycle_panel.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/pipeline/viewport_inspector.h"
#include "gui/text/formula_text.h"
#include "gui/text/help_anchors.h"
#include "gui/view/lifecycle_log.h"
#include "gui/widgets/formula_view.h"
#include "gui/widgets/help_link.h"
#include "tests/gui/comparison_picks.h"
#include "tests/gui/document_edits.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QRegularExpression>
#include <QSet>

#include <memory>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace unproject;
using namespace comparing;
namespace {

/// The anchors that both pages have, with the number of the formula there.
QMap<QString, QString> places()
{
    QMap<QString, QString> both;
    static const QRegularExpression anchor(
        QStringLiteral("<a name=\"([^\"]*)\"|<formula no=\"([^\"]*)\" name=\"([^\"]*)\""));
    for (const char *name : {"formulas.html", "formulas_zh_CN.html"}) {
        QFile file(QStringLiteral(":/help/") + QLatin1String(name));
        if (!file.open(QIODevice::ReadOnly))
            return {};
        const QString page = QString::fromUtf8(file.readAll());
        QMap<QString, QString> found;
        for (auto matches = anchor.globalMatch(page); matches.hasNext();) {
            const QRegularExpressionMatch match = matches.next();
            found[match.captured(1) + match.captured(3)] = match.captured(2);
        }
        if (both.isEmpty())
            both = found;
        else if (both != found)
            return {};
    }
    return both;
}

/// The places of Help that a widget's links lead to.
QSet<QString> linksOf(const QWidget &widget)
{
    QSet<QString> anchors;
    for (const HelpLink *link : widget.findChildren<HelpLink *>()) {
        if (!link->isHidden())
            anchors << link->anchor();
    }
    static const QRegularExpression address(QStringLiteral("href=\"formulas:([^\"]*)\""));
    for (const QLabel *label : widget.findChildren<QLabel *>()) {
        for (auto matches = address.globalMatch(label->text()); matches.hasNext();)
            anchors << matches.next().captured(1);
    }
    return anchors;
}

} // namespace

class TestHelpLinks : public QObject {
    Q_OBJECT

private slots:
    void init() { m_opened.clear(); }

    void everyFormulaHasItsPlace_data()
    {
        addColumn<Pick>("pick");
        newRow("perspective") << picked(frustumGeometry(), 412.0, 299.0, 0.75);
        constexpr Ortho kBox{-3.0, 3.0, -2.0, 2.0, 2.0, 10.0};
        newRow("ortho") << picked(boxGeometry(kBox), 200.0, 150.0, 0.5);
        newRow("oblique") << picked(boxGeometry(Oblique{kBox, 1.0, 1.2}), 200.0, 150.0, 0.5);
        newRow("background") << picked(frustumGeometry(), 412.0, 299.0, 1.0, false);
    }

    void everyFormulaHasItsPlace()
    {
        QFETCH(Pick, pick);
        const QMap<QString, QString> all = places();
        QVERIFY(!all.isEmpty());
        const PickFormulas formulas = formulasOf(pick);
        QVERIFY(!formulas.formulas.empty());
        for (const FormulaWithNumbers &formula : formulas.formulas) {
            const QString anchor = helpAnchorOf(formula.number());
            QVERIFY2(all.contains(anchor), qPrintable(anchor));
            if (pick.hit())
                QCOMPARE(QStringLiteral("(%1)").arg(all[anchor]), formula.number());
        }
    }

    void aNumberIsALink()
    {
        FormulaView view;
        view.setFormulas(formulasOf(picked(frustumGeometry(), 412.0, 299.0, 0.75)));
        view.resize(600, 800);
        view.show();
        for (const auto &[number, anchor] :
             {std::pair("(13)", "z-perspective"), std::pair("(9)", "w9"), std::pair("(16)", "eye-to-world")}) {
            const QRectF place = view.placeOfNumber(QString::fromLatin1(number));
            QVERIFY(!place.isEmpty());
            QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, place.center().toPoint());
            QCOMPARE(m_opened.last(), QString::fromLatin1(anchor));
        }
        QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, QPoint(20, 20)); // of the formula itself
        QCOMPARE(m_opened.size(), 3);
    }

    void everyPanelLeadsToHelp_data()
    {
        addColumn<QStringList>("anchors");
        newRow("comparison") << QStringList{"weng", "matrix", "certainty", "half-pixel", "conventions"};
        newRow("pipeline") << QStringList{"spaces",   "model",      "view", "frustum",
                                          "viewport", "half-pixel", "mvpw", "conventions"};
        newRow("parameters") << QStringList{"view", "frustum", "viewport", "model", "clip-planes"};
        newRow("depth precision") << QStringList{"certainty"};
        newRow("viewport") << QStringList{"near-window"};
        newRow("life of the view") << QStringList{"mfc"};
        newRow("view from outside") << QStringList{"frustum-steps"};
        newRow("doctor") << QStringList{"wrong"};
        newRow("map") << QStringList{"certainty"};
    }

    void everyPanelLeadsToHelp()
    {
        QFETCH(QStringList, anchors);
        SceneDocument document;
        setProjection(document, frustumGeometry().projection());
        const QByteArray name = QTest::currentDataTag();
        LifecycleLog log;
        std::unique_ptr<QWidget> panel;
        if (name == "comparison")
            panel = std::make_unique<ComparisonPanel>(document);
        else if (name == "pipeline")
            panel = std::make_unique<PipelinePanel>(document);
        else if (name == "parameters")
            panel = std::make_unique<ParametersPanel>(document);
        else if (name == "depth precision")
            panel = std::make_unique<DepthPrecisionPanel>(document);
        else if (name == "viewport")
            panel = std::make_unique<ViewportInspector>(document);
        else if (name == "life of the view")
            panel = std::make_unique<LifecyclePanel>(log);
        else if (name == "view from outside")
            panel = std::make_unique<ObserverPanel>(document);
        else if (name == "doctor")
            panel = std::make_unique<DoctorPanel>(document);
        else
            panel = std::make_unique<MapPanel>();
        panel->show();
        document.picks().setPick(picked(frustumGeometry(), 412.0, 299.0, 0.75));
        const QMap<QString, QString> all = places();
        const QSet<QString> links = linksOf(*panel);
        for (const QString &link : links)
            QVERIFY2(all.contains(link), qPrintable(link));
        QCOMPARE(links, QSet<QString>(anchors.begin(), anchors.end()));
        for (HelpLink *link : panel->findChildren<HelpLink *>()) {
            if (link->isHidden())
                continue;
            QTest::keyClick(link, Qt::Key_Space);
            QCOMPARE(m_opened.last(), link->anchor());
            QVERIFY(!link->toolTip().isEmpty() && !link->accessibleName().isEmpty());
        }
    }

    void theLinkIsThatOfTheProjection()
    {
        SceneDocument document;
        ParametersPanel parameters(document);
        PipelinePanel pipeline(document);
        parameters.show();
        pipeline.show();
        const QMap<QString, QString> all = places();
        constexpr Ortho kBox{-3.0, 3.0, -2.0, 2.0, 2.0, 10.0};
        for (const auto &[projection, anchor] :
             {std::pair(Projection(kBox), "ortho"), std::pair(Projection(Oblique{kBox, 1.0, 1.2}), "oblique"),
              std::pair(Projection(Perspective{0.8, 1.5, 1.0, 10.0}), "perspective")}) {
            setProjection(document, projection);
            for (const QWidget *panel : {static_cast<QWidget *>(&parameters), static_cast<QWidget *>(&pipeline)})
                QVERIFY2(linksOf(*panel).contains(QString::fromLatin1(anchor)), anchor);
            QVERIFY(all.contains(QString::fromLatin1(anchor)));
        }
    }

    void theStepsOfAMatrixLeadToHelp()
    {
        constexpr Ortho kBox{-3.0, 3.0, -2.0, 2.0, 2.0, 10.0};
        const QMap<QString, QString> all = places();
        QSet<QString> links;
        for (const Projection &projection :
             {frustumGeometry().projection(), Projection(kBox), Projection(Oblique{kBox, 1.0, 1.2})}) {
            SceneDocument document;
            setProjection(document, projection);
            QVERIFY(editConventions(document, Api::Direct3d, {QStringLiteral("Conventions")}));
            PipelinePanel panel(document);
            panel.show();
            panel.setAllOpen(true);
            for (QToolButton *button : panel.findChildren<QToolButton *>(QStringLiteral("takeApart")))
                button->click();
            links += linksOf(panel);
        }
        for (const char *anchor : {"ortho-steps", "frustum-steps", "view-steps", "conventions", "oblique"})
            QVERIFY2(links.contains(QString::fromLatin1(anchor)), anchor);
        for (const QString &link : std::as_const(links))
            QVERIFY2(all.contains(link), qPrintable(link));
    }

private:
    QStringList m_opened;
    HelpOpener m_opener{[this](const QString &anchor) { m_opened << anchor; }, [](const QString &) {}, this};
};

} // namespace unprojector::gui

UNPROJECTOR_TEST(unprojector::gui::TestHelpLinks)
#include "test_help_links.moc"
