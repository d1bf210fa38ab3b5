#!/usr/bin/env python3
"""Makes the tables of docs/peers.md from features.toml; with --check, says whether they are stale.

    docs/peers/make_tables.py [--check]
"""

import argparse
import pathlib
import re
import sys
import tomllib
import urllib.parse

HERE = pathlib.Path(__file__).resolve().parent
PAGE, ROOT = HERE.parent / "peers.md", HERE.parents[1]
ANSWERS = ("yes", "part", "no", "MIT")


def read() -> dict:
    with open(HERE / "features.toml", "rb") as file:
        table = tomllib.load(file)
    for feature in table["features"]:
        refuse_unknown(feature, table["peers"])
    return table


def refuse_unknown(feature: dict, peers: dict) -> None:
    """Ends the program with one line where a feature is not as the head of the file says."""
    where = f'features.toml: "{feature["name"]}"'
    unknown = set(feature) - set(peers) - {"name", "swayaw", "why", "run", "document"}
    if unknown:
        sys.exit(f"{where}: {', '.join(sorted(unknown))} is no peer")
    if feature["swayaw"] not in ANSWERS:
        sys.exit(f"{where}: swayaw is {feature['swayaw']}, which is none of {', '.join(ANSWERS)}")
    if feature["swayaw"] in ("part", "no") and "why" not in feature:
        sys.exit(f"{where}: no word why")
    if feature["swayaw"] in ("yes", "part") and "run" not in feature:
        sys.exit(f"{where}: nothing to run")


def address(peer: dict, file: str) -> str:
    if file.startswith("https://"):
        return file
    return f"https://github.com/{peer['repository']}/blob/{peer['files'][file]}/{urllib.parse.quote(file)}"


def split(told: str) -> list:
    """Words and file."""
    return [part.strip() for part in told.split(" | ")]


def marks(peers: dict, features: list) -> dict:
    """What a link to each file of a peer is called: (peer, file) to vmm-1, vmm-2, …"""
    found = {}
    for key in peers:
        files = dict.fromkeys(split(feature[key])[1] for feature in features if key in feature)
        found.update({(key, file): f"{key}-{number}" for number, file in enumerate(files, 1)})
    return found


def cell(key: str, told: str | None, called: dict) -> str:
    if told is None:
        return "–"
    words, file = split(told)
    return f"[{words}][{called[key, file]}]"


def comparison(peers: dict, features: list) -> str:
    head = ["", "", "swayaw", *(peer["name"] for peer in peers.values())]
    lines = [f"| {' | '.join(head)} |", "| ---: | --- |" + " --- |" * (len(peers) + 1)]
    called = marks(peers, features)
    for number, feature in enumerate(features, 1):
        own = f"[{feature['swayaw']}]({feature['document']})"
        cells = [cell(key, feature.get(key), called) for key in peers]
        lines.append(f"| {' | '.join([str(number), feature['name'], own, *cells])} |")
    return "\n".join(lines)


def addresses(peers: dict, features: list) -> str:
    return "\n".join(f"[{mark}]: {address(peers[key], file)}" for (key, file), mark in marks(peers, features).items())


def sources(peers: dict, _: list) -> str:
    lines = ["| | what it is | searched |", "| --- | --- | --- |"]
    for peer in peers.values():
        name = f"[{peer['name']}](https://github.com/{peer['repository']})" if "repository" in peer else peer["name"]
        lines.append(f"| {name} | {peer['about']} | {peer['searched']} |")
    return "\n".join(lines)


def commands(_: dict, features: list) -> str:
    runs = [(i, f["run"], f["name"]) for i, f in enumerate(features, 1) if f.get("run", "").startswith("swayaw ")]
    return "\n".join(["```sh", *(f"{run}  # {number}: {name}" for number, run, name in runs), "```"])


def examples(_: dict, features: list) -> str:
    by_file = {}
    for number, feature in enumerate(features, 1):
        if not feature.get("run", "swayaw ").startswith("swayaw "):
            by_file.setdefault(feature["run"], []).append(str(number))
    lines = ["| | shows |", "| --- | --- |"]
    return "\n".join(lines + [f"| [{file}](../{file}) | {', '.join(numbers)} |" for file, numbers in by_file.items()])


def missing(_: dict, features: list) -> str:
    lines = ["| | | why |", "| ---: | --- | --- |"]
    for number, feature in enumerate(features, 1):
        if "why" in feature:
            why = f"{feature['why']} ([more]({feature['document']}))"
            lines.append(f"| {number} | {feature['name']}: {feature['swayaw']} | {why} |")
    return "\n".join(lines)


def page_with_tables(page: str, table: dict) -> str:
    for make in (comparison, commands, examples, missing, sources, addresses):
        between = re.compile(rf"(<!-- table: {make.__name__} -->\n).*?(<!-- end -->)", flags=re.S)
        text = make(table["peers"], table["features"])
        page, count = between.subn(lambda found: f"{found[1]}{text}\n{found[2]}", page)
        if count != 1:
            sys.exit(f"{PAGE}: no line <!-- table: {make.__name__} -->, or no <!-- end --> after it")
    return page


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="writes nothing; exit code 1 if a table is stale")
    check = parser.parse_args().check
    page = PAGE.read_text(encoding="utf-8")
    made = page_with_tables(page, read())
    if check and made != page:
        sys.exit("docs/peers.md: a table is stale; docs/peers/make_tables.py makes it again")
    if not check:
        PAGE.write_text(made, encoding="utf-8")


if __name__ == "__main__":
    main()
