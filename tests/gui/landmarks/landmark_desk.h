#pragma once

#include "gui/document/landmark_files.h"
#include "gui/document/scene_document.h"
#include "gui/document/session.h"
#include "gui/landmarks/scan_series.h"
#include "tests/support/patience.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

/// Helpers that the tests of landmark files and of series of scans share: the test's own folder
/// with a scan, and everything that opens, keeps and asks.
namespace landmarkfiles {

using unprojector::landmarks::Landmark;

struct FixedAnswers : unprojector::gui::SessionQuestions, unprojector::gui::LandmarkFileQuestions {
    SaveAnswer askSave(const QString &, bool) override
    {
        ++saveQuestions;
        return save;
    }
    std::filesystem::path askFileName(const std::filesystem::path &) override { return {}; }
    bool askOverwrite(const std::filesystem::path &) override { return true; }
    bool askOverwriteChanged(const std::filesystem::path &) override { return true; }
    FewerAnswer askFewerLandmarks(const std::filesystem::path &file, int saved, int now) override
    {
        fewerQuestions << QStringLiteral("%1 %2 %3")
                              .arg(QString::fromStdU16String(file.filename().u16string()))
                              .arg(saved)
                              .arg(now);
        return fewer;
    }
    bool askDeleteKept(const QString &) override { return true; }
    Join askJoin(const Counts &counts) override
    {
        ++joinQuestions;
        asked = counts;
        if (meanwhile)
            meanwhile();
        return join;
    }
    unprojector::gui::LandmarkFileQuestions::Stray askStray(const QString &text) override
    {
        strayText = text;
        return stray;
    }

    Order askOrder(const QString &text) override
    {
        orderText = text;
        return order;
    }

    SaveAnswer save = SaveAnswer::Discard;
    FewerAnswer fewer = FewerAnswer::Cancel;
    QStringList fewerQuestions; ///< "face.ply.points.csv 10 0"
    Join join = Join::Replace;
    unprojector::gui::LandmarkFileQuestions::Stray stray = unprojector::gui::LandmarkFileQuestions::Stray::Tie;
    int saveQuestions = 0, joinQuestions = 0;
    std::function<void()> meanwhile; ///< happens during a question
    Counts asked;
    QString strayText, orderText;
    Order order = Order::Fill;
};

/// A square of two triangles from (0, 0, 0) to (10, 10, 0).
inline const QByteArray kSquare = "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nf 1 2 3\nf 1 3 4\n";

/// A test that starts each of its functions in a fresh state.
class LandmarksTest : public QObject {
protected:
    /// Starts with square.obj in the folder.
    void begin();

    QString path(const QString &name) const { return m_folder->filePath(name); }
    std::filesystem::path file(const QString &name) const { return path(name).toStdU16String(); }
    void write(const QString &name, const QByteArray &text) const
    {
        QFile out(path(name));
        QVERIFY(out.open(QIODevice::WriteOnly));
        QCOMPARE(out.write(text), text.size());
    }
    QByteArray read(const QString &name) const
    {
        QFile in(path(name));
        return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray("no file");
    }
    void open(const QStringList &names)
    {
        std::vector<std::filesystem::path> files;
        for (const QString &name : names)
            files.push_back(file(name));
        m_session->openFiles(files);
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
    }
    const std::vector<unprojector::landmarks::Landmark> &points() const { return m_document->landmarks(); }
    void placeAll(double x)
    {
        while (m_document->sceneLandmarks().nextUnplaced()) {
            unprojector::landmarks::Landmark placed;
            placed.world = unprojector::geometry::WorldPoint(x, 1.0, 0.0);
            QVERIFY(m_document->sceneLandmarks().place(placed));
        }
    }

    void openSeries()
    {
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
    }
    void nextScan()
    {
        m_series->next();
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
    }
    void placeOne(const char *name, double x)
    {
        unprojector::landmarks::Landmark placed;
        placed.name = name;
        placed.world = unprojector::geometry::WorldPoint(x, 1.0, 0.0);
        QVERIFY(m_document->sceneLandmarks().place(placed));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<unprojector::gui::SceneDocument> m_document;
    std::unique_ptr<FixedAnswers> m_answers;
    std::unique_ptr<unprojector::gui::Session> m_session;
    std::unique_ptr<unprojector::gui::LandmarkFiles> m_files;
    std::unique_ptr<unprojector::gui::ScanSeries> m_series;
    QStringList m_failures, m_warnings, m_notices;
};

inline void LandmarksTest::begin()
{
    m_series.reset();
    m_files.reset();
    m_session.reset();
    m_failures.clear();
    m_warnings.clear();
    m_notices.clear();
    m_folder = std::make_unique<QTemporaryDir>();
    m_answers = std::make_unique<FixedAnswers>();
    m_document = std::make_unique<unprojector::gui::SceneDocument>();
    m_document->setSurface({800, 600, 1.0});
    unprojector::gui::Session::Options options;
    options.remembers = true;
    options.recoveryFolder = path(QStringLiteral("recovery"));
    m_session = std::make_unique<unprojector::gui::Session>(*m_document, *m_answers, options);
    m_files = std::make_unique<unprojector::gui::LandmarkFiles>(*m_document, m_answers.get());
    m_series = std::make_unique<unprojector::gui::ScanSeries>(*m_document, *m_session);
    const auto note = [](QStringList &list) { return [&list](const QString &text) { list << text; }; };
    connect(m_files.get(), &unprojector::gui::LandmarkFiles::failed, this, note(m_failures));
    connect(m_series.get(), &unprojector::gui::ScanSeries::failed, this, note(m_failures));
    connect(m_session.get(), &unprojector::gui::Session::failed, this, note(m_failures));
    connect(m_files.get(), &unprojector::gui::LandmarkFiles::warned, this, note(m_warnings));
    connect(m_series.get(), &unprojector::gui::ScanSeries::warned, this, note(m_warnings));
    connect(m_session.get(), &unprojector::gui::Session::warned, this, note(m_warnings));
    connect(m_files.get(), &unprojector::gui::LandmarkFiles::noticed, this, note(m_notices));
    connect(m_series.get(), &unprojector::gui::ScanSeries::noticed, this, note(m_notices));
    connect(m_session.get(), &unprojector::gui::Session::landmarkFilesOpened, this,
            [this](const std::vector<std::filesystem::path> &opened) {
                for (const std::filesystem::path &one : opened)
                    m_files->importFrom(one);
            });
    write(QStringLiteral("square.obj"), kSquare);
}

} // namespace landmarkfiles
