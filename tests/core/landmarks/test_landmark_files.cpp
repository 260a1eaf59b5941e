// Landmarks through the files of other programs: our readers and this test's strict ones read back
// what was written. Notes report the parts that a format cannot hold.

#include "tests/support/test.h"

#include "core/landmark_files/landmark_file.h"
#include "core/landmark_files/specimen_table.h"
#include "tests/core/landmarks/strict_landmarks.h"

#include <nlohmann/json.hpp>

#include <QDir>
#include <QTemporaryDir>

#include <bit>
#include <cmath>
#include <random>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::landmark_files;
using namespace strict_landmarks;
using namespace unprojector::landmarks;

namespace {

using Json = nlohmann::ordered_json;

constexpr int kPoints = 500;

/// Any finite double, all exponents as likely.
double anyDouble(std::mt19937_64 &engine)
{
    for (;;) {
        const double value = std::bit_cast<double>(engine());
        if (std::isfinite(value))
            return value == 9999.0 ? 1.0 : value;
    }
}

glm::dvec3 anyPlace(std::mt19937_64 &engine)
{
    return {anyDouble(engine), anyDouble(engine), anyDouble(engine)};
}

/// Names that break formats: separators, quotes, number-like text, other alphabets.
const char *const kNames[] = {"Nasion",       "a, b",      "say \"hi\"", "1e5",   "0x1F",   "Ma\xc3\x9f",
                              "\xe9\xbc\xbb", "<a&b>'c'/", "NA",         "-9999", "x=1; y", "Prosthion 2"};

/// Points that use only the data that a format can hold.
LandmarkSet setFor(Format format)
{
    std::mt19937_64 engine(20261122);
    LandmarkSet set;
    const bool isCsv = format == Format::Csv, isJson = format == Format::SlicerJson,
               isFcsv = format == Format::SlicerCsv;
    const bool isTps = format == Format::Tps, isMeshLab = format == Format::MeshLab;
    if (isTps || isJson || isCsv)
        set.name = "skull 7";
    if (isTps || isMeshLab || isCsv)
        set.mesh = "scans/skull \"7\".ply";
    if (isCsv || isJson)
        set.unit = "mm";
    if (isJson || isFcsv)
        set.axes = Axes::Ras;
    if (isTps)
        set.extra.edit()["COMMENT"] = "left side broken";
    if (isMeshLab)
        set.extra.edit()["DocumentData"] = {{"DateTime", {{"date", "2026-10-01"}, {"time", "12:00:00"}}},
                                            {"User", {{"name", "A & B"}}}};
    if (isJson)
        set.extra.edit() = {{"type", "Curve"}, {"display", {{"color", {0.5, 0.25, 1.0}}}}};
    for (int i = 0; i < kPoints; ++i) {
        Landmark landmark;
        if (format != Format::Tps)
            landmark.name =
                format == Format::Idav ? "S" + std::to_string(i) : kNames[std::size_t(i) % std::size(kNames)];
        if (i % 7 != 3 && format != Format::MeshLabTemplate && !(isFcsv && i % 7 == 3))
            landmark.world = WorldPoint(anyPlace(engine));
        if (isFcsv && !landmark.world)
            landmark.world = WorldPoint(1, 2, 3);
        if (isCsv || isJson || isFcsv) {
            landmark.note = i % 3 == 0 ? "first, \"second\"" : "";
            landmark.isHidden = i % 5 == 0;
        }
        if (!landmark.world && (isCsv || isJson)) // 3D Slicer has no word for skipped ones
            landmark.absence = i % 2 == 0            ? Absence::Missing
                               : isCsv && i % 3 == 0 ? Absence::Skipped
                                                     : Absence::NotPlaced;
        if (isCsv) {
            landmark.object = i % 2 == 0 ? "skull, left" : "";
            landmark.note += i % 4 == 0 ? "line\nbreak\r\n" : "";
            if (i % 4 == 1)
                landmark.anchor = OnTriangle{0xffffffffu - std::uint32_t(i), {0.001 * i, 0.5 - 0.001 * i, 0.5}};
            else if (i % 4 == 2)
                landmark.anchor = AtVertex{std::uint32_t(i)};
            else if (i % 4 == 3)
                landmark.anchor = OnEdge{{std::uint32_t(i), 7}, anyDouble(engine)};
            if (i % 2 == 0)
                landmark.uncertainty = WorldVector(anyPlace(engine));
            if (i % 3 == 1)
                landmark.color = glm::u8vec3(255, i % 256, 8);
            if (i % 6 == 0)
                landmark.extra.edit() = {{"sex, age", "f, \"3\""}, {"count", 5}, {"done", true}, {"code", "007"}};
        }
        if (isJson && i % 6 == 0)
            landmark.extra.edit() = {
                {"id", "p" + std::to_string(i)}, {"orientation", {0, 1, 0, 1, 0, 0, 0, 0, -1}}, {"locked", true}};
        if (isFcsv && i % 6 == 0)
            landmark.extra.edit() = {
                {"id", "vtkMRMLMarkups_" + std::to_string(i)}, {"selected", false}, {"associatedNodeID", "a,b"}};
        set.landmarks.push_back(landmark);
    }
    return set;
}

std::string written(std::span<const LandmarkSet> sets, Format format)
{
    const auto text = landmarksText(sets, format);
    if (!text)
        qFatal("%s", text.error().message().c_str());
    return text->text;
}

bool isSameDouble(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

std::string wideText(std::span<const LandmarkSet> sets)
{
    const auto table = specimenTable(sets, TableForm::Wide);
    return table ? table->text : table.error().message();
}

} // namespace

namespace {

/// Two points, a curve between them with its semilandmarks, and one that is not computed.
LandmarkSet setWithCurves()
{
    LandmarkSet set;
    for (const char *name : {"A", "B"}) {
        Landmark landmark;
        landmark.name = name;
        landmark.world = WorldPoint(1, 2, 3);
        set.landmarks.push_back(landmark);
    }
    Curve brow;
    brow.name = "brow, left";
    brow.points = {"A", "B \"x\""};
    brow.kind = CurveKind::PlaneSection;
    brow.count = 3;
    brow.semilandmarks = {WorldPoint(1, 2, 3), WorldPoint(0.1, 1e-7, 3), WorldPoint(4, 5, 6)};
    Curve other;
    other.name = "other";
    other.points = {"A", "B"};
    other.count = 12;
    set.curves = {brow, other};
    return set;
}

QStringList textsOf(const std::vector<base::Note> &notes)
{
    QStringList texts;
    for (const base::Note &note : notes)
        texts << QString::fromStdString(note.text());
    return texts;
}

} // namespace

class TestLandmarkFiles : public QObject {
    Q_OBJECT

private slots:
    void semilandmarksAreTakenForCurves_data()
    {
        addColumn<QStringList>("names");
        addColumn<int>("points");
        addColumn<QStringList>("curves");
        using L = QStringList;
        newRow("two curves") << L{"a", "x:01", "x:02", "y z:01", "y z:02", "y z:03"} << 1 << L{"x", "y z"};
        newRow("no point besides") << L{"x:01", "x:02"} << 2 << L{};
        newRow("without the end that is a landmark") << L{"a", "x:02", "x:03"} << 1 << L{"x"};
        newRow("one that lacks two") << L{"a", "x:03", "x:04"} << 3 << L{};
        newRow("one semilandmark") << L{"a", "x:02"} << 2 << L{};
        newRow("a gap") << L{"a", "x:01", "x:03"} << 3 << L{};
        newRow("other digits") << L{"a", "x:1", "x:2"} << 3 << L{};
        newRow("no name") << L{"a", ":01", ":02"} << 3 << L{};
        newRow("not behind the others") << L{"a", "x:01", "x:02", "b"} << 4 << L{};
        newRow("a large number") << L{"a", "x:99999999999999999999"} << 2 << L{};
        newRow("no number") << L{"a", "x:", "x:a"} << 3 << L{};
    }

    void semilandmarksAreTakenForCurves()
    {
        QFETCH(QStringList, names);
        QFETCH(int, points);
        QFETCH(QStringList, curves);
        LandmarkSet set;
        for (const QString &name : names) {
            Landmark &landmark = set.landmarks.emplace_back();
            landmark.name = name.toStdString();
            landmark.world = WorldPoint(double(set.landmarks.size()), 0.0, 0.0);
        }
        QCOMPARE(takeSemilandmarks(set), std::size_t(curves.size()));
        QCOMPARE(int(set.landmarks.size()), points);
        QStringList taken;
        double x = points;
        for (const Curve &curve : set.curves) {
            taken << QString::fromStdString(curve.name);
            QCOMPARE(std::size_t(curve.count), curve.semilandmarks.size());
            for (const auto &place : curve.semilandmarks)
                QCOMPARE(place.x, ++x);
        }
        QCOMPARE(taken, curves);
    }

    void whatIsWrittenReadsBackTheSame_data()
    {
        addColumn<Format>("format");
        for (const Format format : kFormats) {
            if (isWritten(format) && format != Format::Nts) // it keeps no names
                newRow(suffixOf(format)) << format;
        }
    }

    void whatIsWrittenReadsBackTheSame()
    {
        QFETCH(Format, format);
        const LandmarkSet set = setFor(format);
        const auto text = landmarksText({&set, 1}, format);
        QVERIFY(text);
        QCOMPARE(noteTexts(text->notes), QStringList());

        const auto read = parseLandmarks(text->text, format, "points");
        QVERIFY2(read, read ? "" : read.error().message().c_str());
        QCOMPARE(read->sets.size(), std::size_t(1));
        for (std::size_t i = 0; i < set.landmarks.size(); ++i) {
            const Landmark &landmark = read->sets[0].landmarks.at(i), &expected = set.landmarks[i];
            QCOMPARE(landmark.name, expected.name);
            QCOMPARE(!landmark.isPlaced(), !expected.isPlaced());
            for (int axis = 0; axis < 3 && landmark.world; ++axis)
                QVERIFY(isSameDouble((*landmark.world)[axis], (*expected.world)[axis]));
            QCOMPARE(landmark.note, expected.note);
            QCOMPARE(QString::fromStdString(landmark.extra.json().dump()),
                     QString::fromStdString(expected.extra.json().dump()));
            QVERIFY(landmark == expected);
        }
        QCOMPARE(QString::fromStdString(read->sets[0].extra.json().dump()),
                 QString::fromStdString(set.extra.json().dump()));
        QVERIFY(read->sets[0] == set);

        const QList<StrictPoint> points = strictPoints(QByteArray::fromStdString(text->text), format);
        QCOMPARE(std::size_t(points.size()), set.landmarks.size());
        for (qsizetype i = 0; i < points.size(); ++i) {
            const Landmark &expected = set.landmarks[std::size_t(i)];
            QCOMPARE(points[i].name, QString::fromStdString(expected.name));
            if (format == Format::MeshLabTemplate)
                continue;
            QCOMPARE(points[i].isMissing, !expected.isPlaced());
            for (int axis = 0; axis < 3 && expected.world; ++axis)
                QVERIFY(isSameDouble(points[i].place[axis], (*expected.world)[axis]));
        }
    }

    void aNameFullOfSeparatorsDividesNothing_data()
    {
        addColumn<Format>("format");
        addColumn<char>("separator");
        addColumn<bool>("hasQuotes");
        for (const Format format : {Format::Csv, Format::SlicerCsv}) {
            for (const char separator : {',', ';', ' '}) {
                for (const bool hasQuotes : {false, true})
                    addRow("%s %c %d", suffixOf(format), separator, hasQuotes) << format << separator << hasQuotes;
            }
        }
    }

    /// The first row decides a table's separator: more of another separator in its quotes has no
    /// effect.
    void aNameFullOfSeparatorsDividesNothing()
    {
        QFETCH(Format, format);
        QFETCH(char, separator);
        LandmarkSet set;
        set.landmarks.resize(1);
        QFETCH(bool, hasQuotes);
        for (int i = 0; i < 40; ++i)
            set.landmarks[0].name += (hasQuotes ? "\"" : ".") + std::string(1, separator);
        set.landmarks[0].name += '!';
        set.landmarks[0].world = WorldPoint(3, 1, 1);
        const auto read = parseLandmarks(written({&set, 1}, format), format, "points");
        QVERIFY2(read, read ? "" : read.error().message().c_str());
        QCOMPARE(read->sets.at(0).landmarks.at(0).name, set.landmarks[0].name);
        QCOMPARE(read->sets[0].landmarks[0].world, set.landmarks[0].world);
    }

    void whatHasNoPlaceIsSaid_data()
    {
        addColumn<Format>("format");
        addColumn<QStringList>("notes");
        const QString object = "the objects of 1 landmark are left out",
                      hold = "the anchor of 1 landmark (triangle, vertex or edge) is left out",
                      uncertainty = "the uncertainties of 1 landmark are left out",
                      note = "the notes of 1 landmark are left out", color = "the colours of 1 landmark are left out",
                      hidden = "1 hidden landmark is written as any other",
                      keys = "the other values of 1 landmark are left out: sex, code",
                      specimen = "the name of the specimen, \"skull 7\", is left out",
                      mesh = "the name of the mesh, \"skull.ply\", is left out", unit = "the unit, mm, is left out",
                      more = "other values of 1 specimen are left out: more";
        newRow("csv") << Format::Csv << QStringList{more};
        newRow("pp") << Format::MeshLab
                     << QStringList{object, hold, uncertainty, note, color, hidden, specimen, unit, keys, more};
        newRow("pptpl") << Format::MeshLabTemplate
                        << QStringList{"the coordinates of 1 landmark are left out",
                                       object,
                                       hold,
                                       uncertainty,
                                       note,
                                       color,
                                       hidden,
                                       specimen,
                                       mesh,
                                       unit,
                                       keys,
                                       more};
        newRow("mrk.json") << Format::SlicerJson << QStringList{object, hold, uncertainty, color, mesh};
        newRow("fcsv")
            << Format::SlicerCsv
            << QStringList{
                   object,
                   hold,
                   uncertainty,
                   color,
                   specimen,
                   mesh,
                   unit,
                   keys,
                   more,
                   "1 point without a position is written as 0, 0, 0 with a status field, which older readers ignore"};
        newRow("pts") << Format::Idav
                      << QStringList{
                             object,   hold,  uncertainty,
                             note,     color, hidden,
                             specimen, mesh,  unit,
                             keys,     more,  "\"N\" has a coordinate of 9999, which readers take for a missing point"};
        newRow("tps") << Format::Tps
                      << QStringList{"the names of 2 landmarks are left out; only their order is kept",
                                     object,
                                     hold,
                                     uncertainty,
                                     note,
                                     color,
                                     hidden,
                                     unit,
                                     keys,
                                     more};
        newRow("nts") << Format::Nts
                      << QStringList{"the names of 2 landmarks are left out; only their order is kept",
                                     object,
                                     hold,
                                     uncertainty,
                                     note,
                                     color,
                                     hidden,
                                     mesh,
                                     unit,
                                     keys,
                                     more,
                                     "the name \"skull 7\" as \"skull_7\""};
    }

    void whatHasNoPlaceIsSaid()
    {
        QFETCH(Format, format);
        LandmarkSet set{
            "skull 7", "skull.ply", "mm", Axes::Lps, {}, {}, {}, 1, base::JsonValue(Json{{"more", {1, 2}}})};
        Landmark full{"N",
                      WorldPoint(1, 9999, 3),
                      Absence::NotPlaced,
                      "skull",
                      AtVertex{4},
                      WorldVector(1, 1, 1),
                      "worn",
                      glm::u8vec3(1, 2, 3),
                      true,
                      base::JsonValue(Json{{"sex", "f"}, {"code", "007"}})};
        Landmark missing;
        missing.name = "gone";
        set.landmarks = {full, missing};
        const auto text = landmarksText({&set, 1}, format);
        QVERIFY(text);
        QTEST(noteTexts(text->notes), "notes");
    }

    void manySpecimens()
    {
        LandmarkSet a{"a", {}, {}, Axes::Lps, {}, {}, {}, 1, {}}, b{"b", {}, {}, Axes::Lps, {}, {}, {}, 1, {}};
        a.landmarks.resize(2);
        b.landmarks.resize(2);
        a.landmarks[0] = {"N", WorldPoint(1, 2, 3), {}, {}, {}, {}, {}, {}, false, {}};
        a.landmarks[1] = {"P", WorldPoint(4, 5, 6), {}, {}, {}, {}, {}, {}, false, {}};
        b.landmarks[0] = {"P", WorldPoint(7, 8, 9.5), {}, {}, {}, {}, {}, {}, false, {}};
        b.landmarks[1] = {"P", std::nullopt, {}, {}, {}, {}, {}, {}, false, {}};
        const std::vector<LandmarkSet> sets{a, b};
        const std::string csv = written(sets, Format::Csv);
        QCOMPARE(csv,
                 std::string(
                     "specimen,name,x,y,z,object,face,u,v,w,note\na,N,1,2,3,,,,,,\na,P,4,5,6,,,,,,\nb,P,7,8,9.5,,,,,,\n"
                     "b,P,,,,,,,,,\n"));
        QVERIFY(parseLandmarks(csv, Format::Csv, "f").value().sets == sets);
        QCOMPARE(wideText(sets), std::string("specimen,N_x,N_y,N_z,P_x,P_y,P_z,P (2)_x,P (2)_y,P (2)_z\n"
                                             "a,1,2,3,4,5,6,NA,NA,NA\nb,NA,NA,NA,7,8,9.5,NA,NA,NA\n"));
        // Names that are taken, in any specimen.
        b.landmarks[1].name.clear();
        b.landmarks[1].world = WorldPoint(1, 1, 1);
        for (const char *name : {"P", "P", "P (2)", "2"}) {
            b.landmarks.push_back(b.landmarks[0]);
            b.landmarks.back().name = name;
        }
        QCOMPARE(wideText(std::vector{a, b}),
                 std::string(
                     "specimen,N_x,N_y,N_z,P_x,P_y,P_z,2 (2)_x,2 (2)_y,2 (2)_z,P (3)_x,P (3)_y,P (3)_z,P (4)_x,P (4)_y,"
                     "P (4)_z,P (2)_x,P (2)_y,P (2)_z,2_x,2_y,2_z\n"
                     "a,1,2,3,4,5,6,NA,NA,NA,NA,NA,NA,NA,NA,NA,NA,NA,NA,NA,NA,NA\n"
                     "b,NA,NA,NA,7,8,9.5,1,1,1,7,8,9.5,7,8,9.5,7,8,9.5,7,8,9.5\n"));
        QCOMPARE(written(sets, Format::Tps),
                 std::string("LM3=2\n1 2 3\n4 5 6\nID=a\n\nLM3=2\n7 8 9.5\nNA NA NA\nID=b\n\n"));
        QCOMPARE(written(sets, Format::Nts),
                 std::string("1 2L 6 1 9999 DIM=3\na\nb\n1 2 3 4 5 6\n7 8 9.5 9999 9999 9999\n"));
        QCOMPARE(written({sets.data(), 1}, Format::Nts), std::string("1 1L 6 0 DIM=3\na\n1 2 3 4 5 6\n"));
        const auto reread = [](const std::vector<LandmarkSet> &those, Format format) {
            std::vector<std::optional<WorldPoint>> places;
            const auto read = parseLandmarks(written(those, format), format, "f");
            for (const LandmarkSet &set : read ? read->sets : std::vector<LandmarkSet>()) {
                for (const Landmark &landmark : set.landmarks)
                    places.push_back(landmark.world);
            }
            return places;
        };
        // A real coordinate that is the usual word for a missing one.
        std::vector<LandmarkSet> full = sets;
        full[0].landmarks[0].world = WorldPoint(9999, 19999, 9999);
        const std::vector<std::optional<WorldPoint>> all{WorldPoint(9999, 19999, 9999), WorldPoint(4, 5, 6),
                                                         WorldPoint(7, 8, 9.5), std::nullopt};
        QVERIFY(written(full, Format::Nts).starts_with("1 2L 6 1 29999 DIM=3\n"));
        QVERIFY(reread(full, Format::Nts) == all);
        full.pop_back();
        full[0].landmarks[0].world = WorldPoint(9999, 9999, 9999);
        QCOMPARE(written(full, Format::Idav), std::string("Version 1.0\n2\nN 9.999e3 9.999e3 9.999e3\nP 4 5 6\n\n"));
        QVERIFY(reread(full, Format::Idav)
                == (std::vector<std::optional<WorldPoint>>{WorldPoint(9999, 9999, 9999), WorldPoint(4, 5, 6)}));
        QCOMPARE(parseLandmarks(written(sets, Format::SlicerJson), Format::SlicerJson, "f").value().sets.size(),
                 std::size_t(2));
    }

    void namesThatReadersStumbleOver()
    {
        LandmarkSet set;
        for (const char *name : {"left eye", "a#b", "left_eye", "", "say \"x\""}) {
            Landmark landmark;
            landmark.name = name;
            landmark.world = WorldPoint(1, 2, 3);
            landmark.note = landmark.name == "a#b" ? "two\nlines #1" : "";
            set.landmarks.push_back(landmark);
        }
        const auto pts = landmarksText({&set, 1}, Format::Idav);
        QVERIFY(pts);
        QCOMPARE(
            pts->text,
            std::string("Version 1.0\n5\nleft_eye 1 2 3\na_b 1 2 3\nleft_eye_2 1 2 3\nS3 1 2 3\nsay__x_ 1 2 3\n\n"));
        QCOMPARE(noteTexts(pts->notes),
                 QStringList({"the notes of 1 landmark are left out", "the name \"left eye\" as \"left_eye\"",
                              "the name \"a#b\" as \"a_b\"", "the name \"left_eye\" as \"left_eye_2\"",
                              "the name \"\" as \"S3\"", "the name \"say \"x\"\" as \"say__x_\""}));
        const auto fcsv = landmarksText({&set, 1}, Format::SlicerCsv);
        QVERIFY(fcsv);
        QCOMPARE(noteTexts(fcsv->notes), QStringList({"the name \"a#b\" as \"a_b\"",
                                                      "the note of \"a#b\" is written without line breaks and #"}));
        QVERIFY(fcsv->text.find("\n1,1,2,3,0,0,0,1,1,1,0,a_b,two_lines _1,,2,0\n") != std::string::npos);
    }

    /// A key of one program must not be read as another one's coordinates.
    void otherKeysAreNotTakenForOurs()
    {
        LandmarkSet set;
        set.extra.edit() = {{"SCALE", "2"}, {"LM3", "5"}, {"COMMENT", "c"}};
        set.landmarks.resize(1);
        set.landmarks[0].world = WorldPoint(1, 2, 3);
        set.landmarks[0].extra.edit() = {{"X", 5}, {"deep", Json::parse("[[1, {\"a\": 2}]]")}};
        const auto tps = landmarksText({&set, 1}, Format::Tps);
        QVERIFY(tps);
        QCOMPARE(tps->text, std::string("LM3=1\n1 2 3\nCOMMENT=c\n\n"));
        QCOMPARE(noteTexts(tps->notes), QStringList({"the other values of 1 landmark are left out: X, deep",
                                                     "other values of 1 specimen are left out: SCALE",
                                                     "other values of 1 specimen are left out: LM3"}));
        const auto csv = landmarksText({&set, 1}, Format::Csv);
        QVERIFY(csv);
        QCOMPARE(csv->text,
                 std::string("name,x,y,z,object,face,u,v,w,note,deep\n,1,2,3,,,,,,,\"[[1,{\"\"a\"\":2}]]\"\n"));
        QVERIFY(noteTexts(csv->notes).contains("the other values of 1 landmark are left out: X"));
        QVERIFY(parseLandmarks(csv->text, Format::Csv, "f").value().sets[0].landmarks[0].extra.json()["deep"]
                == set.landmarks[0].extra.json()["deep"]);
        const std::string deep = "x,y,z,deep\n1,2,3," + std::string(200000, '[') + std::string(200000, ']') + '\n';
        const auto read = parseLandmarks(deep, Format::Csv, "f");
        QVERIFY(read && read->sets[0].landmarks[0].extra.json()["deep"].is_string());
    }

    void whatAFormatCannotHoldIsRefused()
    {
        std::vector<LandmarkSet> sets(2);
        sets[0].landmarks.resize(1);
        const auto said = [&](Format format) {
            const auto text = landmarksText(sets, format);
            return text ? QString("written") : QString::fromStdString(text.error().message());
        };
        QCOMPARE(said(Format::MeshLab),
                 QString(".pp holds one specimen, and there are 2; take .csv, .tps, .nts or .mrk.json"));
        QCOMPARE(said(Format::Nts),
                 QString(".nts is a table, in which all specimens have the same points: \"\" has 0, \"\" has 1; take "
                         ".tps, or leave one of them out"));
        sets.resize(1);
        sets[0].landmarks[0].name = "\xe9";
        QCOMPARE(said(Format::SlicerJson),
                 QString("markups[0].controlPoints[0].label is not UTF-8 and cannot be written as JSON; rename it"));
    }

    void curvesAreWrittenWithThePoints()
    {
        LandmarkSet set = setWithCurves();
        const std::span<const LandmarkSet> one(&set, 1);
        const QString unknown =
            "the curve \"other\" has no semilandmarks and is left out: its path is computed when its mesh is open";
        const auto tps = landmarksText(one, Format::Tps);
        QVERIFY(tps);
        QCOMPARE(QString::fromStdString(tps->text),
                 QString("LM3=2\n1 2 3\n1 2 3\nCURVES=1\nPOINTS=2\n0.1 1e-07 3\n4 5 6\n\n"));
        QVERIFY(textsOf(tps->notes).contains(unknown));
        QVERIFY(textsOf(tps->notes).contains("the names of 1 curve and what they go through are left out"));
        const auto idav = landmarksText(one, Format::Idav);
        QVERIFY(idav);
        QVERIFY(idav->text.find("\n4\n") != std::string::npos && idav->text.find(":02 0.1 ") != std::string::npos
                && idav->text.find(":03 4 5 6\n") != std::string::npos);
        QVERIFY(textsOf(idav->notes).contains(unknown));
        QVERIFY(textsOf(idav->notes)
                    .contains("2 semilandmarks are written as points behind the others, named by their curve; what "
                              "the curves go through is left out"));
        QVERIFY(textsOf(idav->notes).contains("1 end of a curve is a landmark and is not written again"));
        const auto nts = landmarksText(one, Format::Nts);
        QVERIFY(nts && nts->text.find("L 12 ") != std::string::npos);
        QVERIFY(wideText(one).starts_with("specimen,A_x,A_y,A_z,B_x,B_y,B_z,\"brow, left:02_x\","));
    }

    void curvesComeBackFromTheFormatsThatHoldThem()
    {
        LandmarkSet set = setWithCurves();
        const auto csv = landmarksText({&set, 1}, Format::Csv);
        QVERIFY(csv);
        QVERIFY2(csv->notes.empty(), qPrintable(textsOf(csv->notes).join(u'\n')));
        const auto read = parseLandmarks(csv->text, Format::Csv, "x.csv");
        QVERIFY2(read.hasValue(), read ? "" : read.error().message().c_str());
        QVERIFY(read->sets.front() == set);

        const auto more = parseLandmarks(
            "x,y,z,curve,curveKind,note,sex\n1,2,3,c,geodesic,,\n1,2,3,c,,worn,\n1,2,3,c,,,f\n", Format::Csv, "x.csv");
        QVERIFY(more);
        QCOMPARE(textsOf(more->notes),
                 QStringList("2 semilandmarks have more than a name and a position, which is left out"));

        // Semilandmarks are in the order of their numbers; those not computed are omitted.
        const auto sorted = parseLandmarks("name,x,y,z,curve,curveCount\nc:2,4,5,6,c,2\nc:01,1,2,3,c,\n"
                                           "e:1,,,,e,2\ne:2,,,,e,\nf,7,7,7,f,\nf,8,8,8,f,\n",
                                           Format::Csv, "x.csv");
        QVERIFY2(sorted, sorted ? "" : sorted.error().message().c_str());
        const std::vector<Curve> &curves = sorted->sets.front().curves;
        QCOMPARE(curves.size(), std::size_t(3));
        QVERIFY(curves[0].semilandmarks == (std::vector{WorldPoint(1, 2, 3), WorldPoint(4, 5, 6)}));
        QVERIFY(curves[1].semilandmarks.empty() && curves[1].count == 2);
        QVERIFY(curves[2].semilandmarks == (std::vector{WorldPoint(7, 7, 7), WorldPoint(8, 8, 8)}));

        const auto tps = landmarksText({&set, 1}, Format::Tps);
        const auto back = parseLandmarks(tps->text, Format::Tps, "x.tps");
        QVERIFY(back);
        QCOMPARE(back->sets.front().curves.size(), std::size_t(1));
        QVERIFY(back->sets.front().curves[0].semilandmarks
                == (std::vector{WorldPoint(0.1, 1e-7, 3), WorldPoint(4, 5, 6)})); // the end that is a landmark is one
        QVERIFY(back->sets.front().curves[0].points.empty());
    }

    void blanksAroundTextsAreSaid()
    {
        const auto notesOf = [](const char *text, Format format) {
            const auto read = parseLandmarks(text, format, "p");
            return read ? textsOf(read->notes) : QStringList("not read");
        };
        const QStringList one{"the blanks around 1 cell text are removed; put the text in quotes to keep them"},
            two{"the blanks around 2 cell texts are removed; put the texts in quotes to keep them"};
        QVERIFY(notesOf("name,x,y,z\n nasion,1,2,3\n", Format::Csv) == one);
        QVERIFY(notesOf("name,x,y,z,note,sex\nnasion,1,2,3,worn ,\tf\n", Format::Csv) == two);
        QVERIFY(notesOf("name, x, y, z\nnasion, 1, 2, 3\n", Format::Csv).isEmpty()); // numbers lose nothing
        QVERIFY(notesOf("name,x,y,z\n \" nasion\" ,1,2,3\n", Format::Csv).isEmpty());
        const auto quoted = parseLandmarks("name,x,y,z\n\" nasion\",1,2,3\n", Format::Csv, "p");
        QVERIFY(quoted);
        QCOMPARE(quoted->sets[0].landmarks[0].name, std::string(" nasion"));
        QVERIFY(notesOf("# Markups fiducial file version = 5.8\n# CoordinateSystem = LPS\n"
                        "0, 1, 2, 3, 0,0,0,1,1,1,0, nasion,here,\n",
                        Format::SlicerCsv)
                == one);
    }

    void largeFilesAreReadOrNotWritten_data()
    {
        addColumn<Format>("format");
        addColumn<int>("count");
        addColumn<int>("nameLength");
        addColumn<bool>("isWritten");
        newRow("mrk.json of more than a scene may have") << Format::SlicerJson << 30000 << 1 << true;
        newRow("mrk.json of too many") << Format::SlicerJson << 400000 << 1 << false;
        newRow("pp in several pieces") << Format::MeshLab << 10000 << 1 << true;
        newRow("pp of long names") << Format::MeshLab << 20000 << 4000 << false;
    }

    void largeFilesAreReadOrNotWritten()
    {
        QFETCH(Format, format);
        QFETCH(int, count);
        QFETCH(int, nameLength);
        QFETCH(bool, isWritten);
        LandmarkSet set;
        for (int i = 0; i < count; ++i) {
            Landmark &landmark = set.landmarks.emplace_back();
            landmark.name = std::string(std::size_t(nameLength), 'P') + std::to_string(i);
            landmark.world = WorldPoint(i, 0.1 * i, -i);
        }
        const auto text = landmarksText({&set, 1}, format);
        QCOMPARE(bool(text), isWritten);
        if (!text) {
            const QString said = QString::fromStdString(text.error().message());
            QVERIFY2(said.contains("a file of landmarks may have at most 64 MiB; write fewer points"),
                     qPrintable(said));
            return;
        }
        const auto read = parseLandmarks(text->text, format, "f");
        QVERIFY2(read, read ? "" : read.error().message().c_str());
        QVERIFY(read->sets.front() == set);
    }

    void filesOnDisk()
    {
        const QTemporaryDir folder;
        const auto path = [&](const char *name) {
            return std::filesystem::path(folder.filePath(name).toStdU16String());
        };
        const LandmarkSet set = setFor(Format::SlicerJson);
        QVERIFY(writeLandmarkFile(path("a.MRK.json"), {&set, 1}));
        const auto read = readLandmarkFile(path("a.MRK.json"));
        QVERIFY(read && read->sets.front() == set);
        const auto said = [](const auto &result) {
            return QString::fromStdString(result.error().message()).section(": ", -1);
        };
        QCOMPARE(said(readLandmarkFile(path("none.pp"))), QString("there is no such file"));
        QCOMPARE(
            said(readLandmarkFile(path("a.doc"))),
            QString("the name must end in .csv, .pp, .pptpl, .mrk.json, .fcsv, .pts, .tps, .nts, .landmarkAscii or "
                    ".ljson"));
        QCOMPARE(said(readLandmarkFile(path("a.TXT"))), QString("there is no such file"));
        for (const char *name : {"a.txt", "a.ljson"})
            QCOMPARE(said(writeLandmarkFile(path(name), {&set, 1})),
                     QString("the name must end in .csv, .pp, .pptpl, .mrk.json, .fcsv, .pts, .tps or .nts"));
        QVERIFY(QDir(folder.path()).mkdir("d.csv"));
        QCOMPARE(said(readLandmarkFile(path("d.csv"))), QString("this is a folder, not a file of landmarks"));
        QVERIFY(!writeLandmarkFile(path("d.csv"), {&set, 1}));
    }
};

UNPROJECTOR_TEST(TestLandmarkFiles)
#include "test_landmark_files.moc"
