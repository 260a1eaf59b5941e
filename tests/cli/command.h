#pragma once

#include "tests/support/patience.h"

#include <QFile>
#include <QFileInfo>
#include <QList>
#include <QMap>
#include <QProcess>
#include <QProcessEnvironment>
#include <QStringList>
#include <QTemporaryDir>
#include <QTest>

/// The results of a run of the command.
struct Run {
    int exitCode = -1;
    QByteArray output, errors;

    /// The lines written, the last line end left out.
    QList<QByteArray> lines() const
    {
        QByteArray text = output;
        if (text.endsWith('\n'))
            text.chop(1);
        return text.split('\n');
    }
};

using Variables = QMap<QString, QString>;

/// The command's path with its drive: on Windows, a test may move to a folder on another one.
inline const QString kCommand = QFileInfo(QStringLiteral(UNPROJECT_COMMAND)).absoluteFilePath();

/// @param variables  environment variables; without them the command speaks English
inline Run runCommand(const QStringList &arguments, const QByteArray &input = {},
                      const Variables &variables = {{"LC_ALL", "C"}})
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(QStringLiteral("LANGUAGE"));
    environment.remove(QStringLiteral("COLUMNS")); // lines of help would be as long
    for (auto it = variables.begin(); it != variables.end(); ++it)
        environment.insert(it.key(), it.value());
    process.setProcessEnvironment(environment);
    process.start(kCommand, arguments);
    if (!process.waitForStarted(kPatienceMilliseconds))
        qFatal("the command does not start: %s", qPrintable(process.errorString()));
    process.write(input);
    process.closeWriteChannel();
    if (!process.waitForFinished(2 * kPatienceMilliseconds)) // it may have sanitizers
        qFatal("the command does not end");
    QByteArray errors = process.readAllStandardError();
    errors.replace("\r\n", "\n"); // stderr is a text on Windows
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1, process.readAllStandardOutput(),
            errors};
}

/// Verifies that a run succeeded without a message.
#define VERIFY_SUCCEEDED(run)                                                                                          \
    do {                                                                                                               \
        QCOMPARE((run).errors, QByteArray());                                                                          \
        QCOMPARE((run).exitCode, 0);                                                                                   \
    } while (false)

/// A folder of files that a test makes.
class Folder {
public:
    QString write(const QString &name, const QByteArray &text) const
    {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("no room for %s", qPrintable(name));
        return file.fileName();
    }
    QString path(const QString &name) const { return m_folder.filePath(name); }

private:
    QTemporaryDir m_folder;
};

/// 800 x 600; the eye at (0, 0, 5) looks down -z. The window is [-1, 1] x [-3/4, 3/4] at 1, far 4:
/// the depth 2/3 is the distance 2.
inline const QByteArray kFrustumScene = R"({
  "unprojector": 1,
  "window": {"width": 800, "height": 600},
  "projection": {"type": "frustum", "left": -1, "right": 1, "bottom": -0.75, "top": 0.75, "near": 1, "far": 4},
  "view": {"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]},
  "objects": [{"name": "face", "file": "face.obj", "transform": [{"translate": [0, 0, 3]}, {"scale": [2, 2, 2]}]}]
})";
