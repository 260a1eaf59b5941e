#pragma once

#include <QString>

#include <optional>
#include <string>

namespace unprojector::gui {

/// What the window says about one of core's examples.
struct ExampleText {
    QString name; ///< as the menu has it
    QString text; ///< what to look at, rich text; links to the formulas: href="formulas:NAME", a name in formulas.html
    QString source; ///< where it comes from
};

/// The wording of an example; nothing for an id that has none, which is a mistake of ours.
std::optional<ExampleText> exampleText(const std::string &id);

/// A tutorial as the menu names it: "OpenGL pipeline (Zhang Ci)". Empty for an unknown one.
QString tutorialName(const std::string &tutorial);

} // namespace unprojector::gui
