#pragma once

#include "gui/pipeline/pipeline_model.h"

#include <QWidget>

#include <optional>

namespace unprojector::gui {

class HelpLink;
class SceneDocument;
class SteadyLabel;
struct EntryDerivation;

/// The derivation of the chosen coordinate, with a link to the help. It marks the input numbers in
/// the model.
class DerivationLine : public QWidget {
    Q_OBJECT
public:
    DerivationLine(const SceneDocument &document, PipelineModel &model, QWidget *parent = nullptr);

    /// @param coordinate  of the space, as shown: 0 for x, 3 for w
    void choose(PointModel::Space space, int coordinate);
    /// Clears the choice.
    void clear();
    struct Entry {
        PointModel::Space space;
        int coordinate; ///< as shown: 0 for x, 3 for w
        friend bool operator==(const Entry &, const Entry &) = default;
    };
    const std::optional<Entry> &chosen() const { return m_chosen; }
    /// The space of the chosen coordinate.
    std::optional<PointModel::Space> chosenSpace() const;
    void refresh();
    /// Refreshes, and forgets the room that earlier texts needed.
    void startOver();

private:
    QString helpOf(const EntryDerivation &derivation) const;

    const SceneDocument &m_document;
    PipelineModel &m_model;
    SteadyLabel *m_label;
    HelpLink *m_help;
    std::optional<Entry> m_chosen;
};

} // namespace unprojector::gui
