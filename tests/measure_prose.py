#!/usr/bin/env python3
"""Measures how the project's prose reads: words a sentence in comments of headers and in pages of docs.

  tests/measure_prose.py               prints mean, 90th percentile and count of each kind of text
  tests/measure_prose.py --long 28     lists the sentences of more words
  tests/measure_prose.py --check       fails where a bound is exceeded (comments of headers and docs/guide: mean 17
                                       words, 90th percentile 28)
"""

import argparse
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
MAX_MEAN, MAX_90TH = 17.0, 28


def comments(path):
    """Yields (line, text) for each run of whole-line or trailing documentation comments of a header."""
    run, start = [], 0
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        whole = re.match(r"\s*//[/!]?\s?(.*)$", line)
        trailing = re.search(r"\S.*?///?<?\s(.*)$", line)
        if whole:
            start = start or number
            run.append(whole.group(1))
            continue
        if run:
            yield start, "\n".join(run)
            run, start = [], 0
        if trailing and '"' not in line.split("//")[0]:
            yield number, trailing.group(1)
    if run:
        yield start, "\n".join(run)


def paragraphs(path):
    """Yields (line, text) for each paragraph and list item of a Markdown page, without code, tables and headings."""
    run, start, in_code = [], 0, False
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines() + [""], 1):
        if line.lstrip().startswith("```"):
            in_code = not in_code
        ends = in_code or not line.strip() or re.match(r"\s*(```|#|\||<|!\[)", line)
        item = re.match(r"\s*([-*]|\d+\.)\s+(.*)$", line)
        if (ends or item) and run:
            yield start, " ".join(run)
            run, start = [], 0
        if not ends:
            start = start or number
            run.append(item.group(2) if item else line.strip())


def sentences(text):
    """Splits text into sentences and counts their words; code in back quotes is one word."""
    text = re.sub(r"^\s*(Shape|Ensures|Requires|Errors?|Cost|Source|Returns)\s{2,}", ". ", text, flags=re.M)
    text = re.sub(r"`[^`]*`", "code", text.replace("\n", " "))
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    for part in re.split(r"(?<=[.!?])\s+(?=[A-Z0-9`(\"])", text):
        words = [w for w in part.split() if re.search(r"[A-Za-z0-9]", w)]
        if words:
            yield part, len(words)


def measure(kind, sources):
    lengths = [(count, f"{path.relative_to(ROOT)}:{line}", part)
               for path, line, text in sources for part, count in sentences(text)]
    counts = sorted(count for count, _, _ in lengths)
    if not counts:
        return None
    mean = sum(counts) / len(counts)
    ninetieth = counts[int(0.9 * (len(counts) - 1))]
    print(f"{kind:22} {len(counts):6} sentences, mean {mean:5.1f}, 90th percentile {ninetieth:3}, longest {counts[-1]}")
    return mean, ninetieth, lengths


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--long", type=int, metavar="WORDS")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--only", default="", help="only paths that contain this")
    arguments = parser.parse_args()
    headers = [p for room in ("lib", "cli", "postproc", "toolmodels") for p in sorted((ROOT / room).rglob("*.h"))]
    pages = sorted((ROOT / "docs").rglob("*.md")) + [ROOT / "README.md"]
    kinds = [("headers", [(p, n, t) for p in headers if arguments.only in str(p) for n, t in comments(p)])]
    folders = sorted({p.parent for p in pages})
    for folder in folders:
        chosen = [(p, n, t) for p in pages if p.parent == folder and arguments.only in str(p) for n, t in paragraphs(p)]
        kinds.append((str(folder.relative_to(ROOT)) if folder != ROOT else "README.md", chosen))
    failed = False
    for kind, sources in kinds:
        result = measure(kind, sources)
        if result is None:
            continue
        mean, ninetieth, lengths = result
        if arguments.check and kind in ("headers", "docs/guide") and (mean > MAX_MEAN or ninetieth > MAX_90TH):
            print(f"{kind}: expected a mean of at most {MAX_MEAN} and a 90th percentile of at most {MAX_90TH} words")
            failed = True
        if arguments.long:
            for count, place, part in sorted(lengths, reverse=True):
                if count > arguments.long:
                    print(f"  {place}: {count}: {part}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
