#include "gui/lessons/lesson_player.h"

#include "core/lessons/set_link.h"
#include "core/lessons/step_numbers.h"
#include "gui/document/scene_document.h"
#include "gui/lessons/lesson_text.h"
#include "gui/text/error_text.h"

#include <QFile>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;

namespace {

std::optional<std::string> resource(const QString &name)
{
    QFile file(QStringLiteral(":/lessons/") + name);
    return file.open(QIODevice::ReadOnly) ? std::optional(file.readAll().toStdString()) : std::nullopt;
}

bool haveSameTransforms(const Scene &a, const Scene &b)
{
    return std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(), b.objects.end(),
                      [](const SceneObject &one, const SceneObject &other) {
                          return one.model == other.model && one.transform == other.transform
                                 && one.isHidden == other.isHidden;
                      });
}

} // namespace

LessonPlayer::LessonPlayer(SceneDocument &document, Session &session, QObject *parent)
    : QObject(parent), m_document(document), m_session(session)
{
    connect(&session, &Session::opened, this, [this](const QString &lesson) {
        if (lesson.isEmpty())
            end(); // another scene has replaced it, or the one before it is back
    });
}

void LessonPlayer::end()
{
    if (!m_lesson)
        return;
    m_lesson = nullptr;
    m_shown.reset();
    emit changed();
}

const std::vector<Lesson> &LessonPlayer::lessons()
{
    if (std::exchange(m_areRead, true))
        return m_lessons;
    //: The file of a lesson in this language, in resources/lessons; %1 is its name.
    const QString fileName = tr("%1.json");
    const auto names = lessons::parseLessonNames(resource(QStringLiteral("lessons.json")).value_or(std::string()));
    if (!names)
        emit failed(QString::fromStdString(names.error().message()));
    for (const std::string &name : names ? *names : std::vector<std::string>()) {
        const QString english = QString::fromStdString(name) + QStringLiteral(".json"),
                      own = fileName.arg(QString::fromStdString(name));
        const std::optional<std::string> texts = own == english ? std::nullopt : resource(own);
        auto lesson = lessons::parseLesson(name, resource(english).value_or(std::string()), texts);
        if (lesson)
            m_lessons.push_back(std::move(lesson).value());
        else
            emit failed(QString::fromStdString(lesson.error().message()));
    }
    return m_lessons;
}

bool LessonPlayer::start(const std::string &name)
{
    const std::vector<Lesson> &all = lessons();
    const auto found = std::find_if(all.begin(), all.end(), [&name](const Lesson &one) { return one.name == name; });
    return found != all.end() && show(*found, 0, true);
}

QString LessonPlayer::startAt(const QString &nameAndStep)
{
    const std::string name = nameAndStep.section(u':', 0, 0).toStdString();
    bool isNumber = true;
    const int step = nameAndStep.contains(u':') ? nameAndStep.section(u':', 1).toInt(&isNumber) : 1;
    QStringList names;
    for (const Lesson &lesson : lessons()) {
        const int steps = static_cast<int>(lesson.steps.size());
        if (lesson.name == name && isNumber && step >= 1 && step <= steps) {
            if (start(name) && step > 1)
                goTo(static_cast<std::size_t>(step - 1));
            return {}; // start() and goTo() report their own failures
        }
        names << QStringLiteral("%1:1-%2").arg(QString::fromStdString(lesson.name)).arg(steps);
    }
    //: %2 are all lessons with their steps: first:1-7, weng:1-16
    return tr("--lesson is %1; give a lesson, or one of its steps behind a colon: %2.")
        .arg(nameAndStep, names.join(QStringLiteral(", ")));
}

bool LessonPlayer::goTo(std::size_t index)
{
    return show(*m_lesson, index, false);
}

bool LessonPlayer::show(const Lesson &lesson, std::size_t index, bool isNew)
{
    const lessons::Step &step = lesson.steps.at(index);
    // Changes stay if the next step continues with the same scene.
    const bool goesOn = m_lesson == &lesson && this->step().scene == step.scene;
    if (!m_lesson)
        emit aboutToBegin();
    if (goesOn)
        m_session.nameStep(lessonTitle(step.title));
    else if (!open(lesson, step))
        return false;
    m_lesson = &lesson;
    m_index = index;
    if (isNew) {
        m_given.clear();
        m_tried.clear();
    }
    emit changed();
    return true;
}

bool LessonPlayer::open(const Lesson &lesson, const lessons::Step &step)
{
    auto scene = lessons::sceneOf(step);
    if (!scene) {
        emit failed(QString::fromStdString(scene.error().message()));
        return false;
    }
    if (!m_session.mayLeaveStep())
        return false;
    if (!m_session.openLesson(std::move(scene).value(), lessonTitle(step.title), QString::fromStdString(lesson.name)))
        return false;
    m_shown = m_document.scene();
    m_clicked.clear();
    return true;
}

bool LessonPlayer::leave()
{
    return m_lesson && m_session.mayLeaveStep() && m_session.comeBack();
}

bool LessonPlayer::isAsTheStep() const
{
    if (!m_shown)
        return false;
    const Scene &now = m_document.scene();
    const Result<Setup> setup = setupOf(*m_shown, m_document.setup().surface, m_document.ground().box);
    return setup && *setup == m_document.setup() && now.clipPlanes == m_shown->clipPlanes
           && haveSameTransforms(now, *m_shown);
}

bool LessonPlayer::restart()
{
    const std::string clicked = m_clicked;
    if (!m_lesson || !open(*m_lesson, step()))
        return false;
    if (!clicked.empty())
        emit clickWanted(clicked);
    return true;
}

bool LessonPlayer::hasViewOfStep() const
{
    const Surface &surface = m_document.setup().surface;
    return !step().view || *step().view == glm::ivec2(surface.widthPixels, surface.heightPixels);
}

std::optional<lessons::Asked> LessonPlayer::asked() const
{
    // The step as written, independent of changes in its scene.
    const auto numbers = lessons::LessonNumbers::of(*m_lesson, m_document.setup().surface);
    return numbers ? lessons::askedIn(*numbers, step()) : std::nullopt;
}

bool LessonPlayer::check(double given)
{
    const std::optional<lessons::Asked> question = asked();
    if (!question)
        return false;
    if (!lessons::isRight(*question, given)) {
        m_tried.insert(m_index);
        return false;
    }
    give(m_tried.contains(m_index) ? Answered::Later : Answered::AtOnce);
    return true;
}

void LessonPlayer::reveal()
{
    give(Answered::Shown);
}

void LessonPlayer::give(Answered how)
{
    m_given.emplace(m_index, how); // the first result counts
    emit revealed();
}

std::vector<lessons::CoveredPanel> LessonPlayer::coveredPanels() const
{
    std::set<std::size_t> given;
    for (const auto &[index, how] : m_given)
        given.insert(index);
    return lessons::coveredPanels(*m_lesson, m_index, given);
}

LessonPlayer::Tally LessonPlayer::tally() const
{
    Tally tally;
    for (std::size_t i = 0; i < m_lesson->steps.size(); ++i) {
        if (!m_lesson->steps[i].question)
            continue;
        ++tally.questions;
        const auto given = m_given.find(i);
        if (given == m_given.end())
            continue;
        switch (given->second) {
        case Answered::AtOnce: ++tally.atOnce; break;
        case Answered::Later: ++tally.later; break;
        case Answered::Shown: ++tally.shown; break;
        }
    }
    return tally;
}

const Lesson *LessonPlayer::following() const
{
    const auto next = static_cast<std::size_t>(m_lesson - m_lessons.data()) + 1;
    return next < m_lessons.size() ? &m_lessons[next] : nullptr;
}

std::optional<DevicePixel> LessonPlayer::pixelOf(const std::string &point) const
{
    const Surface &surface = m_document.setup().surface;
    std::map<std::string, lessons::StepPoint> points;
    if (const auto found = step().points.find(point); found != step().points.end()) {
        points.insert(*found);
        // A pixel belongs to the step's own view. Its content may be at another pixel of this view.
        if (std::holds_alternative<lessons::ClickedPixel>(found->second)) {
            const auto own = lessons::StepNumbers::of(*m_shown, lessons::surfaceOf(step(), surface), points);
            const std::vector<double> world = own ? own->at(point + ".world") : std::vector<double>();
            if (world.size() != 3)
                return std::nullopt;
            points[point] = GivenPoint{WorldPoint(world[0], world[1], world[2])};
        }
    }
    // The numbers hold for the present view.
    const auto numbers = lessons::StepNumbers::of(m_document.scene(), surface, points);
    return numbers ? numbers->pixelOf(point) : std::nullopt;
}

std::optional<DevicePixel> LessonPlayer::clickedPixel(const std::string &point)
{
    const auto pixel = pixelOf(point);
    if (pixel)
        m_clicked = point;
    return pixel;
}

bool LessonPlayer::change(const std::string &name)
{
    const auto found = step().changes.find(name);
    if (found == step().changes.end())
        return false;
    const auto refuse = [this](const QString &reason) {
        emit failed(tr("The change does not fit the current scene. Restore the step's scene first. (%1)").arg(reason));
        return false;
    };
    const auto settings = lessons::settingsWith(m_document.scene(), m_document.setup(), found->second);
    if (!settings)
        return refuse(QString::fromStdString(settings.error().message()));
    const Check done = m_document.edit({tr("Change by the Lesson")},
                                       [&](Scene &scene) { static_cast<SceneSettings &>(scene) = *settings; });
    return done ? true : refuse(errorText(done.error()));
}

} // namespace unprojector::gui
