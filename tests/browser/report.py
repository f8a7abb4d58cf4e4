"""Opens a report of a blade in a browser without a window, and checks it.

    python3 report.py BROWSER PAGE.report.html [FOLDER]

The page runs its own checks at the address #selftest. Then pictures of a wide and of a narrow
window must have texts and colored curves; they remain in FOLDER if it is given. Exit code 0 if
all is well, else 1 with the failures.
"""

import re
import struct
import subprocess
import sys
import tempfile
import zlib
from collections import Counter
from html import unescape
from pathlib import Path

WINDOWS = [(1280, 800), (390, 1200)]
LIMIT = 120  # seconds for one start of the browser


def run(browser, page, *options):
    """Starts the browser on a page; returns its output."""
    with tempfile.TemporaryDirectory() as profile:
        command = [browser, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                   f"--user-data-dir={profile}", "--virtual-time-budget=20000", *options, page]
        done = subprocess.run(command, capture_output=True, timeout=LIMIT, check=False)
        return done.stdout.decode("utf-8", "replace"), done.stderr.decode("utf-8", "replace")


def selftest(browser, page):
    """Failures of the page's own checks."""
    out, err = run(browser, f"{page}#selftest", "--dump-dom")
    found = re.search(r'<pre id="selftest"[^>]*>(.*?)</pre>', out, re.S)
    text = unescape(found.group(1)) if found else ""
    if re.fullmatch(r"PASS [1-9]\d*", text):
        print(text)
        return []
    return [text or f"the page did not run its checks\n{err[-2000:]}"]


def dots(file):
    """Width and rows of (r, g, b) of a PNG file of 8 bits without interlacing."""
    content = file.read_bytes()
    at, packed = 8, b""
    while at < len(content):
        size, kind = struct.unpack(">I4s", content[at:at + 8])
        part = content[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, color, _, _, interlaced = struct.unpack(">IIBBBBB", part)
            assert depth == 8 and color in (2, 6) and not interlaced, "another kind of PNG"
            step = 3 if color == 2 else 4
        elif kind == b"IDAT":
            packed += part
        at += 12 + size
    data, line = zlib.decompress(packed), width * step
    rows, before = [], bytearray(line)
    for y in range(height):
        start = y * (line + 1)
        kind, row = data[start], bytearray(data[start + 1:start + 1 + line])
        for i in range(line):
            left = row[i - step] if i >= step else 0
            above, corner = before[i], before[i - step] if i >= step else 0
            if kind == 1:
                row[i] = (row[i] + left) & 255
            elif kind == 2:
                row[i] = (row[i] + above) & 255
            elif kind == 3:
                row[i] = (row[i] + (left + above) // 2) & 255
            elif kind == 4:
                guess = left + above - corner
                near = min((abs(guess - left), 0, left), (abs(guess - above), 1, above),
                           (abs(guess - corner), 2, corner))
                row[i] = (row[i] + near[2]) & 255
        rows.append([tuple(row[i:i + 3]) for i in range(0, line, step)])
        before = row
    return rows


def picture(browser, page, size, folder):
    """Failures of the picture of a window: it must have texts and colored curves."""
    file = folder / f"report_{size[0]}.png"
    _, err = run(browser, page, f"--screenshot={file}", f"--window-size={size[0]},{size[1]}")
    if not file.is_file():
        return [f"no picture of {size[0]} dots\n{err[-2000:]}"]
    counts = Counter(dot for row in dots(file) for dot in row)
    total = sum(counts.values())
    dark = sum(count for dot, count in counts.items() if max(dot) < 100)
    colored = sum(count for dot, count in counts.items() if max(dot) - min(dot) > 60)
    if dark < 0.005 * total or colored < 0.002 * total:
        return [f"picture of {size[0]} dots: {dark} dark and {colored} colored dots of {total}"]
    return []


def main():
    if len(sys.argv) not in (3, 4):
        print(__doc__)
        return 1
    browser, page = sys.argv[1], Path(sys.argv[2]).resolve().as_uri()
    failures = selftest(browser, page)
    with tempfile.TemporaryDirectory() as short:
        folder = Path(sys.argv[3] if len(sys.argv) == 4 else short)
        folder.mkdir(parents=True, exist_ok=True)
        for size in WINDOWS:
            failures += picture(browser, page, size, folder)
    for failure in failures:
        print(failure)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
