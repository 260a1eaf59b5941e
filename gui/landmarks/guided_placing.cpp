#include "gui/landmarks/guided_placing.h"

#include "gui/document/scene_document.h"

#include <QScopedValueRollback>

#include <algorithm>
#include <utility>
#include <vector>

namespace unprojector::gui {

using landmarks::Landmark;

GuidedPlacing::GuidedPlacing(SceneDocument &document, QObject *parent) : QObject(parent), m_document(document)
{
    const auto begin = [this] {
        m_hasNext = false;
        m_count = m_document.landmarks().size();
        m_hasWaited = std::exchange(m_isWaiting, false) && m_isOnScan;
        m_isOnScan = false;
    };
    connect(&document, &SceneDocument::opened, this, begin);
    connect(&document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & (Change::Landmarks | Change::LandmarkSelection))
            follow();
    });
    begin();
}

void GuidedPlacing::setPlacing(bool isPlacing)
{
    m_isPlacing = isPlacing;
    m_isWaiting = false; // the user has decided
}

void GuidedPlacing::continueOnScan()
{
    m_isOnScan = true;
    m_isWaiting = std::exchange(m_hasWaited, false) || m_isWaiting;
    if (m_isWaiting && m_document.sceneLandmarks().nextUnplaced())
        emit placingWanted(true);
}

void GuidedPlacing::follow()
{
    const std::vector<Landmark> &all = m_document.landmarks();
    const bool hasNext = m_document.sceneLandmarks().nextUnplaced().has_value();
    const bool hadNext = std::exchange(m_hasNext, hasNext);
    const bool isSameList = std::exchange(m_count, all.size()) == all.size();
    if (m_isPlacing && hadNext && !hasNext && isSameList) {
        emit placingWanted(false);
        m_isWaiting = true;
        const auto missing = std::count_if(all.begin(), all.end(), [](const Landmark &one) { return one.isMissing(); });
        emit noticed(missing == 0 ? tr("All %n landmarks are placed.", nullptr, static_cast<int>(all.size()))
                                  : tr("Placed: %1 of %2 landmarks. Missing on this specimen: %3.")
                                        .arg(all.size() - static_cast<std::size_t>(missing))
                                        .arg(all.size())
                                        .arg(missing));
    } else if (m_isWaiting && hasNext) {
        emit placingWanted(true);
    }
}

QString GuidedPlacing::nextText() const
{
    const std::optional<std::size_t> next = m_document.sceneLandmarks().nextUnplaced();
    return next ? u' ' + tr("Next: %1.").arg(SceneLandmarks::shownNameOf(m_document.landmarks(), *next)) : QString();
}

void GuidedPlacing::skipNext()
{
    SceneLandmarks &landmarks = m_document.sceneLandmarks();
    const std::optional<std::size_t> skipped = landmarks.nextUnplaced();
    if (!skipped) {
        emit noticed(tr("No landmark waits for its position, so there is none to skip."));
        return;
    }
    const QString name = SceneLandmarks::shownNameOf(landmarks.all(), *skipped);
    static_cast<void>(landmarks.skip(*skipped));
    if (landmarks.nextUnplaced() == skipped)
        emit noticed(tr("%1 is the only landmark that is not placed.").arg(name));
    else if (landmarks.all()[*skipped].isMissing())
        emit noticed(tr("%1 stays marked as missing.").arg(name) + nextText());
    else
        emit noticed(tr("%1 is skipped. It comes again after the others.").arg(name) + nextText());
}

void GuidedPlacing::toggleMissing()
{
    SceneLandmarks &landmarks = m_document.sceneLandmarks();
    const std::vector<std::size_t> chosen =
        landmarks.nextUnplaced() ? std::vector{*landmarks.nextUnplaced()} : landmarks.selection();
    if (chosen.empty()) {
        emit noticed(tr("Select landmarks first: their markers in the view, or their rows in the Landmarks panel."));
        return;
    }
    const bool areMissing = std::all_of(chosen.begin(), chosen.end(),
                                        [&](std::size_t index) { return landmarks.all()[index].isMissing(); });
    const QString name = SceneLandmarks::shownNameOf(landmarks.all(), chosen.front());
    const int count = static_cast<int>(chosen.size());
    static_cast<void>(landmarks.setMissing(chosen, !areMissing));
    if (m_isWaiting) // the end of placing was reported
        return;
    if (areMissing)
        emit noticed((count == 1 ? tr("%1 is not marked as missing any more.").arg(name)
                                 : tr("%n landmarks are not marked as missing any more.", nullptr, count))
                     + nextText());
    else
        emit noticed((count == 1 ? tr("%1 is marked as missing on this specimen.").arg(name)
                                 : tr("%n landmarks are marked as missing on this specimen.", nullptr, count))
                     + nextText());
}

} // namespace unprojector::gui
