// The messages where a thread cannot start or memory runs out, for each owner of background jobs;
// the document goes on. The map's and the doctor's messages are in test_map_overlay and
// test_doctor_place.

#include "tests/support/test.h"

#include "tests/gui/document/session_desk.h"
#include "tests/gui/document_edits.h"
#include "tests/gui/job_faults.h"

#include "core/examples/solids.h"
#include "core/ray/closest_place.h"
#include "gui/doctor/diagnoser.h"
#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/document/scene_curves.h"
#include "gui/document/scene_edits.h"
#include "gui/map/map_maker.h"
#include "tests/support/mesh_model.h"
#include "tests/support/patience.h"

#include <QSignalSpy>

#include <memory>
#include <vector>

using namespace jobfaults;
using namespace sessions;
using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::scene;

namespace {

/// 20 * 4^subdivisions triangles: too many to prepare rays or curves at once, and too many to be
/// drawn in motion.
constexpr int kMany = 5, kVeryMany = 7;

std::vector<SceneObject> ball(int subdivisions)
{
    return {{"ball", {}, modelOf(examples::sphereMesh(1.0, subdivisions)), {}}};
}

landmarks::Landmark pointOn(const SceneObject &object, const glm::dvec3 &place, const char *name)
{
    const auto closest = ray::ClosestPlaces::build(object.model, {})->to(ObjectPoint(place));
    landmarks::Landmark landmark;
    landmark.name = name;
    landmark.object = object.name;
    landmark.world = WorldPoint(place);
    landmark.anchor = closest->anchor;
    landmark.uncertainty = WorldVector(0.01, 0.01, 0.01);
    return landmark;
}

} // namespace

class TestJobFailures : public QObject, FolderUser {
    Q_OBJECT

private slots:
    void init() { changeFolder(); }
    void filesAreNotOpened_data() { addRows(); }

    void filesAreNotOpened()
    {
        QFETCH(JobFailure::Kind, kind);
        QFETCH(QString, reason);
        const auto desk = this->desk();
        const QStringList files{file(QStringLiteral("triangle.obj"))};
        QSignalSpy ended(&desk->session, &Session::loadingEnded);
        {
            const Fault fault(kind);
            QVERIFY(desk->openAndWait(files));
        }
        QCOMPARE(desk->failures,
                 QStringList(QStringLiteral("The files cannot be opened: %1. Close other programs, then try "
                                            "again.")
                                 .arg(reason)));
        QCOMPARE(ended.size(), 1);
        QVERIFY(desk->openAndWait(files));
        QCOMPARE(desk->names(), QStringList(QStringLiteral("triangle.obj")));
        QCOMPARE(desk->failures.size(), 1);
    }

    void standInsAreNotMade_data() { addRows(); }

    void standInsAreNotMade()
    {
        QFETCH(JobFailure::Kind, kind);
        QFETCH(QString, reason);
        const auto desk = this->desk();
        ModelStore &models = desk->session.models();
        QSignalSpy failed(&models, &ModelStore::jobFailed);
        const std::vector<SceneObject> objects = ball(kVeryMany);
        {
            const Fault fault(kind);
            models.makeStandIns(objects);
            QVERIFY(failed.wait(kPatienceMilliseconds));
        }
        QCOMPARE(desk->notices,
                 QStringList(QStringLiteral("Large models are not simplified while the view moves: %1.").arg(reason)));
        QVERIFY2(!models.standInsFor(objects), "the model itself is drawn");
        QSignalSpy made(&models, &ModelStore::standInReady);
        // There may be a thread by now, for the same model too.
        const std::vector<SceneObject> next = kind == JobFailure::Kind::NoThread ? objects : ball(kVeryMany);
        models.makeStandIns(next);
        QVERIFY(made.wait(kPatienceMilliseconds));
        QVERIFY(models.standInsFor(next));
    }

    void theRayIsImpossible_data() { addRows(); }

    void theRayIsImpossible()
    {
        QFETCH(JobFailure::Kind, kind);
        QFETCH(QString, reason);
        SceneDocument document;
        document.setSurface({400, 300, 1.0});
        {
            const Fault fault(kind);
            openObjects(document, ball(kMany));
            pickAt(document, WidgetPoint(200.0, 150.0), {0.3, 0, 24});
            QVERIFY(document.picks().pickedRay());
            QTRY_VERIFY_WITH_TIMEOUT(document.picks().pickedRay()->state == PickedRay::State::Impossible,
                                     kPatienceMilliseconds);
            QVERIFY(document.picks().pickedRay()->failure);
            QCOMPARE(failureText(*document.picks().pickedRay()->failure), reason);
            QVERIFY(!document.picks().rays());
            document.picks().rayCasters().complete(document.objects());
            QVERIFY(document.picks().rayCasters().failureOf(document.objects()));
        }
        // The lack of a thread may pass at once; for more memory the model is opened again.
        if (kind == JobFailure::Kind::OutOfMemory)
            openObjects(document, ball(kMany));
        document.picks().rayCasters().complete(document.objects());
        QVERIFY(document.picks().rays());
        QVERIFY(!document.picks().rayCasters().failureOf(document.objects()));
    }

    void aMapIsNotMade_data() { addRows(); }

    void aMapIsNotMade()
    {
        QFETCH(JobFailure::Kind, kind);
        QFETCH(QString, reason);
        SceneDocument document;
        document.setSurface({40, 30, 1.0});
        openObjects(document, {{"cube", {}, modelOf(examples::cubeMesh(2.0)), {}}});
        QVERIFY(document.picks().rays());
        MapMaker maker(document);
        QSignalSpy failed(&maker, &MapMaker::jobFailed), made(&maker, &MapMaker::made);
        {
            const Fault fault(kind);
            QVERIFY(maker.ask({}));
            QVERIFY(failed.wait(kPatienceMilliseconds));
        }
        QCOMPARE(failureText(failed[0][0].value<JobFailure>()), reason);
        QVERIFY(!maker.isMaking() && made.isEmpty());
        QVERIFY(maker.ask({}));
        QVERIFY(made.wait(kPatienceMilliseconds));
    }

    void curvesSayWhy_data() { addRows(); }

    void curvesSayWhy()
    {
        QFETCH(JobFailure::Kind, kind);
        QFETCH(QString, reason);
        SceneDocument document;
        openObjects(document, ball(kMany));
        document.picks().rayCasters().complete(document.objects());
        const SceneObject &ball = document.objects()[0];
        const std::vector<landmarks::Landmark> landmarks{pointOn(ball, {0.0, 0.0, 1.0}, "a"),
                                                         pointOn(ball, {0.0, 0.6, 0.8}, "b"),
                                                         pointOn(ball, {0.6, 0.0, 0.8}, "c")};
        QVERIFY(editLandmarks(document, landmarks, {"put"}));
        SceneCurves &curves = document.curves();
        {
            const Fault fault(kind);
            QCOMPARE(curves.join({0, 1}, landmarks::CurveKind::Geodesic), QString());
            QTRY_VERIFY_WITH_TIMEOUT(!curves.isComputing(), kPatienceMilliseconds);
            QCOMPARE(curves.line(0).reason, reason);
            QVERIFY(!curves.line(0).line && !curves.line(0).isComputing);
            const auto unknown = curves.withSemilandmarks();
            QVERIFY2(!unknown, "a file would lose them");
            QCOMPARE(unknown.error(), reason);
        }
        const auto known = curves.withSemilandmarks();
        QVERIFY2(known && known->curves[0].semilandmarks.size() > 2, "tried again");
        QCOMPARE(curves.join({0, 2}, landmarks::CurveKind::Geodesic), QString());
        QVERIFY(curves.complete());
        QVERIFY(curves.line(1).line && curves.line(1).line->length.value > 0.6);
    }

    void theDoctorHasNoAnswer_data() { addRows(); }

    void theDoctorHasNoAnswer()
    {
        QFETCH(JobFailure::Kind, kind);
        QFETCH(QString, reason);
        SceneDocument document;
        document.setSurface({400, 300, 1.0});
        Diagnoser diagnoser;
        QSignalSpy failed(&diagnoser, &Diagnoser::jobFailed), answered(&diagnoser, &Diagnoser::answered);
        const auto ask = [&] {
            doctor::WrongPoint point;
            point.pixel = DevicePoint(200.0, 150.0);
            point.got = {1.0, 2.0, 3.0};
            diagnoser.ask({document.unprojector().setup(), {}, {}, {}, {}}, {point});
        };
        {
            const Fault fault(kind);
            ask();
            QVERIFY(failed.wait(kPatienceMilliseconds));
        }
        QCOMPARE(failureText(failed[0][0].value<JobFailure>()), reason);
        QVERIFY(answered.isEmpty());
        ask();
        QVERIFY(answered.wait(kPatienceMilliseconds));
    }
};

UNPROJECTOR_TEST(TestJobFailures)
#include "test_job_failures.moc"
