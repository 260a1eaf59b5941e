#pragma once

#include "tests/support/patience.h"

#include <nlohmann/json.hpp>

#include <QByteArray>
#include <QProcess>
#include <QString>
#include <QStringList>

/// Helpers for tests that run the program as a script does.
namespace program_run {

using Json = nlohmann::ordered_json;

struct Run {
    int exitCode = -1;
    bool hasExited = false;
    QByteArray output, errors;
};

/// @param environment  "NAME=value"; "NAME" alone removes it @param output       a file for
/// standard output; empty: it is in the result
inline Run run(const QStringList &arguments, const QStringList &environment = {}, const QString &output = {})
{
    QProcess process;
    QProcessEnvironment variables = QProcessEnvironment::systemEnvironment();
    variables.remove(QStringLiteral("QT_SCALE_FACTOR"));
    for (const QString &variable : environment) {
        if (variable.contains(u'='))
            variables.insert(variable.section(u'=', 0, 0), variable.section(u'=', 1));
        else
            variables.remove(variable);
    }
    process.setProcessEnvironment(variables);
    if (!output.isEmpty())
        process.setStandardOutputFile(output);
    process.start(QStringLiteral(UNPROJECTOR_EXECUTABLE), arguments);
    Run result;
    const bool ended = process.waitForFinished(kPatienceMilliseconds);
    if (!ended)
        process.kill();
    result.hasExited = ended && process.exitStatus() == QProcess::NormalExit;
    result.exitCode = process.exitCode();
    result.output = process.readAllStandardOutput();
    result.errors = process.readAllStandardError();
    return result;
}

/// The program's output as text: UTF-8 on Windows, for any code page; elsewhere in the locale's
/// encoding.
inline QString textOf(const QByteArray &written)
{
#ifdef Q_OS_WIN
    return QString::fromUtf8(written);
#else
    return QString::fromLocal8Bit(written);
#endif
}

} // namespace program_run
