// --series with --screenshots: an image of each scan with its landmarks, and a contact sheet.

#include "tests/support/test.h"

#include "tests/gui/program/program_run.h"
#include "tests/gui/scan_folder.h"

#include <QDir>
#include <QFile>
#include <QImage>

using namespace program_run;

class TestSeriesPictures : public QObject, ScanFolder {
    Q_OBJECT

private slots:
    void init()
    {
        begin();
        QVERIFY(QDir(path(QString())).mkdir(QStringLiteral("scans")));
        for (const char *name : {"scans/a.obj", "scans/b.obj", "scans/c.obj"})
            write(QLatin1String(name), kSquare);
        write(QStringLiteral("scans/a.obj.points.csv"), "name,x,y,z,color\nleft,2,5,0,#ff0000\nright,8,5,0,#ff0000\n");
        write(QStringLiteral("scans/b.obj.points.csv"), "name,x,y,z\nleft,2,5,0\nright,,,\n");
    }

    void eachScanHasItsPicture()
    {
        const QStringList before = files();
        const Run result = pictures();
        QVERIFY2(result.hasExited && result.exitCode == 0, result.errors.constData());
        QCOMPARE(QDir(path(QStringLiteral("out"))).entryList(QDir::Files),
                 (QStringList{"a.obj.png", "b.obj.png", "c.obj.png", "contact-sheet.png"}));
        for (const char *line : {"1 of 3: a.obj: 2 of 2", "2 of 3: b.obj: 1 of 2", "3 of 3: c.obj: 0 of 2",
                                 "Images of 3 scans and contact-sheet.png written to "})
            QVERIFY2(result.errors.contains(line), result.errors.constData());
        const QImage a(path(QStringLiteral("out/a.obj.png"))), c(path(QStringLiteral("out/c.obj.png")));
        QCOMPARE(a.size(), QSize(400, 300));
        const auto reds = [](const QImage &image) { // of the landmarks' markers
            int count = 0;
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) {
                    const QColor color = image.pixelColor(x, y);
                    count += color.red() > 200 && color.green() < 60 && color.blue() < 60 ? 1 : 0;
                }
            }
            return count;
        };
        QVERIFY2(reds(a) > 20, qPrintable(QString::number(reds(a))));
        QCOMPARE(reds(c), 0);
        const QImage sheet(path(QStringLiteral("out/contact-sheet.png")));
        QVERIFY(sheet.width() >= 2 * 320 && sheet.height() >= 2 * 240);
        QVERIFY(reds(sheet.copy(0, 0, sheet.width() / 2, sheet.height() / 2)) > 5);
        QCOMPARE(files(), before); // nothing is written there
    }

    void aScanThatCannotBeReadIsInTheSheet()
    {
        write(QStringLiteral("scans/b.obj"), "v 1 2\n");
        write(QStringLiteral("scans/c.obj.points.csv"), "name,x,y,z\nleft,1,two,3\n");
        const Run result = pictures();
        QVERIFY2(result.hasExited && result.exitCode == 1, result.errors.constData());
        QCOMPARE(QDir(path(QStringLiteral("out"))).entryList(QDir::Files),
                 (QStringList{"a.obj.png", "contact-sheet.png"}));
        for (const char *line : {"2 of 3: b.obj: ", "3 of 3: c.obj: ", "Scans that could not be read: 2."})
            QVERIFY2(result.errors.contains(line), result.errors.constData());
        const QImage sheet(path(QStringLiteral("out/contact-sheet.png")));
        QVERIFY(!sheet.isNull());
        int ink = 0; // the reason, on the second tile
        for (int y = 20; y < 230; ++y) {
            for (int x = 350; x < 640; ++x) {
                const QColor color = sheet.pixelColor(x, y);
                ink += color.red() > color.blue() + 60 ? 1 : 0;
            }
        }
        QVERIFY2(ink > 50, qPrintable(QString::number(ink)));
    }

    void everyTileHasTheImagesProportions()
    {
        write(QStringLiteral("scans/b.obj"), "v 1 2\n");
        const Run result = pictures({QStringLiteral("--size"), QStringLiteral("800x200")});
        QVERIFY2(result.hasExited && result.exitCode == 1, result.errors.constData());
        const QImage sheet(path(QStringLiteral("out/contact-sheet.png")));
        QVERIFY2(sheet.height() < 2 * 120, qPrintable(QString::number(sheet.height()))); // two rows of 320 x 80
        const QRgb grey = qRgb(240, 240, 240);                                           // of the damaged scan's tile
        QRect tile;
        for (int y = 0; y < sheet.height(); ++y) {
            for (int x = sheet.width() / 2; x < sheet.width(); ++x) {
                if (y < sheet.height() / 2 && sheet.pixel(x, y) == grey)
                    tile |= QRect(x, y, 1, 1);
            }
        }
        QCOMPARE(tile.size(), QSize(320, 80));
    }

    void aSideIsChosen()
    {
        const auto redsFrom = [this](const char *side) { // in the left and the right half
            const Run result = pictures(
                {QStringLiteral("--size"), QStringLiteral("400x300"), QStringLiteral("--view"), QLatin1String(side)});
            std::pair<int, int> reds;
            if (!result.hasExited || result.exitCode != 0)
                return reds;
            const QImage image(path(QStringLiteral("out/a.obj.png")));
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) {
                    const QColor color = image.pixelColor(x, y);
                    if (color.red() > 200 && color.green() < 60 && color.blue() < 60)
                        ++(x < image.width() / 2 ? reds.first : reds.second);
                }
            }
            return reds;
        };
        write(QStringLiteral("scans/a.obj.points.csv"), "name,x,y,z,color\nleft,2,5,0,#ff0000\nother,8,5,0,#00ff00\n");
        const auto [left, right] = redsFrom("front");
        QVERIFY2(left > 10 && right == 0, qPrintable(QStringLiteral("%1 %2").arg(left).arg(right)));
        const auto [behindLeft, behindRight] = redsFrom("back"); // it has changed sides
        QVERIFY2(behindLeft == 0 && behindRight > 10,
                 qPrintable(QStringLiteral("%1 %2").arg(behindLeft).arg(behindRight)));
    }

    void aMistakeIsToldOnStderr_data()
    {
        addColumn<QStringList>("words");
        addColumn<QString>("said");
        const QString out = QStringLiteral("--screenshots"), series = QStringLiteral("--series");
        newRow("without a series") << QStringList{out, "o"} << "--screenshots works together with --series FOLDER.";
        newRow("no side") << QStringList{series, "s", out, "o", "--view", "nose"} << "--view is nose; give front";
        newRow("a side of nothing") << QStringList{"--view", "top"} << "--view works together with --screenshots";
        newRow("one image") << QStringList{series, "s", "--screenshot", "x.png"} << "give --screenshots OUT";
        newRow("with a model") << QStringList{series, "s", "a.obj"} << "Give --series alone";
        newRow("no folder") << QStringList{series, "/nowhere/at/all", out, "/tmp"} << "the folder cannot be read";
        newRow("no folder to write") << QStringList{series, "s", out, "/dev/null/x"} << "is not a folder";
    }

    void aMistakeIsToldOnStderr()
    {
        QFETCH(QStringList, words);
        QFETCH(QString, said);
        const Run result = run(words);
        QVERIFY(result.hasExited);
        QCOMPARE(result.exitCode, 2);
        QVERIFY2(textOf(result.errors).contains(said), result.errors.constData());
    }

private:
    QStringList files() const { return QDir(path(QStringLiteral("scans"))).entryList(QDir::Files); }
    Run pictures(const QStringList &more = {}) const
    {
        return run(QStringList{QStringLiteral("--series"), path(QStringLiteral("scans")),
                               QStringLiteral("--screenshots"), path(QStringLiteral("out"))}
                   + (more.isEmpty() ? QStringList{QStringLiteral("--size"), QStringLiteral("400x300")} : more));
    }
};

UNPROJECTOR_TEST(TestSeriesPictures, display)
#include "test_series_pictures.moc"
