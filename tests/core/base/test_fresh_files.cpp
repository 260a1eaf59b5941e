// Temporary files during writing: only the user may read them, and none stays behind for ever.
#include "tests/support/test.h"

#include "core/base/replace_file.h"
#include "tests/core/base/file_folder.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <atomic>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

#ifndef Q_OS_WIN
#include <sys/stat.h>
#endif

using namespace unprojector::base;
using namespace written_files;

namespace {

/// The only file of a folder with the name of a fresh one.
std::filesystem::path freshFile(const Folder &folder)
{
    for (const auto &entry : std::filesystem::directory_iterator(folder / "")) {
        if (entry.path().extension() == ".tmp")
            return entry.path();
    }
    return {};
}

} // namespace

class TestFreshFiles : public QObject {
    Q_OBJECT

private slots:
    void aFileThatIsBeingWrittenIsTheUsersAlone()
    {
#ifdef Q_OS_WIN
        QSKIP("Windows' rights are those of the folder");
#else
        const Folder folder;
        folder.write("old.csv", "before");
        QCOMPARE(chmod(qPrintable(folder.path("old.csv")), 0664), 0);
        const auto permissionsOf = [](const std::filesystem::path &file) {
            return std::filesystem::status(file).permissions();
        };
        const mode_t before = umask(022);
        for (const auto &[name, after] : {std::pair("old.csv", 0664), std::pair("new.csv", 0644)}) {
            ReplacingFile file = std::move(ReplacingFile::open(folder / name)).value();
            QCOMPARE(permissionsOf(freshFile(folder)), std::filesystem::perms(0600));
            QVERIFY(file.write("after").hasValue() && file.commit().hasValue());
            QCOMPARE(permissionsOf(folder / name), std::filesystem::perms(after));
        }
        umask(before);
#endif
    }

    void whatAKilledProgramLeftIsRemoved()
    {
        const Folder folder;
        // The first 8 digits name the system; a killed program differs in the others.
        ReplacingFile waiting = std::move(ReplacingFile::open(folder / "waiting")).value();
        const QString held = QString::fromStdU16String(freshFile(folder).filename().u16string());
        const auto otherDigit = [&held](qsizetype at) {
            QString name = held;
            name[at] = name[at] == '0' ? '1' : '0';
            return name;
        };
        const qsizetype start = QStringLiteral(".unprojector-").size();
        const QString ours = otherDigit(start + 8), oursToo = otherDigit(start + 15);
        const QString another = otherDigit(start), anothersOld = otherDigit(start + 7);
        const QStringList others{".unprojector-0123456789abcde.tmp", ".unprojector-0123456789abcdeg.tmp",
                                 ".unprojector-0123456789abcdef.tmp.bak", "unprojector-0123456789abcdef.tmp"};
        const auto age = [&](const QString &name) {
            const auto before = std::filesystem::file_time_type::clock::now() - std::chrono::hours(25);
            std::error_code refused; // Windows refuses it for an open file, which cannot be removed there anyway
            std::filesystem::last_write_time(folder / name, before, refused);
        };
        for (const QString &name : QStringList{ours, oursToo, another, anothersOld} + others)
            folder.write(name, "left");
        for (const QString &name : QStringList{oursToo, anothersOld, held} + others)
            age(name);
        QVERIFY(replaceFile(folder / "a.json", "after").hasValue());
        QStringList names = folder.names(), expected = others + QStringList{another, held, "a.json"};
        names.sort();
        expected.sort();
        QCOMPARE(names, expected);
        QVERIFY(waiting.write("all the same").hasValue() && waiting.commit().hasValue());
        QCOMPARE(folder.read("waiting"), "all the same");
    }

    /// A program that sweeps a folder may meet a file at any moment of its writing.
    void noFileIsRemovedWhileItIsWritten()
    {
        const Folder folder;
        const std::filesystem::path path = folder / "a";
        std::atomic<bool> isOver = false;
        std::thread sweeper([&] {
            while (!isOver)
                removeAbandonedFiles(path.parent_path());
        });
        QStringList failures;
        for (int i = 0; i < 300; ++i) {
            FreshFile file;
            std::error_code error = file.create(path.parent_path(), path);
            if (!error)
                error = file.write("whole");
            if (!error)
                error = file.moveTo(path);
            if (error)
                failures << QString::number(i) + ": " + QString::fromStdString(error.message());
        }
        isOver = true;
        sweeper.join();
        QCOMPARE(failures, QStringList());
        QCOMPARE(folder.names(), QStringList("a"));
        QCOMPARE(folder.read("a"), "whole");
    }
};

UNPROJECTOR_TEST(TestFreshFiles)
#include "test_fresh_files.moc"
