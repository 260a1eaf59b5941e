#pragma once

#include "gui/document/scene_document.h"
#include "gui/document/session.h"
#include "tests/support/patience.h"

#include "tests/gui/document_edits.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <functional>
#include <memory>

/// Helpers that the tests of a session without a window share: the test's own folder, a session
/// with its dependencies, and canned answers.
namespace sessions {

inline const QByteArray kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
inline const QByteArray kHead = R"({"unprojector": 1, "window": {"width": 300, "height": 200},
    "projection": {"type": "ortho", "left": -3, "right": 3, "bottom": -2, "top": 2, "near": 1, "far": 9},
    "view": {"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]})";

inline std::filesystem::path pathOf(const QString &name)
{
    return std::filesystem::path(name.toStdU16String());
}

inline QByteArray read(const QString &file)
{
    QFile stream(file);
    return stream.open(QIODevice::ReadOnly) ? stream.readAll() : QByteArray();
}

/// Gives the answers that the test has set, and records the questions.
class CannedAnswers : public unprojector::gui::SessionQuestions {
public:
    SaveAnswer save = SaveAnswer::Cancel;
    bool yes = false;
    std::filesystem::path fileName;
    QStringList asked;
    std::function<void()> whileAsking = [] {};

    SaveAnswer askSave(const QString &name, bool) override
    {
        note(QStringLiteral("save ") + name);
        return save;
    }
    std::filesystem::path askFileName(const std::filesystem::path &proposal) override
    {
        note(QStringLiteral("name ") + QString::fromStdU16String(proposal.filename().u16string()));
        return fileName;
    }
    bool askOverwrite(const std::filesystem::path &file) override
    {
        note(QStringLiteral("overwrite ") + QString::fromStdU16String(file.filename().u16string()));
        return yes;
    }
    bool askOverwriteChanged(const std::filesystem::path &file) override
    {
        note(QStringLiteral("changed ") + QString::fromStdU16String(file.filename().u16string()));
        return yes;
    }
    FewerAnswer askFewerLandmarks(const std::filesystem::path &file, int, int) override
    {
        note(QStringLiteral("fewer ") + QString::fromStdU16String(file.filename().u16string()));
        return FewerAnswer::Cancel;
    }
    bool askDeleteKept(const QString &name) override
    {
        note(QStringLiteral("delete ") + name);
        return yes;
    }

private:
    void note(const QString &question)
    {
        asked << question;
        whileAsking();
    }
};

/// A session with its dependencies.
struct Desk {
    explicit Desk(const QString &recoveryFolder) : session(document, answers, {true, recoveryFolder, {}})
    {
        QObject::connect(&session, &unprojector::gui::Session::failed, &context,
                         [this](const QString &reason) { failures << reason; });
        QObject::connect(&session, &unprojector::gui::Session::noticed, &context,
                         [this](const QString &text) { notices << text; });
        QObject::connect(&session, &unprojector::gui::Session::warned, &context,
                         [this](const QString &text) { warnings << text; });
    }
    bool openAndWait(const QStringList &files, bool adds = false)
    {
        std::vector<std::filesystem::path> paths;
        for (const QString &file : files)
            paths.push_back(pathOf(file));
        adds ? session.addFiles(paths) : session.openFiles(paths);
        return QTest::qWaitFor([this] { return !session.isLoading(); }, kPatienceMilliseconds);
    }
    QStringList names() const
    {
        QStringList names;
        for (const unprojector::scene::SceneObject &object : document.objects())
            names << QString::fromStdString(object.name);
        return names;
    }
    void cut(double d = 0.5) { QVERIFY(editClipPlanes(document, {{0.0, 1.0, 0.0, d}}, {}, {QStringLiteral("Plane")})); }

    unprojector::gui::SceneDocument document;
    CannedAnswers answers;
    unprojector::gui::Session session;
    QStringList failures;
    QStringList notices;
    QStringList warnings;
    QObject context;
};

using Step = std::function<void(Desk &)>;

/// A test with a folder for each of its claims.
class FolderUser {
protected:
    /// Another one, with triangle.obj in it.
    void changeFolder()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        write(QStringLiteral("triangle.obj"), kTriangle);
    }
    QString file(const QString &name) const { return m_folder->filePath(name); }
    QString write(const QString &name, const QByteArray &text) const
    {
        QFile stream(file(name));
        if (!stream.open(QIODevice::WriteOnly) || stream.write(text) != text.size())
            qFatal("the test's folder cannot be written");
        return file(name);
    }
    QString writeScene(const QString &name) const
    {
        return write(name, kHead + R"(, "objects": [{"name": "t", "file": "triangle.obj"}]})");
    }
    std::unique_ptr<Desk> desk() const { return std::make_unique<Desk>(file(QStringLiteral("recovery"))); }

    /// The number of files for crash recovery, locks included.
    int kept() const { return static_cast<int>(QDir(file(QStringLiteral("recovery"))).entryList(QDir::Files).size()); }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

} // namespace sessions

Q_DECLARE_METATYPE(sessions::Step)
