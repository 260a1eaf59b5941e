#pragma once

#include "core/mesh_import/mesh_import.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <filesystem>
#include <list>
#include <memory>
#include <thread>
#include <vector>

namespace unprojector::gui {
using namespace mesh_import;

class ModelStore;

/// One opened file.
struct LoadedModel {
    std::filesystem::path file;
    std::shared_ptr<const Model> model;
};

/// Opens model files on a thread of its own and reports back on the thread it lives in.
class ModelLoader : public QObject {
    Q_OBJECT
public:
    /// @param store  outlives the loader; what it holds already is not read again
    explicit ModelLoader(ModelStore &store, QObject *parent = nullptr);
    ~ModelLoader() override;

    /// Starts opening the files, one after the other. A loading that is under way is cancelled.
    void load(std::vector<std::filesystem::path> files);
    /// Ends the loading at once: `cancelled` comes before this returns, nothing of it comes after.
    void cancel();
    bool isLoading() const { return m_isLoading; }

signals:
    void started();
    /// @param share  of all files, in [0, 1]
    void progressed(const QString &fileName, double share);
    /// Those files that could be opened, in the order asked for, and why the others could not.
    void finished(const std::vector<unprojector::gui::LoadedModel> &models,
                  const std::vector<unprojector::mesh_import::ImportError> &errors);
    void cancelled();

private:
    struct Job;
    void reap(bool all);

    ModelStore &m_store;
    std::list<std::shared_ptr<Job>> m_jobs; ///< the running one last; before it, cancelled ones that are ending
    bool m_isLoading = false;
};

} // namespace unprojector::gui
