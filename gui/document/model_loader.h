#pragma once

#include "core/opening/models.h"
#include "gui/document/background.h"

#include <QObject>
#include <QString>

#include <filesystem>
#include <memory>
#include <vector>

namespace unprojector::gui {
using namespace mesh;

/// One opened file.
struct LoadedModel {
    std::filesystem::path file;
    std::shared_ptr<const Model> model;
};

/// Opens model files on a thread of its own and reports back on the thread it lives in.
class ModelLoader : public QObject {
    Q_OBJECT
public:
    /// @param files  outlive the loader; a model that is in use already is not read again
    explicit ModelLoader(opening::ModelFiles &files, QObject *parent = nullptr);

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
    opening::ModelFiles &m_files;
    Background m_background{2}; ///< the next need not wait for the cancelled one
};

} // namespace unprojector::gui
