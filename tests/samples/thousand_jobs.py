#!/usr/bin/env python3
"""thousand_jobs.py SAMPLES DATA OUT.json: a job list of 1,000 jobs for a batch.

SAMPLES is a folder of make_samples, DATA one with toolpaths/ and parts/matched/ (or "-": without them). Each sample is
checked and corrected, each pair of DATA checked, with tolerances that make every job another one, those that take
longest with one of them; one job in thirty has a report.
"""
import json
import os
import sys

PAIRS = [(f"solidworks_cam/{n}.apt", f"{n}.STL")
         for n in ("basemach", "Sacrifice-Board", "SupPetriLED", "Teste-Metrologia", "Paralelipipedo2")] + [
             (f"five_axis_part/{n}", "five_axis_part_inch.stl")
             for n in ("subset_autodesk_iso4343.apt", "subset_camplete.apt")]
LONG = ("basemach.apt", "Sacrifice-Board.apt", "subset_autodesk_iso4343.apt", "subset_camplete.apt",
        "freeform corrected", "blade corrected")
LONG_TURNS = 1


def from_samples(samples):
    jobs = []
    for name in sorted(os.listdir(samples)):
        expected = os.path.join(samples, name, "expected.json")
        if not os.path.isfile(expected):
            continue
        known = json.load(open(expected))
        below = lambda file: os.path.abspath(os.path.join(samples, name, file))
        job = {"name": name, "path": below(known["toolpath"]), "tools": below(known["tools"])}
        for key, files in (("part", "parts"), ("fixture", "fixtures"), ("head", "heads")):
            if known[files]:
                job[key] = [below(file) for file in known[files]]
        jobs += [dict(job, command="check"), dict(job, name=name + " corrected", command="correct")]
    return jobs


def from_data(data):
    jobs = []
    for path, part in PAIRS:
        path = os.path.join(data, "toolpaths", path)
        part = os.path.join(data, "parts/matched", part)
        if os.path.isfile(path) and os.path.isfile(part):
            jobs.append({"name": os.path.basename(path), "path": os.path.abspath(path), "part": [os.path.abspath(part)]})
    return jobs


def main():
    samples, data, out = sys.argv[1:]
    kinds = from_samples(samples) + ([] if data == "-" else from_data(data))
    jobs, turn = [], 0
    while len(jobs) < 1000:
        turns = [job for job in kinds if turn < LONG_TURNS or job["name"] not in LONG]
        for job in turns[:1000 - len(jobs)]:
            jobs.append(dict(job, name=f"{job['name']} {turn}", tolerance=round(0.01 + 0.0005 * turn, 4),
                             report=len(jobs) % 30 == 0))
        turn += 1
    json.dump({"jobs": jobs}, open(out, "w"), indent=1)


if __name__ == "__main__":
    main()
