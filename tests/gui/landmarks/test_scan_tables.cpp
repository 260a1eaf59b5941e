// The tables that are written for a series of scans.

#include "tests/support/test.h"

#include "core/landmark_files/landmark_file.h"
#include "gui/document/landmark_files.h"
#include "gui/document/scene_edits.h"
#include "gui/landmarks/landmark_templates.h"
#include "tests/gui/landmarks/landmark_desk.h"
#include "tests/support/patience.h"

using namespace landmarkfiles;
using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::gui;

class TestScanTables : public LandmarksTest {
    Q_OBJECT

private slots:
    void init() { begin(); }

    void tablesOfASeries()
    {
        write(QStringLiteral("other.obj"), kSquare);
        write(QStringLiteral("other.obj.points.csv"), "name,x,y,z\nb,1,2,0\na,3,4,0\n");
        write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,5,6,0\n");
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(m_series->landmarkNames(), (QStringList{"b", "a"}));
        QVERIFY(m_series->exportTable(file(QStringLiteral("wide.csv")), ScanSeries::Table::Wide));
        QCOMPARE(read(QStringLiteral("wide.csv")),
                 QByteArray("specimen,b_x,b_y,b_z,a_x,a_y,a_z\nother,1,2,0,3,4,0\nsquare,NA,NA,NA,5,6,0\n"));
        QVERIFY(m_series->exportTable(file(QStringLiteral("all.tps")), ScanSeries::Table::Tps));
        QCOMPARE(read(QStringLiteral("all.tps")),
                 QByteArray("LM3=2\n1 2 0\n3 4 0\nID=other\n\nLM3=2\nNA NA NA\n5 6 0\nID=square\n\n"));
        // A single scan has the order of the series too, where the file has no names.
        LandmarkFiles files(*m_document, nullptr);
        QCOMPARE(m_document->landmarks()[0].name, std::string("a"));
        QVERIFY(files.exportTo(file(QStringLiteral("one.tps")), m_series->shownNames()));
        QVERIFY2(read(QStringLiteral("one.tps")).startsWith("LM3=2\nNA NA NA\n5 6 0\n"),
                 read(QStringLiteral("one.tps")).constData());
        QVERIFY(files.exportTo(file(QStringLiteral("one.nts")), m_series->shownNames()));
        QVERIFY2(read(QStringLiteral("one.nts")).endsWith("\n9999 9999 9999 5 6 0\n"),
                 read(QStringLiteral("one.nts")).constData());
        QVERIFY(files.exportTo(file(QStringLiteral("one.csv")), m_series->shownNames()));
        QVERIFY2(read(QStringLiteral("one.csv")).contains("\na,5,6,0"), read(QStringLiteral("one.csv")).constData());
        QVERIFY(m_series->exportTable(file(QStringLiteral("all.nts")), ScanSeries::Table::Nts));
        QVERIFY(m_series->exportTable(file(QStringLiteral("long.csv")), ScanSeries::Table::Long));
        QVERIFY(read(QStringLiteral("long.csv")).startsWith("specimen,name,x,y,z"));
        QVERIFY(!m_series->exportTable(file(QStringLiteral("no/folder/x.csv")), ScanSeries::Table::Wide));
        // The table does not replace the files that it is made of either.
        for (const QString &name : {QStringLiteral("square.obj"), QStringLiteral("other.obj.points.csv")}) {
            const QByteArray before = read(name);
            QVERIFY(!before.isEmpty());
            QVERIFY(!m_series->exportTable(file(name), ScanSeries::Table::Wide));
            QCOMPARE(read(name), before);
        }
    }

    void repeatsOfASeries()
    {
        write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,1,0,0\n");
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QStringList told;
        connect(m_series.get(), &ScanSeries::noticed, this, [&told](const QString &text) { told << text; });
        QVERIFY(m_series->exportTable(file(QStringLiteral("repeats.csv")), ScanSeries::Table::Repeats));
        QVERIFY2(told.back().contains(QStringLiteral("No scan was placed more than once")), qPrintable(told.back()));
        m_series->setPlacing(2);
        QCOMPARE(points().size(), std::size_t(1));
        QVERIFY(!points()[0].isPlaced());
        m_document->sceneLandmarks().waitForNext(std::nullopt);
        placeAll(3.0);
        QVERIFY(m_series->exportTable(file(QStringLiteral("repeats.csv")), ScanSeries::Table::Repeats));
        QVERIFY2(
            told.back().startsWith(QStringLiteral("Repeats written to repeats.csv. Scans that were placed more than "
                                                  "once: 1;")),
            qPrintable(told.back()));
        QVERIFY(QFile::exists(path(QStringLiteral("square.obj.points-2.csv"))));
        QCOMPARE(read(QStringLiteral("square.obj.points.csv")), QByteArray("name,x,y,z\na,1,0,0\n"));
        const QByteArray repeats = read(QStringLiteral("repeats.csv"));
        QVERIFY2(repeats.startsWith("specimen,name,placings,x,y,z,error,farthest\nsquare,a,2,2,0.5,0,1.58"),
                 repeats.constData());
        m_series->setPlacing(1);
        QCOMPARE(points()[0].world->x, 1.0);
        QVERIFY(m_document->sceneLandmarks().moveTo(0, WorldPoint(4.0, 4.0, 0.0)));
        QVERIFY(m_series->close());
        QVERIFY(!m_series->isOpen() && !m_series->hasNext() && !m_series->hasPrevious());
        QVERIFY(read(QStringLiteral("square.obj.points.csv")).contains("a,4,4,0")); // kept, and still shown
        QCOMPARE(points()[0].world->x, 4.0);
        QVERIFY(m_document->sceneLandmarks().moveTo(0, WorldPoint(5.0, 4.0, 0.0)));
        QVERIFY(m_session->mayLeave());
        QVERIFY(read(QStringLiteral("square.obj.points.csv")).contains("a,4,4,0")); // no scan of a series any more
    }

    void tablesHaveEveryPlacing()
    {
        write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,1,0,0\n");
        write(QStringLiteral("square.obj.points-2.csv"), "name,x,y,z\nb,7,0,0\nA,2,0,0\n");
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QStringList told;
        connect(m_series.get(), &ScanSeries::noticed, this, [&told](const QString &text) { told << text; });
        QVERIFY(m_series->exportTable(file(QStringLiteral("wide.csv")), ScanSeries::Table::Wide));
        QCOMPARE(
            read(QStringLiteral("wide.csv")),
            QByteArray("specimen,placing,a_x,a_y,a_z,b_x,b_y,b_z\nsquare,1,1,0,0,NA,NA,NA\nsquare,2,2,0,0,7,0,0\n"));
        QVERIFY2(told.back().startsWith(QStringLiteral("Scans written to wide.csv: 1. 1 landmark has no coordinates")),
                 qPrintable(told.back()));
        QVERIFY(m_series->exportTable(file(QStringLiteral("long.csv")), ScanSeries::Table::Long));
        QVERIFY(read(QStringLiteral("long.csv")).startsWith("specimen,placing,name,x,y,z,"));
        m_series->setPlacing(2);
        QVERIFY(m_series->exportTable(file(QStringLiteral("all.tps")), ScanSeries::Table::Tps));
        QCOMPARE(read(QStringLiteral("all.tps")).count("LM3="), 1);
        QVERIFY(read(QStringLiteral("all.tps")).contains("COMMENT=placing 2\nID=square\n"));
        QVERIFY2(told.back().contains(QStringLiteral("Placing shown: 2.")), qPrintable(told.back()));
    }

    void errorsOfASeries()
    {
        write(QStringLiteral("other.obj"), kSquare);
        write(QStringLiteral("square.obj.points.csv"), "name,x,y,z,unit\na,0,0,0,mm\nb,9,0,0,mm\nc,0,9,0,mm\n");
        write(QStringLiteral("square.obj.points-2.csv"), "name,x,y,z,unit\na,2,0,0,mm\nb,9,0,0,mm\nc,0,9,0,mm\n");
        write(QStringLiteral("other.obj.points.csv"), "name,x,y,z,unit\na,1,0,0,mm\nb,8,0,0,mm\nc,0,7,0,mm\n");
        write(QStringLiteral("other.obj.points-2.csv"), "name,x,y,z,unit\na,1,0,0,mm\nb,8,0,0,mm\nc,0,7,0,mm\n");
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QVERIFY(m_series->exportTable(file(QStringLiteral("errors.csv")), ScanSeries::Table::Errors));
        const QByteArray table = read(QStringLiteral("errors.csv"));
        QVERIFY2(
            table.startsWith("landmark,specimens,placings,error,icc1,icc2,error_1,bias_1,error_2,bias_2\na,2,4,1,"),
            table.constData());
        const std::optional<SeriesRepeats> repeats = m_series->repeats();
        QVERIFY(repeats && repeats->specimens.size() == 2 && repeats->specimens[0].name == "other");
        write(QStringLiteral("other.obj.points-2.csv"), "name,x,y,z,unit\na,0.1,0,0,cm\n");
        QVERIFY(!m_series->repeats()); // one error has one unit
        QVERIFY2(m_failures.back().contains(QStringLiteral(" in cm")), qPrintable(m_failures.back()));
    }

    /// The first scan's measure is every scan's, and stays with the folder.
    void aProtocolGoesThroughTheSeries()
    {
        write(QStringLiteral("other.obj"), kSquare);
        write(QStringLiteral("other.obj.points.csv"), "name,x,y,z\na,0,0,0\nb,1,0,0\n");
        write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,0,0,0\nb,,,\n");
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QVERIFY(!QFile::exists(path(QStringLiteral("series.measures.csv"))));
        m_series->show(0);
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        const std::vector<landmarks::KeptMeasure> measures{{"w", landmarks::MeasureKind::Distance, {"a", "b"}},
                                                           {"s", landmarks::MeasureKind::Surface, {"a", "b"}}};
        landmarks::LandmarkSet set = m_document->scene().landmarks;
        set.measures = measures;
        QVERIFY(editLandmarkSet(*m_document, std::move(set), {QStringLiteral("keep")}));
        QCOMPARE(read(QStringLiteral("series.measures.csv")),
                 QByteArray("name,kind,landmarks\nw,distance,a,b\ns,surface,a,b\n"));
        m_series->next();
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QVERIFY(m_document->scene().landmarks.measures == measures);
        QCOMPARE(read(QStringLiteral("other.obj.points.csv")), QByteArray("name,x,y,z\na,0,0,0\nb,1,0,0\n"));
        QStringList told;
        connect(m_series.get(), &ScanSeries::noticed, this, [&told](const QString &text) { told << text; });
        std::size_t steps = 0;
        m_series->setWaiting([&steps](std::size_t, std::size_t) { return ++steps > 0; });
        QVERIFY(m_series->exportTable(file(QStringLiteral("wide.csv")), ScanSeries::Table::Wide));
        QCOMPARE(read(QStringLiteral("wide.csv")),
                 QByteArray("specimen,a_x,a_y,a_z,b_x,b_y,b_z,w,w_error,s,s_error,measures_note\n"
                            "other,0,0,0,1,0,0,1,NA,1,NA,\n"
                            "square,0,0,0,NA,NA,NA,NA,NA,NA,NA,\"w: \"\"b\"\" has no position yet; s: \"\"b\"\" has no "
                            "position yet\"\n"));
        QVERIFY(steps > 0);
        QVERIFY2(told.back().contains(QStringLiteral("The measure \"w\" is NA for 1 of 2 specimens")),
                 qPrintable(told.back()));
        m_series->setWaiting([](std::size_t, std::size_t) { return false; });
        QVERIFY(!m_series->exportTable(file(QStringLiteral("cancelled.csv")), ScanSeries::Table::Wide));
        QVERIFY(!QFile::exists(path(QStringLiteral("cancelled.csv"))));
        QVERIFY(m_failures.back().contains(QStringLiteral("cancelled")));
        QVERIFY(m_series->close());
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QVERIFY(m_series->measures() == measures);
    }

    void aForeignProtocolIsNotOverwritten()
    {
        const QByteArray broken = "name,kind\nw,width,a,b\n";
        write(QStringLiteral("series.measures.csv"), broken);
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QVERIFY2(m_warnings.join(u'\n').contains(QStringLiteral("series.measures.csv:2:")),
                 qPrintable(m_warnings.join(u'\n')));
        landmarks::LandmarkSet set = m_document->scene().landmarks;
        set.measures = {{"w", landmarks::MeasureKind::Distance, {"a", "b"}}};
        QVERIFY(editLandmarkSet(*m_document, std::move(set), {QStringLiteral("keep")}));
        QCOMPARE(read(QStringLiteral("series.measures.csv")), broken);
        QVERIFY(m_failures.join(u'\n').contains(QStringLiteral("is not overwritten")));
    }

    /// Another program changes the file, and moves it away later.
    void aProtocolIsWrittenOnceItCanBe()
    {
        const QByteArray foreign = "name,kind,landmarks\nother,distance,a,b\n";
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        write(QStringLiteral("series.measures.csv"), foreign);
        landmarks::LandmarkSet set = m_document->scene().landmarks;
        set.measures = {{"w", landmarks::MeasureKind::Distance, {"a", "b"}}};
        QVERIFY(editLandmarkSet(*m_document, std::move(set), {QStringLiteral("keep")}));
        QVERIFY(m_series->keep());
        QCOMPARE(read(QStringLiteral("series.measures.csv")), foreign);
        QVERIFY(QFile::remove(path(QStringLiteral("series.measures.csv"))));
        QVERIFY(m_series->keep());
        QCOMPARE(read(QStringLiteral("series.measures.csv")), QByteArray("name,kind,landmarks\nw,distance,a,b\n"));
    }

    void theSeriesTemplateIsNoTable()
    {
        const QByteArray names = "name,x,y,z\na,,,\nb,,,\n";
        write(QStringLiteral("series-template.csv"), names);
        write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,0,0,0\nb,1,0,0\n");
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QVERIFY(!m_series->exportTable(file(QStringLiteral("series-template.csv")), ScanSeries::Table::Wide));
        QCOMPARE(read(QStringLiteral("series-template.csv")), names);
    }

    void whatATableLacksIsSaid()
    {
        write(QStringLiteral("other.obj"), kSquare);
        write(QStringLiteral("third.obj"), kSquare);
        write(QStringLiteral("other.obj.points.csv"), "name,x,y,z,note\na,3,4,0,worn\n");
        write(QStringLiteral("other.obj.points-3.csv"), "name,x,y,z\na,3,5,0\n"); // the second observer left it out
        write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,1,two,3\n");
        write(QStringLiteral("third.obj.points.csv"), "specimen,name,x,y,z\np,a,1,2,3\nq,a,1,2,3\n");
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        for (const auto table : {ScanSeries::Table::Wide, ScanSeries::Table::Tps, ScanSeries::Table::Repeats}) {
            m_warnings.clear();
            QVERIFY(m_series->exportTable(file(QStringLiteral("all.csv")), table));
            QCOMPARE(m_warnings.size(), 1);
            QVERIFY2(m_warnings[0].contains(QStringLiteral("square.obj.points.csv:2:"))
                         && m_warnings[0].contains(QStringLiteral("third.obj.points.csv")),
                     qPrintable(m_warnings[0]));
            // A row a scan has no room for notes, so their absence needs no warning.
            QCOMPARE(m_warnings[0].contains(QStringLiteral("note")), table == ScanSeries::Table::Tps);
            const QStringList lines = m_warnings[0].split(u'\n');
            const auto repeats = std::find_if(lines.begin(), lines.end(), [](const QString &line) {
                return line.contains(QStringLiteral("1 repeated placing is left out"));
            });
            QCOMPARE(repeats != lines.end(), table == ScanSeries::Table::Tps);
            QVERIFY2(repeats == lines.end() || repeats == lines.begin(), "the message shows three lines at first");
        }
        QVERIFY2(read(QStringLiteral("all.csv")).contains("other,a,2,3,4.5,0,"),
                 read(QStringLiteral("all.csv")).constData());
        // Centimetres and millimetres are not averaged either.
        QString failure;
        connect(m_series.get(), &ScanSeries::failed, this, [&failure](const QString &text) { failure = text; });
        write(QStringLiteral("other.obj.points-3.csv"), "name,x,y,z,unit\na,3,5,0,mm\n");
        write(QStringLiteral("other.obj.points-4.csv"), "name,x,y,z,unit\na,0.3,0.5,0,cm\n");
        QVERIFY(!m_series->exportTable(file(QStringLiteral("all.csv")), ScanSeries::Table::Repeats));
        QVERIFY2(failure.contains(QStringLiteral("other.obj.points-3.csv is in mm and other.obj.points-4.csv in cm")),
                 qPrintable(failure));
    }

    /// Each scan is a triangle of its own size with three placed points; one file is broken, and so are
    /// the points of another one.
    void aHundredScansAndABrokenOne()
    {
        constexpr int kScans = 100, kBroken = 41, kDamaged = 70;
        QVERIFY(QFile::remove(path(QStringLiteral("square.obj"))));
        const auto nameOf = [](int i) { return QStringLiteral("scan%1.obj").arg(i, 3, 10, QChar(u'0')); };
        for (int i = 0; i < kScans; ++i) {
            const QByteArray size = QByteArray::number(i + 1);
            write(nameOf(i),
                  i == kBroken ? QByteArray("v 1 2\n") : "v 0 0 0\nv " + size + " 0 0\nv 0 " + size + " 0\nf 1 2 3\n");
            if (i == kDamaged)
                write(nameOf(i) + QStringLiteral(".points.csv"), "name,x,y,z\na,1,two,3\n");
        }
        open({nameOf(0)});
        fillFromTemplate(
            *m_document,
            [] {
                std::vector<Landmark> names(3);
                names[0].name = "a";
                names[1].name = "b";
                names[2].name = "c";
                return names;
            }(),
            QStringLiteral("three"));
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(m_series->scans().size(), std::size_t(kScans));
        for (int i = 0; i < kScans; ++i) {
            QCOMPARE(m_series->current(), std::optional<std::size_t>(i));
            if (i != kBroken && i != kDamaged) {
                QCOMPARE(m_document->objects()[0].name, nameOf(i).toStdString());
                for (const glm::dvec3 &corner : {glm::dvec3(0.0), glm::dvec3(i + 1, 0, 0), glm::dvec3(0, i + 1, 0)}) {
                    Landmark placed;
                    placed.world = WorldPoint(corner);
                    QVERIFY(m_document->sceneLandmarks().place(placed));
                }
                QVERIFY(!m_document->sceneLandmarks().nextUnplaced());
            }
            m_series->next();
            QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        }
        QCOMPARE(m_answers->saveQuestions, 1); // of the names that were there before
        QCOMPARE(m_failures.size(), 2);
        QVERIFY(m_failures[0].contains(nameOf(kBroken)) && m_failures[1].contains(nameOf(kDamaged)));

        QVERIFY(m_series->exportTable(file(QStringLiteral("long.csv")), ScanSeries::Table::Long));
        const auto rows = landmark_files::readLandmarkFile(file(QStringLiteral("long.csv")));
        QVERIFY(rows);
        QCOMPARE(rows->sets.size(), std::size_t(kScans - 2));
        QVERIFY(m_series->exportTable(file(QStringLiteral("all.tps")), ScanSeries::Table::Tps));
        const auto tps = landmark_files::readLandmarkFile(file(QStringLiteral("all.tps")));
        QVERIFY(tps);
        QCOMPARE(tps->sets.size(), std::size_t(kScans - 2));
        QVERIFY(m_series->exportTable(file(QStringLiteral("wide.csv")), ScanSeries::Table::Wide));
        const QList<QByteArray> wide = read(QStringLiteral("wide.csv")).trimmed().split('\n');
        QCOMPARE(wide.size(), qsizetype(kScans - 2 + 1));
        QCOMPARE(wide[0], QByteArray("specimen,a_x,a_y,a_z,b_x,b_y,b_z,c_x,c_y,c_z"));
        std::size_t row = 0;
        for (int i = 0; i < kScans; ++i) {
            if (i == kBroken || i == kDamaged)
                continue;
            const std::string specimen = nameOf(i).chopped(4).toStdString();
            QCOMPARE(rows->sets[row].name, specimen);
            QCOMPARE(tps->sets[row].name, specimen);
            QCOMPARE(rows->sets[row].landmarks[2].world->coordinates(), glm::dvec3(0, i + 1, 0));
            QCOMPARE(tps->sets[row].landmarks[1].world->coordinates(), glm::dvec3(i + 1, 0, 0));
            ++row;
            QCOMPARE(wide[qsizetype(row)],
                     QStringLiteral("scan%1,0,0,0,%2,0,0,0,%2,0").arg(i, 3, 10, QChar(u'0')).arg(i + 1).toUtf8());
        }
        QVERIFY(m_warnings.join(u'\n').contains(nameOf(kDamaged)));
    }
};

UNPROJECTOR_TEST(TestScanTables, threads)
#include "test_scan_tables.moc"
