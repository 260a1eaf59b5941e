# Writes the manual pages and the completions of the shells from the programs' own help, so that all
# of them name the same commands and options.
#   cmake -DUNPROJECT=program [-DUNPROJECTOR=program] -DVERSION=… -DOUT=folder -P manual.cmake
cmake_minimum_required(VERSION 3.22)

# A program's output for the given words. OUT: help
function(ask program)
    set(ENV{LC_ALL} C.UTF-8)
    unset(ENV{LANGUAGE})
    execute_process(COMMAND "${program}" ${ARGN} --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
    set(help "${help}" PARENT_SCOPE)
endfunction()

# The text for a manual page: no escapes, no commands, and minus signs that can be copied.
function(roff text out)
    string(REPLACE "\\" "\\e" text "${text}")
    string(REPLACE "-" "\\-" text "${text}")
    string(REGEX REPLACE "^([.'])" "\\\\&\\1" text "${text}")
    set(${out} "${text}" PARENT_SCOPE)
endfunction()

# A word in single quotes, for each shell; colons and brackets mean something to zsh.
function(quoted text out)
    string(REPLACE "'" "’" text "${text}")
    set(${out} "${text}" PARENT_SCOPE)
    string(REPLACE ":" "\\:" text "${text}")
    string(REPLACE "[" "(" text "${text}")
    string(REPLACE "]" ")" text "${text}")
    set(${out}_zsh "${text}" PARENT_SCOPE)
endfunction()

# One option or positional is complete: into the page and the completions.
function(flush_entry)
    if(entry_head STREQUAL "")
        return()
    endif()
    if(entry_text STREQUAL "")
        message(FATAL_ERROR "Nothing is said of ${entry_head}: the help's columns are not where they are looked for")
    endif()
    string(REGEX MATCH "^(-[^ ,<]+(, ?-[^ ,<]+)*|[^ ]+) *(.*)$" matched "${entry_head}")
    set(names "${CMAKE_MATCH_1}")
    set(rest "${CMAKE_MATCH_3}")
    roff("${names}" names_roff)
    roff("${rest}" rest_roff)
    roff("${entry_text}" text_roff)
    string(APPEND page ".TP\n\\fB${names_roff}\\fR ${rest_roff}\n${text_roff}\n")
    if(names MATCHES "^-")
        # The value after it: nothing, words, or typed text, mostly a file
        set(choices "")
        set(value "")
        if(NOT rest MATCHES "^(Needs|Excludes|REQUIRED)" AND rest MATCHES "^<?([A-Za-z|.,]+)(=|>| |$)")
            set(value "${CMAKE_MATCH_1}")
            if(value MATCHES "[|]")
                string(TOLOWER "${value}" choices)
                string(REPLACE "|" " " choices "${choices}")
            elseif(value MATCHES "^(WORD|PLACE)$" AND entry_text MATCHES ": ([a-z0-9][^ ,]*(, +[a-zA-Z0-9.-]*[a-zA-Z0-9])+)([.] .*)?$")
                string(REGEX REPLACE ",? +" " " choices "${CMAKE_MATCH_1}")
            endif()
        endif()
        string(REGEX REPLACE "(: [a-z0-9-]+, [^:]*$|[.] .*|[.]$)" "" short "${entry_text}")
        quoted("${short}" short)
        string(REGEX REPLACE ", *" ";" each "${names}")
        set(fish_names "")
        foreach(name IN LISTS each)
            string(APPEND bash_options " ${name}")
            if(NOT value STREQUAL "")
                if(NOT choices STREQUAL "")
                    string(APPEND bash_values "    ${command},${name}) words='${choices}' ;;\n")
                    string(APPEND zsh_specs " \\\n        '${name}[${short_zsh}]:${value}:(${choices})'")
                else()
                    set(files " ")
                    set(in_bash return) # files, unless COMPREPLY has entries
                    if(value STREQUAL "FOLDER")
                        set(files "_files -/")
                        string(CONCAT in_bash "mapfile -t COMPREPLY < <(compgen -d -- \"$current\")\n"
                               "        compopt -o filenames +o default 2>/dev/null\n        return")
                    elseif(value MATCHES "^(FILE|MODEL|TEXT|OUT.png)$")
                        set(files "_files")
                    endif()
                    string(APPEND bash_values "    ${command},${name}) ${in_bash} ;;\n")
                    string(APPEND zsh_specs " \\\n        '${name}[${short_zsh}]:${value}:${files}'")
                endif()
            else()
                string(APPEND zsh_specs " \\\n        '${name}[${short_zsh}]'")
            endif()
            string(REGEX REPLACE "^--" "-l " fish_name "${name}")
            string(REGEX REPLACE "^-([a-z])$" "-s \\1" fish_name "${fish_name}")
            string(APPEND fish_names " ${fish_name}")
        endforeach()
        if(NOT choices STREQUAL "")
            string(APPEND fish_names " -x -a '${choices}'")
        elseif(value STREQUAL "FOLDER")
            string(APPEND fish_names " -x -a '(__fish_complete_directories)'")
        elseif(NOT value STREQUAL "")
            string(APPEND fish_names " -r")
        endif()
        string(APPEND fish_lines "complete -c ${program}${fish_when}${fish_names} -d '${short}'\n")
    elseif(names MATCHES "^[a-z]+$")
        quoted("${entry_text}" short)
        string(APPEND commands " ${names}")
        string(APPEND zsh_commands " \\\n        '${names}:${short_zsh}'")
        string(APPEND fish_lines "complete -c ${program} -n __fish_use_subcommand -f -a ${names} -d '${short}'\n")
    endif()
    foreach(variable page bash_options bash_values zsh_specs fish_lines commands zsh_commands)
        set(${variable} "${${variable}}" PARENT_SCOPE)
    endforeach()
endfunction()

# Reads one help text, whose descriptions begin in a column: appends to page and to the data of the
# completions. The caller gets the first lines, up to the program's usage line: usage.
macro(read_help column)
    set(entry_head "")
    set(entry_text "")
    set(part start)
    set(isVerbatim FALSE)
    set(rest_of_help "${help}")
    while(NOT rest_of_help STREQUAL "")
        string(FIND "${rest_of_help}" "\n" at)
        string(SUBSTRING "${rest_of_help}" 0 ${at} line)
        math(EXPR at "${at} + 1")
        string(SUBSTRING "${rest_of_help}" ${at} -1 rest_of_help)
        string(LENGTH "${line}" length)
        if(line MATCHES "^Usage: [^ ]+ ?(.*)$")
            roff("${CMAKE_MATCH_1}" usage)
        elseif(part STREQUAL "start" AND NOT line MATCHES "^[A-Z][a-z]+:$")
            if(NOT line STREQUAL "")
                roff("${line}" text_roff)
                string(APPEND page "${text_roff}\n")
            endif()
        elseif(line MATCHES "^(Positionals|Options|Subcommands|Arguments):$")
            if(part STREQUAL "start")
                string(APPEND page ".PP\n${usage_line}\n")
            endif()
            set(part entries)
            flush_entry()
            set(entry_head "")
        elseif(part STREQUAL "entries" AND line MATCHES "^  [^ ]")
            flush_entry()
            set(entry_head "${line}")
            set(entry_text "")
            if(length GREATER ${column})
                math(EXPR before "${column} - 2")
                string(SUBSTRING "${line}" ${before} 2 gap)
                if(gap STREQUAL "  ")
                    string(SUBSTRING "${line}" 0 ${column} entry_head)
                    string(SUBSTRING "${line}" ${column} -1 entry_text)
                endif()
            endif()
            string(STRIP "${entry_head}" entry_head)
        elseif(part STREQUAL "entries" AND line MATCHES "^   ")
            string(STRIP "${line}" line)
            string(APPEND entry_text " ${line}")
            string(STRIP "${entry_text}" entry_text)
        elseif(line STREQUAL "")
            flush_entry()
            set(entry_head "")
            if(isVerbatim)
                string(APPEND page ".fi\n")
                set(isVerbatim FALSE)
            endif()
            if(NOT part STREQUAL "entries" AND NOT rest_of_help STREQUAL "")
                string(APPEND page ".PP\n")
            endif()
        else()
            if(part STREQUAL "entries")
                string(APPEND page ".PP\n")
            endif()
            set(part prose)
            if(NOT isVerbatim AND line MATCHES "^ *([a-z][a-z, .-]*[a-z])  +([^ ].*)$")
                roff("${CMAKE_MATCH_1}" names_roff)
                roff("${CMAKE_MATCH_2}" text_roff)
                string(APPEND page ".TP\n${names_roff}\n${text_roff}\n")
            else()
                roff("${line}" text_roff)
                string(APPEND page "${text_roff}\n")
                if(line MATCHES "^Examples?:$")
                    string(APPEND page ".PP\n.nf\n")
                    set(isVerbatim TRUE)
                endif()
            endif()
        endif()
    endwhile()
    flush_entry()
    if(isVerbatim)
        string(APPEND page ".fi\n")
    endif()
endmacro()

macro(begin name)
    set(program ${name})
    set(command "")
    foreach(variable commands zsh_commands zsh_specs bash_options bash_values fish_lines fish_when)
        set(${variable} "")
    endforeach()
endmacro()

# --- unproject
begin(unproject)
set(page ".TH UNPROJECT 1 \"\" \"Unprojector ${VERSION}\"
.SH NAME
unproject \\- the world coordinates under pixels, computed twice
.SH SYNOPSIS
.B unproject
COMMAND [OPTIONS] \\&...
.SH DESCRIPTION
")
set(usage_line "")
ask("${UNPROJECT}")
set(fish_when " -n __fish_use_subcommand")
read_help(30)
string(APPEND page ".SH COMMANDS\n")
set(bash_first "${bash_options}")
set(zsh_first "${zsh_specs}")
set(bash_cases "")
set(zsh_cases "")
string(STRIP "${commands}" names)
string(REPLACE " " ";" names "${names}")
foreach(command IN LISTS names)
    set(bash_options "")
    set(zsh_specs "")
    set(fish_when " -n '__fish_seen_subcommand_from ${command}'")
    string(APPEND page ".SS unproject ${command}\n")
    ask("${UNPROJECT}" ${command})
    string(REGEX MATCH "\nUsage: unproject [a-z]+ ([^\n]*)" matched "${help}")
    roff("${CMAKE_MATCH_1}" usage_line)
    string(PREPEND usage_line "\\fBunproject ${command}\\fR ")
    read_help(30)
    string(APPEND bash_cases "            ${command}) words='${bash_options}' ;;\n")
    string(APPEND zsh_cases "    ${command})\n        _arguments${zsh_specs} \\\n        '*:file:_files'\n        ;;\n")
endforeach()
string(APPEND page ".SH EXIT STATUS
.TP
0
All is done.
.TP
1
Some rows or files were bad: they are empty or left out, and standard error names them.
.TP
2
The input cannot be used at all, or the output not be written; standard error says why.
.SH SEE ALSO
.BR unprojector (1)
")
file(WRITE "${OUT}/unproject.1" "${page}")
file(WRITE "${OUT}/unproject.bash" "# bash completion of unproject
_unproject() {
    local current=\${COMP_WORDS[COMP_CWORD]} command=\${COMP_WORDS[1]} words=
    COMPREPLY=()
    # What an option is followed by; files where it is nothing of this
    case $command,\${COMP_WORDS[COMP_CWORD - 1]} in
${bash_values}    esac
    if [ -z \"$words\" ]; then
        case $COMP_CWORD,$current in
        1,*) words='${commands}${bash_first}' ;;
        *,-*)
            case $command in
${bash_cases}            esac
            ;;
        esac
    fi
    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")
}
complete -o default -F _unproject unproject
")
file(WRITE "${OUT}/unproject.zsh" "#compdef unproject
local -a commands
if (( CURRENT == 2 )); then
    commands=(${zsh_commands}
    )
    _describe command commands
    _arguments${zsh_first}
    return
fi
local command=$words[2]
shift words
(( CURRENT-- ))
case $command in
${zsh_cases}esac
")
file(WRITE "${OUT}/unproject.fish" "# fish completion of unproject\n${fish_lines}")

# --- unprojector
if(NOT UNPROJECTOR)
    return()
endif()
begin(unprojector)
set(page ".TH UNPROJECTOR 1 \"\" \"Unprojector ${VERSION}\"
.SH NAME
unprojector \\- click a pixel of a 3\\-D view and read its world coordinate
.SH SYNOPSIS
.B unprojector
[OPTIONS] [SCENE | MODEL \\&...]
.SH DESCRIPTION
")
ask("${UNPROJECTOR}")
string(REGEX MATCH "\n(  -h, --help +)" matched "${help}")
string(LENGTH "${CMAKE_MATCH_1}" column)
set(usage_line "")
read_help(${column})
string(APPEND page ".SH EXIT STATUS
.TP
0
The window was closed, the picture saved, or what was asked for said.
.TP
2
A word, a file, the display or OpenGL will not do; standard error says why.
.SH EXAMPLES
.PP
.nf
  unprojector scan.ply
  unprojector scan.ply points.pp
  unprojector \\-\\-place doctor scene.json
  unprojector \\-\\-screenshot picture.png \\-\\-view\\-size 600x500 \\-\\-click 300,250 scene.json > clicks.json
.fi
.SH SEE ALSO\n.BR unproject (1)\n")
file(WRITE "${OUT}/unprojector.1" "${page}")
file(WRITE "${OUT}/unprojector.bash" "# bash completion of unprojector
_unprojector() {
    local current=\${COMP_WORDS[COMP_CWORD]} words=
    COMPREPLY=()
    case ,\${COMP_WORDS[COMP_CWORD - 1]} in
${bash_values}    esac
    [ -n \"$words\" ] || case $current in
    -*) words='${bash_options}' ;;
    esac
    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")
}
complete -o default -F _unprojector unprojector
")
file(WRITE "${OUT}/unprojector.zsh" "#compdef unprojector
_arguments${zsh_specs} \\
        '*:file:_files'
")
file(WRITE "${OUT}/unprojector.fish" "# fish completion of unprojector\n${fish_lines}")
