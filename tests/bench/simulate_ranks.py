#!/usr/bin/env python3
"""simulate_ranks.py STORE PROCESSOR_SECONDS: what many jobs cost on many nodes, from the recorded times of some.

STORE is the results.sqlite of a batch of one job at a time, PROCESSOR_SECONDS what that batch took (user and system,
as /usr/bin/time says): on a busy machine its times by the clock are scaled to it. Jobs are drawn from it at random and
handed out as rank 0 does: groups of one scene, those with most work first; one question after the other; a rank that
begins a scene reads it first. Printed: time of the run and its efficiency, and both with what one
process does alone (reading the list, joining the stores, writing the summaries).
"""
import collections
import heapq
import random
import sqlite3
import statistics
import sys

ANSWER_S = 0.00002  # a question and its answer over a network, while others wait
PAUSE_S = 0.0002    # both sides sleep so long between two looks for a message (cli/ranks_mpi.cpp)
QUICK_S = 0.004     # a rank whose last question is not so long ago asks for twice as many jobs
READING_S = 0.05    # of a scene, by each rank that has jobs of it
ALONE_S = 0.00038   # a job: reading the list 0.11 ms, joining 0.17 ms, summaries 0.1 ms (docs/scaling.md)
CASES = ((100_000, 1, 16), (100_000, 100, 16), (1_000_000, 100, 16), (1_000_000, 1000, 16))


def recorded(store, processor_s):
    rows = sqlite3.connect(f"file:{store}?mode=ro", uri=True).execute("SELECT name, path, seconds FROM jobs").fetchall()
    kinds = {}
    for name, path, seconds in rows:
        kinds.setdefault((path, name.rsplit(" ", 1)[0]), []).append(seconds)
    # Others were at work when they were recorded, so a job's time is that of the usual one of its kind.
    jobs = [(path, statistics.median(times)) for (path, _), times in kinds.items() for _ in times]
    scale = processor_s / sum(seconds for _, seconds in jobs)
    return [(path, seconds * scale) for path, seconds in jobs]


class Rank:
    """What one rank was given and has not begun: it asks for as many jobs at once as it finishes in some milliseconds."""

    def __init__(self, most):
        self.most, self.size, self.asked_s, self.jobs, self.known = most, 1, -1.0, collections.deque(), set()

    def block(self, now):
        since = now - self.asked_s
        self.size = min(2 * self.size, self.most) if since < QUICK_S else max(self.size // 2, 1)
        self.asked_s = now
        return self.size


def run_s(jobs, count, cores):
    work = {}
    for path, seconds in jobs:
        work[path] = work.get(path, 0) + seconds
    left = collections.deque(sorted(jobs, key=lambda job: (-work[job[0]], job[0], -job[1])))
    ranks = [Rank(cores) for _ in range(count)]
    free = [(0.0, rank) for rank in range(count) for _ in range(cores)]
    answered, end = 0.0, 0.0
    while free:
        begins, number = heapq.heappop(free)
        rank = ranks[number]
        if not rank.jobs:
            # Who has nothing to do, and who asks, look after half a pause on average.
            answered = max(begins + PAUSE_S / 2, answered) + ANSWER_S
            for _ in range(min(rank.block(begins), len(left))):
                rank.jobs.append(left.popleft())
            begins = answered + PAUSE_S / 2
        if not rank.jobs:
            continue
        path, seconds = rank.jobs.popleft()
        if path not in rank.known:
            rank.known.add(path)
            seconds += READING_S
        end = max(end, begins + seconds)
        heapq.heappush(free, (begins + seconds, number))
    return end


def main():
    store, processor_s = sys.argv[1], float(sys.argv[2])
    mix = recorded(store, processor_s)
    mean = sum(seconds for _, seconds in mix) / len(mix)
    print(f"recorded: {len(mix)} jobs, {mean:.3f} s on average, {max(s for _, s in mix):.2f} s at most")
    chance = random.Random(17)
    for count, ranks, cores in CASES:
        jobs = chance.choices(mix, k=count)
        ideal = sum(seconds for _, seconds in jobs) / (ranks * cores)
        run, alone = run_s(jobs, ranks, cores), ALONE_S * count
        print(f"{count} jobs, {ranks} nodes of {cores} cores: run {run:.1f} s, efficiency {ideal / run:.2f}; "
              f"with list, join and summaries {run + alone:.0f} s, {ideal / (run + alone):.2f}; "
              f"0.90 of all from {9 * ALONE_S * ranks * cores:.1f} s a job on")


if __name__ == "__main__":
    main()
