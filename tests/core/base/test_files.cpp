// The writing of files: whole or not at all, never over another program's changes, and with the
// system's reason if it fails.
#include "tests/support/test.h"

#include "core/base/replace_file.h"
#include "tests/core/base/file_folder.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <algorithm>
#include <csignal>

#ifndef Q_OS_WIN
#include <grp.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

using namespace unprojector::base;
using namespace written_files;

namespace {

QString textOf(const Done &written)
{
    return written ? QStringLiteral("written") : QString::fromStdString(written.error().text);
}

/// Makes a link; returns false if the system has none.
bool linkTo(const std::filesystem::path &target, const std::filesystem::path &link)
{
    std::error_code error;
    std::filesystem::create_symlink(target, link, error);
    return !error;
}

} // namespace

class TestFiles : public QObject {
    Q_OBJECT

private slots:
    void aNameIsWritten_data()
    {
        addColumn<QString>("name");
        newRow("plain") << "a.json";
        newRow("blanks") << " a b .json ";
        newRow("Chinese") << QStringLiteral("\u7403\u4F53.json");
        newRow("no suffix") << "a";
        newRow("the longest") << QString(250, 'a') + ".json";
        newRow("the longest, Chinese") << QString(83, QChar(0x7403)) + ".json";
        newRow("by way of a folder") << "none/../a.json";
    }

    void aNameIsWritten()
    {
        QFETCH(QString, name);
        const Folder folder;
        if (name.contains("none"))
            QVERIFY(QDir(folder.path(".")).mkdir("none"));
#ifdef Q_OS_WIN
        if (name.startsWith(' ') || name.size() > 200)
            QSKIP("Windows has no such names");
#endif
        const auto files = [&] {
            QStringList names = folder.names();
            names.removeOne("none");
            return names;
        };
        QCOMPARE(textOf(replaceFile(folder / name, "first")), "written");
        QCOMPARE(folder.read(name), "first");
        QCOMPARE(textOf(replaceFile(folder / name, "second\n")), "written");
        QCOMPARE(folder.read(name), "second\n");
        QCOMPARE(files(), QStringList(QFileInfo(name).fileName()));
        QCOMPARE(textOf(replaceFile(folder / name, "")), "written");
        QCOMPARE(folder.read(name), "");
    }

    void nothingChangesBeforeTheEnd()
    {
        const Folder folder;
        folder.write("a.json", "before");
        // A program that guesses a temporary name, such as NAME.new, guesses wrong: these files stay
        // untouched.
        folder.write("a.json.new", "mine");
        {
            auto file = ReplacingFile::open(folder / "a.json");
            QVERIFY(file.hasValue());
            ReplacingFile writing = std::move(file).value();
            QVERIFY(writing.write("after").hasValue());
            QCOMPARE(folder.read("a.json"), "before");
            QCOMPARE(folder.names().size(), 3);
        }
        QCOMPARE(folder.names(), QStringList({"a.json", "a.json.new"}));
        QCOMPARE(folder.read("a.json"), "before");
        QVERIFY(replaceFile(folder / "a.json", "after").hasValue());
        QCOMPARE(folder.read("a.json.new"), "mine");
    }

    void aNameThatTakesNoFile_data()
    {
        addColumn<QString>("name");
        addColumn<QString>("text");
        const QString isFolder = "this is a folder; give the name of a file";
        const QString noFolder = "there is no such folder; make it or give another name";
        newRow("a folder") << "folder" << isFolder;
        newRow("a folder, with a slash") << "folder/" << isFolder;
        newRow(".") << "." << isFolder;
        newRow("..") << "folder/.." << isFolder;
        newRow("missing folder") << "none/a.json" << noFolder;
        newRow("no name, missing folder") << "none/" << noFolder;
        newRow("a file for a folder") << "file/a.json"
                                      << "*";
        newRow("a file with a slash") << "file/"
                                      << "*";
#ifndef Q_OS_WIN
        newRow("too long") << QString(256, 'a') << "the file cannot be written (File name too long)";
#endif
    }

    void aNameThatTakesNoFile()
    {
        QFETCH(QString, name);
        QFETCH(QString, text);
        const Folder folder;
        QVERIFY(QDir(folder.path(".")).mkdir("folder"));
        folder.write("file", "before");
        const Done written = replaceFile(pathOf(folder.path(".").chopped(1) + name), "after");
        QVERIFY(!written);
        if (text != "*")
            QCOMPARE(textOf(written), text);
        QCOMPARE(folder.names(), QStringList({"file", "folder"}));
        QCOMPARE(folder.read("file"), "before");
        QCOMPARE(textOf(replaceFile("", "after")), "there is no such folder; make it or give another name");
    }

    void aReadOnlyFileIsKept()
    {
        const Folder folder;
        folder.write("a.json", "before");
        QVERIFY(QFile::setPermissions(folder.path("a.json"), QFile::ReadOwner | QFile::ReadGroup));
        const Done written = replaceFile(folder / "a.json", "after");
        QCOMPARE(textOf(written), "the file is read-only; allow writing to it or give another name");
        QCOMPARE(folder.read("a.json"), "before");
        QCOMPARE(folder.names(), QStringList("a.json"));
        QVERIFY(QFile::setPermissions(folder.path("a.json"), QFile::ReadOwner | QFile::WriteOwner));
        QVERIFY(replaceFile(folder / "a.json", "after").hasValue());
    }

    void permissionsStay()
    {
#ifdef Q_OS_WIN
        QSKIP("Windows' rights are those of the folder");
#else
        const Folder folder;
        for (const mode_t mode : {0600, 0640, 0755, 0666}) {
            folder.write("a.json", "before");
            QCOMPARE(chmod(qPrintable(folder.path("a.json")), mode), 0);
            QVERIFY(replaceFile(folder / "a.json", "after").hasValue());
            struct stat status {};
            QCOMPARE(stat(qPrintable(folder.path("a.json")), &status), 0);
            QCOMPARE(status.st_mode & mode_t(07777), mode);
        }
        const mode_t before = umask(027);
        QVERIFY(replaceFile(folder / "new.json", "after").hasValue());
        umask(before);
        struct stat status {};
        QCOMPARE(stat(qPrintable(folder.path("new.json")), &status), 0);
        QCOMPARE(status.st_mode & mode_t(07777), mode_t(0640));
#endif
    }

    void anothersFileIsNotOpenedToMore_data()
    {
        addColumn<bool>("isOwn");
        addColumn<bool>("isOfOwnGroup");
        addColumn<int>("before");
        addColumn<int>("after");
        // The rights of the new file's owner, its group, and all others; 4000 and 2000 run it as its
        // owner or group. A group that could not be kept gets no rights.
        newRow("all kept") << true << true << 0664 << 0664;
        newRow("all kept, set-id") << true << true << 06775 << 06775;
        newRow("another group") << true << false << 0664 << 0604;
        newRow("another group, set-id") << true << false << 06775 << 04705;
        newRow("another owner") << false << true << 0664 << 0664;
        newRow("another owner, set-id") << false << true << 06775 << 0775;
        newRow("another owner and group") << false << false << 0666 << 0606;
        newRow("another owner and group, set-id") << false << false << 06777 << 0707;
    }

    void anothersFileIsNotOpenedToMore()
    {
#ifdef Q_OS_WIN
        QSKIP("Windows' rights are those of the folder");
#else
        QFETCH(bool, isOwn);
        QFETCH(bool, isOfOwnGroup);
        QFETCH(int, before);
        QFETCH(int, after);
        if (geteuid() != 0)
            QSKIP("only an administrator can make another's file");
        const uid_t self = 54321, another = 54322;
        const gid_t own = 54323, othersGroup = 54324;
        const Folder folder;
        QCOMPARE(chmod(qPrintable(folder.path(".")), 0777), 0);
        folder.write("a.json", "before");
        const QByteArray file = folder.path("a.json").toLocal8Bit();
        QCOMPARE(chown(file.constData(), isOwn ? self : another, othersGroup), 0);
        QCOMPARE(chmod(file.constData(), mode_t(before)), 0); // a change of owner would clear some

        const gid_t groupBefore = getegid();
        std::vector<gid_t> groupsBefore(std::size_t(getgroups(0, nullptr)));
        QVERIFY(getgroups(int(groupsBefore.size()), groupsBefore.data()) >= 0);
        const bool isOther =
            setgroups(isOfOwnGroup ? 1 : 0, &othersGroup) == 0 && setegid(own) == 0 && seteuid(self) == 0;
        struct stat status {};
        const bool isReached = stat(file.constData(), &status) == 0;
        const Done written = replaceFile(folder / "a.json", ""); // writing bytes takes set-id away by itself
        const bool isBack =
            seteuid(0) == 0 && setegid(groupBefore) == 0 && setgroups(groupsBefore.size(), groupsBefore.data()) == 0;
        QVERIFY(isOther && isBack);
        if (!isReached)
            QSKIP("other users cannot enter a folder on the way here");

        QCOMPARE(textOf(written), "written");
        QCOMPARE(stat(file.constData(), &status), 0);
        QCOMPARE(status.st_uid, self);
        QCOMPARE(status.st_gid, isOfOwnGroup ? othersGroup : own);
        QCOMPARE(QString::number(status.st_mode & mode_t(07777), 8), QString::number(after, 8));
#endif
    }

    void aFolderThatMayNotBeEnteredIsThere()
    {
#ifdef Q_OS_WIN
        QSKIP("Windows' rights are those of the folder");
#else
        if (geteuid() != 0)
            QSKIP("only an administrator can become another user");
        const Folder folder;
        QVERIFY(QDir(folder.path(".")).mkdir("inner"));
        QCOMPARE(chmod(qPrintable(folder.path(".")), 0700), 0);
        QCOMPARE(seteuid(54321), 0);
        const Done written = replaceFile(folder / "inner/a.json", "");
        QCOMPARE(seteuid(0), 0);
        QCOMPARE(textOf(written), "the file cannot be written (Permission denied)");
#endif
    }

    void theFileBehindALinkIsReplaced()
    {
        const Folder folder;
        QVERIFY(QDir(folder.path(".")).mkdir("folder"));
        folder.write("folder/a.json", "before");
        if (!linkTo("folder/a.json", folder / "one") || !linkTo("one", folder / "two"))
            QSKIP("no links here");
        QCOMPARE(textOf(replaceFile(folder / "two", "after")), "written");
        QCOMPARE(folder.read("folder/a.json"), "after");
        QVERIFY(QFileInfo(folder.path("one")).isSymLink() && QFileInfo(folder.path("two")).isSymLink());
        QCOMPARE(folder.names(), QStringList({"folder", "one", "two"}));
    }

    void aLinkToNowhereLeadsToANewFile()
    {
        const Folder folder;
        if (!linkTo("new.json", folder / "link") || !linkTo("none/new.json", folder / "lost"))
            QSKIP("no links here");
        QCOMPARE(textOf(replaceFile(folder / "link", "after")), "written");
        QCOMPARE(folder.read("new.json"), "after");
        QVERIFY(QFileInfo(folder.path("link")).isSymLink());
        QCOMPARE(textOf(replaceFile(folder / "lost", "after")),
                 "there is no such folder; make it or give another name");
    }

    void linksInACircle()
    {
        const Folder folder;
        if (!linkTo("b", folder / "a") || !linkTo("a", folder / "b"))
            QSKIP("no links here");
        const Done written = replaceFile(folder / "a", "after");
        QVERIFY2(textOf(written).startsWith("the file cannot be written (Too many"), qPrintable(textOf(written)));
    }

    void aFullDiskLeavesWhatWasThere()
    {
#ifdef Q_OS_WIN
        QSKIP("no limit to the size of files here");
#else
        // The system then refuses to write on, as it does where a disk is full.
        rlimit before{};
        QCOMPARE(getrlimit(RLIMIT_FSIZE, &before), 0);
        const Folder folder;
        folder.write("a.json", "before");
        const auto signalBefore = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit small{1000, before.rlim_max};
        QCOMPARE(setrlimit(RLIMIT_FSIZE, &small), 0);
        const Done written = replaceFile(folder / "a.json", std::string(2000, 'x'));
        const Done fits = replaceFile(folder / "b.json", std::string(1000, 'x'));
        QCOMPARE(setrlimit(RLIMIT_FSIZE, &before), 0);
        std::signal(SIGXFSZ, signalBefore);
        QCOMPARE(textOf(written), "the file cannot be written (File too large)");
        QCOMPARE(folder.read("a.json"), "before");
        QVERIFY(fits.hasValue());
        QCOMPARE(folder.names(), QStringList({"a.json", "b.json"}));
#endif
    }

    void whatIsNoFileIsAStream()
    {
        const Folder folder;
        folder.write("a.json", "");
        QVERIFY(!isStream(folder / "a.json"));
        QVERIFY(!isStream(folder / "none.json"));
        QVERIFY(!isStream(folder / "."));
#ifdef Q_OS_WIN
        QVERIFY(isStream("NUL"));
        QVERIFY(replaceFile("NUL", "x").error().text.starts_with("this is a device or a pipe"));
#else
        QVERIFY(isStream("/dev/null"));
        QCOMPARE(mkfifo(qPrintable(folder.path("pipe")), 0600), 0);
        QVERIFY(isStream(folder / "pipe"));
        const std::filesystem::path pipe = folder / "pipe", null = "/dev/null";
        for (const auto &name : {pipe, null})
            QVERIFY(replaceFile(name, "x").error().text.starts_with("this is a device or a pipe"));
        QVERIFY(!std::filesystem::is_regular_file(pipe) && !std::filesystem::is_regular_file(null));
#endif
    }

    void anOpenFileOfTheProgramIsAStream()
    {
#ifdef Q_OS_WIN
        QSKIP("Windows has no names for them");
#else
        const Folder folder;
        folder.write("a.json", "before");
        QFile file(folder.path("a.json"));
        QVERIFY(file.open(QIODevice::ReadWrite));
        const QString open = "/dev/fd/" + QString::number(file.handle());
        if (!QFile::exists(open))
            QSKIP("no /dev/fd here");
        QVERIFY(isStream(pathOf(open)));
        QVERIFY(isOwnDescriptor("/dev/stdout"));
        QVERIFY(replaceFile(pathOf(open), "after").error().text.starts_with("this is a device or a pipe"));
        QVERIFY(linkTo(pathOf(open), folder / "link"));
        QVERIFY(isStream(folder / "link"));
        QCOMPARE(folder.read("a.json"), "before");
        QVERIFY(!isOwnDescriptor(folder / "a.json"));
#endif
    }

    void aFileIsReplacedOnlyAsItWasKnown()
    {
        const Folder folder;
        folder.write("a.json", "one");
        const FileStamp known = stampOf(folder / "a.json");
        QVERIFY(replaceFile(folder / "a.json", "mine", known).hasValue());
        const FileStamp mine = stampOfContents("mine");

        folder.write("a.json", "his!"); // of the same length, within the same moment
        const Done late = replaceFile(folder / "a.json", "mine again", mine);
        QVERIFY(!late && late.error().kind == Error::Kind::Changed);
        QCOMPARE(folder.read("a.json"), "his!");
        QCOMPARE(folder.names(), QStringList("a.json"));

        QVERIFY(QFile::remove(folder.path("a.json")));
        QVERIFY(replaceFile(folder / "a.json", "mine", mine).error().kind == Error::Kind::Changed);
        const FileStamp none = stampOf(folder / "a.json");
        folder.write("a.json", "his");
        QVERIFY(replaceFile(folder / "a.json", "mine", none).error().kind == Error::Kind::Changed);
        QVERIFY(replaceFile(folder / "a.json", "mine").hasValue());
    }

    void stamps()
    {
        const Folder folder;
        QCOMPARE(stampOf(folder / "none"), FileStamp());
        QVERIFY(!stampOf(folder / "none").exists);
        folder.write("empty", "");
        QVERIFY(stampOf(folder / "empty") != FileStamp());
        QCOMPARE(stampOf(folder / "empty"), stampOfContents(""));
        const QByteArray large = QByteArray("0123456789").repeated(20000);
        folder.write("large", large);
        QCOMPARE(stampOf(folder / "large"), stampOfContents({large.constData(), std::size_t(large.size())}));
        folder.write("large", large.chopped(1) + '8');
        QVERIFY(stampOf(folder / "large") != stampOfContents({large.constData(), std::size_t(large.size())}));
        QVERIFY(isAsAt(FileStamp(), folder / "none"));
        QVERIFY(!isAsAt(FileStamp(), folder / "empty"));
#ifndef Q_OS_WIN
        QCOMPARE(mkfifo(qPrintable(folder.path("pipe")), 0600), 0);
        QVERIFY(stampOf(folder / "pipe").exists); // and does not wait for a writer
#endif
    }

    void theSameFile()
    {
        const Folder folder;
        QVERIFY(QDir(folder.path(".")).mkdir("folder"));
        folder.write("a.json", "same");
        folder.write("b.json", "same");
        QVERIFY(isSameFile(folder / "a.json", folder / "a.json"));
        QVERIFY(isSameFile(folder / "a.json", folder / "folder/../a.json"));
        const QString before =
            QDir::currentPath(); // on Windows it may be on another drive, from where no path leads here
        QVERIFY(QDir::setCurrent(folder.path(".")));
        QVERIFY(isSameFile(folder / "a.json", "a.json"));
        QVERIFY(QDir::setCurrent(before));
        QVERIFY(!isSameFile(folder / "a.json", folder / "b.json"));
        QVERIFY(!isSameFile(folder / "none", folder / "none"));
        QVERIFY(!isSameFile(folder / "a.json", folder / "none"));
        QVERIFY(!isSameFile(folder / "folder", folder / "folder"));
        std::error_code error;
        std::filesystem::create_hard_link(folder / "a.json", folder / "hard", error);
        QVERIFY(error || isSameFile(folder / "a.json", folder / "hard"));
        if (linkTo("a.json", folder / "link"))
            QVERIFY(isSameFile(folder / "a.json", folder / "link"));
#ifndef Q_OS_WIN
        QVERIFY(!isSameFile("/dev/null", "/dev/null"));
#endif
    }

    /// No content is half of one and half of the other.
    void writersAtOnce()
    {
        const Folder folder;
        const auto opened = [&] { return std::move(ReplacingFile::open(folder / "a.json")).value(); };
        ReplacingFile first = opened(), second = opened();
        QVERIFY(first.write("first").hasValue() && second.write("second, ").hasValue());
        QVERIFY(second.write("more").hasValue());
        QVERIFY(second.commit().hasValue());
        QCOMPARE(folder.read("a.json"), "second, more");
        QVERIFY(first.commit().hasValue());
        QCOMPARE(folder.read("a.json"), "first");
        QCOMPARE(folder.names(), QStringList("a.json"));
    }
};

UNPROJECTOR_TEST(TestFiles)
#include "test_files.moc"
