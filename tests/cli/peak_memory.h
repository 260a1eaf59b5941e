#pragma once

#include <QFile>

/// The peak memory of a running process, in KiB; 0 where the system does not report it.
inline qint64 peakMemory([[maybe_unused]] qint64 process)
{
#ifdef Q_OS_LINUX
    QFile status("/proc/" + QString::number(process) + "/status");
    if (!status.open(QIODevice::ReadOnly))
        return 0;
    for (const QByteArray &line : status.readAll().split('\n')) {
        if (line.startsWith("VmHWM:"))
            return line.mid(6).simplified().split(' ').first().toLongLong();
    }
#endif
    return 0;
}
