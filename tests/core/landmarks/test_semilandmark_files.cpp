// Curves in landmark files: ends that are landmarks, curves of 3D Slicer, and the sliders for
// geomorph, whose numbers are those of the written points.

#include "tests/support/test.h"

#include "core/landmark_files/landmark_folder.h"
#include "core/landmark_files/sliders.h"
#include "core/landmark_files/specimen_table.h"
#include "tests/core/landmarks/strict_landmarks.h"

#include <nlohmann/json.hpp>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::landmark_files;
using namespace unprojector::landmarks;
using namespace strict_landmarks;

namespace {

Landmark landmarkAt(const char *name, const glm::dvec3 &place)
{
    Landmark landmark;
    landmark.name = name;
    landmark.world = WorldPoint(place);
    return landmark;
}

/// A curve with `count` semilandmarks on the straight line from one place to another.
Curve straight(const char *name, const std::vector<std::string> &points, const glm::dvec3 &from, const glm::dvec3 &to,
               int count)
{
    Curve curve;
    curve.name = name;
    curve.points = points;
    curve.count = static_cast<std::uint32_t>(count);
    for (int i = 0; i < count; ++i)
        curve.semilandmarks.emplace_back(from + (to - from) * (double(i) / double(count - 1)));
    return curve;
}

/// Three landmarks; a curve from A to B, one from B to nowhere, and one from C around to C.
LandmarkSet specimen(const char *name, double x)
{
    const glm::dvec3 a(x, 0, 0), b(x + 8, 0, 0), c(x, 4, 0);
    LandmarkSet set;
    set.name = name;
    set.landmarks = {landmarkAt("A", a), landmarkAt("B", b), landmarkAt("C", c)};
    Curve loop = straight("loop", {"C", "A", "C"}, c, c + glm::dvec3(0, 0, 3), 4);
    loop.semilandmarks.back() = WorldPoint(c);
    set.curves = {straight("ab", {"A", "B"}, a, b, 5), straight("open", {"B", "Z"}, b, b + glm::dvec3(0, 0, 2), 3),
                  loop};
    return set;
}

std::string written(std::span<const LandmarkSet> sets, Format format)
{
    const auto text = landmarksText(sets, format);
    if (!text)
        qFatal("%s", text.error().message().c_str());
    return text->text;
}

/// The points of a written specimen in their order, as geomorph numbers them: those of the matrix,
/// then in TPS those of the curves.
QList<glm::dvec3> pointsIn(const QByteArray &text, Format format)
{
    QList<glm::dvec3> points;
    if (format == Format::Nts) {
        const QList<QByteArray> words = text.trimmed().split('\n').last().split(' ');
        for (qsizetype i = 0; i < words.size(); i += 3)
            points << strictPlace(words.mid(i, 3));
    } else if (format == Format::Tps) {
        for (const QByteArray &line : text.split('\n')) {
            if (!line.contains('=') && !line.isEmpty())
                points << strictPlace(line.split(' '));
        }
    } else {
        for (const StrictPoint &point : strictPoints(text, format))
            points << point.place;
    }
    return points;
}

/// The rows of a table of sliders, strictly: whole numbers under before,slide,after.
QList<QList<int>> slidersIn(const std::string &text)
{
    QList<QList<int>> sliders;
    const QList<QList<QByteArray>> rows = strictCsv(QByteArray::fromStdString(text));
    if (rows.first() != QList<QByteArray>{"before", "slide", "after"})
        qFatal("another header");
    for (const QList<QByteArray> &row : rows.mid(1)) {
        QList<int> numbers;
        for (const QByteArray &cell : row) {
            bool isNumber = false;
            numbers << cell.toInt(&isNumber);
            if (!isNumber)
                qFatal("not a number");
        }
        sliders << numbers;
    }
    return sliders;
}

} // namespace

class TestSemilandmarkFiles : public QObject {
    Q_OBJECT

private slots:
    void slidersHaveTheNumbersOfTheWrittenPoints_data()
    {
        addColumn<Format>("format");
        for (const Format format :
             {Format::Csv, Format::Tps, Format::Nts, Format::Idav, Format::SlicerCsv, Format::MeshLab})
            newRow(suffixOf(format)) << format;
    }

    void slidersHaveTheNumbersOfTheWrittenPoints()
    {
        QFETCH(Format, format);
        const LandmarkSet set = specimen("s", 0.0);
        const QList<glm::dvec3> points = pointsIn(QByteArray::fromStdString(written({&set, 1}, format)), format);
        // Three landmarks, three of five semilandmarks, two of three, two of four: no point is there twice.
        QCOMPARE(points.size(), qsizetype(10));
        for (qsizetype i = 0; i < points.size(); ++i)
            QCOMPARE(points.indexOf(points[i]), i);

        const auto sliders = slidersOf({&set, 1});
        QVERIFY(sliders);
        const QList<QList<int>> rows = slidersIn(sliders->text);
        QCOMPARE(rows, (QList<QList<int>>{{1, 4, 5}, {4, 5, 6}, {5, 6, 2}, {2, 7, 8}, {3, 9, 10}, {9, 10, 3}}));
        QCOMPARE(sliders->count, std::size_t(6));
        for (const QList<int> &row : rows.mid(0, 4)) { // on a straight line, in its middle
            const glm::dvec3 before = points[row[0] - 1], slide = points[row[1] - 1], after = points[row[2] - 1];
            QCOMPARE(0.5 * (before + after), slide);
        }
    }

    void slidersOfAWideTableGoByItsColumns()
    {
        std::vector<LandmarkSet> sets{specimen("s", 0.0), specimen("t", 20.0)};
        sets[0].landmarks.erase(sets[0].landmarks.begin() + 2); // C, with its curve
        sets[0].curves.resize(1);
        const QList<QList<QByteArray>> table =
            strictCsv(QByteArray::fromStdString(specimenTable(sets, TableForm::Wide).value().text));
        const auto nameOf = [&table](int number) { return table[0].at(3 * number - 2).chopped(2); };
        QStringList named;
        const auto sliders = specimenTable(sets, TableForm::Wide).value().sliders;
        QVERIFY2(sliders, sliders ? "" : sliders.error().message().c_str());
        for (const QList<int> &row : slidersIn(sliders->text))
            named << nameOf(row[0]) + ' ' + nameOf(row[1]) + ' ' + nameOf(row[2]);
        QCOMPARE(named, (QStringList{"A ab:02 ab:03", "ab:02 ab:03 ab:04", "ab:03 ab:04 B", "B open:02 open:03",
                                     "C loop:02 loop:03", "loop:02 loop:03 C"}));
        for (const TableForm form :
             {TableForm::Tps, TableForm::Nts}) { // the same points, NA where a specimen lacks them
            const auto points = specimenTable(sets, form);
            QVERIFY(points && points->sliders);
            QCOMPARE(points->sliders->text, sliders->text);
        }
        QVERIFY(!specimenTable(sets, TableForm::Long).value().sliders); // its rows are those that a specimen has
    }

    void slidersOfDifferentSpecimensAreRefused()
    {
        std::vector<LandmarkSet> sets{specimen("s", 0.0), specimen("t", 20.0)};
        QVERIFY(slidersOf(sets));
        std::swap(sets[1].landmarks[0], sets[1].landmarks[1]);
        const auto refused = slidersOf(sets);
        QVERIFY(!refused);
        QCOMPARE(
            QString::fromStdString(refused.error().message()),
            QString("\"s\" and \"t\" have different points, or the same in another order: their semilandmarks have "
                    "different numbers, so there are no sliders for both"));
        QVERIFY(specimenTable(sets, TableForm::Wide).value().sliders); // its columns go by name
        sets[1].curves[0].points = {"B", "A"};
        std::reverse(sets[1].curves[0].semilandmarks.begin(), sets[1].curves[0].semilandmarks.end());
        const auto other = specimenTable(sets, TableForm::Wide).value().sliders;
        QVERIFY(!other);
        QCOMPARE(
            QString::fromStdString(other.error().message()),
            QString("\"ab:02\" lies between other points on \"t\" than on another specimen, so there are no sliders "
                    "for both"));
        for (LandmarkSet &set : sets)
            set.curves.clear();
        const auto none = slidersOf(sets);
        QVERIFY(none && none->count == 0);
    }

    void slidersBesideATable()
    {
        const QTemporaryDir folder;
        const auto path = [&](const char *name) {
            return std::filesystem::path(folder.filePath(name).toStdU16String());
        };
        QCOMPARE(slidersBeside("d/all.tps"), std::filesystem::path("d/all.sliders.csv"));
        QCOMPARE(slidersBeside("all"), std::filesystem::path("all.sliders.csv"));
        LandmarkSet set = specimen("s", 0.0);
        QVERIFY(writeLandmarkFile(path("all.tps"), {&set, 1}));
        const auto file = writeSlidersBeside(path("all.tps"), slidersOf({&set, 1}));
        QVERIFY(file && *file == path("all.sliders.csv"));
        QFile read(folder.filePath("all.sliders.csv"));
        QVERIFY(read.open(QIODevice::ReadOnly));
        QCOMPARE(read.readAll().toStdString(), slidersOf({&set, 1}).value().text);
        // A folder's table leaves them out: they are no landmarks.
        std::error_code error;
        const LandmarkFolder all = readLandmarkFolder(folder.path().toStdU16String(), {}, error);
        QVERIFY(!error);
        QCOMPARE(all.fileCount, std::size_t(1));
        QVERIFY(all.badFiles.empty());
        set.curves.clear();
        const auto none = writeSlidersBeside(path("none.tps"), slidersOf({&set, 1}));
        QVERIFY(none && !*none);
        QVERIFY(!QFile::exists(folder.filePath("none.sliders.csv")));
    }

    void aTableHasOneNumberOfSemilandmarks()
    {
        std::vector<LandmarkSet> sets;
        for (const char *name : {"r", "s", "t", "u", "v"})
            sets.push_back(specimen(name, 20.0 * double(sets.size())));
        sets[1].curves[0] = straight("ab", {"A", "B"}, glm::dvec3(20, 0, 0), glm::dvec3(28, 0, 0), 9);
        const QString differ(
            "the curve \"ab\" has different numbers of semilandmarks, so they are not at the same places: "
            "5 on \"r\", \"t\", \"u\", … (4 in all); 9 on \"s\"; give it the same number on all specimens");
        for (const TableForm form : {TableForm::Wide, TableForm::Tps, TableForm::Nts}) {
            const auto table = specimenTable(sets, form);
            QVERIFY(!table);
            QCOMPARE(QString::fromStdString(table.error().message()), differ);
        }
        QVERIFY(!convertedText(sets, Format::Tps, {}));
        const auto rows = specimenTable(sets, TableForm::Long); // with curveCount in each row
        QVERIFY(rows);
        QVERIFY(std::any_of(rows->notes.begin(), rows->notes.end(),
                            [&](const base::Note &note) { return QString::fromStdString(note.text()) == differ; }));
        sets[1].curves[0].semilandmarks.clear(); // not computed: NA
        QVERIFY(specimenTable(sets, TableForm::Wide));
    }

    void endsThatAreLandmarksComeBackFromTables()
    {
        const LandmarkSet set = specimen("s", 0.1);
        const std::string csv = written({&set, 1}, Format::Csv);
        QVERIFY(csv.find("ab:02,") != std::string::npos && csv.find("ab:04,") != std::string::npos);
        QVERIFY(csv.find("ab:01,") == std::string::npos && csv.find("ab:05,") == std::string::npos);
        QVERIFY(csv.find("open:03,") != std::string::npos && csv.find("loop:04,") == std::string::npos);
        const auto read = parseLandmarks(csv, Format::Csv, "x");
        QVERIFY2(read, read ? "" : read.error().message().c_str());
        QVERIFY(read->sets.front() == set);
        // An older table has the ends, too.
        const auto older =
            parseLandmarks("name,x,y,z,curve,curvePoints,curveKind,curveCount\nA,1,1,0,,,,\nB,3,1,0,,,,\n"
                           "c:01,1,1,0,c,\"[\"\"A\"\",\"\"B\"\"]\",geodesic,3\nc:02,2,1,0,c,,,\nc:03,3,1,0,c,,,\n",
                           Format::Csv, "x");
        QVERIFY2(older, older ? "" : older.error().message().c_str());
        QVERIFY(older->sets[0].curves[0].semilandmarks
                == (std::vector{WorldPoint(1, 1, 0), WorldPoint(2, 1, 0), WorldPoint(3, 1, 0)}));
        // A curve of two semilandmarks has nothing but its ends.
        LandmarkSet ends = specimen("s", 0.1);
        ends.curves = {straight("c", {"A", "B"}, ends.landmarks[0].world->coordinates(),
                                ends.landmarks[1].world->coordinates(), 2)};
        const std::string two = written({&ends, 1}, Format::Csv);
        QCOMPARE(QString::fromStdString(two).count(u'\n'), 5);
        QVERIFY(parseLandmarks(two, Format::Csv, "x").value().sets.front() == ends);
        // Places beyond all lengths are none of the landmarks'.
        LandmarkSet beyond = specimen("s", 0.0);
        beyond.landmarks[0].world = WorldPoint(-1e300, 0, 0);
        beyond.curves = {straight("c", {"A", "B"}, glm::dvec3(1e300, 0, 0), glm::dvec3(0.0), 3)};
        QVERIFY(parseLandmarks(written({&beyond, 1}, Format::Csv), Format::Csv, "x").value().sets.front() == beyond);
        // An end that is no landmark is missing.
        const auto lacking = parseLandmarks("name,x,y,z,curve,curvePoints,curveKind,curveCount\nA,1,1,0,,,,\nB,,,,,,,\n"
                                            "c:02,2,1,0,c,\"[\"\"A\"\",\"\"B\"\"]\",geodesic,3\n",
                                            Format::Csv, "x");
        QVERIFY(!lacking);
        QCOMPARE(
            QString::fromStdString(lacking.error().message()),
            QString("x:4: the curve \"c\" has 2 semilandmarks here, and curveCount is 3; give all of them, or one row "
                    "without coordinates"));
    }

    void anEndElsewhereIsWritten()
    {
        LandmarkSet set = specimen("s", 0.0);
        set.curves.resize(1);
        set.landmarks[0].world = WorldPoint(0.0, 0.0, 1e-3); // the curve is an old one
        set.landmarks.push_back(set.landmarks[1]);           // two of the name "B"
        QCOMPARE(pointsIn(QByteArray::fromStdString(written({&set, 1}, Format::Tps)), Format::Tps).size(),
                 qsizetype(9));
        const auto sliders = slidersOf({&set, 1});
        QVERIFY(sliders);
        QCOMPARE(slidersIn(sliders->text), (QList<QList<int>>{{5, 6, 7}, {6, 7, 8}, {7, 8, 9}}));
        QVERIFY(parseLandmarks(written({&set, 1}, Format::Csv), Format::Csv, "x").value().sets.front() == set);
        // Rounding of the last digits does not make it another place.
        set.landmarks[0].world = WorldPoint(1e-9, 0.0, 0.0);
        QCOMPARE(pointsIn(QByteArray::fromStdString(written({&set, 1}, Format::Tps)), Format::Tps).size(),
                 qsizetype(8));
    }

    void aHundredSemilandmarksComeBackAsACurve()
    {
        for (const int count : {4, 99, 100, 101}) {
            LandmarkSet set;
            set.landmarks = {landmarkAt("A", glm::dvec3(0.0)), landmarkAt("B", glm::dvec3(1, 2, 3))};
            set.curves = {straight("c", {"A", "B"}, glm::dvec3(0.0), glm::dvec3(1, 2, 3), count)};
            const auto read = parseLandmarks(written({&set, 1}, Format::Idav), Format::Idav, "x");
            QVERIFY(read);
            LandmarkSet back = read->sets.front();
            QCOMPARE(int(back.landmarks.size()), count);
            QCOMPARE(takeSemilandmarks(back), std::size_t(1));
            QCOMPARE(back.landmarks.size(), std::size_t(2));
            const std::vector<WorldPoint> &all = set.curves[0].semilandmarks;
            QVERIFY(back.curves[0].semilandmarks == std::vector(all.begin() + 1, all.end() - 1));
        }
    }

    void curvesOfSlicer()
    {
        LandmarkSet set = specimen("s", 0.0);
        set.unit = "mm";
        set.axes = Axes::Ras;
        set.curves[1].kind = CurveKind::PlaneSection;
        set.curves[2].name.clear();
        set.curves[2].semilandmarks.clear(); // not computed yet
        set.curves[0].extra.edit() = {{"display", {{"opacity", 0.5}}}};
        const LandmarkSet other = specimen("t", 20.0);
        const std::vector<LandmarkSet> sets{set, other};
        const auto text = landmarksText(sets, Format::SlicerJson);
        QVERIFY(text);
        QCOMPARE(noteTexts(text->notes), QStringList());
        // As strict as the schema: a list of points, then its curves with both ends.
        const QJsonArray markups =
            QJsonDocument::fromJson(QByteArray::fromStdString(text->text)).object()["markups"].toArray();
        QStringList found;
        for (const QJsonValue markup : markups) {
            QCOMPARE(markup["coordinateSystem"].toString(), QString(found.size() < 4 ? "RAS" : "LPS"));
            QCOMPARE(markup["coordinateUnits"].toString(), QString(found.size() < 4 ? "mm" : ""));
            found << markup["type"].toString() + ' ' + markup["name"].toString() + ' '
                         + QString::number(markup["controlPoints"].toArray().size());
            for (const QJsonValue point : markup["controlPoints"].toArray())
                QVERIFY(point["position"].toArray().size() == 3 && point["orientation"].toArray().size() == 9
                        && point["positionStatus"] == "defined" && point["selected"].isBool()
                        && point["locked"].isBool());
        }
        QCOMPARE(found, (QStringList{"Fiducial s 3", "Curve ab 5", "Curve open 3", "Curve  0", "Fiducial t 3",
                                     "Curve ab 5", "Curve open 3", "Curve loop 4"}));
        QCOMPARE(markups[1]["controlPoints"][4]["label"].toString(), QString("ab:05"));
        QCOMPARE(markups[1]["controlPoints"][4]["position"][0].toDouble(), -8.0);
        const auto read = parseLandmarks(text->text, Format::SlicerJson, "x");
        QVERIFY2(read, read ? "" : read.error().message().c_str());
        QVERIFY(read->sets == sets);
    }

    void unitsOfSlicer_data()
    {
        addColumn<QByteArray>("value");
        addColumn<QString>("unit");
        newRow("a word") << QByteArray(R"("mm")") << "mm";
        newRow("a word an axis") << QByteArray(R"(["cm", "cm", "cm"])") << "cm";
        newRow("a code and its meaning") << QByteArray(R"(["mm", "UCUM", "millimeter"])") << "mm";
        newRow("a code as an object") << QByteArray(
            R"({"CodeValue": "um", "CodingSchemeDesignator": "UCUM", "CodeMeaning": "micrometer"})")
                                      << "um";
        newRow("several units") << QByteArray(R"(["mm", "mm", "cm"])") << "";
        newRow("another scheme") << QByteArray(R"(["258669008", "SCT", "meter"])") << "";
        newRow("a number") << QByteArray("5") << "";
    }

    void unitsOfSlicer()
    {
        QFETCH(QByteArray, value);
        QFETCH(QString, unit);
        const auto read = parseLandmarks((R"({"markups": [{"type": "Fiducial", "coordinateUnits": )" + value
                                          + R"(, "controlPoints": [{"label": "a", "position": [1, 2, 3]}]}]})")
                                             .toStdString(),
                                         Format::SlicerJson, "x");
        QVERIFY2(read, read ? "" : read.error().message().c_str());
        QCOMPARE(QString::fromStdString(read->sets.front().unit), unit);
        // What is not understood is written again as it was.
        const auto text = landmarksText(read->sets, Format::SlicerJson);
        QVERIFY(text);
        const QJsonValue written =
            QJsonDocument::fromJson(QByteArray::fromStdString(text->text)).object()["markups"][0]["coordinateUnits"];
        QCOMPARE(written, unit.isEmpty() ? QJsonDocument::fromJson("[" + value + "]")[0] : QJsonValue(unit));
    }

    /// 3D Slicer saves each list to a file of its own, without the names of curves and unknown keys.
    void curvesThatSlicerSavedAgain()
    {
        const auto read =
            parseLandmarks(R"({"markups": [{"type": "Curve", "coordinateSystem": "LPS", "coordinateUnits": "mm",
        "controlPoints": [{"label": "brow:01", "position": [1, 2, 3], "positionStatus": "defined"},
                          {"label": "brow:02", "position": [4, 5, 6], "description": "worn"}]}]})",
                           Format::SlicerJson, "x");
        QVERIFY2(read, read ? "" : read.error().message().c_str());
        const LandmarkSet &set = read->sets.front();
        QVERIFY(set.landmarks.empty() && set.curves.size() == 1);
        QCOMPARE(set.unit, std::string("mm"));
        QCOMPARE(set.curves[0].name, std::string("brow"));
        QVERIFY(set.curves[0].semilandmarks == (std::vector{WorldPoint(1, 2, 3), WorldPoint(4, 5, 6)}));
        QCOMPARE(noteTexts(read->notes),
                 QStringList("1 semilandmark has more than a name and a position, which is left out"));
    }

    void curvesOfOthersStayPoints()
    {
        for (const char *points :
             {R"({"label": "C-1", "position": [1, 2, 3]}, {"label": "C-2", "position": [4, 5, 6]})",
              R"({"label": "C:01", "position": [1, 2, 3]})",
              R"({"label": "C:01", "position": [1, 2, 3]},
                                  {"label": "C:02", "position": "", "positionStatus": "undefined"})"}) {
            const std::string text =
                R"({"markups": [{"type": "Curve", "controlPoints": [)" + std::string(points) + "]}]}";
            const auto read = parseLandmarks(text, Format::SlicerJson, "x");
            QVERIFY2(read, read ? "" : read.error().message().c_str());
            QVERIFY(read->sets.front().curves.empty() && !read->sets.front().landmarks.empty());
            QVERIFY(written(read->sets, Format::SlicerJson).find(R"("type": "Curve")") != std::string::npos);
        }
    }

    void theUnitForSlicer()
    {
        LandmarkSet set = specimen("s", 0.0);
        set.curves.clear();
        for (const char *unit : {"", "mm", "cm"}) {
            set.unit = unit;
            const auto text = landmarksText({&set, 1}, Format::SlicerJson);
            QVERIFY(text);
            const QJsonObject markup = QJsonDocument::fromJson(QByteArray::fromStdString(text->text))
                                           .object()["markups"]
                                           .toArray()[0]
                                           .toObject();
            QCOMPARE(markup.contains("coordinateUnits"), *unit != '\0');
            QCOMPARE(markup["coordinateUnits"].toString(), QString(unit));
            QCOMPARE(noteTexts(text->notes),
                     set.unit == "cm" ? QStringList(
                         "3D Slicer takes coordinates for mm, and these are in cm; they are not converted")
                                      : QStringList());
        }
    }
};

UNPROJECTOR_TEST(TestSemilandmarkFiles)
#include "test_semilandmark_files.moc"
