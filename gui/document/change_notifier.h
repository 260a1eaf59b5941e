#pragma once

#include "gui/document/document_change.h"

#include <QObject>

namespace unprojector::gui {

/// Reports the changes of a document, once for all changes that were made together.
class ChangeNotifier : public QObject {
    Q_OBJECT
public:
    /// Holds reports back while it lives. The last batch that ends reports everything at once, so
    /// that no receiver sees a half-made change.
    class Batch {
    public:
        explicit Batch(ChangeNotifier &notifier);
        ~Batch();
        Batch(const Batch &) = delete;
        Batch &operator=(const Batch &) = delete;

    private:
        ChangeNotifier &m_notifier;
    };

    /// Reports these changes and the deferred ones: at the end of the batch, or at once without a
    /// batch.
    void notify(Changes changes);
    /// Reports changes together with the next ones.
    void defer(Changes changes) { m_pending |= changes; }

signals:
    /// Emitted just before `changed`. Changes that its receivers add are part of `changed`.
    void changing(unprojector::gui::Changes changes);
    void changed(unprojector::gui::Changes changes);

private:
    Changes m_pending;
    int m_batches = 0;
};

} // namespace unprojector::gui
