"""Counts of cycles by the package rainflow (PyPI, 3.2.0): pip install rainflow; python counts.py

A history of 5000 whole numbers: a sum of steps from a linear congruential sequence, pulled back to
zero, so that small cycles are on large ones.
"""

import collections

import rainflow

STATE = 2024
history, value = [], 0
for _ in range(5000):
    STATE = (STATE * 6364136223846793005 + 1442695040888963407) % 2**64
    step = (STATE >> 40) % 401 - 200
    value = value + step - int(value / 16)
    history.append(value)

counts = collections.Counter()
for size, mean, count, _, _ in rainflow.extract_cycles(history):
    counts[size, mean] += count

with open("counts.csv", "w", encoding="utf-8") as file:
    file.write("range,mean,count\n")
    for (size, mean), count in sorted(counts.items()):
        file.write(f"{size:g},{mean:g},{count:g}\n")
