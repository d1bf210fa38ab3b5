#!/usr/bin/python3
"""Pages of the manual from the program's own --help: swayaw.1, and swayaw-COMMAND.1 for each command.

    packaging/make_man.py build/release/app/swayaw man/ --date 2026-01-31
"""

import argparse
import gzip
import pathlib
import re
import subprocess

#: column at which descriptions stand, from the name of the option on
DESCRIPTION = 28

EXIT_STATUS = [
    ".SH EXIT STATUS",
    *(line for code, meaning in ((0, "done"), (1, "the data or the question is bad; one line on standard error says where"),
                                 (2, "wrong usage")) for line in (".TP", f"{code}", meaning)),
]


def help_of(program, *command):
    return subprocess.run([program, *command, "--help"], check=True, capture_output=True, text=True).stdout


def roff(text: str) -> str:
    """Text as roff takes it for what it says."""
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq").replace("`", "\\(ga")
    return "\\&" + text if text.startswith((".", "\\(aq")) else text


def bold_options(text: str) -> str:
    return re.sub(r"(?<![\w-])(--?[a-z][\w-]*)", lambda found: f"\\fB{roff(found[1])}\\fR", roff(text).replace("\\-", "-"))


def columns(line: str) -> list:
    """Heading and description, which is empty when it begins on the next line."""
    heading, _, words = line.partition("  ")
    left, right = line[:DESCRIPTION - 1], line[DESCRIPTION:]
    if not words and line[DESCRIPTION - 1:DESCRIPTION] == " " and left.count("[") == left.count("]") \
            and not re.match(r"Needs:|Excludes:|REQUIRED", right):
        heading, words = left, right
    return [heading.strip(), words.strip()]


def entries(lines: list) -> list:
    """Options or arguments as (heading, description), from the two columns in which --help prints them."""
    found = []
    base = min(len(line) - len(line.lstrip()) for line in lines)
    for line in lines:
        indent = len(line) - len(line.lstrip())
        if indent == base:
            found.append(columns(line[base:]))
        elif found[-1][1] or indent >= base + DESCRIPTION - 2:
            found[-1][1] = f"{found[-1][1]} {line.strip()}".strip()
        else:  # the heading goes on
            found[-1][0] += " " + line.strip()
    return found


def listed(lines: list) -> list:
    return [line for heading, words in entries(lines) for line in (".TP", bold_options(heading), roff(words))]


def paragraphs(text: str) -> dict:
    """The help by its parts: introduction, usage, and what stands below a title."""
    parts, title = {"": []}, ""
    for line in text.splitlines():
        if line.startswith("Usage:"):
            parts["usage"] = [line.removeprefix("Usage:").strip()]
            title = "usage"
        elif re.match(r"(Positionals|Options|Subcommands):$|\[Option Group: |For example$", line):
            title = line.rstrip(":")
            parts[title] = []
        elif line.strip():
            parts[title].append(line)
    return parts


def group(title: str, lines: list) -> list:
    """One of several options that go together, such as the manoeuvres of simulate."""
    rule = next((line.strip(" []") for line in lines if line.strip().startswith("[")), "")
    options = lines[[line.strip() for line in lines].index("Options:") + 1:]
    return [f".SS {roff(title[0].upper() + title[1:])}", roff(rule) + "."] + listed(options)


def page(name: str, text: str, head: str) -> list:
    parts = paragraphs(text)
    about = " ".join(line.strip() for line in parts.pop(""))
    usage = " ".join(parts.pop("usage")).removeprefix("swayaw").strip()
    command = name.replace("swayaw-", "swayaw ", 1)
    made = [head, ".SH NAME", f"{roff(name)} \\- {roff(about.rstrip('.'))}", ".SH SYNOPSIS",
            f"\\fB{roff(command)}\\fR " + roff(usage.removeprefix(command.removeprefix("swayaw").strip()).strip())]
    for title, lines in parts.items():
        if title == "Positionals":
            made += [".SH ARGUMENTS"] + listed(lines)
        elif title == "Options":
            made += [".SH OPTIONS"] + listed(lines)
        elif title == "Subcommands":
            made += [".SH COMMANDS", "Each has a page of its own."]
            for command_name, words in entries(lines):
                made += [".TP", f".BR {roff('swayaw-' + command_name)} (1)", roff(words)]
        elif title == "For example":
            made += [".SH EXAMPLES", ".EX"] + [roff(line[2:]) for line in lines] + [".EE"]
        else:
            made += group(re.match(r"\[Option Group: (.*)\]", title)[1], lines)
    return made


def write(given, name: str, lines: list):
    # roff wants no line of text to be empty
    text = "\n".join(line for line in lines if line) + "\n"
    (given.folder / f"{name}.1").write_text(text, encoding="utf-8")
    if given.compress:
        (given.folder / f"{name}.1.gz").write_bytes(gzip.compress(text.encode(), 9, mtime=0))


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("program")
    arguments.add_argument("folder", type=pathlib.Path)
    arguments.add_argument("--date", required=True, help="of the release, YYYY-MM-DD")
    arguments.add_argument("--compress", action="store_true", help="also as .1.gz, as packages have them")
    given = arguments.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    version = subprocess.run([given.program, "--version"], check=True, capture_output=True, text=True).stdout.strip()

    def head(name):
        return f'.TH {roff(name.upper())} 1 "{given.date}" "{version}" "Ship steering dynamics"'

    text = help_of(given.program)
    commands = [name for name, _ in entries(paragraphs(text)["Subcommands"])]
    ships = [".SH FILES", ".TP", "/usr/share/swayaw/ships", "files of the published ships, to be copied and changed"]
    write(given, "swayaw", page("swayaw", text, head("swayaw")) + ships + EXIT_STATUS)
    for command in commands:
        name = f"swayaw-{command}"
        see = [".SH SEE ALSO", ".BR swayaw (1)"]
        write(given, name, page(name, help_of(given.program, command), head(name)) + EXIT_STATUS + see)


if __name__ == "__main__":
    main()
