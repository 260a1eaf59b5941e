#pragma once

#include "core/mesh/import/mesh_import.h"
#include "gui/document/background.h"

#include <QObject>
#include <QString>

#include <filesystem>
#include <memory>
#include <vector>

namespace unprojector::gui {
using namespace mesh;

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

    /// Starts opening the files, one after the other. A loading that is under way is cancelled.
    void load(std::vector<std::filesystem::path> files);
    /// Ends the loading at once: `cancelled` comes before this returns, nothing of it comes after.
    void cancel();
    bool isLoading() const { return m_background.isRunning(); }

signals:
    void started();
    /// @param share  of all files, in [0, 1]
    void progressed(const QString &fileName, double share);
    /// Those files that could be opened, in the order asked for, and why the others could not.
    void finished(const std::vector<unprojector::gui::LoadedModel> &models,
                  const std::vector<unprojector::mesh::ImportError> &errors);
    /// None of the files could be opened, and why.
    void jobFailed(const unprojector::gui::JobFailure &failure);
    void cancelled();

private:
    ModelStore &m_store;
    Background m_background{2}; ///< the next need not wait for the cancelled one
};

} // namespace unprojector::gui
