#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Relative links of the Markdown pages lead to files and headings, scripts and scenes that they name exist, prose is at
most 120 columns wide, quoted numbers are those of docs/benchmarks.md, and each numbered equation stands once and, where the
code cites it, is there.

A number is quoted as [6.6](docs/benchmarks.md "s_shape_perturbed smore mean"): first cells of the row, and the column.
An equation ends with its number, as in (B4), and is cited as docs/belief.md (B4).
"""
import re

from project import ROOT, code_files, files, report, say

COLUMNS = 120  # of prose: a row of a table, a picture or a command stands in one line
ANCHOR = re.compile(r"\]\((?!https?:)([^)#\s]*)#([^)\s]+)\)")
LINK = re.compile(r"\]\((?!https?:|#|mailto:)([^)#\s]+)")
NAMED = re.compile(r"\b(?:scripts|config|launch|python|docs|src|include|test|benchmark)/[\w./-]*\w")
QUOTE = re.compile(r'\[([^\]]+)\]\([^)\s]*benchmarks\.md\s+"([^"]+)"\)')
EQUATION = re.compile(r"^    .*\(([A-Z]\d+)\)$", re.MULTILINE)
CITED = re.compile(r"(docs/\w+\.md) \(([A-Z]\d+)\)")

PLACEHOLDER = re.compile(r"/[A-Z_]{2,}(\.\w+)?$")  # config/NODE.yaml: one of several


def anchors(path):
    """What links to the headings of a page end with."""
    headings = re.findall(r"^#+ (.*)$", path.read_text(), re.MULTILINE)
    return {re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-") for heading in headings}


def exists(path):
    # Headers are named without their extension where the pair is meant.
    return path.exists() or any(path.parent.glob(path.name + ".*"))


def cells(line):
    return [cell.strip().strip("*`") for cell in line.strip().strip("|").split("|")]


def numbers(text):
    """Each number of the tables of a page, by the first two cells of its row and its column."""
    found = {}
    header = None
    for line in text.splitlines():
        if not line.startswith("|"):
            header = None
        elif header is None:
            header = cells(line)
        else:
            row = cells(line)
            for column, value in zip(header[2:], row[2:]):
                found[" ".join((*row[:2], column))] = value
    return found


def wide_lines(lines):
    """Numbers and widths of the lines of prose that are too wide."""
    fenced = False
    for number, line in enumerate(lines, 1):
        if line.startswith("```"):
            fenced = not fenced
        elif len(line) > COLUMNS and not fenced and not line.startswith(("|", "![", "    ")):
            yield number, len(line)


def problems(path, benchmarks):
    text = path.read_text()
    for number, width in wide_lines(text.splitlines()):
        yield say(path, number, f"{width} columns; at most {COLUMNS}")
    for number, line in enumerate(text.splitlines(), 1):
        for target in LINK.findall(line):
            if not (path.parent / target).exists():
                yield say(path, number, f"the link {target} leads nowhere")
        for target, anchor in ANCHOR.findall(line):
            page = path.parent / target if target else path
            if page.suffix == ".md" and page.exists() and anchor not in anchors(page):
                yield say(path, number, f"{page.name} has no heading #{anchor}")
        for name in NAMED.findall(LINK.sub("", line)):
            if not PLACEHOLDER.search(name) and not exists(ROOT / name):
                yield say(path, number, f"{name} does not exist")
    for quote in QUOTE.finditer(text):  # which may go on in the next line
        quoted, key = quote.group(1), " ".join(quote.group(2).split())
        if benchmarks.get(key) != quoted.strip("*"):
            number = text.count("\n", 0, quote.start()) + 1
            yield say(path, number, f"'{key}' is {benchmarks.get(key)} in docs/benchmarks.md, not {quoted}")


def equation_problems():
    """Numbers that two equations have, and citations in the code of none."""
    pages = {}
    for page in files(("docs",), "*.md"):
        for number in EQUATION.findall(page.read_text()):
            if number in pages:
                yield say(page, 1, f"equation ({number}) stands in {pages[number]} too")
            pages[number] = str(page.relative_to(ROOT))
    for path in code_files(("include", "src")):
        for page, number in CITED.findall(path.read_text()):
            if pages.get(number) != page:
                yield say(path, 1, f"equation ({number}) does not stand in {page}")


def main():
    paths = sorted(ROOT.glob("*.md")) + files(("docs", "examples"), "*.md")
    benchmarks = numbers((ROOT / "docs/benchmarks.md").read_text())
    findings = [finding for path in paths for finding in problems(path, benchmarks)]
    report(findings + list(equation_problems()), len(paths))


if __name__ == "__main__":
    main()
