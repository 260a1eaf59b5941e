// Files while they are written: they are the user's alone, and none stays behind for ever.
#include "core/files/replace_file.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <chrono>
#include <utility>

#ifndef Q_OS_WIN
#include <sys/stat.h>
#endif

using namespace unprojector::files;

namespace {

std::filesystem::path pathOf(const QString &name)
{
    return std::filesystem::path(name.toStdU16String());
}

/// A folder of its own for each test.
class Folder {
public:
    QString path(const QString &name) const { return m_folder.filePath(name); }
    std::filesystem::path operator/(const QString &name) const { return pathOf(path(name)); }
    void write(const QString &name, const QByteArray &contents) const
    {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(contents) == contents.size());
    }
    QByteArray read(const QString &name) const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("none");
    }
    /// Hidden ones too: a new file that was left behind would be one.
    QStringList names() const
    {
        return QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::System | QDir::Hidden | QDir::NoDotAndDotDot);
    }

private:
    QTemporaryDir m_folder;
};

} // namespace

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
        std::filesystem::last_write_time(folder / name, hourAgo);
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
