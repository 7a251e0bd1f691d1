#!/usr/bin/env python3
"""same_batch.py FOLDER FOLDER...: whether batches left the same bytes, but for what may differ between two runs.

Left out are the columns seconds, memory_mb, host and rank, JUnit's times, and the manifest of the batch, which has the
hashes of these. Stores are compared by their sorted rows. Status 0: all
are the same; 1: what differs is listed.
"""
import csv
import hashlib
import io
import json
import os
import re
import sqlite3
import sys

MAY_DIFFER = ("seconds", "memory_mb", "host", "rank")


def without_columns(path):
    rows = list(csv.reader(io.open(path, newline="")))
    keep = [k for k, name in enumerate(rows[0]) if name not in MAY_DIFFER]
    return repr([[row[k] for k in keep] for row in rows])


def without_keys(path):
    summary = json.load(open(path))
    for job in summary["jobs"]:
        for key in MAY_DIFFER:
            job.pop(key)
    return json.dumps(summary)


def rows_of(path):
    store = sqlite3.connect(f"file:{path}?mode=ro", uri=True)
    tables = [name for (name,) in store.execute("SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name")]
    rows = []
    for table in tables:
        columns = [c[1] for c in store.execute(f"PRAGMA table_info({table})") if c[1] not in MAY_DIFFER]
        rows += sorted(repr((table,) + row) for row in store.execute(f"SELECT {','.join(columns)} FROM {table}"))
    return "\n".join(rows)


def text_of(path, name):
    if name == "summary.csv":
        return without_columns(path)
    if name == "summary.json":
        return without_keys(path)
    if name == "results.sqlite":
        return rows_of(path)
    data = open(path, "rb").read()
    if name == "junit.xml":
        return re.sub(rb'time="[0-9.]*"', b"", data)
    return data


def files_of(folder):
    files = {}
    for where, _, names in os.walk(folder):
        for each in names:
            path = os.path.join(where, each)
            name = os.path.relpath(path, folder)
            if name == "manifest.json":
                continue
            text = text_of(path, name)
            files[name] = hashlib.sha256(text if isinstance(text, bytes) else text.encode()).hexdigest()
    return files


def main():
    first, *others = sys.argv[1:]
    expected = files_of(first)
    is_same = True
    for folder in others:
        found = files_of(folder)
        differing = sorted(n for n in expected.keys() | found.keys() if expected.get(n) != found.get(n))
        is_same = is_same and not differing
        print(f"{folder}: {'same' if not differing else 'differs: ' + ', '.join(differing[:20])} ({len(found)} files)")
    return 0 if is_same else 1


if __name__ == "__main__":
    sys.exit(main())
