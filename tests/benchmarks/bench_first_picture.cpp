// The time and memory from the start of the program to a whole picture of a model in a file, next
// to F3D in the same run, and their ratios. The two take turns, so that other load of the machine
// falls on both.
//
//   make_models models 913 && bench_first_picture models/*
//   bench_first_picture --rounds 3 --plain models/sphere913.stl
//
// --plain: the view alone, without panels: F3D's picture

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>
#include <QStringList>
#include <QTemporaryDir>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <vector>

namespace {

/// The cost of one run of a program.
struct Cost {
    double seconds = 0.0;
    double mebibytes = 0.0; ///< at most; 0 where the system does not tell
};

/// The peak memory of a process so far; 0 where the system does not report it.
double peakMebibytes(qint64 process)
{
    QFile status(QStringLiteral("/proc/%1/status").arg(process));
    if (!status.open(QIODevice::ReadOnly))
        return 0.0;
    for (const QByteArray &line : status.readAll().split('\n')) {
        if (line.startsWith("VmHWM:"))
            return line.mid(6).simplified().split(' ').front().toDouble() / 1024.0;
    }
    return 0.0;
}

/// @return nothing, and a word on stderr, when the program fails or leaves no picture
std::optional<Cost> run(const QString &program, const QStringList &arguments, const QString &picture)
{
    QFile::remove(picture);
    QElapsedTimer clock;
    clock.start();
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(program, arguments, QIODevice::ReadOnly);
    if (!process.waitForStarted())
        return std::nullopt;
    Cost cost;
    while (!process.waitForFinished(2))
        cost.mebibytes = std::max(cost.mebibytes, peakMebibytes(process.processId()));
    cost.seconds = static_cast<double>(clock.nsecsElapsed()) * 1e-9;
    if (process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0 && QFileInfo(picture).size() > 0)
        return cost;
    std::fprintf(stderr, "%s %s\n%s\n", qPrintable(program), qPrintable(arguments.join(u' ')),
                 process.readAll().constData());
    return std::nullopt;
}

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2.0;
}

Cost medianOf(const std::vector<Cost> &costs)
{
    std::vector<double> seconds, mebibytes;
    for (const Cost &cost : costs) {
        seconds.push_back(cost.seconds);
        mebibytes.push_back(cost.mebibytes);
    }
    return {median(seconds), median(mebibytes)};
}

} // namespace

int main(int argc, char **argv)
{
    const QCoreApplication application(argc, argv);
    QStringList files = QCoreApplication::arguments().mid(1);
    int rounds = 5;
    if (const qsizetype at = files.indexOf(QStringLiteral("--rounds")); at >= 0 && at + 1 < files.size()) {
        rounds = std::max(1, files[at + 1].toInt());
        files.remove(at, 2);
    }
    const bool isPlain = files.removeAll(QStringLiteral("--plain")) > 0;
    const QString f3d = QStandardPaths::findExecutable(QStringLiteral("f3d"));
    if (files.isEmpty() || f3d.isEmpty()) {
        std::fputs(files.isEmpty() ? "Usage: bench_first_picture [--rounds N] [--plain] MODEL …\n"
                                   : "There is no f3d to compare with; Debian's package is f3d.\n",
                   stderr);
        return 2;
    }

    const QTemporaryDir folder;
    const QString ours = folder.filePath(QStringLiteral("ours.png"));
    const QString theirs = folder.filePath(QStringLiteral("f3d.png"));
    std::printf("%-20s %9s %9s %7s %9s %9s %7s\n", "file", "F3D s", "ours s", "ratio", "F3D MiB", "ours MiB", "ratio");
    bool isComplete = true;
    for (const QString &file : std::as_const(files)) {
        // The view is as large as F3D's picture, for any size of the panels.
        QStringList arguments{QStringLiteral("--screenshot"), ours, QStringLiteral("--view-size"),
                              QStringLiteral("720x640"), file};
        if (isPlain)
            arguments << QStringLiteral("--no-panels");
        std::vector<Cost> our, their;
        // The first round of each only warms the file's pages and the programs' own.
        for (int round = 0; round <= rounds; ++round) {
            const auto peer =
                run(f3d, {QStringLiteral("--output=") + theirs, QStringLiteral("--resolution=720,640"), file}, theirs);
            const auto own = run(QStringLiteral(UNPROJECTOR_PROGRAM), arguments, ours);
            if (!peer || !own) {
                our.clear();
                break;
            }
            if (round > 0) {
                their.push_back(*peer);
                our.push_back(*own);
            }
        }
        if (our.empty()) {
            isComplete = false;
            continue;
        }
        const Cost f = medianOf(their), u = medianOf(our);
        std::printf("%-20s %9.2f %9.2f %7.2f %9.0f %9.0f %7.2f\n", qPrintable(QFileInfo(file).fileName()), f.seconds,
                    u.seconds, u.seconds / f.seconds, f.mebibytes, u.mebibytes, u.mebibytes / f.mebibytes);
        std::fflush(stdout);
    }
    return isComplete ? 0 : 1;
}
