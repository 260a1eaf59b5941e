// Temporary files during writing: only the user may read them, and none stays behind for ever.
#include "core/files/replace_file.h"
#include "file_folder.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <chrono>
#include <system_error>
#include <utility>

#ifndef Q_OS_WIN
#include <sys/stat.h>
#endif

using namespace unprojector::files;
using namespace written_files;

class TestFreshFiles : public QObject {
    Q_OBJECT

private slots:
    void aFileThatIsBeingWrittenIsTheUsersAlone();
    void whatAKilledProgramLeftIsRemoved();
};

void TestFreshFiles::aFileThatIsBeingWrittenIsTheUsersAlone()
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
        QCOMPARE(permissionsOf(file.freshFile()), std::filesystem::perms(0600));
        QVERIFY(file.write("after").hasValue() && file.commit().hasValue());
        QCOMPARE(permissionsOf(folder / name), std::filesystem::perms(after));
    }
    umask(before);
#endif
}

void TestFreshFiles::whatAKilledProgramLeftIsRemoved()
{
    const Folder folder;
    const QString ours = ".unprojector-0123456789abcdef.tmp", fresh = ".unprojector-fedcba9876543210.tmp";
    const QStringList others{".unprojector-0123456789abcde.tmp", ".unprojector-0123456789abcdeg.tmp",
                             ".unprojector-0123456789abcdef.tmp.bak", "unprojector-0123456789abcdef.tmp"};
    const auto age = [&](const QString &name) {
        const auto hourAgo = std::filesystem::file_time_type::clock::now() - std::chrono::hours(1);
        std::error_code refused; // Windows refuses it for an open file, which cannot be removed there anyway
        std::filesystem::last_write_time(folder / name, hourAgo, refused);
    };
    for (const QString &name : QStringList{ours, fresh} + others)
        folder.write(name, "left");
    for (const QString &name : QStringList{ours} + others)
        age(name);
    ReplacingFile waiting = std::move(ReplacingFile::open(folder / "waiting")).value();
    const QString held = QString::fromStdU16String(waiting.freshFile().filename().u16string());
    age(held); // another one, which waits for its input for so long
    QVERIFY(replaceFile(folder / "a.json", "after").hasValue());
    QStringList names = folder.names(), expected = others + QStringList{fresh, held, "a.json"};
    names.sort();
    expected.sort();
    QCOMPARE(names, expected);
    QVERIFY(waiting.write("all the same").hasValue() && waiting.commit().hasValue());
    QCOMPARE(folder.read("waiting"), "all the same");
}

QTEST_GUILESS_MAIN(TestFreshFiles)
#include "test_fresh_files.moc"
