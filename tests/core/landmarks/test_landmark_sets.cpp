// Templates, repeated placings, landmarks tied to objects, and the names of files next to scans.

#include "tests/support/test.h"

#include "core/landmark_files/landmark_folder.h"
#include "core/landmark_files/repeats_table.h"
#include "core/landmarks/name_key.h"
#include "core/landmarks/point_template.h"
#include "core/landmarks/repeats.h"
#include "core/ray/tie_landmark.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace {
using namespace unprojector::landmarks;
using namespace unprojector::landmark_files;
using namespace unprojector::geometry;
using unprojector::mesh::Mesh;
using unprojector::mesh::Model;
using unprojector::ray::ClosestPlaces;
using unprojector::ray::Tied;
using unprojector::ray::tieToMesh;
using unprojector::ray::TyingTarget;

Landmark named(const char *name, std::optional<glm::dvec3> world = {}, const char *note = "")
{
    Landmark landmark;
    landmark.name = name;
    if (world)
        landmark.world = WorldPoint(*world);
    landmark.note = note;
    return landmark;
}

QStringList namesOf(const std::vector<Landmark> &landmarks)
{
    QStringList names;
    for (const Landmark &landmark : landmarks)
        names << QString::fromStdString(landmark.name);
    return names;
}

/// The triangle (0, 0, z), (1, 0, z), (0, 1, z).
std::shared_ptr<const ClosestPlaces> triangleAt(float z)
{
    auto model = std::make_shared<Model>();
    Mesh mesh;
    mesh.positions = {{0.0F, 0.0F, z}, {1.0F, 0.0F, z}, {0.0F, 1.0F, z}};
    mesh.indices = {0, 1, 2};
    model->meshes.push_back(std::move(mesh));
    model->bounds.add(glm::dvec3(0.0, 0.0, z));
    model->bounds.add(glm::dvec3(1.0, 1.0, z));
    return ClosestPlaces::build(std::move(model), {});
}

} // namespace

class TestLandmarkSets : public QObject {
    Q_OBJECT

private slots:
    void aTemplateAddsWhatIsLacking_data()
    {
        addColumn<QStringList>("there");
        addColumn<QStringList>("wanted");
        addColumn<QStringList>("all");
        using L = QStringList;
        newRow("none yet") << L{} << L{"a", "b"} << L{"a", "b"};
        newRow("one is there") << L{"b"} << L{"a", "b"} << L{"b", "a"};
        newRow("in another case") << L{"Nasion"} << L{"nasion"} << L{"Nasion"};
        newRow("all are there") << L{"a", "b"} << L{"b", "a"} << L{"a", "b"};
        newRow("others stay in front") << L{"x"} << L{"a"} << L{"x", "a"};
        newRow("a name twice") << L{"a"} << L{"a", "a"} << L{"a", "a"};
    }

    void aTemplateAddsWhatIsLacking()
    {
        QFETCH(QStringList, there);
        QFETCH(QStringList, wanted);
        QFETCH(QStringList, all);
        std::vector<Landmark> landmarks, names;
        for (const QString &name : there)
            landmarks.push_back(named(qPrintable(name), glm::dvec3(1.0)));
        for (const QString &name : wanted)
            names.push_back(named(qPrintable(name), glm::dvec3(2.0), "where"));
        const std::vector<Landmark> filled = withTemplate(landmarks, names);
        QCOMPARE(namesOf(filled), all);
        for (std::size_t i = 0; i < filled.size(); ++i) {
            QCOMPARE(!filled[i].isPlaced(), i >= landmarks.size());
            QCOMPARE(filled[i].note, std::string()); // the template's words are not the scan's
        }
    }

    void landmarksFillTheirPlacesOfATemplate_data()
    {
        addColumn<QStringList>("there");
        addColumn<QStringList>("wanted");
        addColumn<QStringList>("all");
        using L = QStringList;
        newRow("nothing there") << L{} << L{"a", "b"} << L{"-a", "-b"};
        newRow("the others behind") << L{"x", "b"} << L{"a", "b", "c"} << L{"-a", "b", "-c", "x"};
        newRow("in the template's order") << L{"b", "a"} << L{"a", "b"} << L{"a", "b"};
        newRow("in another case") << L{"Nasion"} << L{"tip", "nasion"} << L{"-tip", "Nasion"};
        newRow("with underscores") << L{"x", "Eye_left"} << L{"eye left"} << L{"Eye_left", "x"};
        newRow("both ways of writing") << L{"a_b", "a b"} << L{"a b", "a_b"} << L{"a b", "a_b"};
        newRow("a name twice") << L{"a", "x", "a"} << L{"a"} << L{"a", "x", "a"};
        newRow("twice in the template") << L{"x", "a"} << L{"a", "a"} << L{"a", "-a", "x"};
    }

    void landmarksFillTheirPlacesOfATemplate()
    {
        QFETCH(QStringList, there);
        QFETCH(QStringList, wanted);
        QFETCH(QStringList, all);
        std::vector<Landmark> landmarks, names;
        for (const QString &name : there)
            landmarks.push_back(named(qPrintable(name), glm::dvec3(double(landmarks.size()))));
        for (const QString &name : wanted)
            names.push_back(named(qPrintable(name), glm::dvec3(2.0), "where"));
        QStringList filled;
        double lastOfName = -1.0;
        for (const Landmark &landmark : inTemplateOrder(landmarks, names)) {
            filled << (!landmark.isPlaced() ? u'-' + QString::fromStdString(landmark.name)
                                            : QString::fromStdString(landmark.name));
            QCOMPARE(landmark.note, std::string());
            if (landmark.world && landmark.name == "a") {
                QVERIFY(landmark.world->x > lastOfName); // of one name the first comes first
                lastOfName = landmark.world->x;
            }
        }
        QCOMPARE(filled, all);
    }

    void hintsGoByName()
    {
        const std::vector<Landmark> names{named("nasion", {}, "between the eyes"), named("tip")};
        QCOMPARE(hintFor("Nasion", names), std::string_view("between the eyes"));
        QCOMPARE(hintFor("tip", names), std::string_view());
        QCOMPARE(hintFor("chin", names), std::string_view());
        QCOMPARE(hintFor("_nasion ", names), std::string_view("between the eyes"));
        QCOMPARE(nameKey(" Broca's  point_"), std::string("broca_s_point"));
        QVERIFY(nameKey("_ ").empty());
    }

    /// One rule for files, templates, series and measures.
    void spellingsOfOneName()
    {
        for (const auto &[a, b] : {std::pair("Nasion", "nasion "), std::pair("eye left", "Eye_Left"),
                                   std::pair("ÖHR", "öhr"), std::pair("Ÿ Ž", "ÿ_ž"), std::pair("ΩΈΣ", "ωΈσ"),
                                   std::pair("ЁЖ", "ёж"), std::pair("ŁŹ", "łź"), std::pair("Œ", "œ")})
            QVERIFY2(isSameName(a, b) && isSameName(b, a), a);
        for (const auto &[a, b] : {std::pair("a b", "ab"), std::pair("#", "_"), std::pair("", "_"), std::pair("é", "e"),
                                   std::pair("×", "÷"), std::pair("左", "右"), std::pair("ı", "İ")})
            QVERIFY2(!isSameName(a, b) && !isSameName(b, a), a);
        QVERIFY(isSameName("#", "#"));
        const std::vector<Landmark> both{named("a_b"), named("A b"), named("#")};
        QCOMPARE(indexOfName(both, "A b"), std::optional<std::size_t>(1)); // its own spelling comes first
        QCOMPARE(indexOfName(both, "a b"), std::optional<std::size_t>(0));
        QCOMPARE(indexOfName(both, "#"), std::optional<std::size_t>(2));
        QVERIFY(!indexOfName(both, "_"));
        // Neither stands for the other in a template that has both.
        const auto count = [](std::vector<Landmark> there, const std::vector<Landmark> &names) {
            return withTemplate(std::move(there), names).size();
        };
        QCOMPARE(count({named("a_b")}, {named("a b"), named("a_b")}), std::size_t(2));
        QCOMPARE(withTemplate({named("a_b")}, std::vector{named("a b"), named("a_b")})[1].name, std::string("a b"));
        QCOMPARE(count({named("A_B")}, {named("a b")}), std::size_t(1));
        QCOMPARE(count({named("A_B")}, {named("a b"), named("a b")}), std::size_t(2));
    }

    void picturesGoByName()
    {
        std::vector<Landmark> names{named("nasion"), named("tip"), named("chin")};
        names[0].extra.edit() = {{"picture", "pictures/nasion.png"}};
        names[1].extra.edit() = {{"picture", 7}, {"sex", "f"}};
        QCOMPARE(pictureFor("NASION", names), std::string_view("pictures/nasion.png"));
        for (const char *none : {"tip", "chin", "ear"})
            QCOMPARE(pictureFor(none, names), std::string_view());
    }

    void repeatsOfThreePlacings()
    {
        std::vector<LandmarkSet> placings(3);
        placings[0].landmarks = {named("a", glm::dvec3(1, 0, 0)), named("b", glm::dvec3(5, 5, 5)), named("c")};
        placings[1].landmarks = {named("c"), named("a", glm::dvec3(-1, 0, 0))};
        placings[2].landmarks = {named("a", glm::dvec3(0, 3, 0)), named("a", glm::dvec3(7, 7, 7))};
        const std::vector<RepeatedLandmark> repeats = repeatsOf(placings);
        QCOMPARE(repeats.size(), std::size_t(4));
        QCOMPARE(repeats[0].name, std::string("a"));
        QCOMPARE(repeats[0].count, std::size_t(3));
        QCOMPARE(repeats[0].mean->coordinates(), glm::dvec3(0, 1, 0));
        QCOMPARE(*repeats[0].error, std::sqrt((2.0 + 2.0 + 4.0) / 2.0));
        QCOMPARE(repeats[0].farthest, 2.0);
        QCOMPARE(repeats[1].count, std::size_t(1));
        QVERIFY(repeats[1].mean && !repeats[1].error);
        QCOMPARE(repeats[2].name, std::string("c"));
        QVERIFY(!repeats[2].mean && repeats[2].count == 0);
        QCOMPARE(repeats[3].name, std::string("a (2)"));
        QVERIFY(repeatsOf({}).empty());
        // Two of a name, and one that is called as the second of them would be.
        placings[1].landmarks = {named("a (2)", glm::dvec3(1, 1, 1)), named("", glm::dvec3(2, 2, 2)), named("2")};
        QStringList names;
        for (const RepeatedLandmark &repeated : repeatsOf(placings))
            names << QString::fromStdString(repeated.name);
        QCOMPARE(names, QStringList({"a", "b", "c", "a (2)", "2 (2)", "2", "a (3)"}));
    }

    void farFromTheOriginRepeatsAreAsSure()
    {
        std::vector<LandmarkSet> placings(2);
        placings[0].landmarks = {named("a", glm::dvec3(1e15, 0, 0))};
        placings[1].landmarks = {named("a", glm::dvec3(1e15 + 2.0, 0, 0))};
        const RepeatedLandmark repeated = repeatsOf(placings).front();
        QCOMPARE(repeated.mean->coordinates().x, 1e15 + 1.0);
        QCOMPARE(*repeated.error, std::sqrt(2.0));
        // Neither their difference nor its square is a double.
        placings[0].landmarks = {named("a", glm::dvec3(-1e308, 0, 0)), named("b", glm::dvec3(-1.7e308)),
                                 named("c", glm::dvec3(1e-300, 0, 0))};
        placings[1].landmarks = {named("a", glm::dvec3(1e308, 0, 0)), named("b", glm::dvec3(1.7e308)),
                                 named("c", glm::dvec3(3e-300, 0, 0))};
        const std::vector<RepeatedLandmark> repeats = repeatsOf(placings);
        QCOMPARE(repeats[0].mean->coordinates(), glm::dvec3(0.0));
        QCOMPARE(*repeats[0].error, std::sqrt(2.0) * 1e308);
        QCOMPARE(repeats[0].farthest, 1e308);
        QCOMPARE(repeats[1].mean->coordinates(), glm::dvec3(0.0));
        QVERIFY(!repeats[1].error && std::isinf(repeats[1].farthest));
        QCOMPARE(*repeats[2].error / 1e-300, std::sqrt(2.0));
        const std::vector<RepeatedSpecimen> specimens{{"s", placings, {"a", "b"}}};
        const auto table = repeatsTable(specimens);
        QVERIFY(table && table->text.find("\ns,b,2,0,0,0,,\n") != std::string::npos);
    }

    void tiedToTheClosest()
    {
        TyingTarget low{"low", triangleAt(0.0F)}, high{"high", triangleAt(0.0F)};
        high.worldFromObject[3] = glm::dvec4(0.0, 0.0, 10.0, 1.0);
        high.worldFromObject[2][2] = 2.0;
        const std::vector<TyingTarget> targets{low, high};
        Landmark landmark = named("a", glm::dvec3(0.25, 0.25, 9.5));
        landmark.object = "gone";
        const std::optional<Tied> tied = tieToMesh(landmark, targets);
        QVERIFY(tied);
        QCOMPARE(tied->distance, 0.5);
        QCOMPARE(tied->target, std::size_t(1));
        QCOMPARE(landmark.object, std::string("high"));
        QCOMPARE(landmark.world->coordinates(), glm::dvec3(0.25, 0.25, 10.0));
        QVERIFY(std::holds_alternative<OnTriangle>(landmark.anchor));

        Landmark missing = named("b");
        QVERIFY(!tieToMesh(missing, targets));
        QCOMPARE(missing, named("b"));
        Landmark alone = named("c", glm::dvec3(1.0));
        QVERIFY(!tieToMesh(alone, {}));
        QCOMPARE(alone, named("c", glm::dvec3(1.0)));
    }

    void tiedToTheObjectThatIsNamed()
    {
        const std::vector<TyingTarget> targets{{"low", triangleAt(0.0F)}, {"high", triangleAt(10.0F)}};
        Landmark landmark = named("a", glm::dvec3(0.25, 0.25, 9.5));
        landmark.object = "low";
        const std::optional<Tied> tied = tieToMesh(landmark, targets);
        QVERIFY(tied);
        QCOMPARE(tied->target, std::size_t(0));
        QCOMPARE(tied->distance, 9.5);
    }

    void aHoldThatIsWhereItIsStays()
    {
        const std::vector<TyingTarget> targets{{"low", triangleAt(0.0F)}};
        Landmark landmark = named("a", glm::dvec3(1.0, 0.0, 0.0));
        landmark.object = "low";
        landmark.anchor = AtVertex{1};
        const Landmark before = landmark;
        QVERIFY(tieToMesh(landmark, targets));
        QCOMPARE(landmark, before);
        // Held by another mesh's vertex: that is elsewhere here.
        landmark.anchor = AtVertex{0};
        QVERIFY(tieToMesh(landmark, targets));
        QVERIFY(std::holds_alternative<OnTriangle>(landmark.anchor));
        QCOMPARE(landmark.world->coordinates(), glm::dvec3(1.0, 0.0, 0.0));
    }

    void filesBesideScans_data()
    {
        addColumn<QString>("file");
        addColumn<QString>("specimen");
        newRow("beside a scan") << "dir/face.ply.points.csv"
                                << "face";
        newRow("a second placing") << "face.ply.points-2.csv"
                                   << "face";
        newRow("a scan with dots") << "face.v2.obj.points.csv"
                                   << "face.v2";
        newRow("no scan before it") << "face.points.csv"
                                    << "face";
        newRow("a name that only looks like it") << "face.pointsmap.csv"
                                                 << "face.pointsmap";
        newRow("markups") << "face.mrk.json"
                          << "face";
        newRow("picked points") << "face.ply.pp"
                                << "face.ply";
    }

    void filesBesideScans()
    {
        QFETCH(QString, file);
        QFETCH(QString, specimen);
        QCOMPARE(QString::fromStdString(specimenOf(file.toStdU16String())), specimen);
        QCOMPARE(landmarksBeside("dir/face.ply"), std::filesystem::path("dir/face.ply.points.csv"));
        QCOMPARE(landmarksBeside("face.ply", 2), std::filesystem::path("face.ply.points-2.csv"));
    }
};

UNPROJECTOR_TEST(TestLandmarkSets)
#include "test_landmark_sets.moc"
