#!/usr/bin/env python3
"""simulate_ranks.py STORE PROCESSOR_SECONDS: what many jobs cost on many nodes, from the recorded times of some.

STORE is the results.sqlite of a batch of one job at a time, PROCESSOR_SECONDS what that batch took (user and system,
as /usr/bin/time says): on a busy machine its times by the clock are scaled to it. Jobs are drawn from it at random and
handed out as rank 0 does (cli/batch/job_dealer.h): a rank goes on in its group of one scene, then begins the next group, then
takes the later half of the longest rest; one question after the other; a rank that begins a scene reads it first. Printed: time of the run and its efficiency, and both with what one
process does alone (reading the list, joining the stores, writing the summaries).
"""
import bisect
import collections
import heapq
import itertools
import os
import random
import sqlite3
import statistics
import sys

ANSWER_S = 0.00002  # a question and its answer over a network, while others wait
PAUSE_S = 0.0002    # both sides sleep so long between two looks for a message (cli/batch/ranks_mpi.cpp)
QUICK_S = 0.004     # a rank whose last question is not so long ago asks for twice as many jobs
READING_S = 0.05    # of a scene, by each rank that has jobs of it
ALONE_S = 0.00038   # a job: reading the list 0.11 ms, joining 0.17 ms, summaries 0.1 ms (docs/method/scaling.md)
WORK = {"check": 1, "correct": 1}  # a byte of a path, as the program reckons (cli/batch/batch_run.cpp)
CASES = ((100_000, 1, 16), (100_000, 100, 16), (1_000_000, 100, 16), (1_000_000, 1000, 16))


Job = collections.namedtuple("Job", "path work seconds")


def recorded(store, processor_s):
    database = sqlite3.connect(f"file:{store}?mode=ro", uri=True)
    kinds = {}
    for name, command, path, seconds in database.execute("SELECT name, command, path, seconds FROM jobs"):
        kinds.setdefault((path, command, name.rsplit(" ", 1)[0]), []).append(seconds)
    # Others were at work when they were recorded, so a job's time is that of the usual one of its kind.
    jobs = [Job(path, WORK[command] * os.path.getsize(path), statistics.median(times))
            for (path, command, _), times in kinds.items() for _ in times]
    scale = processor_s / sum(job.seconds for job in jobs)
    return [job._replace(seconds=job.seconds * scale) for job in jobs]


class Dealer:
    """As cli/batch/job_dealer.cpp; the longest rest is found in a heap whose entries may be out of date."""

    def __init__(self, group_ends, work, ranks):
        self.ends, self.begun, self.rests, self.longest = group_ends, 0, [[0, 0] for _ in range(ranks)], []
        self.before = [0, *itertools.accumulate(work)]

    def take(self, rank, most):
        own = self.rests[rank]
        if own[0] == own[1]:
            if self.begun < len(self.ends):
                own[:] = [self.ends[self.begun - 1] if self.begun else 0, self.ends[self.begun]]
                self.begun += 1
            else:
                own[:] = self.half_of_longest()
            self.noted(rank)
        first, own[0] = own[0], min(own[0] + most, own[1])
        return range(first, own[0])

    def work(self, rank):
        first, end = self.rests[rank]
        return self.before[end] - self.before[first]

    def noted(self, rank):
        heapq.heappush(self.longest, (-self.work(rank), rank))

    def half_of_longest(self):
        while self.longest:
            work, rank = heapq.heappop(self.longest)
            rest = self.rests[rank]
            if rest[0] == rest[1]:
                continue
            if -work != self.work(rank):
                self.noted(rank)
                continue
            half = (self.before[rest[0]] + self.before[rest[1]]) / 2
            middle, end = bisect.bisect_right(self.before, half, rest[0], rest[1]) - 1, rest[1]
            rest[1] = middle
            self.noted(rank)
            return [middle, end]
        return [0, 0]


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
    """The end of the last job, and how often a scene was read."""
    work = collections.Counter()
    for job in jobs:
        work[job.path] += job.work
    jobs = sorted(jobs, key=lambda job: (-work[job.path], job.path, -job.work))
    ends = [i + 1 for i, job in enumerate(jobs) if i + 1 == len(jobs) or jobs[i + 1].path != job.path]
    dealer = Dealer(ends, [job.work for job in jobs], count)
    ranks = [Rank(cores) for _ in range(count)]
    free = [(0.0, rank) for rank in range(count) for _ in range(cores)]
    answered, end = 0.0, 0.0
    while free:
        begins, number = heapq.heappop(free)
        rank = ranks[number]
        if not rank.jobs:
            # Who has nothing to do, and who asks, look after half a pause on average.
            answered = max(begins + PAUSE_S / 2, answered) + ANSWER_S
            rank.jobs.extend(jobs[i] for i in dealer.take(number, rank.block(begins)))
            begins = answered + PAUSE_S / 2
        if not rank.jobs:
            continue
        path, _, seconds = rank.jobs.popleft()
        if path not in rank.known:
            rank.known.add(path)
            seconds += READING_S
        end = max(end, begins + seconds)
        heapq.heappush(free, (begins + seconds, number))
    return end, sum(len(rank.known) for rank in ranks)


def main():
    store, processor_s = sys.argv[1], float(sys.argv[2])
    mix = recorded(store, processor_s)
    mean = sum(job.seconds for job in mix) / len(mix)
    print(f"recorded: {len(mix)} jobs, {mean:.3f} s on average, {max(job.seconds for job in mix):.2f} s at most")
    chance = random.Random(17)
    for count, ranks, cores in CASES:
        jobs = chance.choices(mix, k=count)
        ideal = sum(job.seconds for job in jobs) / (ranks * cores)
        run, readings = run_s(jobs, ranks, cores)
        alone = ALONE_S * count
        print(f"{count} jobs, {ranks} nodes of {cores} cores: run {run:.1f} s, efficiency {ideal / run:.2f}, "
              f"{readings} scenes read; with list, join and summaries {run + alone:.0f} s, {ideal / (run + alone):.2f}; "
              f"0.90 of all from {9 * ALONE_S * ranks * cores:.1f} s a job on")


if __name__ == "__main__":
    main()
