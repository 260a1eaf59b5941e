#pragma once

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QString>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

/// A folder of scans that the tests of a series in the window, or of its images, write.
class ScanFolder {
protected:
    /// A square in the plane z = 0, from 0 to 10 along x and y.
    static inline const QByteArray kSquare = "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nf 1 2 3\nf 1 3 4\n";

    /// Begins with another, empty folder.
    void begin() { m_folder = std::make_unique<QTemporaryDir>(); }
    QString path(const QString &name) const { return m_folder->filePath(name); }
    void write(const QString &name, const QByteArray &text) const
    {
        QFile out(path(name));
        QVERIFY(out.open(QIODevice::WriteOnly));
        QCOMPARE(out.write(text), text.size());
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};
