#include "core/cli/commands/clicks_command.h"

#include "core/base/translation.h"
#include "core/cli/rows/byte_stream.h"
#include "core/geometry/error_text.h"
#include "core/unproject/object_from_world.h"

namespace unprojector::cli {
using namespace geometry;
using namespace scene_file;
using namespace unproject;
using namespace base;
namespace {

/// A click's point by one method in the requested space.
Result<glm::dvec3> pointOf(const Unprojector &unprojector, const WindowPoint &click, Method method,
                           const BatchSpace &space)
{
    const auto coordinates = [](const auto &point) {
        return point ? Result<glm::dvec3>(point->coordinates()) : Result<glm::dvec3>(point.error());
    };
    switch (space.kind) {
    case BatchSpace::Kind::Eye: return coordinates(unprojector.eyeAt(method, click));
    case BatchSpace::Kind::World: return coordinates(unprojector.worldAt(method, click));
    case BatchSpace::Kind::Object: break;
    }
    const Result<ObjectFromWorld> object = ObjectFromWorld::of(space.worldFromObject);
    return object ? coordinates(unprojector.objectAt(method, click, *object)) : Result<glm::dvec3>(object.error());
}

/// The input and result columns of a click.
std::vector<std::string> clickColumns(const PointsOptions &options)
{
    std::vector<std::string> names(kClickColumns.begin(), kClickColumns.end());
    for (std::string &name : pointColumns(options.methods))
        names.push_back(std::move(name));
    return names;
}

class ClickRows {
public:
    ClickRows(const PointsOptions &options, std::size_t count)
        : m_options(options), m_isOnly(count == 1), m_names(clickColumns(options)),
          m_writer(options.rows.format, m_names, m_text)
    {
        if (!options.rows.isHeaderless)
            m_writer.header();
    }

    /// Writes the row of a click. Prints errors on stderr.
    /// @return false if a click cannot be computed at all
    bool add(std::size_t index, const Click &click)
    {
        const std::optional<BatchSpace> space = batchSpace(m_options.rows.space, click.scene);
        if (!space)
            return false;
        const Setup setup = setupOf(click.scene);
        const Result<Unprojector> unprojector = Unprojector::of(setup);
        if (!unprojector) {
            complainOf(index, errorText(unprojector.error()));
            return false;
        }
        const DevicePoint device = deviceFromWindow(setup.surface, click.window);
        for (const double number : {device.x, device.y, click.window.z})
            m_writer.number(number);
        if (click.hit)
            write(index, *unprojector, click.window, *space);
        else
            writeBackground(index);
        m_writer.endRow();
        return true;
    }

    ExitCode finish(ByteSink &sink) const
    {
        sink.write(m_text);
        const ExitCode written = sink.finish();
        return written == ExitCode::Done && m_hasBad ? ExitCode::SomeRowsBad : written;
    }

private:
    void complainOf(std::size_t index, const std::string &what)
    {
        const std::string file = m_options.rows.scene == "-" ? "stdin" : m_options.rows.scene;
        complain(file + (m_isOnly ? "" : ": [" + std::to_string(index) + ']') + ": " + what);
    }

    void writeBackground(std::size_t index)
    {
        m_hasBad = true;
        complainOf(index, tr("background: nothing was drawn there, so the click has no point, only a ray"));
        for (std::size_t k = kClickColumns.size(); k < m_names.size(); ++k)
            m_writer.nothing();
    }

    void write(std::size_t index, const Unprojector &unprojector, const WindowPoint &click, const BatchSpace &space)
    {
        std::vector<std::optional<glm::dvec3>> points;
        for (const Method method : m_options.methods) {
            const Result<glm::dvec3> point = pointOf(unprojector, click, method, space);
            points.push_back(point ? std::optional(*point) : std::nullopt);
            if (!point) {
                m_hasBad = true;
                complainOf(index, std::string(keyOf(method)) + ": " + errorText(point.error()));
            }
        }
        writePoints(m_writer, m_options.methods, points);
    }

    const PointsOptions &m_options;
    bool m_isOnly;
    std::vector<std::string> m_names;
    std::string m_text;
    RowWriter m_writer;
    bool m_hasBad = false;
};

} // namespace

ExitCode runClicks(const PointsOptions &options, const std::vector<Click> &clicks)
{
    if (options.isPixel) {
        complain(tr("--pixel is for tables of pixels; clicks already have the centres of their pixels"));
        return ExitCode::UnusableInput;
    }
    ByteSink sink("-", filesOf(clicks, options.rows.scene));
    if (!sink.isOpen())
        return ExitCode::UnusableInput;
    ClickRows rows(options, clicks.size());
    for (std::size_t i = 0; i < clicks.size(); ++i) {
        if (!rows.add(i, clicks[i]))
            return ExitCode::UnusableInput;
    }
    return rows.finish(sink);
}

} // namespace unprojector::cli
