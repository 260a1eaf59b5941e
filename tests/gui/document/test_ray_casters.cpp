// The preparation of models for rays: at once or on a thread of its own, and kept no longer than
// the model is used. No window: the thread sanitizer can follow this.

#include "tests/support/test.h"

#include "core/examples/solids.h"
#include "gui/document/ray_casters.h"
#include "tests/support/patience.h"

#include <QSignalSpy>

#include <memory>
#include <thread>
#include <vector>

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::mesh;
using namespace unprojector::scene;

namespace {

/// 20 * 4^subdivisions triangles: up to 5 subdivisions are few.
constexpr int kFew = 3, kMany = 7;

SceneObject ball(int subdivisions)
{
    auto model = std::make_shared<Model>();
    model->meshes.push_back(examples::sphereMesh(1.0, subdivisions));
    model->bounds = boundsOf(model->meshes);
    return {"ball", {}, model, {}};
}

bool isExpired(const std::weak_ptr<const Model> &model)
{
    return QTest::qWaitFor([&] { return model.expired(); }, kPatienceMilliseconds);
}

} // namespace

class TestRayCasters : public QObject {
    Q_OBJECT

private slots:
    void fewTrianglesAreReadyAtOnce()
    {
        RayCasters casters;
        QSignalSpy built(&casters, &RayCasters::built);
        const std::vector<SceneObject> objects{ball(kFew), ball(kFew)};
        QVERIFY(!casters.of(objects));
        casters.prepare(objects);
        QVERIFY(!casters.isPreparing());
        QCOMPARE(built.size(), 2);
        const auto ready = casters.of(objects);
        QVERIFY(ready && ready->size() == 2);
        QVERIFY(&ready->at(0)->model() == objects[0].model.get());
        const auto hit = ready->at(1)->nearestTriangle({ObjectPoint(0.1, 0.2, 5.0), {0.0, 0.0, -1.0}, 0.0, 100.0});
        QVERIFY(hit && std::abs(hit->t - 4.0) < 0.1);
    }

    void manyComeFromAThread()
    {
        RayCasters casters;
        QSignalSpy built(&casters, &RayCasters::built), finished(&casters, &RayCasters::finished);
        QSignalSpy progressed(&casters, &RayCasters::progressed);
        const std::vector<SceneObject> objects{ball(kMany), ball(kFew), ball(kMany)};
        casters.prepare(objects);
        QVERIFY(casters.isPreparing());
        QVERIFY2(built.size() == 1 && casters.of({objects[1]}), "the small one is not kept waiting");
        QVERIFY(!casters.of(objects));
        QVERIFY(finished.wait(kPatienceMilliseconds));
        QVERIFY(!casters.isPreparing() && casters.of(objects));
        QCOMPARE(built.size(), 3);
        QVERIFY(!progressed.isEmpty());
        double last = 0.0;
        for (const QList<QVariant> &report : progressed) {
            QVERIFY(report[0].toDouble() >= last && report[0].toDouble() <= 1.0);
            last = report[0].toDouble();
        }
        QVERIFY(last > 0.5);
    }

    void eachModelIsPreparedOnce()
    {
        RayCasters casters;
        QSignalSpy built(&casters, &RayCasters::built);
        std::vector<SceneObject> objects{ball(kMany)};
        objects.push_back(objects[0]);
        casters.prepare(objects);
        casters.prepare(objects); // it is under way
        QVERIFY(built.wait(kPatienceMilliseconds));
        casters.prepare(objects);
        QTest::qWait(20);
        QCOMPARE(built.size(), 1);
    }

    void hiddenObjectsWait()
    {
        RayCasters casters;
        std::vector<SceneObject> objects{ball(kFew), ball(kMany)};
        objects[0].isHidden = objects[1].isHidden = true;
        casters.prepare(objects);
        QVERIFY(!casters.isPreparing());
        const auto none = casters.of(objects);
        QVERIFY(none && !none->at(0) && !none->at(1));
        objects[0].isHidden = false;
        QVERIFY(!casters.of(objects));
    }

    void otherObjectsEndWhatWasBegun()
    {
        RayCasters casters;
        QSignalSpy built(&casters, &RayCasters::built), finished(&casters, &RayCasters::finished);
        const std::vector<SceneObject> before{ball(kMany), ball(kMany)}, after{ball(kMany)};
        casters.prepare(before);
        casters.prepare(after);
        QVERIFY(finished.wait(kPatienceMilliseconds));
        QCOMPARE(built.size(), 1);
        QVERIFY(casters.of(after) && !casters.of(before));
        casters.prepare(before);
        casters.prepare({});
        QCOMPARE(finished.size(), 2);
        QTest::qWait(50);
        QCOMPARE(built.size(), 1);
    }

    void noModelIsKept_data()
    {
        addColumn<int>("subdivisions");
        addColumn<bool>("isReady");
        newRow("ready at once") << kFew << true;
        newRow("ready") << kMany << true;
        newRow("being prepared") << kMany << false;
    }

    void noModelIsKept()
    {
        QFETCH(int, subdivisions);
        QFETCH(bool, isReady);
        RayCasters casters;
        QSignalSpy finished(&casters, &RayCasters::finished);
        std::vector<SceneObject> objects{ball(subdivisions)};
        const std::weak_ptr<const Model> model = objects[0].model;
        casters.prepare(objects);
        if (isReady && casters.isPreparing())
            QVERIFY(finished.wait(kPatienceMilliseconds));
        objects.clear();
        QVERIFY(!isReady || model.expired());
        QVERIFY(isExpired(model));
        QVERIFY(QTest::qWaitFor([&] { return !casters.isPreparing(); }, kPatienceMilliseconds));
    }

    void whoHasACasterHasItsModel()
    {
        RayCasters casters;
        std::vector<SceneObject> objects{ball(kFew)};
        const std::weak_ptr<const Model> model = objects[0].model;
        casters.prepare(objects);
        auto held = casters.of(objects);
        objects.clear();
        casters.prepare({});
        QVERIFY(!model.expired());
        QVERIFY(held->at(0)->nearestTriangle({ObjectPoint(0.1, 0.2, 5.0), {0.0, 0.0, -1.0}, 0.0, 100.0}));
        held.reset();
        QVERIFY(model.expired());
    }

    void allCanBeWaitedFor()
    {
        RayCasters casters;
        QSignalSpy built(&casters, &RayCasters::built), finished(&casters, &RayCasters::finished);
        const std::vector<SceneObject> objects{ball(kMany), ball(kFew), ball(kMany)};
        casters.prepare({objects[2]}); // one of them is under way
        casters.complete(objects);
        QVERIFY(casters.of(objects) && !casters.isPreparing());
        QTest::qWait(20);
        QCOMPARE(built.size(), 3);
        QCOMPARE(finished.size(), 1);
    }

    void nothingIsPreparedUntilAskedFor()
    {
        RayCasters casters;
        casters.waitUntilAsked();
        const std::vector<SceneObject> objects{ball(kFew), ball(kMany)};
        casters.prepare(objects);
        QVERIFY(!casters.isPreparing() && !casters.of({objects[0]}));
        casters.complete(objects);
        QVERIFY(casters.of(objects));
    }

    void theyMayGoWhileTheyPrepare()
    {
        for (int i = 0; i < 5; ++i) {
            RayCasters casters;
            casters.prepare({ball(kMany), ball(kMany)});
            QTest::qWait(i);
        }
    }
};

UNPROJECTOR_TEST(TestRayCasters)
#include "test_ray_casters.moc"
