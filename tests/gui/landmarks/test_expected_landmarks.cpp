// Where the other scans of a series expect a landmark, and the landmarks of a series out of place.

#include "tests/support/test.h"

#include "core/landmarks/out_of_place.h"
#include "gui/document/camera_looks.h"
#include "gui/document/scene_edits.h"
#include "gui/landmarks/expected_landmarks.h"
#include "gui/landmarks/series_shapes.h"
#include "tests/gui/landmarks/landmark_desk.h"
#include "tests/support/patience.h"

#include <glm/geometric.hpp>

#include <cmath>

using namespace landmarkfiles;
using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::gui;

namespace {

/// Six landmarks of the square; the names differ in case from scan to scan.
const QByteArray kFirst = "name,x,y,z\na,1,1,0\nb,9,1,0\nc,9,9,0\nd,1,9,0\ne,5,2,0\nf,6,7,0\n";
const QByteArray kSecond = "name,x,y,z\nA,1,1,0\nB,9,1,0\nC,9,9,0\nD,1,9,0\nE,5,2.5,0\nF,6,7,0\n";

} // namespace

class TestExpectedLandmarks : public LandmarksTest {
    Q_OBJECT

private slots:
    void init() { begin(); }

    void namesAreMatchedAsInTheSeries()
    {
        std::vector<Landmark> one(2), other(2);
        one[0].name = "Nasion";
        one[0].world = WorldPoint(1.0, 2.0, 3.0);
        one[1].name = "eye left";
        other[0].name = "Eye Right";
        other[1].name = "nasion";
        other[1].world = WorldPoint(4.0, 5.0, 6.0);
        const SeriesShapes shapes = shapesOf({&one, &other});
        QCOMPARE(shapes.names, QStringList({"Nasion", "eye left", "Eye Right"}));
        QCOMPARE(shapes.places[1], std::vector<std::size_t>({2, 0}));
        QCOMPARE(shapes.scans[1][0]->x, 4.0);
        QVERIFY(!shapes.scans[0][1]);
        QCOMPARE(shapes.pairs(), std::vector<landmarks::Pair>({{1, 2}}));
    }

    void thePlacesAreThoseOfTheOtherScans()
    {
        openSeries();
        QCOMPARE(expectedIndices(), QVector<std::size_t>({3, 4, 5}));
        const std::vector<ExpectedLandmark> &all = m_expected->all();
        QVERIFY(distance(all[0].world, WorldPoint(1.0, 9.0, 0.0)) < 0.1);
        QVERIFY(distance(all[1].world, WorldPoint(5.0, 2.25, 0.0)) < 0.1); // the middle of both
        QVERIFY(std::abs(*all[1].spread - 0.5) < 0.1);                     // each finds it half a unit off
        QVERIFY(*all[0].spread < 0.2);
        QVERIFY(all[0].isNext && !all[1].isNext);
        m_document->sceneLandmarks().setNextUnplaced(5);
        QVERIFY(m_expected->all()[2].isNext);

        // A placed one is expected no more.
        Landmark placed;
        placed.world = WorldPoint(6.0, 7.0, 0.0);
        QVERIFY(m_document->sceneLandmarks().place(placed));
        QCOMPARE(expectedIndices(), QVector<std::size_t>({3, 4}));
        // Fewer than three placed: none.
        QVERIFY(m_document->sceneLandmarks().remove({0, 1}));
        QVERIFY(m_expected->all().empty());
    }

    void theyAreNoPartOfTheScene()
    {
        openSeries();
        const auto before = m_document->scene().landmarks;
        QCOMPARE(m_expected->all().size(), std::size_t(3));
        QVERIFY(m_expected->faceNext().isEmpty());
        QVERIFY(m_document->scene().landmarks == before);
        QVERIFY(m_series->keep());
        QCOMPARE(read(QStringLiteral("u.obj.points.csv")),
                 QByteArray("name,x,y,z\na,1,1,0\nb,9,1,0\nc,9,9,0\nd,,,\nE,,,\nf,,,\n"));
    }

    void aMissingLandmarkIsNotExpected()
    {
        openSeries();
        std::vector<Landmark> all = points();
        all[4].absence = landmarks::Absence::Missing;
        QVERIFY(editLandmarks(*m_document, all, {QStringLiteral("missing")}));
        QCOMPARE(expectedIndices(), QVector<std::size_t>({3, 5}));
    }

    void nTurnsTheCameraToTheNextOne()
    {
        openSeries();
        setCamera(*m_document, {WorldPoint(30.0, 5.0, 20.0), WorldPoint(5.0, 5.0, 0.0), WorldVector(0.0, 1.0, 0.0)});
        const double away = distance(WorldPoint(30.0, 5.0, 20.0), WorldPoint(5.0, 5.0, 0.0));
        QCOMPARE(m_expected->faceNext(), QString());
        const LookAt camera = m_document->scene().camera;
        QVERIFY(distance(camera.center, WorldPoint(1.0, 9.0, 0.0)) < 0.1);
        QVERIFY(std::abs(camera.center.z) < 1e-12); // on the surface
        const WorldVector back = normalized(camera.eye - camera.center);
        QVERIFY(std::abs(back.z - 1.0) < 1e-12); // along its normal
        QVERIFY(std::abs(distance(camera.eye, camera.center) - away) < 1e-9);
    }

    void nTellsWhyItCannot()
    {
        ExpectedLandmarks none(*m_document, *m_series);
        QVERIFY2(none.faceNext().contains(QStringLiteral("No scan of a series is shown")), qPrintable(none.faceNext()));
        openSeries();
        const LookAt before = m_document->scene().camera;
        std::vector<Landmark> all = points();
        all[2].world = WorldPoint(5.0, 1.0, 0.0); // on the line of a and b
        QVERIFY(editLandmarks(*m_document, all, {QStringLiteral("line")}));
        QVERIFY(m_expected->faceNext().contains(QStringLiteral("on a line")));
        all[2].world.reset();
        QVERIFY(editLandmarks(*m_document, all, {QStringLiteral("two")}));
        QVERIFY(m_expected->faceNext().contains(QStringLiteral("Place three landmarks")));
        all[2].world = WorldPoint(9.0, 9.0, 0.0);
        all[3].name = "unknown";
        QVERIFY(editLandmarks(*m_document, all, {QStringLiteral("unknown")}));
        m_document->sceneLandmarks().setNextUnplaced(3);
        QVERIFY2(m_expected->faceNext().contains(QStringLiteral("No other scan of the series has unknown")),
                 qPrintable(m_expected->faceNext()));
        m_document->sceneLandmarks().setNextUnplaced(std::nullopt);
        QVERIFY(m_expected->faceNext().contains(QStringLiteral("No landmark is next")));
        QVERIFY(m_document->scene().camera == before);
        // The other scans have landmarks, but of the first placing only.
        m_series->setPlacing(2);
        m_document->sceneLandmarks().setNextUnplaced(0);
        QVERIFY2(m_expected->faceNext().contains(QStringLiteral("of this placing (2)")),
                 qPrintable(m_expected->faceNext()));
    }

private:
    /// Opens a series of three scans whose third has the landmarks a, b and c.
    void openSeries()
    {
        for (const char *name : {"t.obj", "u.obj"})
            write(QLatin1String(name), kSquare);
        write(QStringLiteral("square.obj.points.csv"), kFirst);
        write(QStringLiteral("t.obj.points.csv"), kSecond);
        // In the scan's own file the square is the same; the landmarks to place have other cases.
        write(QStringLiteral("u.obj.points.csv"), "name,x,y,z\na,1,1,0\nb,9,1,0\nc,9,9,0\nd,,,\nE,,,\nf,,,\n");
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(m_series->current(), std::optional<std::size_t>(2));
        m_expected = std::make_unique<ExpectedLandmarks>(*m_document, *m_series);
    }

    QVector<std::size_t> expectedIndices()
    {
        QVector<std::size_t> indices;
        for (const ExpectedLandmark &one : m_expected->all())
            indices << one.index;
        return indices;
    }

    std::unique_ptr<ExpectedLandmarks> m_expected;
};

UNPROJECTOR_TEST(TestExpectedLandmarks, threads)
#include "test_expected_landmarks.moc"
